// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "widgets/canvas/canvas.h"

namespace nadir {

/// Remembers what was drawn instead of drawing it.
class RecordedPage : public Canvas {
 public:
  struct Text {
    std::string line;
    TextStyle style;
    Eigen::AlignedBox2d box;  ///< From the baseline to the top of capitals, turned as it is drawn.
    Eigen::AlignedBox2d clip;
  };
  struct Image {
    PageRect where;
    int width = 0, height = 0;     ///< Of its pixels.
    const Rgba* pixels = nullptr;  ///< Where they lay; only to compare.
  };
  struct Stroke {
    std::vector<Eigen::Vector2d> points;
    StrokeStyle style;
  };
  std::vector<Text> texts;
  std::vector<Image> images;
  std::vector<Stroke> strokes;
  std::size_t fills = 0;

  void stroke(std::span<const Eigen::Vector2d> points, const StrokeStyle& style) override {
    strokes.push_back({{points.begin(), points.end()}, style});
  }
  void fill(std::span<const Eigen::Vector2d> /*outline*/, Rgba /*colour*/) override { ++fills; }
  void text(const Eigen::Vector2d& point,
            const std::string& line,
            const TextStyle& style) override {
    const TextExtent extent = measure_text(line, style);
    const double begin = style.align == TextAlign::kLeft     ? 0.0
                         : style.align == TextAlign::kCentre ? -extent.width / 2.0
                                                             : -extent.width;
    const Eigen::Rotation2Dd turn(style.rotation_deg * std::numbers::pi / 180.0);
    Eigen::AlignedBox2d box;
    for (const double x : {begin, begin + extent.width}) {
      for (const double y : {0.0, extent.cap_height}) {
        box.extend(point + turn * Eigen::Vector2d(x, y));
      }
    }
    texts.push_back({line, style, box, clips_.empty() ? everything() : clips_.back()});
  }
  void image(const PageRect& where, const Raster<Rgba>& pixels) override {
    images.push_back({where, pixels.width(), pixels.height(), pixels.data()});
  }
  void push_clip(const PageRect& inside) override {
    const Eigen::AlignedBox2d clip(Eigen::Vector2d(inside.left, inside.bottom),
                                   Eigen::Vector2d(inside.right(), inside.top()));
    clips_.push_back(clips_.empty() ? clip : clips_.back().intersection(clip));
  }
  void pop_clip() override { clips_.pop_back(); }

  [[nodiscard]] bool has_text(const std::string& part) const {
    return std::any_of(texts.begin(), texts.end(), [&part](const Text& text) {
      return text.line.find(part) != std::string::npos;
    });
  }
  [[nodiscard]] std::size_t open_clips() const { return clips_.size(); }

 private:
  static Eigen::AlignedBox2d everything() {
    return {Eigen::Vector2d::Constant(-1e9), Eigen::Vector2d::Constant(1e9)};
  }
  std::vector<Eigen::AlignedBox2d> clips_;
};

/// What of a page cannot be read, a sentence each: text that covers other text, leaves the page or is cut off, and text
/// smaller than so many pixels. Half a pixel is nothing. Text that lies wholly outside of its clip is not seen.
[[nodiscard]] inline std::vector<std::string> unreadable_texts(const RecordedPage& canvas,
                                                               double page_width,
                                                               double page_height,
                                                               double least_size_px) {
  constexpr double kSlackPx = 0.5;
  const Eigen::AlignedBox2d page(Eigen::Vector2d(-kSlackPx, -kSlackPx),
                                 Eigen::Vector2d(page_width + kSlackPx, page_height + kSlackPx));
  std::vector<const RecordedPage::Text*> seen;
  std::vector<std::string> faults;
  for (const RecordedPage::Text& text : canvas.texts) {
    if (text.line.empty() || !text.clip.intersects(text.box)) continue;
    const Eigen::AlignedBox2d clip(text.clip.min().array() - kSlackPx,
                                   text.clip.max().array() + kSlackPx);
    if (!page.contains(text.box)) faults.push_back("'" + text.line + "' leaves the page");
    if (!clip.contains(text.box)) faults.push_back("'" + text.line + "' is cut off");
    if (text.style.size_px < least_size_px - 0.01) {
      faults.push_back("'" + text.line + "' is too small: " + std::to_string(text.style.size_px));
    }
    for (const RecordedPage::Text* const other : seen) {
      const Eigen::AlignedBox2d both = text.box.intersection(other->box);
      if (!both.isEmpty() && both.sizes().minCoeff() > kSlackPx) {
        faults.push_back("'" + text.line + "' covers '" + other->line + "'");
      }
    }
    seen.push_back(&text);
  }
  return faults;
}

}  // namespace nadir
