// SPDX-License-Identifier: Apache-2.0
// The figure of a route: route.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/sim/flight_path.h"
#include "core/sim/route.h"
#include "widgets/figures/figures.h"
#include "widgets/figures/map_panel.h"
#include "widgets/figures/page_layout.h"

namespace nadir {
namespace {

using Segment = std::pair<Eigen::Vector2d, Eigen::Vector2d>;

/// The way as it is drawn, and its straight pieces, which have arrows.
struct RouteWay {
  std::vector<Eigen::Vector2d> points_in_enu_m;
  std::vector<Segment> straights_in_enu_m;
  double length_m = 0.0;
};

/// As it is flown, with rounded corners.
RouteWay way_of(const FlightPath& path) {
  constexpr double kMostTurnRad = 0.05;  ///< Of an arc between two points.
  RouteWay way;
  way.length_m = path.length_m;
  for (const PathPiece& piece : path.pieces) {
    const double turn_rad = std::abs(piece.curvature_per_m) * piece.length_m;
    const int steps = std::max(1, static_cast<int>(std::ceil(turn_rad / kMostTurnRad)));
    for (int i = way.points_in_enu_m.empty() ? 0 : 1; i <= steps; ++i) {
      way.points_in_enu_m.push_back(piece.place_in_enu_m(piece.length_m * i / steps));
    }
    if (piece.curvature_per_m == 0.0) {
      way.straights_in_enu_m.emplace_back(piece.start_in_enu_m,
                                          piece.place_in_enu_m(piece.length_m));
    }
  }
  return way;
}

/// From waypoint to waypoint, of a route that cannot be flown.
RouteWay straight_way(const Route& route) {
  RouteWay way;
  way.points_in_enu_m = route.waypoints_in_enu_m;
  if (route.is_closed) way.points_in_enu_m.push_back(way.points_in_enu_m.front());
  for (std::size_t i = 0; i + 1 < way.points_in_enu_m.size(); ++i) {
    way.straights_in_enu_m.emplace_back(way.points_in_enu_m[i], way.points_in_enu_m[i + 1]);
    way.length_m += (way.points_in_enu_m[i + 1] - way.points_in_enu_m[i]).norm();
  }
  way.length_m *= route.laps;
  return way;
}

bool holds(const PageRect& rect, const Eigen::Vector2d& point) {
  return point.x() >= rect.left && point.x() <= rect.right() && point.y() >= rect.bottom &&
         point.y() <= rect.top();
}

/// The part of a segment inside a rectangle (Liang and Barsky 1984); nothing where it passes by.
std::optional<Segment> part_inside(const Segment& segment, const PageRect& rect) {
  const Eigen::Vector2d way = segment.second - segment.first;
  const Eigen::Vector2d low(rect.left, rect.bottom);
  const Eigen::Vector2d high(rect.right(), rect.top());
  double from = 0.0;
  double to = 1.0;
  for (int axis = 0; axis < 2; ++axis) {
    const double start = segment.first[axis];
    if (way[axis] == 0.0) {
      if (start < low[axis] || start > high[axis]) return std::nullopt;
      continue;
    }
    const double a = (low[axis] - start) / way[axis];
    const double b = (high[axis] - start) / way[axis];
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
  }
  if (!(from < to)) return std::nullopt;
  return Segment{segment.first + from * way, segment.first + to * way};
}

class RouteFigure : public Figure {
 public:
  RouteFigure(std::unique_ptr<MapPanel> map, Route route, RouteWay way, std::string foot)
      : map_(std::move(map)),
        route_(std::move(route)),
        way_(std::move(way)),
        foot_(std::move(foot)) {
    map_->include(route_.waypoints_in_enu_m);
  }

  Result<void> draw(Canvas& canvas, FigureContext& context) override {
    const PageFormat& format = context.format();
    const Theme& theme = format.colours();
    PageRect rest = page_inside(format);
    draw_foot(canvas, format, rest, foot_);
    if (!least_map(format).fits_in(rest)) return {};
    const auto frame = map_->draw_ground(canvas, context, rest);
    if (!frame) return forward_error(frame);
    canvas.push_clip(frame->where);
    draw_path(canvas, *frame, way_.points_in_enu_m, estimate_look(theme));
    draw_arrows(canvas, *frame, theme);
    const std::vector<PageRect> plates = draw_waypoints(canvas, *frame, theme);
    canvas.pop_clip();
    map_->draw_furniture(canvas, format, *frame, plates);
    return {};
  }

 private:
  /// In the middle of what is seen of each straight piece, unless that is short or another lap has one there.
  void draw_arrows(Canvas& canvas, const MapFrame& frame, const Theme& theme) const {
    constexpr double kArrowPt = 9.0;
    const double px = frame.px_per_pt;
    std::vector<Eigen::Vector2d> arrows;
    for (const auto& [start, end] : way_.straights_in_enu_m) {
      const auto seen = part_inside({frame.page(start), frame.page(end)}, frame.where);
      if (!seen || (seen->second - seen->first).norm() < 1.5 * kArrowPt * px) continue;
      const Eigen::Vector2d middle = (seen->first + seen->second) / 2.0;
      if (std::any_of(arrows.begin(), arrows.end(), [&](const Eigen::Vector2d& other) {
            return (other - middle).norm() < kArrowPt * px;
          })) {
        continue;
      }
      arrows.push_back(middle);
      const Eigen::Vector2d place = frame.camera.enu_from_page(middle, frame.where);
      const Eigen::Vector2d along = end - start;
      draw_pose(canvas, frame, {place.x(), place.y(), std::atan2(along.y(), along.x())}, kArrowPt,
                estimate_look(theme));
    }
  }

  /// Numbers on plates inside the map; a waypoint whose plate would cover another one is a dot, and one
  /// beside the map is not drawn. @returns the plates.
  [[nodiscard]] std::vector<PageRect> draw_waypoints(Canvas& canvas,
                                                     const MapFrame& frame,
                                                     const Theme& theme) const {
    const double px = frame.px_per_pt;
    TextStyle style;
    style.size_px = 9.0 * px;
    style.is_bold = true;
    style.colour = theme.text;
    std::vector<PageRect> plates;
    for (std::size_t i = 0; i < route_.waypoints_in_enu_m.size(); ++i) {
      const Eigen::Vector2d& point = route_.waypoints_in_enu_m[i];
      if (!holds(frame.where, frame.page(point))) continue;
      const std::string& name = route_.waypoint_names[i];
      const PageRect size = plate_at({0.0, 0.0}, name, style, px);
      const Eigen::Vector2d half(size.width / 2.0, size.height / 2.0);
      const Eigen::Vector2d low = Eigen::Vector2d(frame.where.left, frame.where.bottom) + half;
      const Eigen::Vector2d high = Eigen::Vector2d(frame.where.right(), frame.where.top()) - half;
      // A waypoint on the way between two that have a name has none.
      const bool has_room = !name.empty() && (low.array() <= high.array()).all();
      const Eigen::Vector2d at = frame.page(point).cwiseMax(low).cwiseMin(high);
      const PageRect plate = plate_at(at, name, style, px);
      const auto covers = [&plate](const PageRect& other) { return overlap(plate, other); };
      if (!has_room || std::any_of(plates.begin(), plates.end(), covers)) {
        draw_path_mark(canvas, frame, PathMark::kStart, point, 0.0, estimate_look(theme));
        continue;
      }
      draw_plate(canvas, at, name, style, with_opacity(theme.page, 0.9), px);
      plates.push_back(plate);
    }
    return plates;
  }

  std::unique_ptr<MapPanel> map_;
  Route route_;
  RouteWay way_;
  std::string foot_;
};

}  // namespace

Result<std::unique_ptr<Figure>> make_route(
    FigureInputs inputs) {  // NOLINT(performance-unnecessary-value-param): as all
  const std::filesystem::path file =
      inputs.route.empty() ? inputs.map / "routes" / "loop.toml" : inputs.route;
  auto route = read_route(file);
  if (!route) return forward_error(route);
  auto panel = MapPanel::create(inputs.map, MapPanel::Ground::kPicture, inputs.options);
  if (!panel) return forward_error(panel);
  const auto path = build_flight_path(*route);
  RouteWay way = path ? way_of(*path) : straight_way(*route);
  std::string foot = fmt::format(
      "{}: {:.0f} m{}, {:g} m above ground, at most {:g} m/s", route->name, way.length_m,
      route->laps > 1 ? fmt::format(" in {} laps", route->laps) : std::string(), route->altitude_m,
      route->speed_mps);
  if (!path) foot += " · cannot be flown: " + path.error().message;
  return std::make_unique<RouteFigure>(std::move(*panel), std::move(*route), std::move(way), foot);
}

}  // namespace nadir
