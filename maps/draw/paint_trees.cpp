// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>

#include "maps/draw/painting.h"

namespace nadir::town {
namespace {

/// A ball of leaves.
struct Clump {
  Point centre = Point::Zero();
  double radius_m = 0.6, centre_height_m = 3.0;
  Paint colour = Paint::Zero();
};

void paint_clump(Canvas& canvas, const Clump& clump) {
  const Point reach = Point::Constant(clump.radius_m);
  for_cells(canvas.grid, {clump.centre - reach, clump.centre + reach},
            [&](int column, int row, const Point& p) {
              const double left =
                  clump.radius_m * clump.radius_m - (p - clump.centre).squaredNorm();
              if (left <= 0.0) return;
              const auto top_m = static_cast<float>(clump.centre_height_m + 0.8 * std::sqrt(left));
              float& height_m = canvas.height_m.at(column, row);
              if (top_m <= height_m) return;
              height_m = top_m;
              const float leaf =
                  chance(70, static_cast<std::uint32_t>(row), static_cast<std::uint32_t>(column));
              canvas.colour.at(column, row) = clump.colour * (0.82F + 0.36F * leaf);
            });
}

Paint leaf_colour(std::uint32_t index) {
  const Paint kinds[] = {{72, 86, 50}, {82, 96, 56}, {62, 76, 50}, {94, 100, 62}, {76, 84, 62}};
  const auto kind = static_cast<std::size_t>(5.0F * chance(71, index));
  return kinds[kind] * (0.9F + 0.22F * chance(72, index));
}

/// A crown: clumps over a dome with a lopsided rim, so that no two trees have the same outline.
void paint_tree(Canvas& canvas, const Tree& tree, std::uint32_t index) {
  const double height_m = 2.2 + 1.5 * tree.radius_m;
  const Paint colour = leaf_colour(index);
  const double lobes_rad = 6.28 * static_cast<double>(chance(73, index));
  const auto count = static_cast<std::uint32_t>(16.0 + 11.0 * tree.radius_m * tree.radius_m);
  for (std::uint32_t i = 0; i < count; ++i) {
    const double angle_rad = 2.0 * std::numbers::pi * static_cast<double>(chance(74, index, i));
    const double share = std::sqrt(static_cast<double>(chance(75, index, i)));
    const double rim_m = tree.radius_m * (0.84 + 0.13 * std::sin(3.0 * angle_rad + lobes_rad) +
                                          0.08 * std::sin(5.0 * angle_rad + 2.0 * lobes_rad));
    Clump clump;
    clump.centre = tree.centre + share * rim_m * Point(std::cos(angle_rad), std::sin(angle_rad));
    clump.radius_m =
        (0.26 + 0.075 * tree.radius_m) * (0.6 + 0.8 * static_cast<double>(chance(76, index, i)));
    clump.centre_height_m = height_m * (0.5 + 0.5 * std::sqrt(1.0 - 0.92 * share * share)) - 0.8 +
                            0.6 * static_cast<double>(chance(77, index, i));
    clump.colour = colour * (0.84F + 0.32F * chance(78, index, i));
    paint_clump(canvas, clump);
  }
}

/// Trees all over the woods, bushes all over shrubs and hedges: one try a lattice place, jittered.
void paint_thicket(Canvas& canvas, const Ground& ground, Surface surface, double spacing_m) {
  const bool woods = surface == Surface::kWoods;
  const Grid& grid = canvas.grid;
  const int columns = static_cast<int>(grid.columns * grid.metres_per_cell / spacing_m);
  const int rows = static_cast<int>(grid.rows * grid.metres_per_cell / spacing_m);
  const std::uint32_t purpose = woods ? 80 : 90;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const auto index = static_cast<std::uint32_t>(j * columns + i);
      const double x_m = (i + static_cast<double>(chance(purpose, index))) * spacing_m;
      const double y_m = (j + static_cast<double>(chance(purpose + 1, index))) * spacing_m;
      const int column = static_cast<int>(x_m / grid.metres_per_cell);
      const int row = static_cast<int>(y_m / grid.metres_per_cell);
      if (!ground.bare.contains(column, row) || ground.bare.at(column, row) != surface) continue;
      const Point p = grid.centre(column, row);
      if (woods) {
        paint_tree(canvas, {p, 1.8 + 2.6 * static_cast<double>(chance(82, index))}, 10'000 + index);
        continue;
      }
      const Paint tint = blend({78, 92, 52}, {112, 112, 70}, chance(92, index));
      const double size_m = 0.35 + 0.35 * static_cast<double>(chance(93, index));
      paint_clump(canvas, {p, size_m, 0.5 + 0.6 * static_cast<double>(chance(94, index)), tint});
    }
  }
}

}  // namespace

void paint_trees(Canvas& canvas, const TownLayout& town, const Ground& ground) {
  paint_thicket(canvas, ground, Surface::kShrubs, 0.45);
  paint_thicket(canvas, ground, Surface::kWoods, 3.1);
  for (std::uint32_t i = 0; i < town.trees.size(); ++i) paint_tree(canvas, town.trees[i], i);
}

}  // namespace nadir::town
