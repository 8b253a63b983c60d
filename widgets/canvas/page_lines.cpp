// SPDX-License-Identifier: Apache-2.0
#include "widgets/canvas/page_lines.h"

#include <algorithm>
#include <array>
#include <optional>

namespace nadir {
namespace {

/// Shares of the way from a to b between which it runs inside the box.
std::optional<std::array<double, 2>> shares_inside(const Eigen::Vector2d& a,
                                                   const Eigen::Vector2d& b,
                                                   const Eigen::AlignedBox2d& box) {
  std::array<double, 2> shares = {0.0, 1.0};
  for (Eigen::Index axis = 0; axis < 2; ++axis) {
    const double way = b[axis] - a[axis];
    const double to_low = box.min()[axis] - a[axis];
    const double to_high = box.max()[axis] - a[axis];
    if (way == 0.0) {
      if (to_low > 0.0 || to_high < 0.0) return std::nullopt;
      continue;
    }
    shares[0] = std::max(shares[0], std::min(to_low / way, to_high / way));
    shares[1] = std::min(shares[1], std::max(to_low / way, to_high / way));
  }
  if (shares[0] >= shares[1]) return std::nullopt;
  return shares;
}

/// The part of an outline on one side of a line along an axis (Sutherland and Hodgman 1974).
std::vector<Eigen::Vector2d> half_inside(const std::vector<Eigen::Vector2d>& outline,
                                         Eigen::Index axis,
                                         double border,
                                         bool keeps_above) {
  std::vector<Eigen::Vector2d> kept;
  const auto is_inside = [=](const Eigen::Vector2d& point) {
    return keeps_above ? point[axis] >= border : point[axis] <= border;
  };
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Eigen::Vector2d& from = outline[i == 0 ? outline.size() - 1 : i - 1];
    const Eigen::Vector2d& to = outline[i];
    if (is_inside(from) != is_inside(to)) {
      const double share = (border - from[axis]) / (to[axis] - from[axis]);
      kept.emplace_back(from + share * (to - from));
      kept.back()[axis] = border;
    }
    if (is_inside(to)) kept.push_back(to);
  }
  return kept;
}

}  // namespace

Eigen::AlignedBox2d surroundings_of_page(double width, double height) {
  constexpr double kAround = 10'000.0;
  return {Eigen::Vector2d(-kAround, -kAround), Eigen::Vector2d(width + kAround, height + kAround)};
}

std::vector<LinePiece> line_inside(std::span<const Eigen::Vector2d> line,
                                   const Eigen::AlignedBox2d& box) {
  std::vector<LinePiece> pieces;
  double along = 0.0;
  bool is_open = false;  // whether the last piece ends at the point before
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Eigen::Vector2d& a = line[i - 1];
    const Eigen::Vector2d& b = line[i];
    if (!a.allFinite() || !b.allFinite()) {
      is_open = false;
      along = 0.0;
      continue;
    }
    const double length = (b - a).norm();
    const auto shares = shares_inside(a, b, box);
    if (shares) {
      const auto [begin, end] = *shares;
      if (!is_open || begin > 0.0) {
        pieces.push_back({{begin > 0.0 ? a + begin * (b - a) : a}, along + begin * length});
      }
      pieces.back().points.emplace_back(end < 1.0 ? a + end * (b - a) : b);
      is_open = end == 1.0;
    } else if (a != b || !is_open) {
      is_open = false;
    }
    along += length;
  }
  return pieces;
}

std::vector<Eigen::Vector2d> area_inside(std::span<const Eigen::Vector2d> outline,
                                         const Eigen::AlignedBox2d& box) {
  std::vector<Eigen::Vector2d> area;
  for (const Eigen::Vector2d& point : outline) {
    if (point.allFinite()) area.push_back(point);
  }
  const auto is_inside = [&box](const Eigen::Vector2d& point) { return box.contains(point); };
  if (!std::all_of(area.begin(), area.end(), is_inside)) {
    for (Eigen::Index axis = 0; axis < 2; ++axis) {
      area = half_inside(area, axis, box.min()[axis], true);
      area = half_inside(area, axis, box.max()[axis], false);
    }
  }
  if (area.size() < 3) area.clear();
  return area;
}

}  // namespace nadir
