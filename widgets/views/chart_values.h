// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "widgets/views/chart_layout.h"

namespace nadir {

/// How wide all bars of a group are together, as a share of the distance between groups.
inline constexpr double kBarsShare = 0.7;

/// A bar as it is drawn, pixels of the page, and its height in words above it.
struct BarValue {
  PageRect bar;
  std::string text;
  Eigen::Vector2d baseline;  ///< Middle of the text.
};

/// The values above all bars, in a size that can be read; none where one of them would leave the plot area, touch another
/// or cover a bar.
[[nodiscard]] std::vector<BarValue> bar_values(const BarsSpec& bars,
                                               const ChartLayout& layout,
                                               const TextStyle& style);

/// What stands where a bar would, were its height known: a bar of height 0 is something else.
inline constexpr const char* kNoBar = "–";
/// The middles of those dashes, on their baselines; none where bars are narrower than a dash.
[[nodiscard]] std::vector<Eigen::Vector2d> missing_bars(const BarsSpec& bars,
                                                        const ChartLayout& layout,
                                                        const TextStyle& style);

}  // namespace nadir
