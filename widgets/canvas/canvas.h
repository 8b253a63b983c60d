// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/base/raster.h"

namespace nadir {

/// A colour of the screen (sRGB), 8 bits a channel, not premultiplied.
struct Rgba {
  std::uint8_t red = 0, green = 0, blue = 0, alpha = 255;
  friend bool operator==(const Rgba&, const Rgba&) = default;
};

/// A rectangle on the page: pixels, x right, y *up* from the lower left corner, as VTK counts.
struct PageRect {
  double left = 0.0, bottom = 0.0, width = 0.0, height = 0.0;
  [[nodiscard]] double right() const { return left + width; }
  [[nodiscard]] double top() const { return bottom + height; }
  [[nodiscard]] Eigen::Vector2d centre() const {
    return {left + width / 2.0, bottom + height / 2.0};
  }
  friend bool operator==(const PageRect&, const PageRect&) = default;
};

struct StrokeStyle {
  Rgba colour = {};
  double width_px = 1.0;
  std::vector<double> dashes_px = {};  ///< On, off, on, off ...; empty for a whole line.
};

/// The two type faces of the program: words, and numbers that line up. Where one is not installed the system's own
/// replacement is taken.
enum class FontFace { kText, kNumbers };
enum class TextAlign { kLeft, kCentre, kRight };

struct TextStyle {
  FontFace face = FontFace::kText;
  bool is_bold = false;
  double size_px = 12.0;  ///< Of the em.
  Rgba colour = {};
  TextAlign align = TextAlign::kLeft;
  double rotation_deg = 0.0;  ///< Counter-clockwise about the point.
};

/// What one line of text takes, pixels. Capital letters reach `cap_height` above the baseline, a g `descent` below.
struct TextExtent {
  double width = 0.0, cap_height = 0.0, descent = 0.0;
};

/// One measure for every kind of page, so that a figure has the same layout as PNG, SVG and PDF.
[[nodiscard]] TextExtent measure_text(const std::string& line, const TextStyle& style);

/// Something to draw a page on. All points are page pixels, y up. What is drawn later lies above.
class Canvas {
 public:
  virtual ~Canvas() = default;

  /// An open line; its ends are flat, its corners round. It has a gap where points are not finite.
  virtual void stroke(std::span<const Eigen::Vector2d> points, const StrokeStyle& style) = 0;
  /// The inside of a closed outline (even-odd where it crosses itself).
  virtual void fill(std::span<const Eigen::Vector2d> outline, Rgba colour) = 0;
  /// One line of UTF-8 text; the point lies on its baseline, at the end that `align` names.
  virtual void text(const Eigen::Vector2d& point,
                    const std::string& line,
                    const TextStyle& style) = 0;
  /// Stretched over the rectangle, top row on top. Pixels stay sharp squares when enlarged.
  virtual void image(const PageRect& where, const Raster<Rgba>& pixels) = 0;
  /// Nothing is drawn outside the rectangle until the matching pop_clip(). Clips may be nested.
  virtual void push_clip(const PageRect& inside) = 0;
  virtual void pop_clip() = 0;
};

}  // namespace nadir
