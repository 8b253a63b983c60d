// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <span>
#include <string>

#include "core/geo/rigid2.h"
#include "widgets/views/map_camera.h"

namespace nadir {

/// A map on a page: what is drawn over its ground finds its place by this. Sizes on paper are points (1/72 inch).
struct MapFrame {
  PageRect where;
  MapCamera camera;
  double px_per_pt = 1.0;

  [[nodiscard]] Eigen::Vector2d page(const Eigen::Vector2d& point_in_enu_m) const {
    return camera.page_from_enu(point_in_enu_m, where);
  }
};

/// A line over imagery carries a casing, a wider line of the opposite lightness below it, so that it is seen on any ground.
struct PathLook {
  Rgba colour;
  double width_pt = 1.5;
  bool is_dashed = false;
  Rgba casing{0, 0, 0, 0};  ///< Transparent: none.
  double casing_pt = 0.6;   ///< On each side.
};

/// A polyline in enu, metres. A point that is not finite breaks it. Points closer than a third of a pixel are passed over.
void draw_path(Canvas& canvas,
               const MapFrame& frame,
               std::span<const Eigen::Vector2d> points_in_enu_m,
               const PathLook& look);

enum class PathMark { kStart, kEnd, kTick };
/// A filled circle (start), square (end) or short stroke across the path (tick; `heading_rad` is the path's yaw in enu).
void draw_path_mark(Canvas& canvas,
                    const MapFrame& frame,
                    PathMark mark,
                    const Eigen::Vector2d& point_in_enu_m,
                    double heading_rad,
                    const PathLook& look);

/// Outlines of the ellipses of a covariance of x and y (m^2, enu; its full shape, so turned as it is), at so many standard
/// deviations each, from the outermost; the innermost is filled with 15 % of the colour. Nothing where the covariance is
/// not positive definite. @param outer_share  Opacity of all but the innermost; their casings are two thirds of that.
void draw_ellipses(Canvas& canvas,
                   const MapFrame& frame,
                   const Eigen::Vector2d& centre_in_enu_m,
                   const Eigen::Matrix2d& covariance_m2,
                   std::span<const double> sigmas,
                   const PathLook& look,
                   double outer_share = 0.6);

/// An arrowhead at a pose that points along its heading, `size_pt` long.
void draw_pose(Canvas& canvas,
               const MapFrame& frame,
               const Rigid2& pose_in_enu,
               double size_pt,
               const PathLook& look);

/// What draw_plate() covers.
[[nodiscard]] PageRect plate_at(const Eigen::Vector2d& centre_on_page,
                                const std::string& line,
                                const TextStyle& style,
                                double px_per_pt);

/// A name on a plate at a point of the page, centred; plate and letters in the given colours.
void draw_plate(Canvas& canvas,
                const Eigen::Vector2d& centre_on_page,
                const std::string& line,
                const TextStyle& style,
                Rgba plate,
                double px_per_pt);

}  // namespace nadir
