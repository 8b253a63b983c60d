// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "core/label/label_grid.h"
#include "core/label/label_object.h"

namespace nadir {

/// Which cells a shape claims. Private to this module. Shapes are in cells, x right and y down; all is computed from those
/// alone, never from the window, so that windows agree.

/// Takes the cells [from, to) of a row, all within the window. A cell may come more than once.
using TakeCells = std::function<void(std::int64_t row, std::int64_t from, std::int64_t to)>;

/// Inside of rings by the even-odd rule at the centres of cells; see rasterise() for centres on the border.
/// O(places + rows crossed).
void fill_rings(std::span<const Ring> rings_in_cells,
                const CellRect& window,
                const TakeCells& take);

/// Within `reach` (cells, > 0) of a polyline: of its segments across, and of its inner places all around. Where it is
/// closed all places are inner ones.
void fill_stroke(const Ring& line_in_cells,
                 bool is_closed,
                 double reach,
                 const CellRect& window,
                 const TakeCells& take);

/// The cells that a polyline passes: of every segment one a column, or a row where it is steeper, and those of all places.
/// They hang together, at corners too.
void fill_path(const Ring& line_in_cells,
               bool is_closed,
               const CellRect& window,
               const TakeCells& take);

/// Twice the area inside of closed rings by the length around them: the mean width of what is long and thin.
[[nodiscard]] double mean_width(std::span<const Ring> rings);
[[nodiscard]] double path_length(const Ring& line);

}  // namespace nadir
