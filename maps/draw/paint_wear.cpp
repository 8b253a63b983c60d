// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>

#include "maps/draw/painting.h"

namespace nadir::town {
namespace {

bool on_road(const Ground& ground, int column, int row) {
  return class_of(ground.bare.at(column, row)) == kRoad;
}

/// Multiplies the colour of every road cell of a shape.
void tint(Canvas& canvas, const Ground& ground, const Polygon& shape, float tone) {
  for_cells(canvas.grid, bounds(shape.corners), [&](int column, int row, const Point& p) {
    if (on_road(ground, column, row) && contains(shape, p)) canvas.colour.at(column, row) *= tone;
  });
}

/// A crack wanders from a point; a sealed one is a black ribbon.
void crack(Canvas& canvas,
           const Ground& ground,
           Point p,
           double heading_rad,
           double length_m,
           bool sealed,
           std::uint32_t index) {
  Polyline line{{p}};
  const double main_heading_rad = heading_rad;
  for (int i = 0; i < static_cast<int>(length_m / 0.4); ++i) {
    heading_rad += 0.25 * (main_heading_rad - heading_rad);
    heading_rad +=
        1.0 * (static_cast<double>(chance(20, index, static_cast<std::uint32_t>(i))) - 0.5);
    p += 0.4 * Point(std::cos(heading_rad), std::sin(heading_rad));
    line.points.push_back(p);
  }
  if (line.points.size() < 2) return;
  const double half_m = sealed ? 0.09 : 0.055;
  const float tone = sealed ? 0.62F : 0.8F;
  for_cells(canvas.grid, bounds(line.points).grown(0.2), [&](int column, int row, const Point& q) {
    if (on_road(ground, column, row) && nearest(line, q).distance_m < half_m) {
      canvas.colour.at(column, row) *= tone;
    }
  });
}

void paint_cracks(Canvas& canvas, const TownLayout& town, const Ground& ground) {
  for (std::uint32_t s = 0; s < town.streets.size(); ++s) {
    const Street& street = town.streets[s];
    const double street_m = nadir::town::length_m(street.centre);
    const double spacing_m = street.surface == Surface::kNewAsphalt   ? 40.0
                             : street.surface == Surface::kOldAsphalt ? 5.0
                                                                      : 10.0;
    for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(street_m / spacing_m); ++i) {
      const std::uint32_t index = s * 1000 + i;
      const double along_m = street_m * static_cast<double>(chance(21, index));
      const double lateral_m =
          (static_cast<double>(chance(22, index)) * 2.0 - 1.0) * street.half_width_m;
      const bool across = chance(23, index) < 0.5F;
      const double heading_deg = heading_at_deg(street.centre, along_m) + (across ? 90.0 : 0.0);
      const Point from =
          point_at(street.centre, along_m, across ? -street.half_width_m : lateral_m);
      const double reach_m =
          across ? street.half_width_m * (0.8 + 1.4 * static_cast<double>(chance(24, index)))
                 : 4.0 + 16.0 * static_cast<double>(chance(24, index));
      crack(canvas, ground, from, heading_deg * std::numbers::pi / 180.0, reach_m,
            chance(25, index) < 0.35F, index);
    }
  }
}

/// Rectangles that were dug up and filled, with dark joints, and strips where a pipe was laid.
void paint_patches(Canvas& canvas, const TownLayout& town, const Ground& ground) {
  for (std::uint32_t s = 0; s < town.streets.size(); ++s) {
    const Street& street = town.streets[s];
    if (street.surface == Surface::kNewAsphalt) continue;
    const double street_m = length_m(street.centre);
    for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(street_m / 28.0); ++i) {
      const std::uint32_t index = s * 1000 + i;
      const double along_m = street_m * static_cast<double>(chance(30, index));
      const double side = chance(31, index) < 0.5F ? -1.0 : 1.0;
      const double size_m = 1.2 + 5.0 * static_cast<double>(chance(32, index) * chance(33, index));
      const Point centre = point_at(street.centre, along_m, side * street.half_width_m * 0.55);
      const double heading_deg = heading_at_deg(street.centre, along_m);
      const Polygon patch = rectangle(
          centre, size_m, 1.4 + 1.2 * static_cast<double>(chance(34, index)), heading_deg);
      tint(canvas, ground, patch, chance(35, index) < 0.7F ? 0.8F : 1.1F);
      for (std::size_t c = 0; c < 4; ++c) {
        const Polyline edge{{patch.corners[c], patch.corners[(c + 1) % 4]}};
        tint(canvas, ground, strip(edge, 0.0, length_m(edge), 0.0, 0.14), 0.75F);
      }
      const Point lid = point_at(street.centre, street_m * static_cast<double>(chance(36, index)),
                                 side * street.half_width_m * 0.4);
      tint(canvas, ground, disc(lid, 0.5, 24), 1.08F);
      tint(canvas, ground, disc(lid, 0.36, 24), 0.6F);
    }
  }
}

/// Old lines that were blacked out when the new ones were painted half a metre beside them.
void paint_ghost_lines(Canvas& canvas, const TownLayout& town, const Ground& ground) {
  const Street& main = town.streets[0];
  for (int i = 0; i < 9; ++i) {
    tint(canvas, ground, strip(main.centre, 62.0 + 9.0 * i, 65.5 + 9.0 * i, 0.7, 0.2), 0.84F);
    tint(canvas, ground, strip(main.centre, 166.0 + 8.0 * i, 169.0 + 8.0 * i, -0.6, 0.18), 1.14F);
  }
}

/// Oil where cars stand.
void paint_oil(Canvas& canvas, const TownLayout& town, const Ground& ground) {
  std::uint32_t index = 0;
  for (const BayRow& row : town.bay_rows) {
    const Point along = rectangle({0, 0}, 2.0, 2.0, row.row_heading_deg).corners[1] -
                        rectangle({0, 0}, 2.0, 2.0, row.row_heading_deg).corners[0];
    const Point unit = along / 2.0, into{-unit.y(), unit.x()};
    for (int i = 0; i < row.count; ++i, ++index) {
      const Point spot =
          row.start +
          (i + 0.45 + 0.1 * static_cast<double>(chance(40, index))) * row.bay_width_m * unit +
          row.bay_depth_m * (0.3 + 0.4 * static_cast<double>(chance(41, index))) * into;
      const double radius_m = 0.3 + 0.5 * static_cast<double>(chance(42, index));
      tint(canvas, ground, disc(spot, radius_m, 20), 0.88F);
      tint(canvas, ground, disc(spot, 0.6 * radius_m, 20), 0.86F);
    }
  }
}

/// The heap in the yard: broken concrete on clay, heights and all.
void paint_rubble(Canvas& canvas, const Ground& ground) {
  for (std::uint32_t i = 0; i < 420; ++i) {
    const double angle_rad = 2.0 * std::numbers::pi * static_cast<double>(chance(50, i));
    const double away_m = 5.6 * std::sqrt(static_cast<double>(chance(51, i)));
    const Point at =
        Point(-69.0, -54.0) + away_m * Point(0.75 * std::cos(angle_rad), std::sin(angle_rad));
    const double size_m = 0.4 + 1.4 * static_cast<double>(chance(52, i) * chance(53, i));
    const Polygon slab =
        rectangle(at, size_m, size_m * (0.4 + 0.6 * static_cast<double>(chance(54, i))),
                  180.0 * static_cast<double>(chance(55, i)));
    const auto heap_m = static_cast<float>(std::max(0.15, 2.4 - 0.42 * away_m));
    const Paint colour =
        blend({182, 172, 158}, {150, 112, 88}, chance(56, i)) * (0.85F + 0.25F * chance(57, i));
    for_cells(canvas.grid, bounds(slab.corners), [&](int column, int row, const Point& p) {
      if (class_of(ground.bare.at(column, row)) != kTerrain || !contains(slab, p)) return;
      canvas.colour.at(column, row) = colour;
      canvas.height_m.at(column, row) = heap_m * (0.75F + 0.25F * chance(58, i));
    });
  }
}

}  // namespace

void paint_wear(Canvas& canvas, const TownLayout& town, const Ground& ground) {
  paint_patches(canvas, town, ground);
  paint_ghost_lines(canvas, town, ground);
  paint_cracks(canvas, town, ground);
  paint_oil(canvas, town, ground);
  paint_rubble(canvas, ground);
}

}  // namespace nadir::town
