// SPDX-License-Identifier: Apache-2.0
#include "core/sim/column_ray.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nadir {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kFaceInsetCells = 0.05;

/// Walks a ray from cell to cell, or over squares of cells at once. Whole-numbered borders keep it
/// exact: the cell never comes from rounding along the axis that was crossed.
class CellWalk {
 public:
  CellWalk(const Raster<ClassId>& labels, const ColumnRay& ray, double t)
      : ray_(ray),
        inverse_x_(1.0 / ray.rate.x()),
        inverse_y_(1.0 / ray.rate.y()),
        width_(labels.width()),
        height_(labels.height()),
        t_(t),
        column_(cell(ray.start.x() + t * ray.rate.x(), 0, width_ - 1)),
        row_(cell(ray.start.y() + t * ray.rate.y(), 0, height_ - 1)) {}

  [[nodiscard]] int column() const { return column_; }
  [[nodiscard]] int row() const { return row_; }
  [[nodiscard]] double t() const { return t_; }

  /// Where the ray leaves the square of 2 `reach` - 1 cells about its cell.
  [[nodiscard]] double exit(int reach) const { return std::min(exit_x(reach), exit_y(reach)); }

  /// Goes to the cell behind that exit; false once it is outside the raster.
  bool leave(int reach) {
    const double x_t = exit_x(reach);
    const double y_t = exit_y(reach);
    if (std::min(x_t, y_t) == kNever) return false;  // straight down: it never leaves its cell
    if (x_t < y_t) {
      t_ = std::max(t_, x_t);
      row_ = cell(ray_.start.y() + t_ * ray_.rate.y(), row_ - reach + 1, row_ + reach - 1);
      column_ += ray_.rate.x() > 0.0 ? reach : -reach;
    } else {
      t_ = std::max(t_, y_t);
      column_ = cell(ray_.start.x() + t_ * ray_.rate.x(), column_ - reach + 1, column_ + reach - 1);
      row_ += ray_.rate.y() > 0.0 ? reach : -reach;
    }
    return column_ >= 0 && row_ >= 0 && column_ < width_ && row_ < height_;
  }

 private:
  static int cell(double position, int lowest, int highest) {
    if (!(position >= lowest)) return lowest;  // NaN too, from a rate next to nothing
    return position >= highest ? highest : static_cast<int>(std::floor(position));
  }
  [[nodiscard]] double exit_x(int reach) const {
    if (ray_.rate.x() == 0.0) return kNever;
    return ((ray_.rate.x() > 0.0 ? column_ + reach : column_ - reach + 1) - ray_.start.x()) *
           inverse_x_;
  }
  [[nodiscard]] double exit_y(int reach) const {
    if (ray_.rate.y() == 0.0) return kNever;
    return ((ray_.rate.y() > 0.0 ? row_ + reach : row_ - reach + 1) - ray_.start.y()) * inverse_y_;
  }

  const ColumnRay& ray_;
  double inverse_x_, inverse_y_;
  int width_, height_;
  double t_;
  int column_, row_;
};

/// The part of [begin, end] in which the ray is above the raster; empty where begin > end.
struct Above {
  double begin, end;
};

Above above_raster(const Raster<ClassId>& labels, const ColumnRay& ray, double begin, double end) {
  for (int axis = 0; axis < 2; ++axis) {
    const double size = axis == 0 ? labels.width() : labels.height();
    const double start = ray.start[axis];
    const double rate = ray.rate[axis];
    if (rate == 0.0) {
      if (start < 0.0 || start >= size) return {kNever, -kNever};
      continue;
    }
    const double first = -start / rate;
    const double second = (size - start) / rate;
    begin = std::max(begin, std::min(first, second));
    end = std::min(end, std::max(first, second));
  }
  return {begin, end};
}

/// Hit of the column that the walk is over, if the ray is in it between now and its exit.
ColumnHit column_hit(const World& world,
                     const ColumnRay& ray,
                     const CellWalk& walk,
                     double t_exit) {
  const double height_m = static_cast<double>(world.relief.height_m.at(walk.column(), walk.row()));
  const ClassId label = world.map.labels.at(walk.column(), walk.row());
  if (ray.z_m + walk.t() * ray.z_rate_m <= height_m) {
    const double inset = kFaceInsetCells / std::max(ray.rate.norm(), 1e-12);
    return {walk.t() + std::min(inset, 0.5 * (t_exit - walk.t())), label};
  }
  if (ray.z_m + t_exit * ray.z_rate_m < height_m) {
    return {(height_m - ray.z_m) / ray.z_rate_m, label};
  }
  return {kNever, kSky};
}

ColumnHit trace_tall(const World& world, const ColumnRay& ray, double t_end) {
  if (world.relief.tallest_m <= world.relief.low_m) return {kNever, kSky};
  if (ray.z_rate_m > 0.0) {
    t_end = std::min(t_end, (static_cast<double>(world.relief.tallest_m) - ray.z_m) / ray.z_rate_m);
  }
  const auto [begin, end] = above_raster(world.map.labels, ray, 0.0, t_end);
  if (begin >= end) return {kNever, kSky};
  CellWalk walk(world.map.labels, ray, begin);
  bool is_inside = begin == 0.0;  // of the column that the camera is in, if it is in one
  do {
    const int reach = world.relief.cells_to_tall.at(walk.column(), walk.row());
    if (reach > 0) {
      is_inside = false;
      if (!walk.leave(reach)) break;
      continue;
    }
    is_inside = is_inside &&
                ray.z_m <= static_cast<double>(world.relief.height_m.at(walk.column(), walk.row()));
    if (!is_inside) {
      const ColumnHit hit = column_hit(world, ray, walk, walk.exit(1));
      if (hit.t <= end) return hit;
    }
    if (!walk.leave(1)) break;
  } while (walk.t() < end);
  return {kNever, kSky};
}

/// Between the height of the curb-high ground and z = 0 the ray meets curb sides.
ColumnHit trace_low(const World& world, const ColumnRay& ray, double t_low, double t_ground) {
  const Raster<ClassId>& labels = world.map.labels;
  const auto ground_at = [&](double t) -> ColumnHit {
    const Eigen::Vector2d cell = ray.start + t * ray.rate;
    const int column = static_cast<int>(std::floor(cell.x()));
    const int row = static_cast<int>(std::floor(cell.y()));
    return {t, labels.contains(column, row) ? labels.at(column, row) : ClassId{kUnclassified}};
  };
  const auto [begin, end] = above_raster(labels, ray, t_low, t_ground);
  if (begin > end || world.relief.low_m == 0.0F) return ground_at(t_ground);
  CellWalk walk(labels, ray, begin);
  while (true) {
    if (world.relief.height_m.at(walk.column(), walk.row()) > 0.0F) {
      // On the top right away, or later through a side.
      if (walk.t() == t_low) return {t_low, labels.at(walk.column(), walk.row())};
      return column_hit(world, ray, walk, walk.exit(1));
    }
    if (walk.exit(1) >= t_ground) return {t_ground, labels.at(walk.column(), walk.row())};
    if (!walk.leave(1)) return {t_ground, kUnclassified};
  }
}

}  // namespace

ColumnHit trace_columns(const World& world, const ColumnRay& ray, double t_end) {
  const double low_m = static_cast<double>(world.relief.low_m);
  double t_low = kNever;
  double t_ground = kNever;
  if (ray.z_rate_m < 0.0) {
    t_low = std::max(0.0, (low_m - ray.z_m) / ray.z_rate_m);
    t_ground = std::max(0.0, -ray.z_m / ray.z_rate_m);
  }
  const ColumnHit tall = trace_tall(world, ray, std::min(t_end, t_low));
  if (tall.t < kNever) return tall;
  if (t_low > t_end) return {kNever, kSky};
  const ColumnHit low = trace_low(world, ray, t_low, t_ground);
  return low.t <= t_end ? low : ColumnHit{kNever, kSky};
}

}  // namespace nadir
