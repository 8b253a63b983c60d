// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/space_camera.h"

#include <Eigen/Geometry>
#include <cmath>

namespace nadir {
namespace {

/// Pixels from the middle of the page to a point seen under 45 degrees.
double focal_px(const SpaceCamera& camera, const PageRect& where) {
  return where.height / 2.0 / std::tan(camera.view_rad / 2.0);
}

}  // namespace

Eigen::Matrix3d SpaceCamera::enu_from_view() const {
  const Eigen::Vector3d ahead(std::cos(yaw_rad) * std::cos(down_rad),
                              std::sin(yaw_rad) * std::cos(down_rad), -std::sin(down_rad));
  const Eigen::Vector3d right(std::sin(yaw_rad), -std::cos(yaw_rad), 0.0);
  Eigen::Matrix3d axes;
  axes << right, right.cross(ahead), ahead;
  return axes;
}

Eigen::Vector3d SpaceCamera::eye_in_enu_m() const {
  return target_in_enu_m - distance_m * enu_from_view().col(2);
}

std::optional<Eigen::Vector2d> SpaceCamera::page_from_enu(const Eigen::Vector3d& point_in_enu_m,
                                                          const PageRect& where) const {
  const Eigen::Vector3d in_view = enu_from_view().transpose() * (point_in_enu_m - eye_in_enu_m());
  if (!(in_view.z() > 0.0)) return std::nullopt;
  return where.centre() + focal_px(*this, where) * in_view.head<2>() / in_view.z();
}

std::optional<Eigen::Vector2d> SpaceCamera::ground_from_page(const Eigen::Vector2d& point_on_page,
                                                             const PageRect& where) const {
  const Eigen::Vector2d aside = (point_on_page - where.centre()) / focal_px(*this, where);
  const Eigen::Vector3d ray = enu_from_view() * aside.homogeneous();
  const Eigen::Vector3d eye = eye_in_enu_m();
  const double length = -eye.z() / ray.z();
  if (!(length > 0.0) || !std::isfinite(length)) return std::nullopt;
  return (eye + length * ray).head<2>();
}

double SpaceCamera::distance_to_show(double width_m, const PageRect& where) const {
  return width_m * focal_px(*this, where) / where.width;
}

}  // namespace nadir
