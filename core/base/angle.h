// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <numbers>

namespace nadir {

/// The same direction in (-pi, pi]. NaN stays NaN.
[[nodiscard]] inline double wrap_rad(double angle_rad) {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  const double wrapped = std::remainder(angle_rad, kTurn);  // in [-pi, pi]
  return wrapped == -std::numbers::pi ? std::numbers::pi : wrapped;
}

/// An angle across interfaces, where a bare double would not say its unit.
class Angle {
 public:
  constexpr Angle() = default;
  [[nodiscard]] static constexpr Angle radians(double value) { return Angle(value); }
  [[nodiscard]] static constexpr Angle degrees(double value) {
    return Angle(value * std::numbers::pi / 180.0);
  }
  [[nodiscard]] constexpr double radians() const { return radians_; }
  [[nodiscard]] constexpr double degrees() const { return radians_ * 180.0 / std::numbers::pi; }

 private:
  explicit constexpr Angle(double radians) : radians_(radians) {}
  double radians_ = 0.0;
};

/// Clockwise from north in [0, 360), for screens and files; `yaw` is counter-clockwise from east.
[[nodiscard]] inline double compass_deg_from_yaw(Angle yaw) {
  const double remainder_deg = std::fmod(90.0 - yaw.degrees(), 360.0);
  const double compass_deg = remainder_deg < 0.0 ? remainder_deg + 360.0 : remainder_deg;
  return compass_deg < 360.0 ? compass_deg
                             : 0.0;  // the sum of 360 and a hair below 0 rounds to 360
}

}  // namespace nadir
