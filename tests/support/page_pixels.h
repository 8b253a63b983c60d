// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ostream>
#include <vector>

#include "widgets/canvas/canvas.h"

namespace nadir {

/// For GoogleTest's messages.
inline void PrintTo(const Rgba& colour, std::ostream* out) {
  *out << "(" << int{colour.red} << ", " << int{colour.green} << ", " << int{colour.blue} << ", "
       << int{colour.alpha} << ")";
}

inline constexpr Rgba kNothing{0, 0, 0, 0};
inline constexpr Rgba kWhite{255, 255, 255};
inline constexpr Rgba kBlack{0, 0, 0};
inline constexpr Rgba kRed{255, 0, 0};
inline constexpr Rgba kGreen{0, 255, 0};
inline constexpr Rgba kBlue{0, 0, 255};

/// The pixel that holds a point of the page, y up.
[[nodiscard]] inline Rgba pixel_at(const Raster<Rgba>& page, double x, double y_up) {
  return page.at(static_cast<int>(std::floor(x)),
                 page.height() - 1 - static_cast<int>(std::floor(y_up)));
}

/// Centre of a pixel as a point of the page, y up.
[[nodiscard]] inline Eigen::Vector2d centre_of_pixel(const Raster<Rgba>& page,
                                                     int column,
                                                     int row) {
  return {column + 0.5, page.height() - row - 0.5};
}

[[nodiscard]] inline bool holds(const PageRect& area, const Eigen::Vector2d& point) {
  return point.x() > area.left && point.x() < area.right() && point.y() > area.bottom &&
         point.y() < area.top();
}

[[nodiscard]] inline std::vector<Eigen::Vector2d> outline_of(const PageRect& area) {
  return {{area.left, area.bottom},
          {area.right(), area.bottom},
          {area.right(), area.top()},
          {area.left, area.top()}};
}

/// Of the four channels the one that differs most.
[[nodiscard]] inline int difference(Rgba a, Rgba b) {
  return std::max({std::abs(a.red - b.red), std::abs(a.green - b.green), std::abs(a.blue - b.blue),
                   std::abs(a.alpha - b.alpha)});
}

/// Pixels of the page that are not as they should be: `inside` within the area, `outside` elsewhere.
[[nodiscard]] inline int wrong_pixels(const Raster<Rgba>& page,
                                      const PageRect& area,
                                      Rgba inside,
                                      Rgba outside) {
  int wrong = 0;
  for (int row = 0; row < page.height(); ++row) {
    for (int column = 0; column < page.width(); ++column) {
      const bool is_inside = holds(area, centre_of_pixel(page, column, row));
      wrong += page.at(column, row) == (is_inside ? inside : outside) ? 0 : 1;
    }
  }
  return wrong;
}

/// Smallest rectangle around the pixels that differ clearly from the paper; empty where none does.
[[nodiscard]] inline PageRect ink_box(const Raster<Rgba>& page, Rgba paper) {
  constexpr int kClearly = 60;
  int left = page.width();
  int right = -1;
  int top = page.height();
  int bottom = -1;
  for (int row = 0; row < page.height(); ++row) {
    for (int column = 0; column < page.width(); ++column) {
      if (difference(page.at(column, row), paper) < kClearly) continue;
      left = std::min(left, column);
      right = std::max(right, column);
      top = std::min(top, row);
      bottom = std::max(bottom, row);
    }
  }
  if (right < 0) return {};
  return {static_cast<double>(left), static_cast<double>(page.height() - 1 - bottom),
          static_cast<double>(right - left + 1), static_cast<double>(bottom - top + 1)};
}

/// Pixels' worth of black ink on white paper, shares of half covered pixels added up.
[[nodiscard]] inline double ink_area(const Raster<Rgba>& page) {
  double area = 0.0;
  for (const Rgba pixel : page.values()) area += (255.0 - pixel.green) / 255.0;
  return area;
}

}  // namespace nadir
