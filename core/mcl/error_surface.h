// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/mcl/measurement_model.h"

namespace nadir {

/// A grid of poses around a centre. Steps are along east, north and yaw; odd counts put a sample on
/// the centre itself. Where step_m is a whole number of the map's cells (see whole_cells()), all poses of one yaw share the
/// fractions of their cells, and the surface costs a small part of what it costs otherwise.
struct ErrorSurfaceGrid {
  int count_x = 41;
  int count_y = 41;
  int count_yaw = 1;
  double step_m = 0.25;
  double step_rad = 0.05;
};

/// The grid with the step nearest to its own that is a whole number of cells, at least one.
[[nodiscard]] ErrorSurfaceGrid whole_cells(ErrorSurfaceGrid grid, double metres_per_cell);

/// Mean cost of a topview at each pose of a grid: what the filter's weights are made of.
struct ErrorSurface {
  Rigid2 centre_in_enu;
  ErrorSurfaceGrid grid;
  std::vector<float> mean_cost;  ///< In [0, 1]; x fastest (west to east), then y (south to north),
                                 ///< then yaw (clockwise end first).

  [[nodiscard]] Rigid2 pose(int ix, int iy, int iyaw) const;
  [[nodiscard]] float at(int ix, int iy, int iyaw) const {
    return mean_cost[(static_cast<std::size_t>(iyaw) * static_cast<std::size_t>(grid.count_y) +
                      static_cast<std::size_t>(iy)) *
                         static_cast<std::size_t>(grid.count_x) +
                     static_cast<std::size_t>(ix)];
  }
};

/// Evaluates the same kernel as the weights do: every number is MapMatcher::mean_cost() at its pose. O(poses x cells),
/// parallel; the same numbers on any number of threads and with every instruction set.
/// @errors kInvalidOptions: a count below 1, more than 10^8 poses, a step that is not positive, a
/// topview without usable cells.
[[nodiscard]] Result<ErrorSurface> error_surface(const MapMatcher& matcher,
                                                 const SemanticTopview& seen,
                                                 const Rigid2& centre_in_enu,
                                                 const ErrorSurfaceGrid& grid = {});

}  // namespace nadir
