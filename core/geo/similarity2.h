// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <span>

#include "core/base/result.h"
#include "core/geo/rigid2.h"

namespace nadir {

/// A rigid motion of the plane with a change of scale: `scale * R(yaw) * point_in_source +
/// translation`.
struct Similarity2 {
  double scale = 1.0;  ///< Metres of the target a metre of the source; positive.
  Rigid2 rigid;        ///< Rotation and translation, applied after the scale.

  [[nodiscard]] Similarity2 inverse() const;
  friend bool operator==(const Similarity2&, const Similarity2&) = default;
};

[[nodiscard]] inline Eigen::Vector2d operator*(const Similarity2& target_from_source,
                                               const Eigen::Vector2d& point_in_source) {
  return target_from_source.rigid * Eigen::Vector2d(target_from_source.scale * point_in_source);
}

/// The pose of a body after the plane below it was moved and scaled: its heading turns, its own
/// size stays.
[[nodiscard]] inline Rigid2 operator*(const Similarity2& target_from_source,
                                      const Rigid2& source_from_body) {
  const Eigen::Vector2d at_m = target_from_source * source_from_body.translation_m();
  return {at_m.x(), at_m.y(),
          wrap_rad(target_from_source.rigid.yaw_rad + source_from_body.yaw_rad)};
}

/// The motion that takes `points_from` nearest to `points_to` in the sense of least squares. Point
/// i belongs to point i; both have the same number of points, metres. O(points), closed form.
/// @errors kMalformed: fewer than two points, NaN, or no rotation is better than another (all
/// points at one place). See Umeyama, PAMI 13(4), 1991, in two dimensions.
[[nodiscard]] Result<Rigid2> align_rigid2(std::span<const Eigen::Vector2d> points_from,
                                          std::span<const Eigen::Vector2d> points_to);

/// As align_rigid2, with the scale estimated too (for monocular odometry, which has none of its
/// own).
[[nodiscard]] Result<Similarity2> align_similarity2(std::span<const Eigen::Vector2d> points_from,
                                                    std::span<const Eigen::Vector2d> points_to);

}  // namespace nadir
