// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "widgets/canvas/canvas.h"
#include "widgets/kit/control.h"
#include "widgets/kit/ui_fonts.h"
#include "widgets/kit/ui_pictures.h"

struct ImDrawList;

namespace nadir::kit {

/// Draws on a list of triangles of Dear ImGui, so that what figures draw is drawn in the window as well. Text is as wide as
/// measure_text() says where the fonts are the same. Fills of outlines that are not convex have no smoothed edge.
class UiCanvas : public Canvas {
 public:
  /// @param area  Of the window (pixels, y down): the page's lower left corner is its own, and nothing is drawn outside.
  /// All references outlive the canvas.
  UiCanvas(ImDrawList& list, const Rect& area, const FontSet& fonts, UiPictures& pictures);

  void stroke(std::span<const Eigen::Vector2d> points, const StrokeStyle& style) override;
  void fill(std::span<const Eigen::Vector2d> outline, Rgba colour) override;
  void text(const Eigen::Vector2d& point, const std::string& line, const TextStyle& style) override;
  void image(const PageRect& where, const Raster<Rgba>& pixels) override;
  void push_clip(const PageRect& inside) override;
  void pop_clip() override;

 private:
  class Clipped;
  [[nodiscard]] Eigen::Vector2f in_window(const Eigen::Vector2d& point) const;
  [[nodiscard]] Rect in_window(const PageRect& rect) const;
  void stroke_piece(std::span<const Eigen::Vector2d> points, const StrokeStyle& style);

  ImDrawList& list_;
  Rect area_;
  const FontSet& fonts_;
  UiPictures& pictures_;
  std::vector<Rect> clips_;  ///< The innermost, which lies inside of all before, is the last.
};

/// Triangles that cover the inside of a closed outline, even-odd where it crosses itself: three corners each. For n corners
/// with k edges beside each other O(n k). Points that are not finite are left out.
[[nodiscard]] std::vector<Eigen::Vector2d> triangles_inside(
    std::span<const Eigen::Vector2d> outline);

/// Pieces of a polyline that its dashes draw. @param dashes  On, off, on, off …, in the unit of the points, repeated; odd ones are taken twice, as
/// in SVG. @param begin  Of the line's first point along the dashes.
[[nodiscard]] std::vector<std::vector<Eigen::Vector2d>> dashed(
    std::span<const Eigen::Vector2d> line, std::span<const double> dashes, double begin = 0.0);

}  // namespace nadir::kit
