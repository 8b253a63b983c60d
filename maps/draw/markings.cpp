// SPDX-License-Identifier: Apache-2.0
#include "maps/draw/markings.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nadir::town {
namespace {

constexpr double kLineM = 0.2;

/// Whether a street's lines stop at a point, because a junction or a circle is there.
bool in_junction(const TownLayout& town, int street, const Point& p) {
  for (const Junction& junction : town.junctions) {
    if (junction.first != street && junction.second != street) continue;
    if ((p - junction.centre).norm() < junction.clear_m) return true;
  }
  return std::any_of(town.circles.begin(), town.circles.end(), [&](const Circle& circle) {
    return (p - circle.centre).norm() < circle.radius_m + 5.0;
  });
}

bool on_crossing(const TownLayout& town, const Point& p) {
  return std::any_of(town.crossings.begin(), town.crossings.end(),
                     [&](const Crossing& crossing) { return (p - crossing.centre).norm() < 2.6; });
}

/// Pieces of `dash_m` with gaps between, wherever both ends are clear of junctions.
void add_line(std::vector<Painted>& shapes,
              const TownLayout& town,
              int index,
              double lateral_m,
              double dash_m,
              double gap_m,
              bool yellow) {
  const Street& street = town.streets[static_cast<std::size_t>(index)];
  const double end_m = length_m(street.centre);
  const int count = static_cast<int>((end_m - street.first_dash_m) / (dash_m + gap_m));
  for (int i = 0; i < count; ++i) {
    const double from_m = street.first_dash_m + i * (dash_m + gap_m);
    const double to_m = from_m + dash_m;
    const Point from = point_at(street.centre, from_m, lateral_m);
    const Point to = point_at(street.centre, to_m, lateral_m);
    if (in_junction(town, index, point_at(street.centre, from_m)) ||
        in_junction(town, index, point_at(street.centre, to_m)) || on_crossing(town, from) ||
        on_crossing(town, to)) {
      continue;
    }
    shapes.push_back({strip(street.centre, from_m, to_m, lateral_m, kLineM), yellow});
  }
}

void add_street_lines(std::vector<Painted>& shapes, const TownLayout& town) {
  for (int i = 0; i < static_cast<int>(town.streets.size()); ++i) {
    const Street& street = town.streets[static_cast<std::size_t>(i)];
    switch (street.centre_line) {
      case CentreLine::kNone:
        break;
      case CentreLine::kDashed:
        add_line(shapes, town, i, 0.0, street.dash_m, street.gap_m, true);
        break;
      case CentreLine::kSolid:
        add_line(shapes, town, i, 0.0, 1.0, 0.0, true);
        break;
      case CentreLine::kDouble:
        add_line(shapes, town, i, 0.2, 1.0, 0.0, true);
        add_line(shapes, town, i, -0.2, 1.0, 0.0, true);
        break;
    }
    if (!street.edge_lines) continue;
    add_line(shapes, town, i, street.half_width_m - 0.4, 1.0, 0.0, false);
    add_line(shapes, town, i, 0.4 - street.half_width_m, 1.0, 0.0, false);
  }
}

void add_bays(std::vector<Painted>& shapes, const BayRow& row) {
  const double heading_rad = row.row_heading_deg * std::numbers::pi / 180.0;
  const Point along{std::round(std::cos(heading_rad)), std::round(std::sin(heading_rad))};
  const Point into{-along.y(), along.x()};
  for (int i = 0; i <= row.count; ++i) {
    const Point from = row.start + i * row.bay_width_m * along;
    const Point to = from + row.bay_depth_m * into + row.lean_m * along;
    const Polyline line{{from, to}};
    shapes.push_back({strip(line, 0.0, length_m(line), 0.0, kLineM)});
  }
}

void add_crossing(std::vector<Painted>& shapes, const Crossing& crossing) {
  constexpr double kStripeM = 0.5, kLengthM = 3.0;
  const int count = static_cast<int>((crossing.road_width_m - 0.3) / (2.0 * kStripeM));
  for (int i = 0; i < count; ++i) {
    const double lateral_m = (i - 0.5 * (count - 1)) * 2.0 * kStripeM;
    const Polygon stripe = rectangle({0.0, lateral_m}, kLengthM, kStripeM);
    shapes.push_back({placed(stripe, crossing.centre, crossing.road_heading_deg)});
  }
}

/// An arrow of 4 m in its own frame: x ahead, y left.
std::vector<Polygon> arrow_parts(Arrow::Kind kind) {
  if (kind == Arrow::kAhead) {
    return {{{{0.0, -0.1}, {2.6, -0.1}, {2.6, 0.1}, {0.0, 0.1}}},
            {{{2.4, -0.5}, {4.0, 0.0}, {2.4, 0.5}}}};
  }
  const double side = kind == Arrow::kLeft ? 1.0 : -1.0;
  return {{{{0.0, -0.1}, {2.7, -0.1}, {2.7, 0.1}, {0.0, 0.1}}},
          {{{2.5, 0.0}, {2.7, 0.0}, {3.1, 0.7 * side}, {2.8, 0.7 * side}}},
          {{{2.2, 0.6 * side}, {3.7, 0.6 * side}, {3.0, 1.5 * side}}}};
}

}  // namespace

std::vector<Painted> painted_shapes(const TownLayout& town) {
  std::vector<Painted> shapes;
  add_street_lines(shapes, town);
  for (const BayRow& row : town.bay_rows) add_bays(shapes, row);
  for (const StopLine& line : town.stop_lines) {
    shapes.push_back({rectangle(line.centre, 0.4, line.length_m, line.road_heading_deg)});
  }
  for (const Crossing& crossing : town.crossings) add_crossing(shapes, crossing);
  for (const Arrow& arrow : town.arrows) {
    for (const Polygon& part : arrow_parts(arrow.kind)) {
      shapes.push_back({placed(part, arrow.tail, arrow.heading_deg)});
    }
  }
  shapes.insert(shapes.end(), town.painted.begin(), town.painted.end());
  return shapes;
}

}  // namespace nadir::town
