// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "core/map/overhead_map_file.h"
#include "core/sim/camera_renderer.h"
#include "core/sim/smooth_noise.h"

namespace nadir {

/// What a colour camera would see of a world, for people to look at: nothing is localised with it.
///
/// - Ground, and crowns over ground that the map calls vegetation, take the colour of the overhead
///   picture where they are hit: bilinear, averaged over about the ground that the pixel covers, so
///   that far ground does not sparkle. Shadows are those of the picture. Without a picture,
///   ground has the colour of its class. Off the map all is bare ground, in one colour.
/// - Walls, fences, trees, cars and people have colours of their kind, some varying from thing to
///   thing, in the light of the sun of the bundled town (south-east, 50 degrees high) by
///   Lambert's law. They cast no shadows.
/// - Haze grows with depth, until at kFarthestLabelM the sky takes over, as it does in the labels.
class WorldColours {
 public:
  /// Refers to world and picture, which must outlive it.
  /// @param picture  Of the labels' size, or null. Smaller copies of it are made here.
  /// @param seed     Of the texture of walls and leaves.
  WorldColours(const World& world, const ColourRaster* picture, std::uint64_t seed);

  /// Colours of a view that was rendered with `max_range_m` of kFarthestLabelM, pixel by pixel.
  /// Parallel over rows; the same bits on any number of threads.
  [[nodiscard]] ColourRaster paint(const SurfaceView& view,
                                   const CameraModel& camera,
                                   const Rigid3& enu_from_camera) const;

 private:
  class Brush;

  const World& world_;
  const ColourRaster* picture_;
  std::vector<ColourRaster> halved_;  ///< The picture at 1/2, 1/4, 1/8 and 1/16.
  SmoothNoise texture_;
};

}  // namespace nadir
