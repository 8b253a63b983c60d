// SPDX-License-Identifier: Apache-2.0
#include "core/sim/relief.h"

#include <algorithm>
#include <vector>

#include "core/base/random.h"
#include "core/sim/object_kind.h"

namespace nadir {
namespace {

constexpr float kLowestBuildingM = 3.0F;
constexpr float kHighestBuildingM = 8.0F;
constexpr float kFenceM = 1.1F;
constexpr float kPostM = 4.0F;

bool is_behind_curb(ClassId id) {
  return id == kCurb || id == kSidewalk || id == kTerrain || id == kVegetation;
}

bool is_post(ClassId id) {
  return id == kPole || id == kTrafficLight || id == kTrafficSign || id == kStreetLight;
}

/// Gives the whole building that holds a cell one height.
void raise_building(
    const Raster<ClassId>& labels, int column, int row, float height_m, Raster<float>& heights) {
  std::vector<std::pair<int, int>> open = {{column, row}};
  heights.at(column, row) = height_m;
  while (!open.empty()) {
    const auto [x, y] = open.back();
    open.pop_back();
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        if (!labels.contains(x + dx, y + dy) || labels.at(x + dx, y + dy) != kBuilding) continue;
        if (heights.at(x + dx, y + dy) > 0.0F) continue;
        heights.at(x + dx, y + dy) = height_m;
        open.emplace_back(x + dx, y + dy);
      }
    }
  }
}

}  // namespace

Relief raise_relief(const OverheadMap& map, double curb_height_m, std::uint64_t seed) {
  const Raster<ClassId>& labels = map.labels;
  const bool has_curbs =
      std::find(labels.values().begin(), labels.values().end(), kCurb) != labels.values().end();
  Relief relief{.height_m = Raster<float>(labels.width(), labels.height()),
                .cells_to_tall = {},
                .low_m = has_curbs ? static_cast<float>(curb_height_m) : 0.0F,
                .tallest_m = 0.0F};
  Raster<std::uint8_t> is_tall(labels.width(), labels.height());
  std::uint32_t buildings = 0;
  for (int row = 0; row < labels.height(); ++row) {
    for (int column = 0; column < labels.width(); ++column) {
      const ClassId label = labels.at(column, row);
      float& height_m = relief.height_m.at(column, row);
      if (label == kBuilding && height_m == 0.0F) {
        const auto draw = uniforms({seed, kWorldObjects, kBuildingHeight, buildings++, 0});
        const float share = static_cast<float>(draw[0]);
        raise_building(labels, column, row,
                       kLowestBuildingM + share * (kHighestBuildingM - kLowestBuildingM),
                       relief.height_m);
      } else if (label == kFence || label == kRailing) {
        height_m = kFenceM;
      } else if (is_post(label)) {
        height_m = kPostM;
      } else if (is_behind_curb(label)) {
        height_m = relief.low_m;
      }
      relief.tallest_m = std::max(relief.tallest_m, height_m);
      is_tall.at(column, row) = height_m > relief.low_m ? 1 : 0;
    }
  }
  relief.cells_to_tall = chessboard_distance(is_tall);
  return relief;
}

Raster<std::uint8_t> chessboard_distance(const Raster<std::uint8_t>& cells) {
  // Two passes are exact in this metric: a shortest way first goes diagonally, then straight
  // (Rosenfeld & Pfaltz 1968).
  const int width = cells.width();
  const int height = cells.height();
  Raster<std::uint8_t> distance(width, height, 255);
  const auto relax = [&](int column, int row, int dx, int dy) {
    if (!distance.contains(column + dx, row + dy)) return;
    const int through = distance.at(column + dx, row + dy) + 1;
    std::uint8_t& best = distance.at(column, row);
    if (through < best) best = static_cast<std::uint8_t>(through);
  };
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      if (cells.at(column, row) != 0) distance.at(column, row) = 0;
      relax(column, row, -1, 0);
      relax(column, row, -1, -1);
      relax(column, row, 0, -1);
      relax(column, row, 1, -1);
    }
  }
  for (int row = height - 1; row >= 0; --row) {
    for (int column = width - 1; column >= 0; --column) {
      relax(column, row, 1, 0);
      relax(column, row, 1, 1);
      relax(column, row, 0, 1);
      relax(column, row, -1, 1);
    }
  }
  return distance;
}

}  // namespace nadir
