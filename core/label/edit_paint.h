// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "core/base/result.h"
#include "core/label/label_document.h"

namespace nadir {

/// Gestures that paint. Each gives the edit of one step, which is empty where nothing changes; none changes anything itself.
/// Only cells of the document's grid are painted. kNoPaint erases.

/// A stroke of a round brush: the cells whose centre is within its radius of a path, and the cell under a path that is a
/// single place. O(cells + tiles).
/// @param path_in_enu_m  Not empty. @param radius_m  > 0.
[[nodiscard]] LabelEdit paint_stroke(const LabelDocument& document,
                                     const Ring& path_in_enu_m,
                                     double radius_m,
                                     PaintValue value,
                                     std::string title);

/// The cells that rings surround, as rasterise() has areas.
[[nodiscard]] LabelEdit paint_rings(const LabelDocument& document,
                                    const std::vector<Ring>& rings_in_enu_m,
                                    PaintValue value,
                                    std::string title);

/// More cells than these are not filled at once: somebody has missed a gap in a border.
inline constexpr std::int64_t kMostFilledCells = 16'000'000;
/// The cells of one class that hang together by their sides with the one under a place, as the document's raster shows them.
/// @errors kInvalidOptions: the place is outside of the grid; there are more than kMostFilledCells.
[[nodiscard]] Result<LabelEdit> flood_fill(const LabelDocument& document,
                                           const Eigen::Vector2d& at_in_enu_m,
                                           PaintValue value,
                                           std::string title);

}  // namespace nadir
