// SPDX-License-Identifier: Apache-2.0
#include "maps/draw/painting.h"

#include <cmath>

#include "core/base/random.h"

namespace nadir::town {
namespace {

constexpr std::uint64_t kSeed = 1864;

}  // namespace

float chance(std::uint32_t purpose, std::uint32_t index, std::uint32_t draw) {
  return static_cast<float>(random_words({kSeed, kTownDrawing, purpose, index, draw})[0] >> 8U) *
         0x1.0p-24F;
}

Noise::Noise(const Grid& grid, double lattice_m, std::uint32_t purpose)
    : low_(-0.5 * grid.columns * grid.metres_per_cell, -0.5 * grid.rows * grid.metres_per_cell),
      lattice_m_(lattice_m),
      values_(static_cast<int>(-2.0 * low_.x() / lattice_m) + 3,
              static_cast<int>(-2.0 * low_.y() / lattice_m) + 3) {
  for (int row = 0; row < values_.height(); ++row) {
    for (int column = 0; column < values_.width(); ++column) {
      values_.at(column, row) = 2.0F * chance(purpose, static_cast<std::uint32_t>(row),
                                              static_cast<std::uint32_t>(column)) -
                                1.0F;
    }
  }
}

float Noise::operator()(const Point& p) const {
  const Point q = (p - low_) / lattice_m_;
  const int column = static_cast<int>(q.x()), row = static_cast<int>(q.y());
  const auto smooth = [](double share) {
    return static_cast<float>(share * share * (3.0 - 2.0 * share));
  };
  const float x = smooth(q.x() - column), y = smooth(q.y() - row);
  const float below = values_.at(column, row) * (1 - x) + values_.at(column + 1, row) * x;
  const float above = values_.at(column, row + 1) * (1 - x) + values_.at(column + 1, row + 1) * x;
  return below * (1 - y) + above * y;
}

Raster<Colour> draw_picture(const TownLayout& town, const Ground& ground) {
  Canvas canvas = paint_ground(town, ground);
  paint_wear(canvas, town, ground);
  paint_things(canvas, town);
  paint_roofs(canvas, town);
  paint_trees(canvas, town, ground);
  return light(canvas);
}

}  // namespace nadir::town
