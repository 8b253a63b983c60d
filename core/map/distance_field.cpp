// SPDX-License-Identifier: Apache-2.0
#include "core/map/distance_field.h"

#include <algorithm>
#include <cmath>

#include "core/base/require.h"
#include "core/map/squared_distances.h"

namespace nadir {

std::vector<double> DistanceField::row_m(int row) const {
  std::vector<double> distances_m;
  distances_m.reserve(static_cast<std::size_t>(codes.width()));
  for (int column = 0; column < codes.width(); ++column) {
    distances_m.push_back(distance_m(column, row));
  }
  return distances_m;
}

DistanceField build_class_distance_field(const OverheadMap& map, ClassId id, double truncation_m) {
  NADIR_REQUIRE(truncation_m > 0.0 && map.metres_per_cell > 0.0);
  const double truncation_cells = truncation_m / map.metres_per_cell;
  NADIR_REQUIRE(truncation_cells <= 65'000.0);
  const int cap = static_cast<int>(std::ceil(truncation_cells)) + 1;
  IdSet targets{};
  targets[id] = true;
  DistanceField field{Raster<std::uint8_t>(map.labels.width(), map.labels.height()), truncation_m};
  visit_squared_distances(
      map.labels, targets, cap, [&](int row, std::span<const std::int64_t> squared) {
        const std::span<std::uint8_t> codes = field.codes.row(row);
        for (std::size_t column = 0; column < codes.size(); ++column) {
          const double cells = std::sqrt(static_cast<double>(squared[column]));
          const double fraction = std::min(1.0, cells / truncation_cells);
          codes[column] = static_cast<std::uint8_t>(std::lround(255.0 * fraction));
        }
      });
  return field;
}

}  // namespace nadir
