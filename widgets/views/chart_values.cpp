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

/// Where bars stand between the ends of a group, pixels of the page.
struct BarPlaces {
  BarPlaces(const BarsSpec& bars, const ChartLayout& layout)
      : group_px(layout.plot.width / layout.x.span()),
        width(kBarsShare * group_px / static_cast<double>(bars.series.size())),
        first(layout.plot.left - layout.x.low * group_px - kBarsShare * group_px / 2.0) {}
  [[nodiscard]] double left(std::size_t group, std::size_t series) const {
    return first + static_cast<double>(group) * group_px + static_cast<double>(series) * width;
  }
  double group_px, width, first;
};

}  // namespace

std::vector<Eigen::Vector2d> missing_bars(const BarsSpec& bars,
                                          const ChartLayout& layout,
                                          const TextStyle& style) {
  const BarPlaces places(bars, layout);
  std::vector<Eigen::Vector2d> missing;
  if (measure_text(kNoBar, style).width > places.width) return missing;
  for (std::size_t g = 0; g < bars.groups.size(); ++g) {
    for (std::size_t s = 0; s < bars.series.size(); ++s) {
      const std::vector<double>& heights = bars.series[s].heights;
      if (g < heights.size() && std::isfinite(heights[g])) continue;
      missing.emplace_back(places.left(g, s) + places.width / 2.0,
                           layout.plot.bottom + kGapShare * style.size_px);
    }
  }
  return missing;
}

std::vector<BarValue> bar_values(const BarsSpec& bars,
                                 const ChartLayout& layout,
                                 const TextStyle& style) {
  const PageRect& plot = layout.plot;
  const BarPlaces places(bars, layout);
  const double width = places.width;
  const double cap_height = measure_text("0", style).cap_height;
  std::vector<BarValue> values;
  std::vector<PageRect> texts;
  for (std::size_t g = 0; g < bars.groups.size(); ++g) {
    for (std::size_t s = 0; s < bars.series.size(); ++s) {
      const std::vector<double>& heights = bars.series[s].heights;
      const double value = g < heights.size() ? heights[g] : 0.0;
      const double plotted = layout.scale.plotted(value);
      if (!(value > 0.0) || !std::isfinite(plotted)) continue;
      BarValue made{{places.left(g, s), plot.bottom, width,
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
