// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "widgets/canvas/canvas.h"

namespace nadir {

/// Looks straight down on the project plane: which stretch of ground fills a rectangle of the page.
struct MapCamera {
  Eigen::Vector2d centre_in_enu_m = Eigen::Vector2d::Zero();
  double metres_per_px = 1.0;
  /// Direction that is up on the page: radians counter-clockwise from east, so pi/2 is north up.
  double up_rad = 1.5707963267948966;

  /// Shows the whole rectangle [low, high] of the plane, north up, with `margin` (a share of its sides) around it.
  [[nodiscard]] static MapCamera fit(const Eigen::Vector2d& low_in_enu_m,
                                     const Eigen::Vector2d& high_in_enu_m,
                                     const PageRect& where,
                                     double margin = 0.0);

  [[nodiscard]] Eigen::Vector2d page_from_enu(const Eigen::Vector2d& point_in_enu_m,
                                              const PageRect& where) const;
  [[nodiscard]] Eigen::Vector2d enu_from_page(const Eigen::Vector2d& point_on_page,
                                              const PageRect& where) const;
  /// Whether anything but north is up, however often it was turned round.
  [[nodiscard]] bool is_turned() const;
  friend bool operator==(const MapCamera&, const MapCamera&) = default;
};

}  // namespace nadir
