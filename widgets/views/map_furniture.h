// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "widgets/views/map_overlays.h"
#include "widgets/views/theme.h"

namespace nadir {

/// What tells a reader of a map how large it is and where: quiet, at the border, over any ground.

inline constexpr double kScaleBarTextPt = 8.0;

/// A bar of a round length (1, 2 or 5 times a power of ten, at most a quarter of the map's width) at the lower left, on a
/// plate with its length.
void draw_scale_bar(Canvas& canvas, const MapFrame& frame, const Theme& theme);

/// An arrow to the north of the project plane at the upper right.
void draw_north_arrow(Canvas& canvas, const MapFrame& frame, const Theme& theme);

/// The largest of 1, 2, 5 times a power of ten that is at most `largest`.
[[nodiscard]] double round_length(double largest);

}  // namespace nadir
