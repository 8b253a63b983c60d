// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/session/action.h"
#include "core/session/session.h"
#include "widgets/kit/ui.h"
#include "widgets/panels/label_gestures.h"
#include "widgets/panels/map_geometry.h"
#include "widgets/panels/map_trails.h"
#include "widgets/panels/surface_picture.h"
#include "widgets/views/legend.h"

namespace nadir {

/// A run as the map shows it.
struct MapRun {
  int number = 1;  ///< Counts from 1, as in actions.
  std::string name;
  std::size_t colour = 0;  ///< Of run_colour().
  bool is_active = false;
  std::shared_ptr<const RunDocument> document;  ///< Null while it is read.
  std::optional<std::size_t> step;              ///< At the cursor.
  std::vector<Eigen::Vector2d> bookmarks_in_enu_m;
  std::vector<std::string> bookmark_notes;  ///< One a bookmark; may be empty.
};

/// A run that would be shown, had it the ground of what is shown.
struct ApartRun {
  int number = 1;
  std::string name, map;  ///< Of the run, and of the map that it was made on.
};

/// What the hero of the window shows. Made each frame: it holds no pixels and copies no path.
struct MapViewModel {
  MapLook look;              ///< Resolved: centre and up are those of now.
  std::vector<MapRun> runs;  ///< Those that are drawn; the active one last, so that it lies on top.
  std::shared_ptr<const RunStep> step;  ///< Of the active run, with particles; null until decoded.
  std::shared_ptr<const MapIndex> map;  ///< Null: none, or being read.
  bool has_picture = true;              ///< False: the map is labels only.
  std::optional<ProjectPlane> plane;    ///< Of the map, else of the active run.
  std::string reading;                  ///< Name of what is being read; empty: nothing is.
  std::string
      coming;  ///< Name of a run whose first step is waited for, beside what is seen; empty: none.
  std::optional<JobStatus> work;  ///< That is waited for, with nothing else to see.
  /// Runs that are not drawn, for the map that is open is not theirs, or not that of the active run.
  std::vector<ApartRun> apart;
  bool is_map_foreign = false;             ///< The map that is open is not that of the active run.
  std::optional<CostRange> surface_costs;  ///< Of the error surface that lies on the ground now.
  std::optional<int> selected_particle;
  /// Labels that are drawn, instead of runs; null: runs are shown. Stays until the next action.
  const LabelDesk* labels = nullptr;
  bool takes_keys = true;  ///< False: something lies over the window, and Escape is for that.
};
[[nodiscard]] MapViewModel map_view_model(const Session& session);
/// Where the coordinates of what is open lie on earth: of the map, else of the active run; nothing without either.
[[nodiscard]] std::optional<ProjectPlane> plane_of(const Session& session);

/// A part of the ground that the window draws for a map: picture, labels, reconstruction, surfaces, topview, particles.
struct MapGround {
  int run = 0;       ///< Number of the run whose topview and particles lie on it; 0: none.
  MapCamera camera;  ///< Metres a pixel of the window, not of the frame buffer.
  int width_px = 0, height_px = 0;
  std::vector<Layer> layers;  ///< Of this part, from below.
  int part = 0,
      part_count = 1;     ///< Others are asked for in the same frame, where lines lie between them.
  bool is_lowest = true;  ///< Nothing lies below it but the window; else it lets lines through.
  bool is_second = false;  ///< Of the second map of a split view.
  bool is_of_labels =
      false;  ///< Picture, labels and borders of what is labelled; layers are not asked for.
};

/// How much of a legend has room on a map, kept as long as what it was made for: words are dear to measure.
struct LegendFit {
  std::vector<std::string> names;  ///< What it was made for.
  double map_width = 0.0, map_height = 0.0, px_per_pt = 0.0;
  std::size_t count = 0;  ///< Of the entries that are shown; a last one counts the others.
  double width = 0.0, height = 0.0;
  LegendLayout layout;  ///< Of what is shown.
};

/// Where the vehicle (the active run's estimate at the cursor) is when it is out of sight.
struct VehicleAway {
  PageRect free;            ///< The part of the map's page that controls leave.
  Eigen::Vector2d tip;      ///< Of an arrow at the border of that part, pointing to the vehicle.
  Eigen::Vector2d along;    ///< The arrow's direction on the page, of length 1.
  double distance_m = 0.0;  ///< From the map's middle.
};

/// Classes that the topviews of a run have shown, so that a legend that is looked at only grows.
struct SeenClasses {
  std::string run;  ///< Its path.
  std::array<bool, kClassCount> is_seen{};
  void add(const std::string& of_run, const RunStep& step);
};

struct MapViewState {
  /// Draws the ground and gives its texture, bottom row first; called while the view is drawn, so that ground and lines never
  /// part. Empty: nothing lies below the lines.
  std::function<kit::TextureId(const MapGround&)> ground;

  std::optional<MapReadout>
      readout;       ///< Of the place under the mouse in this frame; for the status line.
  MapCamera camera;  ///< That the view (of the active run) was drawn with; for exports.
  PageRect where;    ///< Of its page.
  MapRoom room;      ///< What controls leave of it.
  double legend_height_px = 0.0;  ///< Of the map's lower end, as much as legends cover.

  LabelDragState label_drag;  ///< What a drag over labels holds.
  RunPathsCache paths;
  LegendFit legend, second_legend;  ///< Of the only or first map, and of the second.
  LegendFit lasting_legend;         ///< Of the first: lasting_map_legend(), for the room below.
  SeenClasses seen_classes;         ///< Of the active run.
  std::optional<VehicleAway> away;  ///< In this frame, on the only or first map.
  std::string grabbing_pane;        ///< Map whose ground a drag holds; empty: none.
  Eigen::Vector2d grabbed_in_enu_m =
      Eigen::Vector2d::Zero();  ///< The place of the ground that it holds.
  Eigen::Vector2d menu_in_enu_m = Eigen::Vector2d::Zero();  ///< Where the menu was opened.
};

/// The map with all that lies over it, in the region that the caller has made: takes all its room. Paths begin with "Map/".
[[nodiscard]] Actions draw_map_view(kit::Ui& ui, const MapViewModel& model, MapViewState& state);

}  // namespace nadir
