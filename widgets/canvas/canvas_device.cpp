// SPDX-License-Identifier: Apache-2.0
#include "widgets/canvas/canvas_device.h"

#include <vtkBrush.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkObjectFactory.h>
#include <vtkPen.h>
#include <vtkPlotPoints.h>
#include <vtkRect.h>
#include <vtkStdString.h>
#include <vtkTextProperty.h>
#include <vtkUnicodeString.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/base/require.h"
#include "widgets/canvas/vtk_image.h"

namespace nadir {

CanvasDevice* CanvasDevice::New() { VTK_STANDARD_NEW_BODY(CanvasDevice); }

namespace {
constexpr double kTurnRadPerDeg = std::numbers::pi / 180.0;

Rgba rgba(const vtkColor4ub& colour) {
  return {colour.GetRed(), colour.GetGreen(), colour.GetBlue(), colour.GetAlpha()};
}

/// Colour of vertex i where colours are given, else the fallback.
Rgba colour_of(const unsigned char* colors, int components, int i, Rgba fallback) {
  if (colors == nullptr || components < 3) return fallback;
  const unsigned char* const colour = colors + static_cast<std::ptrdiff_t>(i) * components;
  return {colour[0], colour[1], colour[2],
          components > 3 ? colour[3] : static_cast<unsigned char>(255)};
}

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

/// Points of an ellipse from one angle to another, both included.
std::vector<Eigen::Vector2d> arc(const Eigen::Vector2d& centre,
                                 const Eigen::Vector2d& radii,
                                 double start_deg,
                                 double stop_deg) {
  const int steps = std::max(2, static_cast<int>(std::ceil(std::abs(stop_deg - start_deg) / 4.0)));
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i <= steps; ++i) {
    const double angle = (start_deg + (stop_deg - start_deg) * i / steps) * kTurnRadPerDeg;
    points.emplace_back(centre.x() + radii.x() * std::cos(angle),
                        centre.y() + radii.y() * std::sin(angle));
  }
  return points;
}

/// Outlines of a marker around the origin that is one pixel wide.
std::vector<std::vector<Eigen::Vector2d>> marker_outlines(int shape) {
  static constexpr double kArm = 0.14;  // half the thickness of a cross's arms
  const auto bar = [](double angle) {
    std::vector<Eigen::Vector2d> corners = {{-0.5, -kArm}, {0.5, -kArm}, {0.5, kArm}, {-0.5, kArm}};
    for (Eigen::Vector2d& corner : corners) {
      corner = Eigen::Rotation2Dd(angle) * corner;
    }
    return corners;
  };
  switch (shape) {
    case VTK_MARKER_CROSS:
      return {bar(std::numbers::pi / 4.0), bar(-std::numbers::pi / 4.0)};
    case VTK_MARKER_PLUS:
      return {bar(0.0), bar(std::numbers::pi / 2.0)};
    case VTK_MARKER_SQUARE:
      return {{{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}};
    case VTK_MARKER_DIAMOND:
      return {{{-0.5, 0.0}, {0.0, -0.5}, {0.5, 0.0}, {0.0, 0.5}}};
    default:
      return {arc({0.0, 0.0}, {0.5, 0.5}, 0.0, 360.0)};
  }
}

}  // namespace

CanvasDevice::CanvasDevice() = default;
CanvasDevice::~CanvasDevice() = default;

void CanvasDevice::draw_on(Canvas& canvas, int width, int height) {
  canvas_ = &canvas;
  this->Geometry[0] = width;
  this->Geometry[1] = height;
  page_from_item_.setIdentity();
  saved_.clear();
  is_clipping_ = false;  // a clip that was left open went with its canvas
}

std::vector<Eigen::Vector2d> CanvasDevice::on_page(const float* points, int n) const {
  std::vector<Eigen::Vector2d> placed;
  placed.reserve(static_cast<std::size_t>(n));
  for (int i = 0; i < n; ++i) {
    const Eigen::Vector3d point(points[2 * i], points[2 * i + 1], 1.0);
    placed.emplace_back((page_from_item_ * point).head<2>());
  }
  return placed;
}

StrokeStyle CanvasDevice::stroke_style() const {
  const double width = std::max(0.25, static_cast<double>(this->Pen->GetWidth()));
  StrokeStyle style{rgba(this->Pen->GetColorObject()), width};
  switch (this->Pen->GetLineType()) {
    case vtkPen::NO_PEN:
      style.colour.alpha = 0;
      break;
    case vtkPen::DASH_LINE:
      style.dashes_px = {4.0 * width, 2.5 * width};
      break;
    case vtkPen::DOT_LINE:
    case vtkPen::DENSE_DOT_LINE:
      style.dashes_px = {width, 1.5 * width};
      break;
    case vtkPen::DASH_DOT_LINE:
    case vtkPen::DASH_DOT_DOT_LINE:
      style.dashes_px = {4.0 * width, 2.0 * width, width, 2.0 * width};
      break;
    default:
      break;
  }
  return style;
}

void CanvasDevice::DrawPoly(float* points, int n, unsigned char* colors, int nc_comps) {
  StrokeStyle style = stroke_style();
  style.colour = colour_of(colors, nc_comps, 0, style.colour);
  if (style.colour.alpha > 0) canvas_->stroke(on_page(points, n), style);
}

void CanvasDevice::DrawLines(float* points, int n, unsigned char* colors, int nc_comps) {
  StrokeStyle style = stroke_style();
  const Rgba pen = style.colour;
  const std::vector<Eigen::Vector2d> placed = on_page(points, n);
  for (int i = 0; i + 1 < n; i += 2) {
    style.colour = colour_of(colors, nc_comps, i, pen);
    if (style.colour.alpha == 0) continue;
    canvas_->stroke(std::span(placed).subspan(static_cast<std::size_t>(i), 2), style);
  }
}

void CanvasDevice::DrawPoints(float* points, int n, unsigned char* colors, int nc_comps) {
  DrawMarkers(VTK_MARKER_CIRCLE, false, points, n, colors, nc_comps);
}

void CanvasDevice::DrawPointSprites(
    vtkImageData* /*sprite*/, float* points, int n, unsigned char* colors, int nc_comps) {
  DrawMarkers(VTK_MARKER_CIRCLE, false, points, n, colors, nc_comps);
}

void CanvasDevice::DrawMarkers(
    int shape, bool /*highlight*/, float* points, int n, unsigned char* colors, int nc_comps) {
  const Rgba pen = rgba(this->Pen->GetColorObject());
  const double size = this->Pen->GetWidth();
  const auto outlines = marker_outlines(shape);
  const std::vector<Eigen::Vector2d> placed = on_page(points, n);
  std::vector<Eigen::Vector2d> marker;
  for (int i = 0; i < n; ++i) {
    for (const auto& outline : outlines) {
      marker.clear();
      for (const Eigen::Vector2d& corner : outline) {
        marker.emplace_back(placed[static_cast<std::size_t>(i)] + size * corner);
      }
      canvas_->fill(marker, colour_of(colors, nc_comps, i, pen));
    }
  }
}

void CanvasDevice::DrawQuad(float* points, int n) {
  for (int i = 0; i + 3 < n; i += 4) DrawPolygon(points + static_cast<std::ptrdiff_t>(2) * i, 4);
}

void CanvasDevice::DrawQuadStrip(float* points, int n) {
  // One outline, along the even points and back along the odd ones: quad by quad, seams would show.
  const std::vector<Eigen::Vector2d> placed = on_page(points, n);
  std::vector<Eigen::Vector2d> outline;
  for (std::size_t i = 0; i < placed.size(); i += 2) outline.push_back(placed[i]);
  for (std::size_t i = placed.size() / 2; i > 0; --i) outline.push_back(placed[2 * i - 1]);
  const Rgba colour = rgba(this->Brush->GetColorObject());
  if (colour.alpha > 0) canvas_->fill(outline, colour);
}

void CanvasDevice::DrawPolygon(float* points, int n) { DrawColoredPolygon(points, n, nullptr, 0); }

void CanvasDevice::DrawColoredPolygon(float* points, int n, unsigned char* colors, int nc_comps) {
  const Rgba colour = colour_of(colors, nc_comps, 0, rgba(this->Brush->GetColorObject()));
  if (colour.alpha > 0) canvas_->fill(on_page(points, n), colour);
}

void CanvasDevice::DrawEllipseWedge(float x,
                                    float y,
                                    float outer_x,
                                    float outer_y,
                                    float inner_x,
                                    float inner_y,
                                    float start_deg,
                                    float stop_deg) {
  std::vector<Eigen::Vector2d> outline = arc({x, y}, {outer_x, outer_y}, start_deg, stop_deg);
  const std::vector<Eigen::Vector2d> back = arc({x, y}, {inner_x, inner_y}, stop_deg, start_deg);
  outline.insert(outline.end(), back.begin(), back.end());
  for (Eigen::Vector2d& point : outline) point = (page_from_item_ * point.homogeneous()).head<2>();
  const Rgba colour = rgba(this->Brush->GetColorObject());
  if (colour.alpha > 0) canvas_->fill(outline, colour);
}

void CanvasDevice::DrawEllipticArc(
    float x, float y, float radius_x, float radius_y, float start_deg, float stop_deg) {
  std::vector<Eigen::Vector2d> points = arc({x, y}, {radius_x, radius_y}, start_deg, stop_deg);
  for (Eigen::Vector2d& point : points) point = (page_from_item_ * point.homogeneous()).head<2>();
  const Rgba inside = rgba(this->Brush->GetColorObject());
  if (inside.alpha > 0) canvas_->fill(points, inside);
  const StrokeStyle style = stroke_style();
  if (style.colour.alpha > 0) canvas_->stroke(points, style);
}

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

constexpr double kLineSpacing = 1.3;  ///< From baseline to baseline, in text sizes.

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
    canvas_->text(point + turned * Eigen::Vector2d(0.0, baseline), line, style);
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

void CanvasDevice::DrawImage(float point[2], float scale, vtkImageData* image) {
  const std::array<int, 3> size = image_size(*image);
  DrawImage(vtkRectf(point[0], point[1], static_cast<float>(size[0]) * scale,
                     static_cast<float>(size[1]) * scale),
            image);
}

void CanvasDevice::DrawImage(const vtkRectf& where, vtkImageData* image) {
  const std::array<float, 4> corners = {where.GetLeft(), where.GetBottom(), where.GetRight(),
                                        where.GetTop()};
  const auto placed = on_page(corners.data(), 2);
  canvas_->image(
      {placed[0].x(), placed[0].y(), placed[1].x() - placed[0].x(), placed[1].y() - placed[0].y()},
      raster_of(*image));
}

void CanvasDevice::SetColor4(unsigned char color[4]) {
  this->Pen->SetColor(color);
  this->Brush->SetColor(color);
}

void CanvasDevice::SetPointSize(float size) { this->Pen->SetWidth(size); }
void CanvasDevice::SetLineWidth(float width) { this->Pen->SetWidth(width); }
void CanvasDevice::SetLineType(int type) { this->Pen->SetLineType(type); }

namespace {

Eigen::Matrix3d eigen(vtkMatrix3x3* matrix) {
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(matrix->GetData());
}

}  // namespace

void CanvasDevice::SetMatrix(vtkMatrix3x3* matrix) { page_from_item_ = eigen(matrix); }

void CanvasDevice::GetMatrix(vtkMatrix3x3* matrix) {
  Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(matrix->GetData()) = page_from_item_;
  matrix->Modified();
}

void CanvasDevice::MultiplyMatrix(vtkMatrix3x3* matrix) {
  page_from_item_ = page_from_item_ * eigen(matrix);
}

void CanvasDevice::PushMatrix() { saved_.push_back(page_from_item_); }

void CanvasDevice::PopMatrix() {
  NADIR_REQUIRE(!saved_.empty());
  page_from_item_ = saved_.back();
  saved_.pop_back();
}

void CanvasDevice::SetClipping(int* box) {
  clip_ = {static_cast<double>(box[0]), static_cast<double>(box[1]), static_cast<double>(box[2]),
           static_cast<double>(box[3])};
  if (is_clipping_) EnableClipping(true);  // at once, as VTK's own device does
}

void CanvasDevice::EnableClipping(bool enable) {
  if (is_clipping_) canvas_->pop_clip();
  is_clipping_ = enable;
  if (enable) canvas_->push_clip(clip_);
}

}  // namespace nadir
