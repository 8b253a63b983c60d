// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "widgets/figures/page.h"
#include "widgets/views/legend.h"
#include "widgets/views/xy_chart.h"

namespace nadir {

struct CaptionedChart {
  std::string caption;
  ChartSpec chart;
};

/// Draws charts in a grid, from the left and from the top, each below its caption. Charts one above the other begin at
/// the same place.
void draw_charts(Canvas& canvas,
                 const PageFormat& format,
                 const PageRect& where,
                 std::span<const CaptionedChart> charts,
                 std::size_t columns_wanted);

/// Everything that has a name in some of the charts, once.
[[nodiscard]] std::vector<LegendEntry> legend_of_all(std::span<const CaptionedChart> charts);

}  // namespace nadir
