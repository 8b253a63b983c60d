// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cmath>

#include "core/geo/rigid2.h"
#include "core/topview/semantic_topview.h"

namespace nadir {

/// Where the cells of a topview lie in `enu` when the body is at a pose: the one place that knows
/// that a cell's centre is half a cell beyond its indices. Sine and cosine are taken once for all
/// cells; the result has the same bits as `enu_from_body * centre_in_level_m`.
class CellPlacement {
 public:
  /// A pose that is not finite places every cell nowhere (NaN).
  CellPlacement(const Rigid2& enu_from_body, double metres_per_cell)
      : enu_from_body_(enu_from_body),
        metres_per_cell_(metres_per_cell),
        cos_(std::cos(enu_from_body.yaw_rad)),
        sin_(std::sin(enu_from_body.yaw_rad)) {}

  /// Centre of the cell that spans `forward` to `forward + 1` cells ahead of the body and `left` to
  /// `left + 1` to its left, metres.
  [[nodiscard]] Eigen::Vector2d centre_in_enu_m(int forward, int left) const {
    const double forward_m = (forward + 0.5) * metres_per_cell_;
    const double left_m = (left + 0.5) * metres_per_cell_;
    return {enu_from_body_.x_m + cos_ * forward_m - sin_ * left_m,
            enu_from_body_.y_m + sin_ * forward_m + cos_ * left_m};
  }
  [[nodiscard]] Eigen::Vector2d centre_in_enu_m(TopviewCell cell) const {
    return centre_in_enu_m(cell.forward, cell.left);
  }

 private:
  Rigid2 enu_from_body_;
  double metres_per_cell_;
  double cos_, sin_;
};

}  // namespace nadir
