// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/geo/trajectory.h"

namespace nadir {

/// Where and how fast to fly.
struct Route {
  std::string name;
  std::vector<Eigen::Vector2d> waypoints_in_enu_m;
  std::vector<std::string> waypoint_names =
      {};  ///< One each, for figures; counted from 1 where the file gives none.
  double corner_radius_m =
      3.0;  ///< Of the arcs that round the waypoints off; smaller where there is no room.
  bool is_closed = false;          ///< Back to the first waypoint at the end.
  int laps = 1;                    ///< Rounds of a closed route, without a halt between them.
  double altitude_m = 2.0;         ///< Above ground.
  double speed_mps = 4.0;          ///< At most.
  double acceleration_mps2 = 1.0;  ///< Along the path, at most.
  double lateral_acceleration_mps2 = 1.5;  ///< In corners, at most.
};

/// Reads a route file (core/sim/README.md has an example): `name`, a `[[waypoint]]` table each with
/// `east_m`, `north_m` and perhaps `name`, and, where they differ from the defaults above,
/// `corner_radius_m closed laps altitude_m speed_mps acceleration_mps2 lateral_acceleration_mps2`.
/// @errors kNotFound, kMalformed (file and fault; unknown keys are refused), kInvalidOptions.
[[nodiscard]] Result<Route> read_route(const std::filesystem::path& path);
/// Parses the text of a route file; `name` stands for the file in messages.
[[nodiscard]] Result<Route> parse_route(std::string_view text, const std::string& name);

/// Checks what plan_flight needs. @errors kInvalidOptions: fewer than two waypoints, two in one
/// place, laps of an open route, limits out of range, an altitude below 0.5 m (curbs), more than
/// 50 km in all laps. Messages start with the route's name.
[[nodiscard]] Result<void> validate(const Route& route);

/// Flies a route: straight lines and arcs, from rest to rest at the highest speed that the limits
/// allow, yaw along the path, roll and pitch of a multirotor (vehicle_attitude.h). Sampled at 20 Hz
/// from time 0, with the end as last sample.
///
/// @param seed  Of the small jitter of roll and pitch.
/// @returns     enu_from_body; z is the altitude.
/// @errors      kInvalidOptions: as validate(), or a corner that turns back or has no room for half
/// a metre of radius.
[[nodiscard]] Result<Trajectory> plan_flight(const Route& route, std::uint64_t seed);

}  // namespace nadir
