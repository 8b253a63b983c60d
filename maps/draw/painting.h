// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "core/base/raster.h"
#include "core/map/semantic_classes.h"
#include "maps/draw/ground.h"

namespace nadir::town {

/// Red, green, blue as they look in full sun, 0 to 255.
using Paint = Eigen::Vector3f;

/// The picture before light falls on it: what colour things have and how high they stand.
struct Canvas {
  Grid grid;
  Raster<Paint> colour;
  Raster<float> height_m;
};

/// A uniform number in [0, 1) that depends on nothing but its arguments (stream kTownDrawing).
[[nodiscard]] float chance(std::uint32_t purpose, std::uint32_t index, std::uint32_t draw = 0);

/// Smooth random ground: uniform numbers in [-1, 1] at the corners of a lattice, blended between.
class Noise {
 public:
  Noise(const Grid& grid, double lattice_m, std::uint32_t purpose);
  [[nodiscard]] float operator()(const Point& p) const;

 private:
  Point low_;
  double lattice_m_;
  Raster<float> values_;
};

/// One colour towards another.
[[nodiscard]] inline Paint blend(const Paint& from, const Paint& to, float share) {
  return from + share * (to - from);
}

/// The ground and its paint: texture of every surface, worn markings, tyre tracks. Heights are 0
/// but for fences and hedges.
[[nodiscard]] Canvas paint_ground(const TownLayout& town, const Ground& ground);
/// Cracks, sealed cracks, patches, manholes and oil on the roads, rubble and tracks in the yard.
void paint_wear(Canvas& canvas, const TownLayout& town, const Ground& ground);
void paint_roofs(Canvas& canvas, const TownLayout& town);
/// Trees of the layout, and those that grow in woods and shrubs.
void paint_trees(Canvas& canvas, const TownLayout& town, const Ground& ground);
/// Cars on the road and in the bays, containers, poles.
void paint_things(Canvas& canvas, const TownLayout& town);
/// Sun, cast shadows (to the north-west), sky light, and the camera's blur, noise and colour cast.
[[nodiscard]] Raster<Colour> light(const Canvas& canvas);

/// The whole picture, cell for cell on the label map.
[[nodiscard]] Raster<Colour> draw_picture(const TownLayout& town, const Ground& ground);

}  // namespace nadir::town
