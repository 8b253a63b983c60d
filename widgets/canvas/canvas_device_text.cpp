// SPDX-License-Identifier: Apache-2.0
// What CanvasDevice does with text: VTK asks for blocks of lines, a Canvas draws one line at a time.
#include <vtkStdString.h>
#include <vtkTextProperty.h>
#include <vtkUnicodeString.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "widgets/canvas/canvas_device.h"

namespace nadir {

TextStyle CanvasDevice::text_style() const {
  vtkTextProperty* const property = this->TextProp;
  const auto byte = [](double share) {
    return static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(share, 0.0, 1.0)));
  };
  TextStyle style;
  style.face = property->GetFontFamily() == VTK_COURIER ? FontFace::kNumbers : FontFace::kText;
  style.is_bold = property->GetBold() != 0;
  style.size_px = property->GetFontSize();
  const double* const colour = property->GetColor();
  style.colour = {byte(colour[0]), byte(colour[1]), byte(colour[2]), byte(property->GetOpacity())};
  style.rotation_deg = property->GetOrientation();
  switch (property->GetJustification()) {
    case VTK_TEXT_CENTERED:
      style.align = TextAlign::kCentre;
      break;
    case VTK_TEXT_RIGHT:
      style.align = TextAlign::kRight;
      break;
    default:
      style.align = TextAlign::kLeft;
      break;
  }
  return style;
}

namespace {

constexpr double kTurnRadPerDeg = std::numbers::pi / 180.0;
constexpr double kLineSpacing = 1.3;  ///< From baseline to baseline, in text sizes.

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines(1);
  for (const char letter : text) {
    if (letter == '\n') {
      lines.emplace_back();
    } else {
      lines.back() += letter;
    }
  }
  return lines;
}

/// A block of lines around the point that it is anchored to, before rotation.
struct TextBlock {
  std::vector<std::string> lines;
  double width = 0.0, bottom = 0.0, top = 0.0;  ///< Of the block, from the anchor.
  double first_baseline = 0.0;                  ///< Above the anchor.
};

TextBlock block_of(const std::string& text, const TextStyle& style, int vertical) {
  TextBlock block;
  block.lines = lines_of(text);
  TextExtent extent;
  for (const std::string& line : block.lines) {
    extent = measure_text(line, style);
    block.width = std::max(block.width, extent.width);
  }
  const double below = kLineSpacing * style.size_px * static_cast<double>(block.lines.size() - 1);
  const double height = extent.cap_height + below + extent.descent;
  switch (vertical) {
    case VTK_TEXT_TOP:
      block.top = 0.0;
      break;
    // Centred by its capitals, as the eye does.
    case VTK_TEXT_CENTERED:
      block.top = (extent.cap_height + below) / 2.0;
      break;
    default:
      block.top = height;
      break;
  }
  block.bottom = block.top - height;
  block.first_baseline = block.top - extent.cap_height;
  return block;
}

}  // namespace

void CanvasDevice::draw_text(const Eigen::Vector2d& point, const std::string& text) {
  const TextStyle style = text_style();
  if (style.colour.alpha == 0 || text.empty()) return;
  const TextBlock block = block_of(text, style, this->TextProp->GetVerticalJustification());
  const Eigen::Rotation2Dd turned(style.rotation_deg * kTurnRadPerDeg);
  double baseline = block.first_baseline;
  for (const std::string& line : block.lines) {
    if (line.find_first_not_of(' ') != std::string::npos) {
      canvas_->text(point + turned * Eigen::Vector2d(0.0, baseline), line, style);
    }
    baseline -= kLineSpacing * style.size_px;
  }
}

PageRect CanvasDevice::text_box(const std::string& text) const {
  const TextStyle style = text_style();
  const TextBlock block = block_of(text, style, this->TextProp->GetVerticalJustification());
  double left = 0.0;
  if (style.align == TextAlign::kCentre) left = -block.width / 2.0;
  if (style.align == TextAlign::kRight) left = -block.width;
  const Eigen::Rotation2Dd turned(style.rotation_deg * kTurnRadPerDeg);
  Eigen::AlignedBox2d box;
  for (const double x : {left, left + block.width}) {
    for (const double y : {block.bottom, block.top}) box.extend(turned * Eigen::Vector2d(x, y));
  }
  return {box.min().x(), box.min().y(), box.sizes().x(), box.sizes().y()};
}

void CanvasDevice::DrawString(float* point, const vtkStdString& string) {
  draw_text(on_page(point, 1).front(), string);
}

void CanvasDevice::DrawString(float* point, const vtkUnicodeString& string) {
  draw_text(on_page(point, 1).front(), string.utf8_str());
}

void CanvasDevice::DrawMathTextString(float* point, const vtkStdString& string) {
  draw_text(on_page(point, 1).front(), string);
}

void CanvasDevice::ComputeStringBounds(const vtkStdString& string, float bounds[4]) {
  const TextBlock block = block_of(string, text_style(), VTK_TEXT_BOTTOM);
  bounds[0] = 0.0F;
  bounds[1] = 0.0F;
  bounds[2] = static_cast<float>(block.width);
  bounds[3] = static_cast<float>(block.top - block.bottom);
}

void CanvasDevice::ComputeStringBounds(const vtkUnicodeString& string, float bounds[4]) {
  ComputeStringBounds(vtkStdString(string.utf8_str()), bounds);
}

void CanvasDevice::ComputeJustifiedStringBounds(const char* string, float bounds[4]) {
  const PageRect box = text_box(string);
  bounds[0] = static_cast<float>(box.left);
  bounds[1] = static_cast<float>(box.bottom);
  bounds[2] = static_cast<float>(box.width);
  bounds[3] = static_cast<float>(box.height);
}

}  // namespace nadir
