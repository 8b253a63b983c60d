// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/camera_frustum.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/require.h"

namespace nadir {

CameraFrustum camera_frustum(const CameraModel& camera,
                             const Rigid3& enu_from_camera,
                             double depth_m) {
  NADIR_REQUIRE(depth_m > 0.0);
  const double right = camera.width;
  const double below = camera.height;
  const auto corner = [&](double x, double y) -> Eigen::Vector3d {
    return enu_from_camera * Eigen::Vector3d(depth_m * camera.ray({x, y}));
  };
  return {enu_from_camera.translation_m,
          {corner(0.0, 0.0), corner(right, 0.0), corner(right, below), corner(0.0, below)}};
}

std::vector<Eigen::Vector2d> ground_inside(const CameraFrustum& frustum) {
  std::vector<Eigen::Vector2d> places;
  const auto cross = [&places](const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
    if ((from.z() > 0.0) == (to.z() > 0.0)) return;
    const double share = from.z() / (from.z() - to.z());
    places.emplace_back((from + share * (to - from)).head<2>());
  };
  for (std::size_t i = 0; i < 4; ++i) {
    const Eigen::Vector3d& corner = frustum.corners_in_enu_m.at(i);
    cross(frustum.eye_in_enu_m, corner);
    cross(corner, frustum.corners_in_enu_m.at((i + 1) % 4));
  }
  if (places.size() < 3) return {};
  // A plane cuts a convex body in a convex polygon, so the angle around its middle gives the order.
  const Eigen::Vector2d middle =
      std::accumulate(places.begin(), places.end(), Eigen::Vector2d(0.0, 0.0)) /
      static_cast<double>(places.size());
  std::sort(places.begin(), places.end(), [&middle](const auto& a, const auto& b) {
    return std::atan2(a.y() - middle.y(), a.x() - middle.x()) <
           std::atan2(b.y() - middle.y(), b.x() - middle.x());
  });
  return places;
}

}  // namespace nadir
