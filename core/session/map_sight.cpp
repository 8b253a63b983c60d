// SPDX-License-Identifier: Apache-2.0
#include "core/session/map_sight.h"

#include <cmath>

namespace nadir {

bool MapPage::shows(const Eigen::Vector2d& place_in_enu_m) const {
  const Eigen::Vector2d up(std::cos(up_rad), std::sin(up_rad)), right(up.y(), -up.x());
  const Eigen::Vector2d away = place_in_enu_m - centre_in_enu_m;
  return std::abs(away.dot(right)) <= 0.5 * width_m &&
         std::abs(away.dot(up)) <= 0.5 * width_m / aspect;
}

}  // namespace nadir
