// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>

namespace nadir {

/// A rectangle of cells: columns [left, right), rows [top, bottom). May reach outside of any raster.
struct CellRect {
  std::int64_t left = 0, top = 0, right = 0, bottom = 0;

  [[nodiscard]] bool empty() const { return left >= right || top >= bottom; }
  [[nodiscard]] std::int64_t width() const { return std::max<std::int64_t>(0, right - left); }
  [[nodiscard]] std::int64_t height() const { return std::max<std::int64_t>(0, bottom - top); }
  [[nodiscard]] CellRect cut_to(const CellRect& other) const {
    return {std::max(left, other.left), std::max(top, other.top), std::min(right, other.right),
            std::min(bottom, other.bottom)};
  }
  /// The smallest that holds both; an empty one adds nothing.
  [[nodiscard]] CellRect joined(const CellRect& other) const {
    if (empty()) return other;
    if (other.empty()) return *this;
    return {std::min(left, other.left), std::min(top, other.top), std::max(right, other.right),
            std::max(bottom, other.bottom)};
  }
  friend bool operator==(const CellRect&, const CellRect&) = default;
};

/// A rectangle of the project plane, metres in enu. Empty until something was included.
struct PlaneBounds {
  Eigen::Vector2d low = Eigen::Vector2d::Zero(), high = Eigen::Vector2d::Zero();
  bool is_empty = true;

  void include(const Eigen::Vector2d& point_in_enu_m) {
    low = is_empty ? point_in_enu_m : Eigen::Vector2d(low.cwiseMin(point_in_enu_m));
    high = is_empty ? point_in_enu_m : Eigen::Vector2d(high.cwiseMax(point_in_enu_m));
    is_empty = false;
  }
  void grow(double by_m) {
    low -= Eigen::Vector2d::Constant(by_m);
    high += Eigen::Vector2d::Constant(by_m);
  }
};

/// North-up square cells on a document's project plane, at any resolution. Coordinates in cells are `overhead`: x to the
/// right, y *down* from the upper left corner of cell (0, 0), whose centre is (0.5, 0.5). They are defined outside too.
struct LabelGrid {
  double metres_per_cell = 0.1;  ///< > 0.
  Eigen::Vector2d top_left_in_enu_m = Eigen::Vector2d::Zero();
  int width = 0, height = 0;  ///< Cells.

  [[nodiscard]] CellRect whole() const { return {0, 0, width, height}; }
  [[nodiscard]] Eigen::Vector2d cells_from_enu(const Eigen::Vector2d& point_in_enu_m) const {
    return {(point_in_enu_m.x() - top_left_in_enu_m.x()) / metres_per_cell,
            (top_left_in_enu_m.y() - point_in_enu_m.y()) / metres_per_cell};
  }
  [[nodiscard]] Eigen::Vector2d enu_from_cells(const Eigen::Vector2d& point_in_cells) const {
    return {top_left_in_enu_m.x() + point_in_cells.x() * metres_per_cell,
            top_left_in_enu_m.y() - point_in_cells.y() * metres_per_cell};
  }
  /// All cells that a part of the plane touches, and `margin` more on every side.
  [[nodiscard]] CellRect cells_of(const PlaneBounds& bounds, std::int64_t margin) const;

  friend bool operator==(const LabelGrid&, const LabelGrid&) = default;
};

}  // namespace nadir
