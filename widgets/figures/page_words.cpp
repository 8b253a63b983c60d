// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>

#include "widgets/figures/page_layout.h"

namespace nadir {
namespace {

constexpr double kFootTextPt = 7.5;
constexpr double kCaptionTextPt = 9.0;
constexpr double kLineSpacing = 1.35;

TextStyle words_style(const PageFormat& format, double size_pt, Rgba colour) {
  TextStyle style;
  style.size_px = size_pt * format.px_per_pt();
  style.colour = colour;
  return style;
}

/// As many lines as fit, none wider than the room; the last one tells by an ellipsis that there is more.
std::vector<std::string> lines_inside(const std::string& text,
                                      const TextStyle& style,
                                      double width_px,
                                      std::size_t most) {
  std::vector<std::string> lines = broken_to(text, style, width_px);
  if (lines.size() > most) {
    lines.resize(most);
    if (!lines.empty()) {
      const std::string more = lines.back() + "…";
      lines.back() = measure_text(more, style).width <= width_px
                         ? more
                         : shortened_to(lines.back() + " …", style, width_px);
    }
  }
  for (std::string& line : lines) line = shortened_to(line, style, width_px);
  return lines;
}

}  // namespace

void draw_foot(Canvas& canvas, const PageFormat& format, PageRect& rest, const std::string& text) {
  constexpr double kMostShare = 0.25;
  const double gap = 5.0 * format.px_per_pt();
  const TextStyle style = words_style(format, kFootTextPt, format.colours().muted);
  const double line_height = kLineSpacing * style.size_px;
  const auto most =
      static_cast<std::size_t>(std::max(0.0, (kMostShare * rest.height - gap) / line_height));
  const std::vector<std::string> lines = lines_inside(text, style, rest.width, most);
  if (lines.empty()) return;
  const PageRect strip = take_bottom(rest, line_height * static_cast<double>(lines.size()), gap);
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
  constexpr double kLeastCaptionedPt = 42.0;
  constexpr double kLeastTextPt = 7.5;
  const double px = format.px_per_pt();
  if (panel.height < kLeastCaptionedPt * px) return;
  TextStyle style = words_style(format, kCaptionTextPt, format.colours().text);
  const PageRect strip = take_top(panel, (kCaptionPt - 2.0) * px, 2.0 * px);
  // Somewhat smaller, and then cut, where it would reach into the next panel.
  const double width = measure_text(text, style).width;
  if (width > strip.width) {
    style.size_px = std::max(kLeastTextPt * px, style.size_px * strip.width / width);
  }
  const std::string shown = shortened_to(text, style, strip.width);
  if (!shown.empty()) canvas.text({strip.left, strip.bottom + 3.0 * px}, shown, style);
}

void draw_page_legend(Canvas& canvas,
                      const PageFormat& format,
                      PageRect& rest,
                      std::span<const LegendEntry> entries) {
  constexpr double kMostShare = 1.0 / 3.0;
  constexpr double kTextPt = 8.5;     // as draw_legend() writes
  constexpr double kSamplePt = 20.0;  // with the gap behind it
  const double px = format.px_per_pt();
  const TextStyle style = words_style(format, kTextPt, format.colours().text);
  std::vector<LegendEntry> shown(entries.begin(), entries.end());
  for (LegendEntry& entry : shown) {
    entry.name = shortened_to(entry.name, style, rest.width - kSamplePt * px);
  }
  const LegendLayout layout = legend_layout(rest.width, shown, px);
  if (layout.height_px <= 0.0 || layout.height_px > kMostShare * rest.height) return;
  const PageRect strip = take_top(rest, layout.height_px, 4.0 * px);
  draw_legend(canvas, strip, shown, layout, format.colours(), px);
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
  TextStyle style = words_style(format, 9.0, format.colours().muted);
  // Somewhat smaller where the panel is.
  if (panel.height < 40.0 * format.px_per_pt() || panel.width < 80.0 * format.px_per_pt()) {
    style.size_px = 7.5 * format.px_per_pt();
  }
  style.align = TextAlign::kCentre;
  const double line_height = kLineSpacing * style.size_px;
  const auto most = static_cast<std::size_t>(std::max(0.0, panel.height / line_height));
  const std::vector<std::string> lines = lines_inside(text, style, 0.96 * panel.width, most);
  double baseline =
      panel.centre().y() + line_height * static_cast<double>(lines.size()) / 2.0 - style.size_px;
  for (const std::string& line : lines) {
    if (!line.empty()) canvas.text({panel.centre().x(), baseline}, line, style);
    baseline -= line_height;
  }
}

}  // namespace nadir
