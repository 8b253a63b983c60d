// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/session/step_pose.h"
#include "widgets/panels/map_view.h"
#include "widgets/views/legend.h"
#include "widgets/views/map_colours.h"
#include "widgets/views/map_overlays.h"

namespace nadir {

/// What lines are drawn with and of.
struct MapDrawing {
  Canvas& canvas;
  const MapFrame& frame;
  const MapViewModel& model;
  const std::vector<int>& shown;  ///< Numbers of the runs to draw; others are left out.
  RunPathsCache& paths;
  const Theme& theme;
};

/// The lines of one layer: graticule, a trajectory with a trail up to now and a faint rest, ellipses, modes. Nothing for a
/// layer that is none.
void draw_map_layer(const MapDrawing& drawing, Layer layer);
/// What lies above all layers: arrows at the poses, bookmarks.
void draw_map_poses(const MapDrawing& drawing);
/// Lines of equal east and north with their numbers. @param is_plain  There is no ground below them.
void draw_map_grid(const MapDrawing& drawing, bool is_plain);

/// The polyline that is measured, with its legs' lengths; `next_in_enu_m` is where the mouse would add a point.
void draw_measured(Canvas& canvas,
                   const MapFrame& frame,
                   const std::vector<Eigen::Vector2d>& points_in_enu_m,
                   const std::optional<Eigen::Vector2d>& next_in_enu_m,
                   const Theme& theme);
/// What the mouse would measure: "12.34 m  045.0°", and from the third point on "56.78 m in all". Empty without a point.
[[nodiscard]] std::vector<std::string> running_words(
    const std::vector<Eigen::Vector2d>& points_in_enu_m, const Eigen::Vector2d& next_in_enu_m);

/// A ring around a particle with its heading. @param is_selected  False: the mouse would pick it.
void draw_particle_ring(Canvas& canvas,
                        const MapFrame& frame,
                        const Rigid2& pose,
                        bool is_selected,
                        const Theme& theme);

/// What lies on the map means: lines, particles, agreement, the surface's scale, classes; only what is in sight.
/// @param seen  By the topviews of the active run, beside those of the map.
[[nodiscard]] std::vector<LegendEntry> map_legend(const MapViewModel& model,
                                                  const std::vector<int>& shown,
                                                  const SeenClasses& seen,
                                                  const Theme& theme,
                                                  bool with_classes = true);
/// The same whatever the moment is, about as high as it may become while the runs play: what one of their steps has counts as
/// there, and of classes those of the map. By it a fitted map leaves room, so that it rests while time passes.
[[nodiscard]] std::vector<LegendEntry> lasting_map_legend(const MapViewModel& model,
                                                          const std::vector<int>& shown,
                                                          const Theme& theme,
                                                          bool with_classes = true);
/// On a plate at the lower right of the map, as narrow as it may be so that it is not high. Where it has no room its last
/// entries are left out, and counted. @param fit  Of the last frame; made anew where that is of something else.
/// @returns the plate; without area where there is nothing to say, or no room to say it.
PageRect draw_map_legend(Canvas& canvas,
                         const MapFrame& frame,
                         const std::vector<LegendEntry>& entries,
                         const Theme& theme,
                         LegendFit& fit);
/// The plate alone, where nothing is drawn.
[[nodiscard]] PageRect place_of_map_legend(const MapFrame& frame,
                                           const std::vector<LegendEntry>& entries,
                                           LegendFit& fit);

/// Whether lines lie on pictures or labels, or on the plain window.
[[nodiscard]] bool has_ground_picture(const MapViewModel& model);
[[nodiscard]] bool has_ground_picture(const MapLook& look, bool has_map);
/// What lies around particles.
[[nodiscard]] Rgba particle_casing(const Theme& theme, bool is_on_picture);
/// The layer that shows a source's path.
[[nodiscard]] Layer layer_of_source(PoseSource source);
/// Lines of the graticule, before they are made pale.
[[nodiscard]] Rgba graticule_colour(bool is_on_picture, const Theme& theme);
/// How a run's truth, odometry or estimate is drawn on the map.
[[nodiscard]] PathLook run_path_look(const MapViewModel& model,
                                     const MapRun& run,
                                     PoseSource source,
                                     const Theme& theme);

}  // namespace nadir
