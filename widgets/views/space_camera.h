// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>

#include "widgets/canvas/canvas.h"

namespace nadir {

/// Looks at a place of the project plane from aside, in perspective: a pinhole in the middle of the page.
struct SpaceCamera {
  Eigen::Vector3d target_in_enu_m = Eigen::Vector3d::Zero();  ///< In the middle of the page.
  double distance_m = 50.0;                                   ///< Of the eye from the target, > 0.
  double yaw_rad = 0.0;  ///< Where it looks to: counter-clockwise from east.
  double down_rad =
      0.5;  ///< How far below the horizon it looks: 0 along the ground, pi/2 straight down.
  double view_rad = 0.6;  ///< From the lower end of the page to the upper one, in (0, pi).

  [[nodiscard]] Eigen::Vector3d eye_in_enu_m() const;
  /// Columns are to the right and up on the page, and ahead, in enu: unit vectors. No view is without an up.
  [[nodiscard]] Eigen::Matrix3d enu_from_view() const;

  /// Nothing where the point is not in front of the eye.
  [[nodiscard]] std::optional<Eigen::Vector2d> page_from_enu(const Eigen::Vector3d& point_in_enu_m,
                                                             const PageRect& where) const;
  /// The place on the ground (z = 0) that a point of the page shows; nothing at the horizon and above.
  [[nodiscard]] std::optional<Eigen::Vector2d> ground_from_page(
      const Eigen::Vector2d& point_on_page, const PageRect& where) const;

  /// The distance from which a length across the line of sight at the target fills the width of the page.
  [[nodiscard]] double distance_to_show(double width_m, const PageRect& where) const;
  friend bool operator==(const SpaceCamera&, const SpaceCamera&) = default;
};

}  // namespace nadir
