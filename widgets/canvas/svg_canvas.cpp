// SPDX-License-Identifier: Apache-2.0
#include "widgets/canvas/svg_canvas.h"

#include <fmt/format.h>
#include <vtkBase64Utilities.h>

#include <array>
#include <string_view>
#include <utility>

#include "core/base/require.h"
#include "widgets/canvas/page_lines.h"
#include "widgets/canvas/png_file.h"
#include "widgets/canvas/printable.h"

namespace nadir {
namespace {

/// A hundredth of a pixel, without trailing zeros.
std::string number(double value) {
  std::string text = fmt::format("{:.2f}", value);
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string paint(const char* attribute, Rgba colour) {
  std::string text =
      fmt::format(" {}=\"#{:02x}{:02x}{:02x}\"", attribute, colour.red, colour.green, colour.blue);
  if (colour.alpha < 255) {
    text += fmt::format(" {}-opacity=\"{:.3g}\"", attribute, colour.alpha / 255.0);
  }
  return text;
}

std::string base64(const std::string& bytes) {
  std::string text(4 * (bytes.size() / 3 + 1) + 1, '\0');
  text.resize(vtkBase64Utilities::Encode(reinterpret_cast<const unsigned char*>(bytes.data()),
                                         bytes.size(),
                                         reinterpret_cast<unsigned char*>(text.data())));
  return text;
}

}  // namespace

SvgCanvas::SvgCanvas(
    int width, int height, double dpi, const std::string& title, const std::string& metadata)
    : width_(width), height_(height) {
  // The unit of CSS is 1/96 inch; the view box keeps our own pixels inside.
  constexpr double kCssPixelsPerInch = 96.0;
  svg_ = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" "
      "width=\"{}\" height=\"{}\" viewBox=\"0 0 {} {}\">\n<title>{}</title>\n",
      number(width * kCssPixelsPerInch / dpi), number(height * kCssPixelsPerInch / dpi), width,
      height, markup_text(title));
  if (!metadata.empty()) svg_ += "<metadata>" + markup_text(metadata) + "</metadata>\n";
}

std::string SvgCanvas::path_data(std::span<const Eigen::Vector2d> points) const {
  std::string data;
  for (const Eigen::Vector2d& point : points) {
    if (!data.empty()) data += ' ';
    data += number(point.x()) + ',' + number(height_ - point.y());
  }
  return data;
}

void SvgCanvas::stroke(std::span<const Eigen::Vector2d> points, const StrokeStyle& style) {
  std::string look = "<polyline fill=\"none\" stroke-linejoin=\"round\"" +
                     paint("stroke", style.colour) + " stroke-width=\"" + number(style.width_px) +
                     "\"";
  std::string dashes;
  for (const double dash : style.dashes_px) dashes += (dashes.empty() ? "" : " ") + number(dash);
  if (!dashes.empty()) look += " stroke-dasharray=\"" + dashes + "\"";
  for (const LinePiece& piece : line_inside(points, surroundings_of_page(width_, height_))) {
    svg_ += look;
    if (!dashes.empty() && piece.begin > 0.0) {
      svg_ += " stroke-dashoffset=\"" + number(piece.begin) + "\"";
    }
    svg_ += " points=\"" + path_data(piece.points) + "\"/>\n";
  }
}

void SvgCanvas::fill(std::span<const Eigen::Vector2d> outline, Rgba colour) {
  const auto area = area_inside(outline, surroundings_of_page(width_, height_));
  if (area.empty()) return;
  svg_ += "<polygon fill-rule=\"evenodd\"" + paint("fill", colour) + " points=\"" +
          path_data(area) + "\"/>\n";
}

void SvgCanvas::text(const Eigen::Vector2d& point,
                     const std::string& line,
                     const TextStyle& style) {
  if (line.empty()) return;
  constexpr std::array<const char*, 3> kAnchors = {"start", "middle", "end"};
  const std::string x = number(point.x());
  const std::string y = number(height_ - point.y());
  svg_ += fmt::format(
      "<text x=\"{}\" y=\"{}\" font-family=\"{}\" font-size=\"{}\" xml:space=\"preserve\"", x, y,
      style.face == FontFace::kText ? "Inter, 'DejaVu Sans', Helvetica, Arial, sans-serif"
                                    : "'JetBrains Mono', 'DejaVu Sans Mono', monospace",
      number(style.size_px));
  if (style.is_bold) svg_ += " font-weight=\"bold\"";
  if (style.align != TextAlign::kLeft) {
    svg_ += fmt::format(" text-anchor=\"{}\"", kAnchors.at(static_cast<std::size_t>(style.align)));
  }
  if (style.rotation_deg != 0.0) {
    svg_ += fmt::format(" transform=\"rotate({} {} {})\"", number(-style.rotation_deg), x, y);
  }
  svg_ += " textLength=\"" + number(measure_text(line, style).width) + "\"" +
          paint("fill", style.colour) + ">" + markup_text(line) + "</text>\n";
}

void SvgCanvas::image(const PageRect& where, const Raster<Rgba>& pixels) {
  if (pixels.empty() || where.width <= 0.0 || where.height <= 0.0) return;
  const bool is_enlarged = where.width > pixels.width() || where.height > pixels.height();
  svg_ += fmt::format(
      "<image x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" preserveAspectRatio=\"none\"{} "
      "xlink:href=\"data:image/png;base64,{}\"/>\n",
      number(where.left), number(height_ - where.top()), number(where.width), number(where.height),
      is_enlarged ? " style=\"image-rendering:pixelated\"" : "", base64(encode_png(pixels)));
}

void SvgCanvas::push_clip(const PageRect& inside) {
  const int name = clips_++;
  ++open_clips_;
  svg_ += fmt::format(
      "<clipPath id=\"c{}\"><rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/></clipPath>\n"
      "<g clip-path=\"url(#c{})\">\n",
      name, number(inside.left), number(height_ - inside.top()), number(inside.width),
      number(inside.height), name);
}

void SvgCanvas::pop_clip() {
  NADIR_REQUIRE(open_clips_ > 0);
  --open_clips_;
  svg_ += "</g>\n";
}

std::string SvgCanvas::finish() {
  NADIR_REQUIRE(open_clips_ == 0);
  svg_ += "</svg>\n";
  return std::move(svg_);
}

std::string svg_metadata(const std::string& svg) {
  constexpr std::string_view kBegin = "<metadata>";
  const std::size_t begin = svg.find(kBegin);
  if (begin == std::string::npos) return {};
  const std::size_t end = svg.find("</metadata>", begin);
  if (end == std::string::npos) return {};
  std::string text = svg.substr(begin + kBegin.size(), end - begin - kBegin.size());
  // The ampersand last, or "&amp;lt;" would become "<".
  constexpr std::array<std::pair<std::string_view, char>, 4> kEscapes{
      {{"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&amp;", '&'}}};
  for (const auto& [escape, letter] : kEscapes) {
    for (std::size_t at = text.find(escape); at != std::string::npos;
         at = text.find(escape, at + 1)) {
      text.replace(at, escape.size(), 1, letter);
    }
  }
  return text;
}

}  // namespace nadir
