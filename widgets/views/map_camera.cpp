// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/map_camera.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/angle.h"
#include "core/base/require.h"

namespace nadir {
namespace {

Eigen::Rotation2Dd page_from_east(const MapCamera& camera) {
  return Eigen::Rotation2Dd(std::numbers::pi / 2.0 - camera.up_rad);
}

}  // namespace

MapCamera MapCamera::fit(const Eigen::Vector2d& low_in_enu_m,
                         const Eigen::Vector2d& high_in_enu_m,
                         const PageRect& where,
                         double margin) {
  NADIR_REQUIRE(where.width > 0.0 && where.height > 0.0);
  // A single point is shown as a metre of ground, not magnified without end.
  const Eigen::Vector2d size_m =
      (high_in_enu_m - low_in_enu_m).cwiseMax(1.0) * (1.0 + 2.0 * margin);
  MapCamera camera;
  camera.centre_in_enu_m = (low_in_enu_m + high_in_enu_m) / 2.0;
  camera.metres_per_px = std::max(size_m.x() / where.width, size_m.y() / where.height);
  return camera;
}

bool MapCamera::is_turned() const {
  return !(std::abs(wrap_rad(up_rad - std::numbers::pi / 2.0)) <= 1e-9);
}

Eigen::Vector2d MapCamera::page_from_enu(const Eigen::Vector2d& point_in_enu_m,
                                         const PageRect& where) const {
  return where.centre() +
         page_from_east(*this) * (point_in_enu_m - centre_in_enu_m) / metres_per_px;
}

Eigen::Vector2d MapCamera::enu_from_page(const Eigen::Vector2d& point_on_page,
                                         const PageRect& where) const {
  return centre_in_enu_m +
         page_from_east(*this).inverse() * (point_on_page - where.centre()) * metres_per_px;
}

}  // namespace nadir
