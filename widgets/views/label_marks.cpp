// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/label_marks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

namespace nadir {
namespace {

using PageLine = std::vector<Eigen::Vector2d>;

void stroke_mark(Canvas& canvas, const PageLine& line, double width_pt, const MarkLook& look) {
  canvas.stroke(line, {look.casing, (width_pt + 1.6) * look.px_per_pt});
  canvas.stroke(line, {look.colour, width_pt * look.px_per_pt});
}

/// Closed, and its first side once more, so that the last corner is like the others.
PageLine polygon_around(const Eigen::Vector2d& at, double radius_px, int corners, double turn_rad) {
  PageLine polygon;
  for (int i = 0; i <= corners + 1; ++i) {
    const double angle = turn_rad + 2.0 * std::numbers::pi * i / corners;
    polygon.emplace_back(at + radius_px * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
  }
  return polygon;
}

PageLine square_around(const Eigen::Vector2d& at, double half_px) {
  return polygon_around(at, half_px * std::numbers::sqrt2, 4, std::numbers::pi / 4.0);
}

PageLine circle_around(const Eigen::Vector2d& at, double radius_px) {
  const int corners = static_cast<int>(std::clamp(radius_px, 24.0, 180.0));
  return polygon_around(at, radius_px, corners, 0.0);
}

PageLine outline_of_polygon(PageLine polygon) {
  polygon.resize(polygon.size() - 2);
  return polygon;
}

}  // namespace

void draw_corner(Canvas& canvas, const Eigen::Vector2d& at, bool is_picked, const MarkLook& look) {
  const double half = (is_picked ? 3.4 : 2.2) * look.px_per_pt;
  canvas.fill(outline_of_polygon(square_around(at, half + 0.9 * look.px_per_pt)), look.casing);
  if (is_picked) {
    canvas.fill(outline_of_polygon(square_around(at, half)), look.colour);
  } else {
    canvas.stroke(square_around(at, half), {look.colour, 1.1 * look.px_per_pt});
  }
}

void draw_snap_mark(Canvas& canvas,
                    const Eigen::Vector2d& at,
                    SnapMark mark,
                    const Eigen::Vector2d& along,
                    const MarkLook& look) {
  const double px = look.px_per_pt;
  const Eigen::Vector2d across(-along.y(), along.x());
  switch (mark) {
    case SnapMark::kCorner:
      return stroke_mark(canvas, square_around(at, 5.0 * px), 1.5, look);
    case SnapMark::kEdge:
      return stroke_mark(canvas, polygon_around(at, 6.5 * px, 4, 0.0), 1.5, look);
    case SnapMark::kContinuing:
      for (const double place : {-2.5, 2.5}) {
        const Eigen::Vector2d middle = at + place * px * along;
        stroke_mark(canvas, {middle - 6.0 * px * across, middle + 6.0 * px * across}, 1.5, look);
      }
      return;
    case SnapMark::kSquareOn: {
      const double side = 9.0 * px;
      stroke_mark(canvas, {at - side * along, at, at + side * across}, 1.5, look);
      stroke_mark(canvas,
                  {at - side / 2.0 * along, at - side / 2.0 * along + side / 2.0 * across,
                   at + side / 2.0 * across},
                  1.2, look);
      return;
    }
    case SnapMark::kClosing:
      stroke_mark(canvas, circle_around(at, 4.0 * px), 1.5, look);
      stroke_mark(canvas, circle_around(at, 7.5 * px), 1.5, look);
      return;
  }
}

void draw_brush_circle(Canvas& canvas,
                       const Eigen::Vector2d& at,
                       double radius_px,
                       const MarkLook& look) {
  const double arm = 3.0 * look.px_per_pt;
  // A ring about as large as its cross would hide what is painted.
  if (radius_px > 1.5 * arm) stroke_mark(canvas, circle_around(at, radius_px), 1.2, look);
  // On the middle of a pixel, for between two of them line and casing mix to the grey of the ground.
  const Eigen::Vector2d middle = at.array().floor() + 0.5;
  for (const Eigen::Vector2d& way : {Eigen::Vector2d(arm, 0.0), Eigen::Vector2d(0.0, arm)}) {
    stroke_mark(canvas, {middle - way, middle + way}, 0.9, look);
  }
}

std::vector<Eigen::Vector2d> keyholed(const MapFrame& frame,
                                      const std::vector<Ring>& rings_in_enu_m) {
  std::vector<Eigen::Vector2d> outline;
  for (const Ring& ring : rings_in_enu_m) {
    if (ring.empty()) continue;
    for (const Eigen::Vector2d& place : ring) outline.push_back(frame.page(place));
    outline.push_back(frame.page(ring.front()));
    if (&ring != &rings_in_enu_m.front()) outline.push_back(outline.front());
  }
  return outline;
}

}  // namespace nadir
