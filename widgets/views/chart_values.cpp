// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/chart_values.h"

#include <algorithm>
#include <cmath>

namespace nadir {
namespace {

constexpr double kGapShare = 0.35;  ///< Between a bar and its value, of the size of the text.
constexpr double kApartShare = 0.2;

bool touch(const PageRect& a, const PageRect& b) {
  return a.left < b.right() && b.left < a.right() && a.bottom < b.top() && b.bottom < a.top();
}

}  // namespace

std::vector<BarValue> bar_values(const BarsSpec& bars,
                                 const ChartLayout& layout,
                                 const TextStyle& style) {
  const PageRect& plot = layout.plot;
  const double group_px = plot.width / layout.x.span();
  const double width = kBarsShare * group_px / static_cast<double>(bars.series.size());
  const double cap_height = measure_text("0", style).cap_height;
  std::vector<BarValue> values;
  std::vector<PageRect> texts;
  for (std::size_t g = 0; g < bars.groups.size(); ++g) {
    const double middle = plot.left + (static_cast<double>(g) - layout.x.low) * group_px;
    const double first = middle - kBarsShare * group_px / 2.0;
    for (std::size_t s = 0; s < bars.series.size(); ++s) {
      const std::vector<double>& heights = bars.series[s].heights;
      const double value = g < heights.size() ? heights[g] : 0.0;
      const double plotted = layout.scale.plotted(value);
      if (!(value > 0.0) || !std::isfinite(plotted)) continue;
      BarValue made{{first + static_cast<double>(s) * width, plot.bottom, width,
                     (plotted - layout.y.low) / layout.y.span() * plot.height},
                    short_number(value),
                    {}};
      made.baseline = {made.bar.left + width / 2.0, made.bar.top() + kGapShare * style.size_px};
      const double apart = kApartShare * style.size_px;
      const double text_width = measure_text(made.text, style).width + 2.0 * apart;
      texts.push_back({made.baseline.x() - text_width / 2.0, made.baseline.y() - apart, text_width,
                       cap_height + 2.0 * apart});
      values.push_back(std::move(made));
    }
  }
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const PageRect& text = texts[i];
    const bool is_inside =
        text.left >= plot.left && text.right() <= plot.right() && text.top() <= plot.top();
    const bool hits_bar = std::any_of(values.begin(), values.end(), [&text](const BarValue& other) {
      return touch(text, other.bar);
    });
    const bool hits_text =
        std::any_of(texts.begin(), texts.begin() + static_cast<std::ptrdiff_t>(i),
                    [&text](const PageRect& other) { return touch(text, other); });
    if (!is_inside || hits_bar || hits_text) return {};
  }
  return values;
}

}  // namespace nadir
