// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "core/map/semantic_classes.h"

namespace nadir {

/// An upright body of simple shape that stands in a world: part of a tree, a pole, a car, a
/// pedestrian.
struct Solid {
  enum class Shape : std::uint8_t {
    kBox,        ///< Half sizes along `heading`, across it and up.
    kCylinder,   ///< Upright; half_size_m.x() is the radius, z half the height.
    kEllipsoid,  ///< Semi-axes along `heading`, across it and up.
    kCapsule     ///< Upright cylinder with round ends; x is the radius, z half the height with the
                 ///< ends.
  };
  Shape shape = Shape::kBox;
  ClassId label = kUnclassified;
  Eigen::Vector3d centre_in_enu_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d half_size_m = Eigen::Vector3d::Ones();
  Eigen::Vector2d heading{1.0, 0.0};  ///< Unit vector in the plane, where the body's x points.

  /// Radius of the upright cylinder about the centre that holds the whole body.
  [[nodiscard]] double footprint_radius_m() const;
};

/// Smallest t > 0 at which `origin + t * direction` enters the solid; infinity where it does not,
/// and where the origin is inside, so that a camera inside a body sees through it. `direction` need
/// not have unit length.
[[nodiscard]] double first_hit(const Solid& solid,
                               const Eigen::Vector3d& origin_in_enu_m,
                               const Eigen::Vector3d& direction_in_enu);

/// Unit vector that points out of the solid at a point of its surface; on edges that of one side.
[[nodiscard]] Eigen::Vector3d outward_normal(const Solid& solid,
                                             const Eigen::Vector3d& point_in_enu_m);

}  // namespace nadir
