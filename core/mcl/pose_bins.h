// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <compare>
#include <cstdint>
#include <numbers>

#include "core/geo/rigid2.h"

namespace nadir {

/// A regular grid over x, y and yaw. Yaw wraps: the last bin is a neighbour of the first.
class PoseBins {
 public:
  struct Bin {
    std::int32_t x, y, yaw;
    friend auto operator<=>(const Bin&, const Bin&) = default;
  };

  /// Both sizes > 0; the yaw size is rounded so that whole bins fill the circle.
  PoseBins(double size_m, double size_rad)
      : size_m_(size_m),
        yaw_count_(std::max(1, static_cast<int>(std::lround(2.0 * std::numbers::pi / size_rad)))) {}

  [[nodiscard]] int yaw_count() const { return yaw_count_; }
  [[nodiscard]] Bin bin(const Rigid2& pose) const {
    const double turns = (pose.yaw_rad + std::numbers::pi) / (2.0 * std::numbers::pi);
    return {static_cast<std::int32_t>(std::floor(pose.x_m / size_m_)),
            static_cast<std::int32_t>(std::floor(pose.y_m / size_m_)),
            wrapped(static_cast<int>(std::floor(turns * yaw_count_)))};
  }
  /// The bin that lies (dx, dy, dyaw) bins away.
  [[nodiscard]] Bin moved(const Bin& bin, int dx, int dy, int dyaw) const {
    return {bin.x + dx, bin.y + dy, wrapped(bin.yaw + dyaw)};
  }

 private:
  [[nodiscard]] std::int32_t wrapped(int yaw) const {
    return ((yaw % yaw_count_) + yaw_count_) % yaw_count_;
  }
  double size_m_;
  int yaw_count_;
};

}  // namespace nadir
