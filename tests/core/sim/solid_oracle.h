// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "core/sim/solid.h"

namespace nadir {

/// Whether a point is in a solid, written down from the definition of the shapes and not from the
/// ray code.
inline bool is_inside(const Solid& solid, const Eigen::Vector3d& point_in_enu_m) {
  const Eigen::Vector3d offset = point_in_enu_m - solid.centre_in_enu_m;
  const double along = solid.heading.dot(offset.head<2>());
  const double across = -solid.heading.y() * offset.x() + solid.heading.x() * offset.y();
  const double up = offset.z();
  const Eigen::Vector3d& half = solid.half_size_m;
  switch (solid.shape) {
    case Solid::Shape::kBox:
      return std::abs(along) <= half.x() && std::abs(across) <= half.y() &&
             std::abs(up) <= half.z();
    case Solid::Shape::kCylinder:
      return std::hypot(along, across) <= half.x() && std::abs(up) <= half.z();
    case Solid::Shape::kEllipsoid:
      return std::hypot(along / half.x(), across / half.y(), up / half.z()) <= 1.0;
    case Solid::Shape::kCapsule:
      break;
  }
  const double trunk = half.z() - half.x();
  return std::hypot(along, across, up - std::clamp(up, -trunk, trunk)) <= half.x();
}

}  // namespace nadir
