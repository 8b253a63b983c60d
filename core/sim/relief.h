// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "core/base/raster.h"
#include "core/map/overhead_map.h"

namespace nadir {

/// Heights that a label raster is raised by: every cell is an upright column with a flat top, from
/// z = 0.
///
/// Building cells are walls of 3 to 8 m, one height a connected component (8 neighbours); whether a
/// building is filled or a contour makes no difference to a ray, which stops at the first cell.
/// Fence and railing cells are 1.1 m, cells of poles, lights and signs 4 m. Where the map has curb
/// cells at all, curb, sidewalk, terrain and vegetation cells are one curb height; everything else,
/// vegetation of maps without curbs too, is flat, so that views stay open.
struct Relief {
  Raster<float> height_m;
  Raster<std::uint8_t>
      cells_to_tall;       ///< Chessboard distance to the nearest tall cell (0 on it), at most 255.
  float low_m = 0.0F;      ///< Height of the curb-high cells: cells above it are tall.
  float tallest_m = 0.0F;  ///< Of all columns.
};

/// @param seed  Decides the heights of buildings.
[[nodiscard]] Relief raise_relief(const OverheadMap& map, double curb_height_m, std::uint64_t seed);

/// Chessboard distance in cells to the nearest cell that is not 0 (0 on it), at most 255; 255
/// everywhere where there is none. A square of that many cells less one, every way, is free of such
/// cells. O(cells).
[[nodiscard]] Raster<std::uint8_t> chessboard_distance(const Raster<std::uint8_t>& cells);

}  // namespace nadir
