// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "core/base/raster.h"
#include "maps/draw/town_layout.h"

namespace nadir::town {

/// Cells of the town; a cell belongs to a shape if its centre does. No antialiasing: a mixed cell
/// would be a class of its own.
struct Grid {
  int columns = 0, rows = 0;
  double metres_per_cell = 0.1;

  [[nodiscard]] Point centre(int column, int row) const {
    return {(column + 0.5 - columns / 2.0) * metres_per_cell,
            (rows / 2.0 - row - 0.5) * metres_per_cell};
  }
};
[[nodiscard]] Grid grid_of(const TownLayout& town);
/// Calls `visit(column, row, point)` for every cell whose centre lies in the box, row by row.
void for_cells(const Grid& grid,
               const Box& box,
               const std::function<void(int column, int row, const Point& p)>& visit);

/// How a point lies to the streets.
struct StreetPlace {
  double distance_m = 0.0;  ///< To the edge of the road, negative on it; street corners are
                            ///< rounded, islands are outside.
  int street = -1;          ///< The nearest.
  Foot foot;                ///< On its centre line.
};
[[nodiscard]] StreetPlace street_place(const TownLayout& town, const Point& p);

struct Ground {
  Grid grid;
  Raster<Surface> bare;     ///< Without paint, fences and buildings.
  Raster<Surface> surface;  ///< With them.
  Raster<float> road_distance_m;
};

/// Draws the ground, later things over earlier ones: grass; areas; sidewalks; roads; curbs;
/// islands; driveways; hedges; paint (on road only); fences; building contours (0.3 m inwards from
/// the footprint's edge) and indoors.
[[nodiscard]] Ground draw_ground(const TownLayout& town);

/// The label map: the class of every cell's surface.
[[nodiscard]] Raster<ClassId> draw_labels(const Ground& ground);

}  // namespace nadir::town
