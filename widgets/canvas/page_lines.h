// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Geometry>
#include <span>
#include <vector>

namespace nadir {

/// Cairo's and browsers' numbers have no room for points hundreds of kilometres off the page, which a map far from its
/// run or a close look at a long flight gives. What cannot be seen is cut off before.

/// The page and so much around it that no line is drawn otherwise for being cut there.
[[nodiscard]] Eigen::AlignedBox2d surroundings_of_page(double width, double height);

struct LinePiece {
  std::vector<Eigen::Vector2d> points;  ///< Two or more.
  double begin = 0.0;  ///< Of the piece, along the line from where its dashes begin.
};

/// Pieces of an open line inside a box. A line ends before a point that is not finite and begins anew after it.
[[nodiscard]] std::vector<LinePiece> line_inside(std::span<const Eigen::Vector2d> line,
                                                 const Eigen::AlignedBox2d& box);

/// An outline around the part of an area that lies inside a box, even-odd as before; empty where nothing does. Points that
/// are not finite are left out.
[[nodiscard]] std::vector<Eigen::Vector2d> area_inside(std::span<const Eigen::Vector2d> outline,
                                                       const Eigen::AlignedBox2d& box);

}  // namespace nadir
