// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/session/step_pose.h"
#include "widgets/panels/map_view.h"
#include "widgets/views/legend.h"
#include "widgets/views/map_overlays.h"

namespace nadir {

/// All lines and marks over the ground, in the order and with the looks of the model's layers: graticule, trajectories with
/// a trail up to now and a faint rest, ellipses, modes, poses, bookmarks.
/// @param shown  Numbers of the runs to draw; others are left out.
void draw_map_lines(Canvas& canvas,
                    const MapFrame& frame,
                    const MapViewModel& model,
                    const std::vector<int>& shown,
                    RunPathsCache& paths,
                    const Theme& theme);

/// The polyline that is measured, with its legs' lengths; `next_in_enu_m` is where the mouse would add a point.
void draw_measured(Canvas& canvas,
                   const MapFrame& frame,
                   const std::vector<Eigen::Vector2d>& points_in_enu_m,
                   const std::optional<Eigen::Vector2d>& next_in_enu_m,
                   const Theme& theme);

/// A ring around the selected particle with its heading.
void draw_selected_particle(Canvas& canvas,
                            const MapFrame& frame,
                            const Rigid2& pose,
                            const Theme& theme);

/// What the lines mean, and the classes where labels show; only what is visible.
[[nodiscard]] std::vector<LegendEntry> map_legend(const MapViewModel& model,
                                                  const std::vector<int>& shown,
                                                  const Theme& theme);
/// On a plate at the lower right of the map, at most a third of its width.
void draw_map_legend(Canvas& canvas,
                     const MapFrame& frame,
                     const std::vector<LegendEntry>& entries,
                     const Theme& theme);

/// Whether lines lie on pictures or labels, or on the plain window.
[[nodiscard]] bool has_ground_picture(const MapViewModel& model);
/// The layer that shows a source's path.
[[nodiscard]] Layer layer_of_source(PoseSource source);
/// The colour with its own opacity times a share.
[[nodiscard]] Rgba faded(Rgba colour, double share);
/// "#RRGGBB" as a colour; nothing for anything else.
[[nodiscard]] std::optional<Rgba> colour_from_hex(const std::string& text);
/// How a run's truth, odometry or estimate is drawn on the map.
[[nodiscard]] PathLook run_path_look(const MapViewModel& model,
                                     const MapRun& run,
                                     PoseSource source,
                                     const Theme& theme);

}  // namespace nadir
