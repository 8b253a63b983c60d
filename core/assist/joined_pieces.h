// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/assist/superpixels.h"

namespace nadir {

/// What hangs together by sides of each value of a raster, but kNoSuperpixel; pieces of fewer than `least_pixels`, the
/// smallest first, join the neighbour whose mean colour is nearest to theirs, while they have one. Numbered in the order of
/// their first pixels. Private to this module.
[[nodiscard]] Superpixels joined_pieces(const AssistWindow& window,
                                        const Raster<SuperpixelId>& values,
                                        int least_pixels);

}  // namespace nadir
