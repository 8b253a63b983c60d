// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/assist/pixel_mask.h"

namespace nadir {

struct WandOptions {
  double tolerance = 12.0;
  double edge_stop = 0.0;
  PixelNeighbours neighbours = PixelNeighbours::kFour;
  double fill_holes_m2 = 0.0;
  friend bool operator==(const WandOptions&, const WandOptions&) = default;
};
template <typename Options, typename Visitor>
void visit_fields(Options& options, Visitor&& visit) requires
    std::is_same_v<std::remove_const_t<Options>, WandOptions> {
  visit(options.tolerance,
        Field{"wand-tolerance", "dE", "How far colours may be from the one that was clicked", 0.0,
              150.0});
  visit(options.edge_stop,
        Field{"wand-edge-stop", "dE",
              "Neighbours that differ by more do not hang together; 0: all do", 0.0, 150.0});
  visit(options.neighbours,
        Field{"wand-neighbours", "", "Neighbours of a pixel: sides, or corners too"});
  visit(options.fill_holes_m2,
        Field{"wand-fill-holes", "m2", "Holes of at most that size are filled", 0.0, 1e6});
}

/// The pixels that hang together with the one at a place and whose colour is within `tolerance` of it, as CIE 1976
/// differences; the colour is the mean of the 3 x 3 pixels around it. The pixel itself always belongs. O(pixels).
/// @errors kInvalidOptions: the place is outside of the window, nothing was seen there, an option out of its range.
[[nodiscard]] Result<PixelMask> magic_wand(const AssistWindow& window,
                                           const Eigen::Vector2d& at_in_enu_m,
                                           const WandOptions& options = {});

}  // namespace nadir
