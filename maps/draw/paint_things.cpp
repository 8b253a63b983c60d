// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "maps/draw/painting.h"

namespace nadir::town {
namespace {

/// The same point in the frame of a thing: x ahead, y left.
Point in_frame(const Point& p, const Point& origin, double heading_deg) {
  const double heading_rad = heading_deg * std::numbers::pi / 180.0;
  const Point forward{std::cos(heading_rad), std::sin(heading_rad)};
  return {(p - origin).dot(forward), (p - origin).dot(Point(-forward.y(), forward.x()))};
}

Paint car_colour(std::uint32_t index) {
  const std::array<Paint, 8> colours = {
      Paint{226, 226, 224}, Paint{178, 182, 186}, Paint{58, 60, 64},    Paint{120, 124, 128},
      Paint{140, 42, 38},   Paint{52, 76, 118},   Paint{232, 230, 226}, Paint{150, 138, 112}};
  return colours[static_cast<std::size_t>(8.0F * chance(100, index))];
}

/// Seen from above: body with rounded corners, glass before and behind the roof, bonnet and boot
/// lower.
void paint_car(Canvas& canvas, const Car& car, std::uint32_t index) {
  const double half_length_m =
      car.truck ? 3.4 : 2.15 + 0.3 * static_cast<double>(chance(101, index));
  const double half_width_m = car.truck ? 1.15 : 0.92;
  const Paint body = car.truck ? Paint{214, 212, 204} : car_colour(index);
  const Point reach = Point::Constant(half_length_m + 1.0);
  for_cells(canvas.grid, {car.centre - reach, car.centre + reach},
            [&](int column, int row, const Point& p) {
              const Point q = in_frame(p, car.centre, car.heading_deg);
              const double round_m =
                  std::hypot(std::max(0.0, std::abs(q.x()) - half_length_m + 0.5),
                             std::max(0.0, std::abs(q.y()) - half_width_m + 0.5));
              if (round_m > 0.5) return;
              Paint colour = body;
              float height_m = 1.0F;
              if (car.truck) {
                const bool cab = q.x() > 1.6;
                height_m = cab ? 2.0F : 2.7F;
                if (cab) colour = {150, 60, 48};
                if (q.x() > 2.5 && q.x() < 2.9) colour = {40, 46, 52};
              } else if (q.x() > -1.45 && q.x() < 0.75) {
                height_m = 1.45F;
                const bool roof = q.x() > -0.95 && q.x() < 0.2 && std::abs(q.y()) < 0.66;
                if (!roof) colour = {44, 50, 56};
                if (roof) colour *= 1.03F;
              }
              canvas.colour.at(column, row) = colour;
              canvas.height_m.at(column, row) = height_m;
            });
}

std::vector<Car> cars_in_bays(const TownLayout& town) {
  std::vector<Car> cars;
  std::uint32_t index = 0;
  for (const BayRow& row : town.bay_rows) {
    const double heading_rad = row.row_heading_deg * std::numbers::pi / 180.0;
    const Point along{std::cos(heading_rad), std::sin(heading_rad)}, into{-along.y(), along.x()};
    const bool lengthwise = row.bay_width_m > row.bay_depth_m;
    for (int i = 0; i < row.count; ++i, ++index) {
      if (static_cast<double>(chance(110, index)) > row.filled) continue;
      const double jitter_m = 0.5 * (static_cast<double>(chance(111, index)) - 0.5);
      const Point centre =
          row.start + ((i + 0.5) * row.bay_width_m + 0.5 * row.lean_m + 0.3 * jitter_m) * along +
          (0.5 * row.bay_depth_m + (lengthwise ? 0.2 : 1.0) * jitter_m) * into;
      const double lean_deg = std::atan2(row.lean_m, row.bay_depth_m) * 180.0 / std::numbers::pi;
      const double turn_deg = chance(112, index) < 0.7F ? 0.0 : 180.0;
      const double sloppy_deg = 5.0 * (static_cast<double>(chance(113, index)) - 0.5);
      cars.push_back({centre, row.row_heading_deg + (lengthwise ? 0.0 : 90.0 - lean_deg) +
                                  turn_deg + sloppy_deg});
    }
  }
  return cars;
}

void paint_crate(Canvas& canvas, const Crate& crate) {
  const std::array<Paint, 5> colours = {Paint{148, 76, 52}, Paint{62, 92, 128}, Paint{86, 112, 84},
                                        Paint{188, 182, 168}, Paint{60, 88, 64}};
  const Point along = (crate.outline.corners[1] - crate.outline.corners[0]).normalized();
  for_cells(canvas.grid, bounds(crate.outline.corners), [&](int column, int row, const Point& p) {
    if (!contains(crate.outline, p)) return;
    const double rib_m = (p - crate.outline.corners[0]).dot(along);
    const float tone = rib_m - 0.4 * std::floor(rib_m / 0.4) < 0.2 ? 1.0F : 0.9F;
    canvas.colour.at(column, row) = colours[static_cast<std::size_t>(crate.colour)] * tone;
    canvas.height_m.at(column, row) = static_cast<float>(crate.height_m);
  });
}

/// A pole is two cells of concrete and a lamp on an arm; what one sees of it is its shadow.
void paint_pole(Canvas& canvas, const Point& pole) {
  for_cells(canvas.grid, Box{pole, pole}.grown(1.8), [&](int column, int row, const Point& p) {
    const Point away = p - pole;
    const bool post = away.norm() < 0.13;
    const bool arm = std::abs(away.x()) < 0.06 && away.y() < 0.0 && away.y() > -1.6;
    if (!post && !arm) return;
    canvas.colour.at(column, row) = {172, 170, 164};
    // A height is solid down to the ground, so an arm with height would throw a wall's shadow.
    if (post) canvas.height_m.at(column, row) = 7.0F;
  });
}

}  // namespace

void paint_things(Canvas& canvas, const TownLayout& town) {
  for (const Crate& crate : town.crates) paint_crate(canvas, crate);
  std::uint32_t index = 0;
  for (const Car& car : town.cars) paint_car(canvas, car, index++);
  for (const Car& car : cars_in_bays(town)) paint_car(canvas, car, index++);
  for (const Point& pole : town.poles) paint_pole(canvas, pole);
}

}  // namespace nadir::town
