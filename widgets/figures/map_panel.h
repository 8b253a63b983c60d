// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/geo/project_plane.h"
#include "widgets/figures/figure_options.h"
#include "widgets/figures/page.h"
#include "widgets/views/map_grid.h"
#include "widgets/views/map_overlays.h"
#include "widgets/views/overhead_view.h"

namespace nadir {

/// An overhead on a page with coordinates at its border, scale bar and north arrow; figures put their views into its scene
/// and draw their lines over it.
class MapPanel {
 public:
  /// What lies at the bottom: the picture (labels where the package has none), or the labels.
  enum class Ground { kPicture, kLabels };

  /// @errors as OverheadTiles::open.
  [[nodiscard]] static Result<std::unique_ptr<MapPanel>> create(
      const std::filesystem::path& package, Ground ground, const FigureOptions& options);

  [[nodiscard]] MapScene& scene() { return scene_; }
  [[nodiscard]] const ProjectPlane& plane() const { return plane_; }
  [[nodiscard]] const Eigen::AlignedBox2d& map_bounds_in_enu_m() const { return bounds_; }
  /// Whether the ground is labels: then lines need other colours than over a picture.
  [[nodiscard]] bool shows_picture() const { return shows_picture_; }
  /// Whether the map has one, shown or not.
  [[nodiscard]] bool has_picture() const { return has_picture_; }

  /// What the panel has to show, enu metres; the crop of the options wins over it. Points that are not finite do not count.
  void include(std::span<const Eigen::Vector2d> points_in_enu_m);
  void include_map();
  /// Where the ground is labels: makes them pale, so that cells laid over them can be told from them.
  void fade_labels();
  /// Forgets what was included before: a map that goes with the vehicle shows only what is around it. The
  /// whole map where the centre is not finite.
  void show_square(const Eigen::Vector2d& centre_in_enu_m, double side_m);

  /// What is up from now on, counter-clockwise from east; a map that is turned has no coordinates at its border.
  void turn(double up_rad) { up_rad_ = up_rad; }
  /// How the ground's own layers are seen; a picture that the panel does not show stays away.
  void set_picture(bool is_visible, double opacity);
  void set_labels(bool is_visible, double opacity);

  /// The part of a panel that the whole map fills with its coordinates and with so many pixels above it, in the panel's
  /// middle; all of it where something else than the whole map is shown.
  [[nodiscard]] PageRect part_filled(const PageRect& panel,
                                     double above_px,
                                     const PageFormat& format) const;

  /// Draws ground and border into a rectangle, and nothing over them; no coordinates where they would leave no room for
  /// the map. Pixels that are as the last ones are not rendered again, so that a film renders a map that stands still once;
  /// likewise each part of the ground.
  /// @returns the frame that lines are drawn with; the caller clips them by it.
  /// @errors as OverheadView::update and OffscreenRenderer::render.
  [[nodiscard]] Result<MapFrame> draw_ground(Canvas& canvas,
                                             FigureContext& context,
                                             const PageRect& where);

  // Or one after the other, where lines lie between parts of the ground.
  /// Where the map lies, and which coordinates have room around it.
  struct Place {
    MapFrame frame;
    Graticule graticule = Graticule::kNone;
  };
  [[nodiscard]] Place place_in(const PageRect& where, double px_per_pt) const;
  /// Some layers of the ground, over what is drawn already. @param layers  Empty: all. @errors as draw_ground().
  [[nodiscard]] Result<void> draw_part(Canvas& canvas,
                                       FigureContext& context,
                                       const MapFrame& frame,
                                       std::span<const MapLayer> layers,
                                       bool is_lowest);
  /// Thin lines across the map. @param look  Of a map that is turned, whose lines have their numbers with them; others are
  /// as draw_graticule_lines() has them.
  void draw_lines(Canvas& canvas,
                  const PageFormat& format,
                  const Place& place,
                  const MapGridLook& look) const;
  void draw_border(Canvas& canvas, const PageFormat& format, const Place& place) const;

  /// Scale bar and north arrow, after everything else; neither over a map that it would hide nor over what is taken.
  void draw_furniture(Canvas& canvas,
                      const PageFormat& format,
                      const MapFrame& frame,
                      std::span<const PageRect> taken = {}) const;

 private:
  /// All that the ground's pixels depend on.
  struct GroundState {
    MapCamera camera;
    int width = 0, height = 0, supersampling = 0;
    double px_per_pt = 1.0;
    Rgba background;
    bool is_transparent = false;
    std::vector<MapLayer> layers = {};  ///< That are drawn alone; none: all.
    friend bool operator==(const GroundState&, const GroundState&) = default;
  };
  /// A part of the ground as it was rendered last.
  struct RenderedGround {
    GroundState state;
    std::vector<PropStamp> content;  ///< What lay in its layers then.
    Raster<Rgba> pixels;
  };

  MapPanel(const ProjectPlane& plane,
           const Eigen::AlignedBox2d& bounds,
           const FigureOptions& options);
  [[nodiscard]] bool shows_whole_map() const;
  [[nodiscard]] MapCamera camera_for(const PageRect& where) const;
  [[nodiscard]] PageRect frame_inside(const PageRect& where, Graticule graticule, double px) const;
  [[nodiscard]] bool is_turned() const;
  void keep_on_map(MapFrame& frame) const;
  /// @returns what holds until the next call.
  [[nodiscard]] Result<const Raster<Rgba>*> render(FigureContext& context,
                                                   const GroundState& wanted);
  [[nodiscard]] Result<void> choose_tiles(const MapSight& close);

  ProjectPlane plane_;
  Eigen::AlignedBox2d bounds_;
  FigureOptions options_;
  bool shows_picture_ = false, has_picture_ = false;
  double up_rad_ = MapCamera{}.up_rad;
  Eigen::AlignedBox2d shown_;
  MapScene scene_;
  std::unique_ptr<OverheadView> picture_, labels_;  ///< Null: not shown.
  std::optional<MapSight> tiles_for_;     ///< That they show; nothing: they are to be chosen.
  std::vector<RenderedGround> rendered_;  ///< One for each choice of layers, oldest first.
};

/// Line colours that fit the ground: with a casing over imagery.
[[nodiscard]] PathLook truth_look(const Theme& theme);
[[nodiscard]] PathLook odometry_look(const Theme& theme);
/// @param run  0 for the first run of a figure, 1 for the second ...
[[nodiscard]] PathLook estimate_look(const Theme& theme, std::size_t run = 0);

}  // namespace nadir
