// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "tests/support/recorded_page.h"

namespace nadir {

/// A recorded page that keeps the pixels of its pictures, and what came after what.
class SeenPage : public RecordedPage {
 public:
  std::vector<Raster<Rgba>> pictures;
  std::vector<std::pair<char, std::size_t>>
      order;  ///< 'i' an image, 's' a stroke, with their number.

  void image(const PageRect& where, const Raster<Rgba>& pixels) override {
    order.emplace_back('i', pictures.size());
    pictures.push_back(pixels);
    RecordedPage::image(where, pixels);
  }
  void stroke(std::span<const Eigen::Vector2d> points, const StrokeStyle& style) override {
    order.emplace_back('s', strokes.size());
    RecordedPage::stroke(points, style);
  }
  /// Of a picture, where it lies on the page.
  [[nodiscard]] Rgba colour_at(std::size_t picture, const Eigen::Vector2d& on_page) const {
    const PageRect& where = images.at(picture).where;
    const Raster<Rgba>& pixels = pictures.at(picture);
    return pixels.at(
        static_cast<int>((on_page.x() - where.left) * pixels.width() / where.width),
        static_cast<int>((where.top() - on_page.y()) * pixels.height() / where.height));
  }
  /// The longest line of a colour; empty where there is none.
  [[nodiscard]] std::vector<Eigen::Vector2d> line_in(Rgba colour) const {
    const Stroke* longest = nullptr;
    for (const Stroke& stroke : strokes) {
      const bool is_longer = longest == nullptr || stroke.points.size() > longest->points.size();
      if (stroke.style.colour == colour && is_longer) longest = &stroke;
    }
    return longest == nullptr ? std::vector<Eigen::Vector2d>() : longest->points;
  }
  [[nodiscard]] std::string words() const {
    std::string all;
    for (const Text& text : texts) all += text.line + " ";
    return all;
  }
};

}  // namespace nadir
