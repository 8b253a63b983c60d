// SPDX-License-Identifier: Apache-2.0
#include "core/sim/route.h"

#include <algorithm>
#include <cmath>

#include "core/base/settings.h"
#include "core/sim/flight_path.h"
#include "core/sim/vehicle_attitude.h"

namespace nadir {
namespace {

constexpr double kSampleS = 0.05;

struct NumberKey {
  std::string_view key;
  double* value;
};

Result<void> add_waypoint(Route& route, const Settings& settings) {
  if (auto known = settings.refuse_unknown({"name", "east_m", "north_m"}); !known) return known;
  const auto east_m = settings.number("east_m");
  if (!east_m) return forward_error(east_m);
  const auto north_m = settings.number("north_m");
  if (!north_m) return forward_error(north_m);
  const auto name = settings.text_or("name", fmt::format("{}", route.waypoint_names.size() + 1));
  if (!name) return forward_error(name);
  route.waypoints_in_enu_m.emplace_back(*east_m, *north_m);
  route.waypoint_names.push_back(*name);
  return {};
}

Result<Route> route_from(const Settings& settings) {
  if (const auto known = settings.refuse_unknown(
          {"name", "waypoint", "corner_radius_m", "closed", "laps", "altitude_m", "speed_mps",
           "acceleration_mps2", "lateral_acceleration_mps2"});
      !known) {
    return forward_error(known);
  }
  Route route;
  const auto name = settings.text_or("name", settings.name());
  if (!name) return forward_error(name);
  route.name = *name;
  const auto waypoints = settings.tables("waypoint");
  if (!waypoints) return forward_error(waypoints);
  for (const Settings& waypoint : *waypoints) {
    if (const auto added = add_waypoint(route, waypoint); !added) return forward_error(added);
  }
  for (const auto& [key, value] :
       {NumberKey{"corner_radius_m", &route.corner_radius_m},
        NumberKey{"altitude_m", &route.altitude_m}, NumberKey{"speed_mps", &route.speed_mps},
        NumberKey{"acceleration_mps2", &route.acceleration_mps2},
        NumberKey{"lateral_acceleration_mps2", &route.lateral_acceleration_mps2}}) {
    const auto number = settings.number_or(key, *value);
    if (!number) return forward_error(number);
    *value = *number;
  }
  if (settings.has("closed")) {
    const auto is_closed = settings.boolean("closed");
    if (!is_closed) return forward_error(is_closed);
    route.is_closed = *is_closed;
  }
  if (settings.has("laps")) {
    const auto laps = settings.integer("laps");
    if (!laps) return forward_error(laps);
    route.laps = static_cast<int>(std::clamp<std::int64_t>(*laps, -1, 1'000'000));
  }
  if (const auto valid = validate(route); !valid) return forward_error(valid, settings.name());
  return route;
}

Result<void> check_limits(const Route& route) {
  struct Limit {
    std::string_view key;
    double value, least, most;
  };
  // Slower than the least speeds and accelerations, a flight would last for days.
  for (const auto& [key, value, least, most] :
       {Limit{"corner_radius_m", route.corner_radius_m, 0.01, 1000.0},
        Limit{"altitude_m", route.altitude_m, 0.5, 50.0},  // Above every curb.
        Limit{"speed_mps", route.speed_mps, 0.1, 50.0},
        Limit{"acceleration_mps2", route.acceleration_mps2, 0.05, 20.0},
        Limit{"lateral_acceleration_mps2", route.lateral_acceleration_mps2, 0.05, 20.0}}) {
    if (value >= least && value <= most) continue;
    return fail(ErrorCode::kInvalidOptions, "{}: {} = {} is not in [{}, {}]", route.name, key,
                value, least, most);
  }
  return {};
}

Result<void> check_length(const Route& route) {
  constexpr double kLongestM = 50'000.0;
  const auto& places = route.waypoints_in_enu_m;
  double lap_m = route.is_closed ? (places.front() - places.back()).norm() : 0.0;
  for (std::size_t i = 1; i < places.size(); ++i) lap_m += (places[i] - places[i - 1]).norm();
  const double length_m = lap_m * route.laps;
  if (length_m <= kLongestM) return {};
  return fail(ErrorCode::kInvalidOptions, "{}: is {:.1f} km long, and a flight may be {:.0f} km",
              route.name, length_m / 1000.0, kLongestM / 1000.0);
}

}  // namespace

Result<Route> read_route(const std::filesystem::path& path) {
  const auto settings = Settings::read(path);
  if (!settings) return forward_error(settings);
  return route_from(*settings);
}

Result<Route> parse_route(std::string_view text, const std::string& name) {
  const auto settings = Settings::parse(text, name);
  if (!settings) return forward_error(settings);
  return route_from(*settings);
}

Result<void> validate(const Route& route) {
  constexpr double kFarthestM = 1e6;
  const auto& places = route.waypoints_in_enu_m;
  if (places.size() < 2) {
    return fail(ErrorCode::kInvalidOptions, "{}: a route needs at least two waypoints", route.name);
  }
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!(places[i].cwiseAbs().maxCoeff() <= kFarthestM)) {
      return fail(ErrorCode::kInvalidOptions, "{}: waypoint {} is nowhere", route.name, i + 1);
    }
    const bool is_last = i + 1 == places.size();
    if (is_last && !route.is_closed) continue;
    if ((places[is_last ? 0 : i + 1] - places[i]).norm() < 0.1) {
      return fail(ErrorCode::kInvalidOptions, "{}: waypoint {} is at the same place as the next",
                  route.name, i + 1);
    }
  }
  if (route.laps < 1 || route.laps > 1000 || (route.laps > 1 && !route.is_closed)) {
    return fail(ErrorCode::kInvalidOptions,
                "{}: laps = {} is not 1 or, for a closed route, up to 1000", route.name,
                route.laps);
  }
  if (auto limits = check_limits(route); !limits) return limits;
  return check_length(route);
}

Result<Trajectory> plan_flight(const Route& route, std::uint64_t seed) {
  const auto path = build_flight_path(route);
  if (!path) return forward_error(path);
  const std::vector<PathMotion> motions = plan_motion(*path, route, kSampleS);
  std::vector<VehicleLoad> loads;
  for (const PathMotion& motion : motions) {
    const double curvature_per_m = path->at(motion.along_m).piece->curvature_per_m;
    loads.push_back({.time_s = motion.time_s,
                     .forward_mps2 = motion.acceleration_mps2,
                     .left_mps2 = motion.speed_mps * motion.speed_mps * curvature_per_m,
                     .speed_mps = motion.speed_mps});
  }
  const std::vector<Tilt> tilts = vehicle_tilt(loads, seed);
  std::vector<TimedPose> poses;
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const auto [piece, along_m] = path->at(motions[i].along_m);
    const Eigen::Vector2d place_in_enu_m = piece->place_in_enu_m(along_m);
    poses.push_back({motions[i].time_s,
                     {rotation_of({.roll_rad = tilts[i].roll_rad,
                                   .pitch_rad = tilts[i].pitch_rad,
                                   .yaw_rad = piece->yaw_at_rad(along_m)}),
                      {place_in_enu_m.x(), place_in_enu_m.y(), route.altitude_m}}});
  }
  return Trajectory::create(std::move(poses), route.name);
}

}  // namespace nadir
