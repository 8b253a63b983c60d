// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/chart_layout.h"

#include <algorithm>
#include <cmath>

#include "core/base/require.h"
#include "widgets/views/chart_texts.h"

namespace nadir {
namespace {

constexpr double kLabelPt = 8.0;
constexpr double kTitlePt = 9.0;
constexpr double kLeastChartPt = 24.0;
constexpr double kLeastWidth = 0.5;  ///< Of the plot area, as a share of the chart.
constexpr double kLeastHeight = 0.45;
constexpr double kRoomyLines = 1.6;  ///< Labels above each other: text sizes from one to the next.
constexpr double kTightLines = 1.15;
constexpr double kLeastPlotPx = 4.0;

/// What is written beside an axis, from much to little.
enum class AxisWords { kTwoTitleLines, kOneTitleLine, kLabels, kNothing };

AxisWords fewer(AxisWords words) {
  return static_cast<AxisWords>(
      std::min(static_cast<int>(AxisWords::kNothing), static_cast<int>(words) + 1));
}

std::size_t most_title_lines(AxisWords words) {
  if (words == AxisWords::kTwoTitleLines) return 2;
  return words == AxisWords::kOneTitleLine ? 1 : 0;
}

struct ChartWords {
  AxisWords x = AxisWords::kTwoTitleLines;
  AxisWords y = AxisWords::kTwoTitleLines;
};

double position_px(double at, const AxisRange& range, double length_px) {
  return (at - range.low) / range.span() * length_px;
}

TicksFit beside_each_other(const AxisRange& range, double length_px, const TextStyle& usual) {
  return [=](const Ticks& ticks) {
    const TextStyle style = style_for(ticks.labels, usual);
    const double gap = 0.8 * style.size_px;
    double last_end = -1e9;
    for (std::size_t i = 0; i < ticks.at.size(); ++i) {
      const double half = measure_text(ticks.labels[i], style).width / 2.0;
      const double centre = position_px(ticks.at[i], range, length_px);
      if (centre - half < last_end + gap) return false;
      last_end = centre + half;
    }
    return true;
  };
}

TicksFit above_each_other(const AxisRange& range, double length_px, double least_px) {
  return [=](const Ticks& ticks) {
    for (std::size_t i = 1; i < ticks.at.size(); ++i) {
      const double distance = (ticks.at[i] - ticks.at[i - 1]) / range.span() * length_px;
      if (distance < least_px) return false;
    }
    return true;
  };
}

struct Margins {
  double left = 0.0, right = 0.0, bottom = 0.0, top = 0.0;
  friend bool operator==(const Margins&, const Margins&) = default;
  [[nodiscard]] Margins or_more(const Margins& other) const {
    return {std::max(left, other.left), std::max(right, other.right),
            std::max(bottom, other.bottom), std::max(top, other.top)};
  }
};

/// Whole pixels, because VTK cuts its own down.
PageRect plot_area(const PageRect& where, const Margins& margins) {
  const double left = std::round(where.left + margins.left);
  const double bottom = std::round(where.bottom + margins.bottom);
  const double right = std::floor(where.right() - margins.right);
  const double top = std::floor(where.top() - margins.top);
  return {left, bottom, std::max(kLeastPlotPx, right - left), std::max(kLeastPlotPx, top - bottom)};
}

bool is_in_seconds(const AxisSpec& axis) { return axis.title.find("[s]") != std::string::npos; }

/// Ticks of the y axis, so many pixels apart or more.
Ticks value_ticks(const ChartLayout& layout, const AxisSpec& axis, double least_px) {
  const TicksFit fit = above_each_other(layout.y, layout.plot.height, least_px);
  if (!layout.scale.is_logarithmic) return round_ticks(layout.y, is_in_seconds(axis), fit);
  const double low = std::pow(10.0, layout.scale.log10_at_low);
  const double high = std::pow(10.0, layout.scale.log10_at_low + layout.y.high);
  Ticks ticks = logarithmic_ticks({low, high}, fit);
  for (double& at : ticks.at) {
    at = std::clamp(at - layout.scale.log10_at_low, layout.y.low, layout.y.high);
  }
  return ticks;
}

Ticks x_ticks(const ChartLayout& layout, const ChartSpec& spec, const ChartType& type) {
  const double width = layout.plot.width;
  if (spec.bars) return group_ticks(*spec.bars, type.x_label, width / layout.x.span());
  Ticks ticks = round_ticks(layout.x, is_in_seconds(spec.x),
                            beside_each_other(layout.x, width, type.x_label));
  // One number alone was not asked whether it fits.
  if (widest_of(ticks.labels, style_for(ticks.labels, type.x_label)) > width) return {};
  return ticks;
}

/// Texts and ticks for a plot area of that size.
void fill_axes(ChartLayout& layout,
               const ChartSpec& spec,
               const ChartType& type,
               const ChartWords& words) {
  const PageRect& plot = layout.plot;
  layout.x_ticks = words.x == AxisWords::kNothing ? Ticks{} : x_ticks(layout, spec, type);
  layout.x_label_style = style_for(layout.x_ticks.labels, type.x_label);
  layout.y_ticks = {};
  if (words.y != AxisWords::kNothing) {
    layout.y_ticks = value_ticks(layout, spec.y, kRoomyLines * type.y_label.size_px);
    if (layout.y_ticks.at.size() < 2) {  // a strip: one number alone gives no scale
      layout.y_ticks = value_ticks(layout, spec.y, kTightLines * type.y_label.size_px);
    }
  }
  layout.y_label_style = style_for(layout.y_ticks.labels, type.y_label);
  layout.x_title = title_lines(spec.x.title, type.title, plot.width, most_title_lines(words.x));
  layout.y_title = title_lines(spec.y.title, type.title, plot.height, most_title_lines(words.y));
}

/// What the texts of a layout need beside the plot area.
Margins margins_for(const ChartLayout& layout, const ChartType& type) {
  Margins margins;
  const double half_line = type.line_px / 2.0;
  const double half_label = std::ceil(measure_text("0", type.y_label).cap_height / 2.0) + 1.0;
  margins.left = type.line_px;
  margins.top = type.line_px;
  margins.bottom = type.line_px;
  if (!layout.y_ticks.at.empty()) {
    margins.left =
        half_line + type.label_gap_px + widest_of(layout.y_ticks.labels, layout.y_label_style);
    margins.top = half_label;
    margins.bottom = half_label;
  }
  if (!layout.y_title.empty()) {
    margins.left += type.title_gap_px + height_of(layout.y_title, layout.y_title_style);
  }
  std::size_t lines = 0;
  double beyond_left = 0.0;
  double beyond_right = 0.0;
  for (std::size_t i = 0; i < layout.x_ticks.at.size(); ++i) {
    const auto label = parts_of(layout.x_ticks.labels[i], '\n');
    lines = std::max(lines, label.size());
    const double half = widest_of(label, layout.x_label_style) / 2.0;
    const double centre = position_px(layout.x_ticks.at[i], layout.x, layout.plot.width);
    beyond_left = std::max(beyond_left, half - centre);
    beyond_right = std::max(beyond_right, centre + half - layout.plot.width);
  }
  margins.left = std::max(margins.left, std::ceil(beyond_left) + 1.0);
  margins.right = std::max(type.line_px, std::ceil(beyond_right) + 1.0);
  if (lines > 0) {
    margins.bottom = std::max(
        margins.bottom, half_line + type.label_gap_px +
                            height_of(std::vector<std::string>(lines, "0"), layout.x_label_style));
  }
  if (!layout.x_title.empty()) {
    margins.bottom += type.title_gap_px + height_of(layout.x_title, type.title);
  }
  return margins;
}

/// Fills the layout with so many words. @returns what they need on the left.
double settle(ChartLayout& layout,
              const ChartSpec& spec,
              const ChartType& type,
              const PageRect& where,
              double asked_left,
              const ChartWords& words) {
  // Labels depend on the room for the plot, and that on the labels: margins grow until they are enough.
  Margins margins;
  double needed_left = 0.0;
  for (int round = 0; round < 6; ++round) {
    layout.plot = plot_area(where, margins);
    fill_axes(layout, spec, type, words);
    Margins needed = margins_for(layout, type);
    needed_left = needed.left;
    if (asked_left > 0.0) needed.left = asked_left;
    const Margins grown = margins.or_more(needed);
    if (grown == margins) break;
    margins = grown;
  }
  return needed_left;
}

}  // namespace

ChartType::ChartType(const Theme& theme, double px_per_pt, bool has_bars) {
  x_label.face = has_bars ? FontFace::kText : FontFace::kNumbers;
  x_label.size_px = std::max(1.0, std::round(kLabelPt * px_per_pt));
  x_label.colour = has_bars ? theme.text : theme.muted;
  x_label.align = TextAlign::kCentre;
  y_label = x_label;
  y_label.face = FontFace::kNumbers;
  y_label.colour = theme.muted;
  y_label.align = TextAlign::kRight;
  title.size_px = std::max(1.0, std::round(kTitlePt * px_per_pt));
  title.colour = theme.text;
  title.align = TextAlign::kCentre;
  tick_px = has_bars ? 0.0 : std::round(2.5 * px_per_pt);
  label_gap_px = std::round(5.0 * px_per_pt);
  title_gap_px = std::round(5.0 * px_per_pt);
  line_px = std::max(1.0, std::round(0.6 * px_per_pt));
  least_px = kLeastChartPt * px_per_pt;
}

ChartLayout lay_out(const ChartSpec& spec, const ChartType& type, const PageRect& where) {
  NADIR_REQUIRE(spec.left_margin_px >= 0.0);
  ChartLayout layout;
  layout.x = x_range_of(spec);
  layout.y = y_range_of(spec);
  if (spec.bars && spec.bars->is_logarithmic) {
    layout.scale = {true, std::log10(layout.y.low)};
    layout.y = {0.0, std::log10(layout.y.high) - layout.scale.log10_at_low};
  }
  layout.x_label_style = type.x_label;
  layout.y_label_style = type.y_label;
  layout.y_title_style = type.title;
  layout.y_title_style.rotation_deg = 90.0;
  if (!(where.width >= type.least_px && where.height >= type.least_px)) {
    layout.is_only_frame = true;
    layout.plot = plot_area(where, {});
    return layout;
  }
  const double least_width = std::max(0.9 * type.least_px, kLeastWidth * where.width);
  const double least_height = std::max(0.8 * type.least_px, kLeastHeight * where.height);
  // A margin that leaves no plot is none that could be asked for.
  const double asked_left =
      spec.left_margin_px <= where.width - least_width ? spec.left_margin_px : 0.0;
  ChartWords words;
  for (;;) {
    const double needed_left = settle(layout, spec, type, where, asked_left, words);
    // With a margin that is asked for, fewer words make no more room, but all of them must fit in.
    const bool is_narrow =
        asked_left > 0.0 ? needed_left > asked_left + 1.0 : layout.plot.width < least_width;
    const bool is_low = layout.plot.height < least_height;
    if (is_narrow && words.y != AxisWords::kNothing) {
      words.y = fewer(words.y);
    } else if ((is_low || is_narrow) && words.x != AxisWords::kNothing) {
      words.x = fewer(words.x);
    } else {
      break;
    }
  }
  return layout;
}

}  // namespace nadir
