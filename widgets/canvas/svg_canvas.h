// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "widgets/canvas/canvas.h"

namespace nadir {

/// Writes SVG 1.1: lines as lines, text as text (so that it can be searched, selected and restyled), pictures as PNG
/// inside the file. Text is laid out with our own measure and stretched to it, so that a viewer without our fonts keeps
/// the layout.
class SvgCanvas : public Canvas {
 public:
  /// A page of width x height pixels of 1/dpi inch. @param metadata  Kept in the element of that name, escaped.
  SvgCanvas(
      int width, int height, double dpi, const std::string& title, const std::string& metadata);

  void stroke(std::span<const Eigen::Vector2d> points, const StrokeStyle& style) override;
  void fill(std::span<const Eigen::Vector2d> outline, Rgba colour) override;
  void text(const Eigen::Vector2d& point, const std::string& line, const TextStyle& style) override;
  void image(const PageRect& where, const Raster<Rgba>& pixels) override;
  void push_clip(const PageRect& inside) override;
  void pop_clip() override;

  /// The whole file. Nothing can be drawn afterwards.
  [[nodiscard]] std::string finish();

 private:
  [[nodiscard]] std::string path_data(std::span<const Eigen::Vector2d> points) const;

  int width_ = 0, height_ = 0;
  int clips_ = 0;  ///< Made so far; their names are numbers.
  int open_clips_ = 0;
  std::string svg_;
};

/// The text of the first element `metadata` of an SVG that we wrote; empty where there is none.
[[nodiscard]] std::string svg_metadata(const std::string& svg);

}  // namespace nadir
