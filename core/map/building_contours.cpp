// SPDX-License-Identifier: Apache-2.0
#include "core/map/building_contours.h"

#include <algorithm>
#include <cmath>

#include "core/base/require.h"
#include "core/map/squared_distances.h"

namespace nadir {

Raster<ClassId> with_building_contours(const Raster<ClassId>& labels,
                                       double metres_per_cell,
                                       double thickness_m) {
  NADIR_REQUIRE(metres_per_cell > 0.0 && thickness_m >= 0.0);
  // From the centre of the nearest other cell to the edge it is half a cell.
  const double wall_cells = std::max(1.0, thickness_m / metres_per_cell + 0.5);
  const double capped_cells = std::min(wall_cells, 60'000.0);
  IdSet everything_else{};
  everything_else.fill(true);
  everything_else[kBuilding] = false;
  Raster<ClassId> walls = labels;
  visit_squared_distances(labels, everything_else, static_cast<int>(std::ceil(capped_cells)) + 1,
                          [&](int row, std::span<const std::int64_t> squared) {
                            const std::span<ClassId> cells = walls.row(row);
                            for (std::size_t column = 0; column < cells.size(); ++column) {
                              const bool is_inside = static_cast<double>(squared[column]) >
                                                     capped_cells * capped_cells;
                              if (cells[column] == kBuilding && is_inside)
                                cells[column] = kUnclassified;
                            }
                          });
  return walls;
}

}  // namespace nadir
