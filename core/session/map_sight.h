// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace nadir {

/// The ground that a map's page shows, whatever lies over it there: what is on the page is in sight, and what is not has an
/// arrow that points to it.
struct MapPage {
  Eigen::Vector2d centre_in_enu_m = Eigen::Vector2d::Zero();
  double width_m = 0.0;
  double up_rad = 0.0;  ///< Of what is up on the page: counter-clockwise from east.
  double aspect = 1.0;  ///< Width by height.

  /// Whether a place of the ground lies on it, its border included.
  [[nodiscard]] bool shows(const Eigen::Vector2d& place_in_enu_m) const;
};

}  // namespace nadir
