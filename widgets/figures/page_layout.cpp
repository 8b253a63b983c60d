// SPDX-License-Identifier: Apache-2.0
#include "widgets/figures/page_layout.h"

#include <numeric>
#include <sstream>

#include "core/base/require.h"

namespace nadir {
namespace {

constexpr double kMarginPt = 8.0;
constexpr double kFootTextPt = 7.5;
constexpr double kCaptionTextPt = 9.0;

TextStyle style_of(const PageFormat& format, double size_pt, Rgba colour) {
  TextStyle style;
  style.size_px = size_pt * format.px_per_pt();
  style.colour = colour;
  return style;
}

std::vector<std::pair<double, double>> cut(double length,
                                           const std::vector<double>& shares,
                                           double gap) {
  NADIR_REQUIRE(!shares.empty());
  const double whole = std::accumulate(shares.begin(), shares.end(), 0.0);
  const double room = length - gap * static_cast<double>(shares.size() - 1);
  std::vector<std::pair<double, double>> pieces;
  double at = 0.0;
  for (const double share : shares) {
    const double piece = std::max(0.0, room) * share / whole;
    pieces.emplace_back(at, piece);
    at += piece + gap;
  }
  return pieces;
}

}  // namespace

PageRect page_inside(const PageFormat& format) {
  const double margin = kMarginPt * format.px_per_pt();
  return {margin, margin, format.width - 2.0 * margin, format.height - 2.0 * margin};
}

PageRect take_top(PageRect& rest, double height, double gap) {
  const PageRect strip{rest.left, rest.top() - height, rest.width, height};
  rest.height = std::max(0.0, rest.height - height - gap);
  return strip;
}

PageRect take_bottom(PageRect& rest, double height, double gap) {
  const PageRect strip{rest.left, rest.bottom, rest.width, height};
  rest.height = std::max(0.0, rest.height - height - gap);
  rest.bottom += height + gap;
  return strip;
}

std::vector<PageRect> columns(const PageRect& whole,
                              const std::vector<double>& shares,
                              double gap) {
  std::vector<PageRect> made;
  for (const auto& [at, width] : cut(whole.width, shares, gap)) {
    made.push_back({whole.left + at, whole.bottom, width, whole.height});
  }
  return made;
}

std::vector<PageRect> rows(const PageRect& whole, const std::vector<double>& shares, double gap) {
  std::vector<PageRect> made;
  for (const auto& [at, height] : cut(whole.height, shares, gap)) {
    made.push_back({whole.left, whole.top() - at - height, whole.width, height});
  }
  return made;
}

std::vector<std::string> broken_to(const std::string& text,
                                   const TextStyle& style,
                                   double width_px) {
  std::vector<std::string> lines;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (!lines.empty() && measure_text(lines.back() + " " + word, style).width <= width_px) {
      lines.back() += " " + word;
    } else {
      lines.push_back(word);
    }
  }
  return lines;
}

void draw_foot(Canvas& canvas, const PageFormat& format, PageRect& rest, const std::string& text) {
  const double px = format.px_per_pt();
  const TextStyle style = style_of(format, kFootTextPt, format.colours().muted);
  const std::vector<std::string> lines = broken_to(text, style, rest.width);
  const double line_height = 1.35 * style.size_px;
  const PageRect strip =
      take_bottom(rest, line_height * static_cast<double>(lines.size()), 5.0 * px);
  double baseline = strip.top() - style.size_px;
  for (const std::string& line : lines) {
    canvas.text({strip.left, baseline}, line, style);
    baseline -= line_height;
  }
}

void draw_caption(Canvas& canvas,
                  const PageFormat& format,
                  PageRect& panel,
                  const std::string& text) {
  const double px = format.px_per_pt();
  TextStyle style = style_of(format, kCaptionTextPt, format.colours().text);
  const PageRect strip = take_top(panel, 12.0 * px, 2.0 * px);
  // Smaller where it would reach into the next panel.
  const double width = measure_text(text, style).width;
  if (width > strip.width) style.size_px *= strip.width / width;
  canvas.text({strip.left, strip.bottom + 3.0 * px}, text, style);
}

void draw_page_legend(Canvas& canvas,
                      const PageFormat& format,
                      PageRect& rest,
                      std::span<const LegendEntry> entries) {
  const double px = format.px_per_pt();
  const double height = legend_height(rest.width, entries, px);
  const PageRect strip = take_top(rest, height, height > 0.0 ? 4.0 * px : 0.0);
  draw_legend(canvas, strip, entries, format.colours(), px);
}

void draw_frame(Canvas& canvas, const PageFormat& format, const PageRect& panel) {
  const std::array<Eigen::Vector2d, 5> outline = {
      Eigen::Vector2d(panel.left, panel.bottom), Eigen::Vector2d(panel.right(), panel.bottom),
      Eigen::Vector2d(panel.right(), panel.top()), Eigen::Vector2d(panel.left, panel.top()),
      Eigen::Vector2d(panel.left, panel.bottom)};
  canvas.stroke(outline, {format.colours().line, 0.75 * format.px_per_pt()});
}

void draw_message(Canvas& canvas,
                  const PageFormat& format,
                  const PageRect& panel,
                  const std::string& text) {
  TextStyle style = style_of(format, 9.0, format.colours().muted);
  style.align = TextAlign::kCentre;
  const std::vector<std::string> lines = broken_to(text, style, 0.9 * panel.width);
  const double line_height = 1.35 * style.size_px;
  double baseline =
      panel.centre().y() + line_height * (static_cast<double>(lines.size()) / 2.0 - 1.0);
  for (const std::string& line : lines) {
    canvas.text({panel.centre().x(), baseline}, line, style);
    baseline -= line_height;
  }
}

}  // namespace nadir
