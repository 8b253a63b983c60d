// SPDX-License-Identifier: Apache-2.0
#include "core/sim/flight_path.h"

#include <algorithm>
#include <cmath>

#include "core/base/angle.h"
#include "core/base/require.h"

namespace nadir {
namespace {

constexpr double kSharpestTurnRad = Angle::degrees(170.0).radians();
constexpr double kSmallestRadiusM = 0.5;
constexpr double kStraightRad = 1e-6;  ///< Turns below it are no corners.

double yaw_of(const Eigen::Vector2d& direction) { return std::atan2(direction.y(), direction.x()); }

/// All places to pass, from start to end, laps written out.
std::vector<Eigen::Vector2d> places_in_order(const Route& route) {
  std::vector<Eigen::Vector2d> places;
  for (int lap = 0; lap < route.laps; ++lap) {
    places.insert(places.end(), route.waypoints_in_enu_m.begin(), route.waypoints_in_enu_m.end());
  }
  if (route.is_closed) places.push_back(route.waypoints_in_enu_m.front());
  return places;
}

/// How a corner is rounded: the arc begins and ends `tangent_m` from the waypoint.
struct Corner {
  double turn_rad = 0.0;
  double radius_m = 0.0;
  double tangent_m = 0.0;
};

Result<Corner> round_corner(const Route& route,
                            const std::vector<Eigen::Vector2d>& places,
                            std::size_t i) {
  const Eigen::Vector2d before = places[i] - places[i - 1];
  const Eigen::Vector2d after = places[i + 1] - places[i];
  const double turn_rad = wrap_rad(yaw_of(after) - yaw_of(before));
  if (std::abs(turn_rad) < kStraightRad) return Corner{};
  if (std::abs(turn_rad) > kSharpestTurnRad) {
    return fail(ErrorCode::kInvalidOptions, "{}: the route turns back at ({:.1f}, {:.1f}) m",
                route.name, places[i].x(), places[i].y());
  }
  // A line is shared with the corner at its other end, unless the route starts or ends there.
  const double room_m = std::min(before.norm() * (i == 1 ? 1.0 : 0.5),
                                 after.norm() * (i + 2 == places.size() ? 1.0 : 0.5));
  const double tangent_per_radius = std::tan(0.5 * std::abs(turn_rad));
  const double tangent_m = std::min(room_m, route.corner_radius_m * tangent_per_radius);
  const double radius_m = tangent_m / tangent_per_radius;
  if (radius_m < kSmallestRadiusM) {
    return fail(ErrorCode::kInvalidOptions,
                "{}: the corner at ({:.1f}, {:.1f}) m has room for a radius of {:.2f} m only",
                route.name, places[i].x(), places[i].y(), radius_m);
  }
  return Corner{turn_rad, radius_m, tangent_m};
}

void append(FlightPath& path, const PathPiece& piece) {
  if (piece.length_m <= 1e-9) return;
  path.begin_m.push_back(path.length_m);
  path.pieces.push_back(piece);
  path.length_m += piece.length_m;
}

double sharpest_speed_mps(const Route& route, double curvature_per_m) {
  const double bend = std::abs(curvature_per_m);
  return bend == 0.0 ? route.speed_mps
                     : std::min(route.speed_mps, std::sqrt(route.lateral_acceleration_mps2 / bend));
}

/// Places along the path with the time and speed there; acceleration is constant in between.
struct SpeedProfile {
  double step_m = 0.0;
  std::vector<double> speed_mps, time_s;
};

SpeedProfile fastest_profile(const FlightPath& path, const Route& route) {
  constexpr double kStepM = 0.01;
  SpeedProfile profile;
  const auto steps = static_cast<std::size_t>(std::max(2.0, std::ceil(path.length_m / kStepM)));
  profile.step_m = path.length_m / static_cast<double>(steps);
  std::vector<double>& speed = profile.speed_mps;
  speed.resize(steps + 1);
  for (std::size_t i = 0; i <= steps; ++i) {
    // Both sides of a joint count, for a sample may stand just before an arc that the step then
    // enters.
    const double along_m = profile.step_m * static_cast<double>(i);
    const double behind_m = std::max(0.0, along_m - profile.step_m);
    const double ahead_m = std::min(path.length_m, along_m + profile.step_m);
    speed[i] = std::min({sharpest_speed_mps(route, path.at(behind_m).piece->curvature_per_m),
                         sharpest_speed_mps(route, path.at(along_m).piece->curvature_per_m),
                         sharpest_speed_mps(route, path.at(ahead_m).piece->curvature_per_m)});
  }
  speed.front() = 0.0;
  speed.back() = 0.0;
  const double gain = 2.0 * route.acceleration_mps2 * profile.step_m;
  for (std::size_t i = 1; i <= steps; ++i) {
    speed[i] = std::min(speed[i], std::sqrt(speed[i - 1] * speed[i - 1] + gain));
  }
  for (std::size_t i = steps; i-- > 0;) {
    speed[i] = std::min(speed[i], std::sqrt(speed[i + 1] * speed[i + 1] + gain));
  }
  profile.time_s.resize(steps + 1);
  for (std::size_t i = 1; i <= steps; ++i) {
    profile.time_s[i] = profile.time_s[i - 1] + 2.0 * profile.step_m / (speed[i - 1] + speed[i]);
  }
  return profile;
}

}  // namespace

Eigen::Vector2d PathPiece::place_in_enu_m(double along_m) const {
  if (curvature_per_m == 0.0) {
    return start_in_enu_m + along_m * Eigen::Vector2d(std::cos(yaw_rad), std::sin(yaw_rad));
  }
  const double end_rad = yaw_at_rad(along_m);
  return start_in_enu_m + Eigen::Vector2d(std::sin(end_rad) - std::sin(yaw_rad),
                                          std::cos(yaw_rad) - std::cos(end_rad)) /
                              curvature_per_m;
}

FlightPath::Station FlightPath::at(double along_m) const {
  NADIR_REQUIRE(!pieces.empty());
  const auto after = std::upper_bound(begin_m.begin() + 1, begin_m.end(), along_m);
  const auto index = static_cast<std::size_t>(after - begin_m.begin()) - 1;
  return {&pieces[index], along_m - begin_m[index]};
}

Result<FlightPath> build_flight_path(const Route& route) {
  if (const auto valid = validate(route); !valid) return forward_error(valid);
  const std::vector<Eigen::Vector2d> places = places_in_order(route);
  FlightPath path;
  double cut_m = 0.0;  // of the line, by the corner at its beginning
  for (std::size_t i = 1; i < places.size(); ++i) {
    Corner corner;
    if (i + 1 < places.size()) {
      const auto rounded = round_corner(route, places, i);
      if (!rounded) return forward_error(rounded);
      corner = *rounded;
    }
    const Eigen::Vector2d line = places[i] - places[i - 1];
    const Eigen::Vector2d along = line.normalized();
    append(path, {.start_in_enu_m = places[i - 1] + cut_m * along,
                  .yaw_rad = yaw_of(line),
                  .length_m = line.norm() - cut_m - corner.tangent_m});
    if (corner.radius_m > 0.0) {
      append(path, {.start_in_enu_m = places[i] - corner.tangent_m * along,
                    .yaw_rad = yaw_of(line),
                    .length_m = corner.radius_m * std::abs(corner.turn_rad),
                    .curvature_per_m = std::copysign(1.0 / corner.radius_m, corner.turn_rad)});
    }
    cut_m = corner.tangent_m;
  }
  return path;
}

std::vector<PathMotion> plan_motion(const FlightPath& path, const Route& route, double step_s) {
  const SpeedProfile profile = fastest_profile(path, route);
  const double end_s = profile.time_s.back();
  std::vector<PathMotion> motions;
  std::size_t i = 0;
  const auto count = static_cast<std::size_t>(std::floor(end_s / step_s - 1e-6)) + 1;
  for (std::size_t sample = 0; sample <= count; ++sample) {
    const double time_s = sample == count ? end_s : static_cast<double>(sample) * step_s;
    while (i + 2 < profile.time_s.size() && profile.time_s[i + 1] <= time_s) ++i;
    const double since_s = time_s - profile.time_s[i];
    const double acceleration_mps2 = (profile.speed_mps[i + 1] - profile.speed_mps[i]) /
                                     (profile.time_s[i + 1] - profile.time_s[i]);
    const double along_m = profile.step_m * static_cast<double>(i) +
                           since_s * (profile.speed_mps[i] + 0.5 * acceleration_mps2 * since_s);
    motions.push_back({.time_s = time_s,
                       .along_m = std::clamp(along_m, 0.0, path.length_m),
                       .speed_mps = profile.speed_mps[i] + acceleration_mps2 * since_s,
                       .acceleration_mps2 = acceleration_mps2});
  }
  return motions;
}

}  // namespace nadir
