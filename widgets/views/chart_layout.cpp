// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/chart_layout.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "core/base/require.h"

namespace nadir {
namespace {

constexpr double kLabelPt = 8.0;
constexpr double kTitlePt = 9.0;
constexpr double kLineSpacing =
    1.3;  ///< From baseline to baseline, in text sizes; CanvasDevice's too.
constexpr double kRoomyLines = 1.6;  ///< Labels above each other: text sizes from one to the next.
constexpr double kTightLines = 1.15;
constexpr double kLeastPlotPx = 4.0;
constexpr double kSmallestText = 0.65;  ///< Of the usual size.

TextExtent measure(const std::string& text, const TextStyle& style) {
  return text.empty() ? TextExtent{} : measure_text(text, style);
}

std::vector<std::string> words_of(const std::string& text, char separator) {
  std::vector<std::string> words;
  std::istringstream stream(text);
  for (std::string word; std::getline(stream, word, separator);) {
    if (!word.empty()) words.push_back(word);
  }
  return words;
}

double widest(const std::vector<std::string>& lines, const TextStyle& style) {
  double width = 0.0;
  for (const std::string& line : lines) width = std::max(width, measure(line, style).width);
  return width;
}

/// Broken at spaces so that no line is longer than it may be; a single word may be.
std::vector<std::string> broken(const std::string& text, const TextStyle& style, double most_px) {
  std::vector<std::string> lines;
  for (const std::string& word : words_of(text, ' ')) {
    if (!lines.empty() && measure(lines.back() + " " + word, style).width <= most_px) {
      lines.back() += " " + word;
    } else {
      lines.push_back(word);
    }
  }
  return lines;
}

/// Smaller until the longest word has room.
TextStyle fitting_style(const std::string& text, TextStyle style, double most_px) {
  const double width = widest(words_of(text, ' '), style);
  if (width > most_px && width > 0.0) {
    style.size_px = std::floor(style.size_px * std::max(kSmallestText, most_px / width));
  }
  return style;
}

double height_of(const std::vector<std::string>& lines, const TextStyle& style) {
  if (lines.empty()) return 0.0;
  const TextExtent extent = measure("Hg", style);
  return extent.cap_height + extent.descent +
         kLineSpacing * style.size_px * static_cast<double>(lines.size() - 1);
}

double position_px(double at, const AxisRange& range, double length_px) {
  return (at - range.low) / range.span() * length_px;
}

TicksFit beside_each_other(const AxisRange& range, double length_px, const TextStyle& style) {
  return [=](const Ticks& ticks) {
    const double gap = 0.8 * style.size_px;
    double last_end = -1e9;
    for (std::size_t i = 0; i < ticks.at.size(); ++i) {
      const double half = measure(ticks.labels[i], style).width / 2.0;
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

/// Cut at the end, with an ellipsis, until it is no wider than it may be.
std::string shortened(const std::string& text, const TextStyle& style, double most_px) {
  std::string cut = text;
  while (!cut.empty() && measure(cut + "…", style).width > most_px) {
    while (!cut.empty() && (static_cast<unsigned char>(cut.back()) & 0xC0U) == 0x80U)
      cut.pop_back();
    if (!cut.empty()) cut.pop_back();
  }
  return cut + "…";
}

/// Names below the bars: smaller, then broken, then cut where they are wider than their group.
Ticks group_ticks(const BarsSpec& bars, TextStyle& style, double group_px) {
  const double most_px = std::max(1.0, group_px - 0.4 * style.size_px);
  double smallest = style.size_px;
  for (const std::string& group : bars.groups) {
    smallest = std::min(smallest, fitting_style(group, style, most_px).size_px);
  }
  style.size_px = smallest;
  Ticks ticks;
  for (std::size_t i = 0; i < bars.groups.size(); ++i) {
    std::string label;
    for (const std::string& line : broken(bars.groups[i], style, most_px)) {
      const bool is_wide = measure(line, style).width > most_px;
      label += (label.empty() ? "" : "\n") + (is_wide ? shortened(line, style, most_px) : line);
    }
    ticks.at.push_back(static_cast<double>(i));
    ticks.labels.push_back(label);
  }
  return ticks;
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

/// Texts and ticks for a plot area of that size.
void fill_axes(ChartLayout& layout, const ChartSpec& spec, const ChartType& type) {
  const PageRect& plot = layout.plot;
  layout.x_label_style = type.x_label;
  if (spec.bars) {
    layout.x_ticks = group_ticks(*spec.bars, layout.x_label_style, plot.width / layout.x.span());
  } else {
    layout.x_ticks = round_ticks(layout.x, is_in_seconds(spec.x),
                                 beside_each_other(layout.x, plot.width, type.x_label));
  }
  layout.y_ticks = value_ticks(layout, spec.y, kRoomyLines * type.y_label.size_px);
  if (layout.y_ticks.at.size() < 2) {  // a strip: one number alone gives no scale
    layout.y_ticks = value_ticks(layout, spec.y, kTightLines * type.y_label.size_px);
  }
  layout.x_title_style = fitting_style(spec.x.title, type.title, plot.width);
  layout.y_title_style = fitting_style(spec.y.title, type.title, plot.height);
  layout.y_title_style.rotation_deg = 90.0;
  layout.x_title = broken(spec.x.title, layout.x_title_style, plot.width);
  layout.y_title = broken(spec.y.title, layout.y_title_style, plot.height);
}

/// What the texts of a layout need beside the plot area.
Margins margins_for(const ChartLayout& layout, const ChartType& type) {
  Margins margins;
  const double half_line = type.line_px / 2.0;
  margins.left = half_line + type.label_gap_px + widest(layout.y_ticks.labels, type.y_label);
  if (!layout.y_title.empty()) {
    margins.left += type.title_gap_px + height_of(layout.y_title, layout.y_title_style);
  }
  std::size_t lines = 0;
  double overhang = 0.0;
  for (std::size_t i = 0; i < layout.x_ticks.at.size(); ++i) {
    const auto label = words_of(layout.x_ticks.labels[i], '\n');
    lines = std::max(lines, label.size());
    const double end = position_px(layout.x_ticks.at[i], layout.x, layout.plot.width) +
                       widest(label, layout.x_label_style) / 2.0;
    overhang = std::max(overhang, end - layout.plot.width);
  }
  margins.right = std::max(type.line_px, std::ceil(overhang) + 1.0);
  margins.bottom = half_line + type.label_gap_px +
                   height_of(std::vector<std::string>(lines, "0"), layout.x_label_style);
  if (!layout.x_title.empty()) {
    margins.bottom += type.title_gap_px + height_of(layout.x_title, layout.x_title_style);
  }
  margins.top = std::ceil(measure("0", type.y_label).cap_height / 2.0) + 1.0;
  return margins;
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
}

ChartLayout lay_out(const ChartSpec& spec, const ChartType& type, const PageRect& where) {
  NADIR_REQUIRE(where.width > 0.0 && where.height > 0.0 && spec.left_margin_px >= 0.0);
  ChartLayout layout;
  layout.x = x_range_of(spec);
  layout.y = y_range_of(spec);
  if (spec.bars && spec.bars->is_logarithmic) {
    layout.scale = {true, std::log10(layout.y.low)};
    layout.y = {0.0, std::log10(layout.y.high) - layout.scale.log10_at_low};
  }
  // Labels depend on the room for the plot, and that on the labels: margins grow until they are enough.
  Margins margins;
  for (int round = 0; round < 6; ++round) {
    layout.plot = plot_area(where, margins);
    fill_axes(layout, spec, type);
    Margins needed = margins_for(layout, type);
    if (spec.left_margin_px > 0.0) needed.left = spec.left_margin_px;
    const Margins grown = margins.or_more(needed);
    if (grown == margins) break;
    margins = grown;
  }
  return layout;
}

}  // namespace nadir
