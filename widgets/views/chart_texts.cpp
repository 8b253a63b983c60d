// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/chart_texts.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace nadir {
namespace {

constexpr std::string_view kEllipsis = "…";
constexpr std::size_t kMostNameLines = 3;
constexpr double kLeastName = 3.0;  ///< Narrowest room for a name, in text sizes.

double width_of(const std::string& text, const TextStyle& style) {
  return text.empty() ? 0.0 : measure_text(text, style).width;
}

/// Broken at spaces so that no line is longer than it may be; a single word may be.
std::vector<std::string> broken(const std::string& text, const TextStyle& style, double most_px) {
  std::vector<std::string> lines;
  for (const std::string& word : parts_of(text, ' ')) {
    if (!lines.empty() && width_of(lines.back() + " " + word, style) <= most_px) {
      lines.back() += " " + word;
    } else {
      lines.push_back(word);
    }
  }
  return lines;
}

void drop_last_letter(std::string& text) {
  const auto is_inside_letter = [&text] {
    return !text.empty() && (static_cast<unsigned char>(text.back()) & 0xC0U) == 0x80U;
  };
  while (is_inside_letter()) text.pop_back();
  if (!text.empty()) text.pop_back();
}

/// Ends in an ellipsis, cut until it is no wider than it may be.
std::string shortened(std::string text, const TextStyle& style, double most_px) {
  while (!text.empty() && width_of(text + std::string(kEllipsis), style) > most_px) {
    drop_last_letter(text);
  }
  return text + std::string(kEllipsis);
}

std::string name_below(const std::string& group, const TextStyle& style, double most_px) {
  std::vector<std::string> lines = broken(group, style, most_px);
  if (lines.size() > kMostNameLines) {
    lines.resize(kMostNameLines);
    lines.back() = shortened(lines.back(), style, most_px);
  }
  std::string name;
  for (const std::string& line : lines) {
    const bool is_wide = width_of(line, style) > most_px;
    name += (name.empty() ? "" : "\n") + (is_wide ? shortened(line, style, most_px) : line);
  }
  return name;
}

}  // namespace

std::vector<std::string> parts_of(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) {
    if (!part.empty()) parts.push_back(part);
  }
  return parts;
}

double widest_of(const std::vector<std::string>& lines, const TextStyle& style) {
  double width = 0.0;
  for (const std::string& line : lines) width = std::max(width, width_of(line, style));
  return width;
}

double height_of(const std::vector<std::string>& lines, const TextStyle& style) {
  if (lines.empty()) return 0.0;
  const TextExtent extent = measure_text("Hg", style);
  return extent.cap_height + extent.descent +
         kChartLineSpacing * style.size_px * static_cast<double>(lines.size() - 1);
}

std::vector<std::string> title_lines(const std::string& title,
                                     const TextStyle& style,
                                     double most_px,
                                     std::size_t most_lines) {
  const bool has_unit = title.find('[') != std::string::npos;
  std::string said = title;
  while (!said.empty()) {
    std::vector<std::string> lines = broken(said, style, most_px);
    if (lines.size() <= most_lines && widest_of(lines, style) <= most_px) return lines;
    const std::size_t space = said.find(' ');
    const bool is_unit_next = has_unit && space != std::string::npos && said.front() != '[';
    if (!is_unit_next) break;
    said.erase(0, space + 1);
  }
  return {};
}

Ticks group_ticks(const BarsSpec& bars, const TextStyle& style, double group_px) {
  Ticks ticks;
  const double least_px = kLeastName * style.size_px;
  const double wanted = std::ceil(least_px / std::max(group_px, 1e-3 * least_px));
  const auto stride = static_cast<std::size_t>(std::max(1.0, wanted));
  const double gap_px = 0.4 * style.size_px;
  const double most_px = static_cast<double>(stride) * group_px - gap_px;
  bool is_whole = stride == 1;
  for (std::size_t i = 0; i < bars.groups.size(); i += stride) {
    ticks.at.push_back(static_cast<double>(i));
    ticks.labels.push_back(name_below(bars.groups[i], style, most_px));
    is_whole = is_whole && ticks.labels.back().find(kEllipsis) == std::string::npos;
  }
  // Names on lines of their own have the room of their neighbours too, but the first must not come below the other axis.
  const double widest_px = widest_of(bars.groups, style);
  const bool has_room =
      !bars.groups.empty() && width_of(bars.groups.front(), style) <= 1.5 * group_px;
  for (std::size_t lines = 2; !is_whole && has_room && lines <= kMostNameLines; ++lines) {
    if (widest_px > static_cast<double>(lines) * group_px - gap_px) continue;
    ticks = {};
    for (std::size_t i = 0; i < bars.groups.size(); ++i) {
      ticks.at.push_back(static_cast<double>(i));
      std::string& label = ticks.labels.emplace_back();
      for (std::size_t line = 0; line < i % lines; ++line) label += " \n";
      label += bars.groups[i];
    }
    break;
  }
  return ticks;
}

TextStyle style_for(const std::vector<std::string>& labels, TextStyle style) {
  const bool has_raised_minus =
      std::any_of(labels.begin(), labels.end(),
                  [](const std::string& label) { return label.find("⁻") != std::string::npos; });
  if (has_raised_minus) style.face = FontFace::kText;
  return style;
}

}  // namespace nadir
