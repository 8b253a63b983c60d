// SPDX-License-Identifier: Apache-2.0
#include "widgets/figures/chart_panel.h"

#include <algorithm>

#include "widgets/figures/page_layout.h"

namespace nadir {

void draw_charts(Canvas& canvas,
                 const PageFormat& format,
                 const PageRect& where,
                 std::span<const CaptionedChart> charts,
                 std::size_t columns_wanted) {
  const double px = format.px_per_pt();
  const std::size_t across = std::max<std::size_t>(1, std::min(columns_wanted, charts.size()));
  const std::size_t down = (charts.size() + across - 1) / across;
  const auto strips = rows(where, std::vector<double>(down, 1.0), 8.0 * px);
  std::vector<PageRect> panels;
  double left_margin_px = 0.0;
  for (std::size_t i = 0; i < charts.size(); ++i) {
    PageRect panel =
        columns(strips[i / across], std::vector<double>(across, 1.0), 12.0 * px)[i % across];
    if (!charts[i].caption.empty()) draw_caption(canvas, format, panel, charts[i].caption);
    const XyChart chart(charts[i].chart, format.colours(), px);
    left_margin_px = std::max(left_margin_px, chart.needed_left_margin_px(panel));
    panels.push_back(panel);
  }
  for (std::size_t i = 0; i < charts.size(); ++i) {
    ChartSpec spec = charts[i].chart;
    if (down > 1) spec.left_margin_px = left_margin_px;
    XyChart(std::move(spec), format.colours(), px)
        .draw(canvas, panels[i], format.width, format.height);
  }
}

std::vector<LegendEntry> legend_of_all(std::span<const CaptionedChart> charts) {
  std::vector<LegendEntry> entries;
  for (const CaptionedChart& captioned : charts) {
    for (const LegendEntry& entry : legend_of(captioned.chart)) {
      if (std::find(entries.begin(), entries.end(), entry) == entries.end()) {
        entries.push_back(entry);
      }
    }
  }
  return entries;
}

}  // namespace nadir
