// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/raster.h"
#include "core/map/overhead_map.h"
#include "core/map/semantic_classes.h"

namespace nadir {

/// How far each cell of a map is from a class, up to a limit; one byte a cell.
struct DistanceField {
  /// 0 on the class, 255 at `truncation_m` and beyond, rounded to the nearest step of truncation_m
  /// / 255.
  Raster<std::uint8_t> codes;
  double truncation_m = 0.0;

  /// From the centre of the cell to the centre of the nearest cell of the class, within
  /// truncation_m / 510. Cell inside.
  [[nodiscard]] double distance_m(int column, int row) const {
    return codes.at(column, row) * (truncation_m / 255.0);
  }
  [[nodiscard]] std::vector<double> row_m(int row) const;
};

/// Builds the field from exact Euclidean distances. truncation_m everywhere where the map has no
/// cell of the class.
/// @param truncation_m  > 0, and at most 65,000 cells.
/// O(cells); same result on any number of threads.
[[nodiscard]] DistanceField build_class_distance_field(const OverheadMap& map,
                                                       ClassId id,
                                                       double truncation_m = 20.0);

}  // namespace nadir
