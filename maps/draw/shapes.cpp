// SPDX-License-Identifier: Apache-2.0
#include "maps/draw/shapes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/angle.h"
#include "core/base/require.h"

namespace nadir::town {
namespace {

Point direction(double heading_deg) {
  const double heading_rad = heading_deg * std::numbers::pi / 180.0;
  return {std::cos(heading_rad), std::sin(heading_rad)};
}

double cross(const Point& a, const Point& b) { return a.x() * b.y() - a.y() * b.x(); }

Point left_of(const Point& forward) { return {-forward.y(), forward.x()}; }

/// Share of the way from a to b at which the piece is nearest to p.
double nearest_share(const Point& a, const Point& b, const Point& p) {
  const Point piece = b - a;
  const double squared = piece.squaredNorm();
  return squared > 0.0 ? std::clamp((p - a).dot(piece) / squared, 0.0, 1.0) : 0.0;
}

/// The piece that holds a distance along the line, and how far into it that is.
struct Place {
  std::size_t piece = 0;
  double into_m = 0.0;
};

Place place_at(const Polyline& line, double along_m) {
  NADIR_REQUIRE(line.points.size() >= 2);
  for (std::size_t i = 0; i + 2 < line.points.size(); ++i) {
    const double piece_m = (line.points[i + 1] - line.points[i]).norm();
    if (along_m <= piece_m) return {i, along_m};
    along_m -= piece_m;
  }
  return {line.points.size() - 2, along_m};
}

Point forward_of(const Polyline& line, std::size_t piece) {
  return (line.points[piece + 1] - line.points[piece]).normalized();
}

}  // namespace

Box bounds(const std::vector<Point>& points) {
  NADIR_REQUIRE(!points.empty());
  Box box{points.front(), points.front()};
  for (const Point& p : points) {
    box.low = box.low.cwiseMin(p);
    box.high = box.high.cwiseMax(p);
  }
  return box;
}

bool contains(const Polygon& polygon, const Point& p) {
  bool inside = false;
  const auto& corners = polygon.corners;
  for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
    const Point &a = corners[i], &b = corners[j];
    if ((a.y() > p.y()) == (b.y() > p.y())) continue;
    if (p.x() < a.x() + (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y())) inside = !inside;
  }
  return inside;
}

double signed_distance(const Polygon& polygon, const Point& p) {
  double squared = std::numeric_limits<double>::infinity();
  const auto& corners = polygon.corners;
  for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
    const double share = nearest_share(corners[j], corners[i], p);
    squared = std::min(squared, (corners[j] + share * (corners[i] - corners[j]) - p).squaredNorm());
  }
  return contains(polygon, p) ? -std::sqrt(squared) : std::sqrt(squared);
}

Foot nearest(const Polyline& line, const Point& p) {
  Foot best{std::numeric_limits<double>::infinity()};
  double squared = best.distance_m;
  double start_m = 0.0;
  for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
    const Point &a = line.points[i], &b = line.points[i + 1];
    const double share = nearest_share(a, b, p);
    const double piece_squared = (a + share * (b - a) - p).squaredNorm();
    const double piece_m = (b - a).norm();
    if (piece_squared < squared) {
      squared = piece_squared;
      best.along_m = start_m + share * piece_m;
      best.at_end = (i == 0 && share == 0.0) || (i + 2 == line.points.size() && share == 1.0);
      best.lateral_m = cross(b - a, p - a) >= 0.0 ? 1.0 : -1.0;
    }
    start_m += piece_m;
  }
  best.distance_m = std::sqrt(squared);
  best.lateral_m *= best.distance_m;
  return best;
}

double length_m(const Polyline& line) {
  double sum_m = 0.0;
  for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
    sum_m += (line.points[i + 1] - line.points[i]).norm();
  }
  return sum_m;
}

Point point_at(const Polyline& line, double along_m, double lateral_m) {
  const Place place = place_at(line, along_m);
  const Point forward = forward_of(line, place.piece);
  return line.points[place.piece] + place.into_m * forward + lateral_m * left_of(forward);
}

double heading_at_deg(const Polyline& line, double along_m) {
  const Point forward = forward_of(line, place_at(line, along_m).piece);
  return std::atan2(forward.y(), forward.x()) * 180.0 / std::numbers::pi;
}

Polygon rectangle(const Point& centre, double length_m, double width_m, double heading_deg) {
  const double x = length_m / 2.0, y = width_m / 2.0;
  return placed({{{-x, -y}, {x, -y}, {x, y}, {-x, y}}}, centre, heading_deg);
}

Polygon disc(const Point& centre, double radius_m, int corners) {
  Polygon result;
  for (int i = 0; i < corners; ++i) {
    result.corners.emplace_back(centre + radius_m * direction(360.0 * i / corners));
  }
  return result;
}

Polygon strip(const Polyline& line, double from_m, double to_m, double lateral_m, double width_m) {
  constexpr double kStepM = 1.0;
  const int steps = heading_at_deg(line, from_m) == heading_at_deg(line, to_m)
                        ? 1
                        : static_cast<int>(std::ceil((to_m - from_m) / kStepM));
  std::vector<Point> left, right;
  for (int i = 0; i <= steps; ++i) {
    const double along_m = from_m + (to_m - from_m) * i / steps;
    left.push_back(point_at(line, along_m, lateral_m + width_m / 2.0));
    right.push_back(point_at(line, along_m, lateral_m - width_m / 2.0));
  }
  right.insert(right.end(), left.rbegin(), left.rend());
  return {right};
}

Polygon placed(const Polygon& polygon, const Point& offset, double heading_deg) {
  // No turn means no trigonometry: axis-aligned shapes keep their exact corners.
  const Point forward = heading_deg == 0.0 ? Point(1.0, 0.0) : direction(heading_deg);
  Polygon result;
  for (const Point& p : polygon.corners) {
    result.corners.emplace_back(offset + p.x() * forward + p.y() * left_of(forward));
  }
  return result;
}

void append_arc(
    Polyline& line, const Point& centre, double radius_m, double from_deg, double to_deg) {
  const int pieces = std::max(1, static_cast<int>(std::ceil(std::abs(to_deg - from_deg))));
  for (int i = 0; i <= pieces; ++i) {
    line.points.emplace_back(centre +
                             radius_m * direction(from_deg + (to_deg - from_deg) * i / pieces));
  }
}

double rounded_union(double first_m, double second_m, double radius_m) {
  const double nearer_m = std::min(first_m, second_m);
  const double first_into_m = std::max(radius_m - first_m, 0.0);
  const double second_into_m = std::max(radius_m - second_m, 0.0);
  if (first_into_m == 0.0 || second_into_m == 0.0) return nearer_m;
  return std::min(
      nearer_m, radius_m - std::sqrt(first_into_m * first_into_m + second_into_m * second_into_m));
}

}  // namespace nadir::town
