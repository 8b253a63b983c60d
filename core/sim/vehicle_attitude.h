// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

namespace nadir {

/// Accelerations of a vehicle in its level frame, and its airspeed.
struct VehicleLoad {
  double time_s = 0.0;
  double forward_mps2 = 0.0;
  double left_mps2 = 0.0;  ///< speed^2 x curvature; positive in a left turn.
  double speed_mps = 0.0;
};

/// Roll and pitch, with the signs of Attitude: positive roll lowers the right side, positive pitch
/// the nose.
struct Tilt {
  double roll_rad = 0.0;
  double pitch_rad = 0.0;
};

/// How a multirotor leans: thrust stands against gravity, acceleration and drag, so the nose goes
/// down to speed up and, by four degrees, to keep 4 m/s; it banks into turns. What it should lean
/// is low-passed (0.3 s), for it is a body with inertia, and jitters by half a degree with a memory
/// of half a second.
[[nodiscard]] std::vector<Tilt> vehicle_tilt(const std::vector<VehicleLoad>& loads,
                                             std::uint64_t seed);

}  // namespace nadir
