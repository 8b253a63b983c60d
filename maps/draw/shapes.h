// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

namespace nadir::town {

/// Every coordinate of the drawing is in `enu`: metres east and north of the middle of the town.
using Point = Eigen::Vector2d;

struct Box {
  Point low = Point::Zero(), high = Point::Zero();

  [[nodiscard]] Box grown(double by_m) const {
    return {low - Point::Constant(by_m), high + Point::Constant(by_m)};
  }
  [[nodiscard]] bool contains(const Point& p) const {
    return p.x() >= low.x() && p.x() <= high.x() && p.y() >= low.y() && p.y() <= high.y();
  }
};

/// A simple polygon; the last corner joins the first.
struct Polygon {
  std::vector<Point> corners;
};

[[nodiscard]] Box bounds(const std::vector<Point>& points);
/// Even-odd rule; an edge belongs to the side below it, so that polygons that share an edge share
/// no point.
[[nodiscard]] bool contains(const Polygon& polygon, const Point& p);
/// Distance to the outline in metres, negative inside.
[[nodiscard]] double signed_distance(const Polygon& polygon, const Point& p);

/// A chain of straight pieces; arcs are chains of one-degree pieces (1.5 mm off at a radius of 40
/// m).
struct Polyline {
  std::vector<Point> points;
};

/// The place on a line that is nearest to a point.
struct Foot {
  double distance_m = 0.0;
  double along_m = 0.0;    ///< From the start of the line.
  double lateral_m = 0.0;  ///< Signed distance, positive to the left of the line's direction.
  bool at_end = false;     ///< Whether it is the first or last point of the line.
};
[[nodiscard]] Foot nearest(const Polyline& line, const Point& p);
[[nodiscard]] double length_m(const Polyline& line);
/// Point at a distance along the line, `lateral_m` to its left.
[[nodiscard]] Point point_at(const Polyline& line, double along_m, double lateral_m = 0.0);
/// Direction there, counter-clockwise from east.
[[nodiscard]] double heading_at_deg(const Polyline& line, double along_m);

/// Rectangle of `length_m` along `heading_deg` and `width_m` across it.
[[nodiscard]] Polygon rectangle(const Point& centre,
                                double length_m,
                                double width_m,
                                double heading_deg = 0.0);
[[nodiscard]] Polygon disc(const Point& centre, double radius_m, int corners = 90);
/// Band of `width_m` about the piece of the line from `from_m` to `to_m`, `lateral_m` to its left.
[[nodiscard]] Polygon strip(
    const Polyline& line, double from_m, double to_m, double lateral_m, double width_m);
/// `polygon` turned by `heading_deg` about the origin and then moved by `offset`.
[[nodiscard]] Polygon placed(const Polygon& polygon, const Point& offset, double heading_deg);
/// Adds the arc about `centre` from one angle to the other (counter-clockwise where `to_deg` is
/// larger).
void append_arc(
    Polyline& line, const Point& centre, double radius_m, double from_deg, double to_deg);

/// Union of two regions given by signed distances, its inner corners rounded with a radius: kerbs
/// at a street corner.
[[nodiscard]] double rounded_union(double first_m, double second_m, double radius_m);

}  // namespace nadir::town
