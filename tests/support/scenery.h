// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <memory>

#include "core/base/random.h"
#include "core/geo/rigid2.h"
#include "core/map/map_index.h"
#include "core/topview/semantic_topview.h"

namespace nadir {

/// A made landscape without repetition: blobs of road, terrain, vegetation and sidewalk of a few
/// metres, curbs between some. Lower left corner at `enu` (0, 0).
[[nodiscard]] inline OverheadMap patchwork_map(int width, int height, double metres_per_cell) {
  OverheadMap map{.name = "patchwork",
                  .plane = ProjectPlane::create({32.4, -83.7}).value(),
                  .metres_per_cell = metres_per_cell,
                  .top_left_in_enu_m = {0.0, height * metres_per_cell},
                  .labels = Raster<ClassId>(width, height, kTerrain)};
  constexpr ClassId kClasses[] = {kRoad, kTerrain, kVegetation, kSidewalk, kBuilding};
  const auto patches = static_cast<std::uint32_t>(width * height / 250);
  for (std::uint32_t i = 0; i < patches; ++i) {
    const auto [u, v] = uniforms({.seed = 11, .particle = i});
    const auto words = random_words({.seed = 12, .particle = i});
    const int radius = 4 + static_cast<int>(words[1] % 12);
    const int column = static_cast<int>(u * width);
    const int row = static_cast<int>(v * height);
    for (int y = row - radius; y <= row + radius; ++y) {
      for (int x = column - radius; x <= column + radius; ++x) {
        const int squared = (x - column) * (x - column) + (y - row) * (y - row);
        if (squared > radius * radius || !map.labels.contains(x, y)) continue;
        map.labels.at(x, y) = squared > (radius - 1) * (radius - 1) ? static_cast<ClassId>(kCurb)
                                                                    : kClasses[words[0] % 5];
      }
    }
  }
  return map;
}

[[nodiscard]] inline std::shared_ptr<const MapIndex> index_of(OverheadMap map) {
  return std::make_shared<const MapIndex>(std::make_shared<const OverheadMap>(std::move(map)));
}

/// What a perfect observer at a pose sees: every cell of the map in a fan ahead, 60 degrees wide.
[[nodiscard]] inline SemanticTopview perfect_topview(const OverheadMap& map,
                                                     const Rigid2& enu_from_body,
                                                     double range_m) {
  SemanticCloud cloud;
  const double step_m = map.metres_per_cell;
  for (double forward = 0.5 * step_m; forward < range_m; forward += step_m) {
    const double reach = forward * std::tan(0.52);
    const auto cells = static_cast<int>(reach / step_m);
    for (int i = -cells; i < cells; ++i) {
      const Eigen::Vector2d point_in_body(forward, (i + 0.5) * step_m);
      const ClassId id = map.class_at(enu_from_body * point_in_body);
      if (id == kUnclassified) continue;
      cloud.points_in_level_m.emplace_back(static_cast<float>(point_in_body.x()),
                                           static_cast<float>(point_in_body.y()), -2.0F);
      cloud.labels.push_back(id);
    }
  }
  return build_semantic_topview(cloud, map.metres_per_cell, {.max_range_m = range_m}).value();
}

}  // namespace nadir
