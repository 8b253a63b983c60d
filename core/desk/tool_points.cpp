// SPDX-License-Identifier: Apache-2.0
#include "core/desk/tool_points.h"

#include <cmath>

#include "core/base/require.h"
#include "core/edit/edit_objects.h"
#include "core/edit/polygon_algebra.h"

namespace nadir {
namespace {

Angle yaw_of(const Eigen::Vector2d& leg) { return Angle::radians(std::atan2(leg.y(), leg.x())); }

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// Typed directions are compass ones, or turns to the right from the last leg.
std::optional<Angle> typed_yaw(const TypedLeg& typed, const Ring& drawn) {
  if (!typed.bearing_deg) return std::nullopt;
  if (typed.is_turn && drawn.size() > 1) {
    const Angle last = yaw_of(drawn.back() - drawn[drawn.size() - 2]);
    return Angle::degrees(last.degrees() - *typed.bearing_deg);
  }
  return Angle::degrees(90.0 - *typed.bearing_deg);
}

}  // namespace

Ring ToolPoints::ring() const {
  Ring places;
  places.reserve(points_.size());
  for (const ToolPoint& point : points_) places.push_back(point.in_enu_m);
  return places;
}

void ToolPoints::add(const ToolPoint& point) {
  points_.push_back(point);
  taken_back_.clear();
  typed_ = {};
}

void ToolPoints::take_back() {
  NADIR_REQUIRE(!points_.empty());
  taken_back_.push_back(points_.back());
  points_.pop_back();
}

void ToolPoints::give_again() {
  NADIR_REQUIRE(!taken_back_.empty());
  points_.push_back(taken_back_.back());
  taken_back_.pop_back();
}

void ToolPoints::clear() {
  points_.clear();
  taken_back_.clear();
  typed_ = {};
}

ToolPoint ToolPoints::aim(const LabelTool& tool,
                          const SnapIndex& index,
                          const Eigen::Vector2d& hand_in_enu_m,
                          double reach_m) const {
  ToolPoint free{on_lattice(hand_in_enu_m), std::nullopt, false};
  if (draws_freely(tool.kind)) return free;
  const Ring drawn = ring();
  if (!drawn.empty() && !typed_.empty()) {
    const Eigen::Vector2d place =
        typed_place(drawn.back(), hand_in_enu_m, typed_.length_m, typed_yaw(typed_, drawn));
    return {on_lattice(place), std::nullopt, false};
  }
  const bool can_close = draws_ring(tool.kind) && drawn.size() >= least_points(tool.kind);
  if (can_close && (drawn.front() - hand_in_enu_m).norm() <= reach_m) {
    return {drawn.front(), points_.front().snap, true};
  }
  if (!tool.snaps || !(reach_m > 0.0)) return free;
  if (const auto snap = index.nearest(hand_in_enu_m, reach_m)) return {snap->in_enu_m, snap, false};
  if (const auto snap = snap_to_direction(drawn, hand_in_enu_m, reach_m)) {
    return {snap->in_enu_m, snap, false};
  }
  return free;
}

MeasuredWay measured_way(const Ring& places) {
  MeasuredWay result;
  double twice_area = 0.0;
  for (std::size_t i = 1; i < places.size(); ++i) {
    const Eigen::Vector2d leg = places[i] - places[i - 1];
    result.length_m += leg.norm();
    result.leg_m = leg.norm();
    result.leg_deg = compass_deg_from_yaw(yaw_of(leg));
    twice_area += cross(places[i - 1] - places.front(), places[i] - places.front());
  }
  if (places.size() > 2) result.area_m2 = std::abs(twice_area) / 2.0;
  return result;
}

Ring rectangle_of(const Ring& places) {
  NADIR_REQUIRE(places.size() == 3);
  const Eigen::Vector2d edge = places[1] - places[0];
  const double length_m = edge.norm();
  const double to_the_left_m = length_m > 0.0 ? cross(edge, places[2] - places[1]) / length_m : 0.0;
  return rectangle(places[0], places[1], to_the_left_m);
}

}  // namespace nadir
