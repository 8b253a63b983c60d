// SPDX-License-Identifier: Apache-2.0
// What CanvasDevice does with lines, markers, areas and pictures.
#include <vtkBrush.h>
#include <vtkImageData.h>
#include <vtkPen.h>
#include <vtkPlotPoints.h>
#include <vtkRect.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "widgets/canvas/canvas_device.h"
#include "widgets/canvas/vtk_image.h"

namespace nadir {
namespace {

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

/// Points of an ellipse from one angle to another, both included.
std::vector<Eigen::Vector2d> arc(const Eigen::Vector2d& centre,
                                 const Eigen::Vector2d& radii,
                                 double start_deg,
                                 double stop_deg) {
  const int steps = std::max(2, static_cast<int>(std::ceil(std::abs(stop_deg - start_deg) / 4.0)));
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i <= steps; ++i) {
    const double angle =
        (start_deg + (stop_deg - start_deg) * i / steps) * (std::numbers::pi / 180.0);
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

}  // namespace nadir
