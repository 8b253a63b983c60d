// SPDX-License-Identifier: Apache-2.0
#include "core/sim/vehicle_attitude.h"

#include <cmath>

#include "core/base/angle.h"
#include "core/base/random.h"

namespace nadir {
namespace {

constexpr double kGravityMps2 = 9.81;
constexpr double kDragPerS =
    0.1715;  ///< Drag deceleration a m/s of airspeed: four degrees at 4 m/s.
constexpr double kResponseS = 0.3;
constexpr double kJitterMemoryS = 0.5;
constexpr double kJitterRad = Angle::degrees(0.5).radians();

Tilt wanted_tilt(const VehicleLoad& load) {
  return {.roll_rad = -std::atan2(load.left_mps2, kGravityMps2),
          .pitch_rad = std::atan2(load.forward_mps2 + kDragPerS * load.speed_mps, kGravityMps2)};
}

}  // namespace

std::vector<Tilt> vehicle_tilt(const std::vector<VehicleLoad>& loads, std::uint64_t seed) {
  std::vector<Tilt> tilts;
  tilts.reserve(loads.size());
  Tilt steady;  // upright and at rest before it starts
  Tilt jitter;
  double before_s = loads.empty() ? 0.0 : loads.front().time_s;
  for (std::size_t i = 0; i < loads.size(); ++i) {
    const double step_s = loads[i].time_s - before_s;
    before_s = loads[i].time_s;
    const Tilt wanted = wanted_tilt(loads[i]);
    const double follow = 1.0 - std::exp(-step_s / kResponseS);
    steady.roll_rad += follow * (wanted.roll_rad - steady.roll_rad);
    steady.pitch_rad += follow * (wanted.pitch_rad - steady.pitch_rad);
    // An Ornstein-Uhlenbeck process: its spread does not depend on the sampling.
    const double keep = std::exp(-step_s / kJitterMemoryS);
    const double fresh = kJitterRad * std::sqrt(1.0 - keep * keep);
    const auto [roll, pitch] =
        standard_normals({seed, kAttitude, static_cast<std::uint32_t>(i), 0, 0});
    jitter.roll_rad = keep * jitter.roll_rad + fresh * roll;
    jitter.pitch_rad = keep * jitter.pitch_rad + fresh * pitch;
    tilts.push_back({steady.roll_rad + jitter.roll_rad, steady.pitch_rad + jitter.pitch_rad});
  }
  return tilts;
}

}  // namespace nadir
