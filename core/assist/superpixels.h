// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <vector>

#include "core/assist/pixel_mask.h"

namespace nadir {

struct SuperpixelOptions {
  double side_px = 16.0;
  double compactness = 10.0;
  int iterations = 10;
  friend bool operator==(const SuperpixelOptions&, const SuperpixelOptions&) = default;
};
template <typename Options, typename Visitor>
void visit_fields(Options& options, Visitor&& visit) requires
    std::is_same_v<std::remove_const_t<Options>, SuperpixelOptions> {
  visit(options.side_px,
        Field{"superpixel-side", "px", "How long and wide a superpixel is, about", 3.0, 200.0});
  visit(
      options.compactness,
      Field{"superpixel-compactness", "dE",
            "Colour difference that counts as much as the way to the next superpixel", 0.5, 100.0});
  visit(options.iterations,
        Field{"superpixel-iterations", "", "Times that pixels look for the nearest one", 1, 50});
}

/// Number of a superpixel in its window, from 0.
using SuperpixelId = std::int32_t;
/// Of a pixel where nothing was seen.
inline constexpr SuperpixelId kNoSuperpixel = -1;

/// A window cut into pieces of one colour, each of which hangs together by sides. Every pixel that was seen is in one.
struct Superpixels {
  Raster<SuperpixelId> of_pixel;
  int count = 0;
};

/// SLIC: k-means over place and CIE L*a*b* colour, each centre looking no farther than its neighbours (Achanta et al., "SLIC
/// Superpixels Compared to State-of-the-art Superpixel Methods", TPAMI 34(11), 2012, algorithm 1). Pieces smaller than a
/// quarter of a superpixel join the neighbour of the nearest colour. The same on any number of threads. O(pixels).
/// @errors kInvalidOptions: an option out of its range.
[[nodiscard]] Result<Superpixels> find_superpixels(const AssistWindow& window,
                                                   const SuperpixelOptions& options = {});

/// The one at a place; nothing outside of the window and where nothing was seen.
[[nodiscard]] std::optional<SuperpixelId> superpixel_at(const Superpixels& superpixels,
                                                        const AssistWindow& window,
                                                        const Eigen::Vector2d& at_in_enu_m);
/// All that the hand has been in on a straight way, so that a fast one leaves none out.
[[nodiscard]] std::set<SuperpixelId> superpixels_along(const Superpixels& superpixels,
                                                       const AssistWindow& window,
                                                       const Eigen::Vector2d& from_in_enu_m,
                                                       const Eigen::Vector2d& to_in_enu_m);
/// The pixels of those that were chosen.
[[nodiscard]] PixelMask mask_of(const Superpixels& superpixels,
                                const std::set<SuperpixelId>& chosen);

}  // namespace nadir
