// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "core/flight/flight_recording.h"
#include "core/geo/rigid3.h"
#include "core/sim/world.h"
#include "core/topview/camera_model.h"

namespace nadir {

/// Nothing farther than this along the optical axis shows: such pixels are sky.
inline constexpr double kFarthestLabelM = 60.0;

/// What a camera sees of a world at an instant: class and depth along the optical axis of what the
/// ray through every pixel centre (+0.5) hits first. Exact for the columns and solids that the
/// world is made of.
///
/// Pixels whose ray hits nothing within kFarthestLabelM are sky. Depth is 0 there and wherever it
/// is above `max_range_m`; labels reach farther than depths, as in a real camera. The visible side
/// of a column lies a twentieth of a cell inside its cell (never more than half the ray's way
/// through it), so that a back-projected wall falls on the cells that are labelled wall. A camera
/// inside a column or a solid sees through that one.
///
/// Parallel over rows; the same bits on any number of threads.
/// @param enu_from_camera  Camera x right, y down, z forward.
[[nodiscard]] SemanticFrame render(const World& world,
                                   const CameraModel& camera,
                                   const Rigid3& enu_from_camera,
                                   double time_s,
                                   double max_range_m);

/// What the same camera sees, with what whoever colours it needs to know beside labels and depth.
struct SurfaceView {
  static constexpr std::int32_t kNoSolid = -1;
  SemanticFrame frame;
  std::vector<Solid> solids;   ///< Those in sight, as they stand at the time of the frame.
  Raster<std::int32_t> solid;  ///< Index into `solids` of what a pixel shows, or kNoSolid.
};
[[nodiscard]] SurfaceView render_surfaces(const World& world,
                                          const CameraModel& camera,
                                          const Rigid3& enu_from_camera,
                                          double time_s,
                                          double max_range_m);

}  // namespace nadir
