// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/map_geometry.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/angle.h"
#include "widgets/views/map_furniture.h"

namespace nadir {
namespace {

constexpr double kFitMargin = 0.06;  ///< Of what is shown, on each side.

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

}  // namespace

void GroundBounds::include(const Eigen::Vector2d& point) {
  if (!point.allFinite()) return;
  low = low.cwiseMin(point);
  high = high.cwiseMax(point);
}

MapCamera map_camera(const MapLook& look, const PageRect& where, const GroundBounds& all) {
  MapCamera camera;
  camera.up_rad = look.up_rad;
  if (look.width_m > 0.0) {
    camera.centre_in_enu_m = look.centre_in_enu_m;
    camera.metres_per_px = look.width_m / std::max(where.width, 1.0);
    return camera;
  }
  if (all.empty()) {
    camera.centre_in_enu_m = look.centre_in_enu_m;
    camera.metres_per_px = 100.0 / std::max(where.width, 1.0);
    return camera;
  }
  // As large as the turned rectangle fits.
  const double angle = std::numbers::pi / 2.0 - look.up_rad;
  const double c = std::abs(std::cos(angle));
  const double s = std::abs(std::sin(angle));
  const Eigen::Vector2d size = (all.high - all.low).cwiseMax(1.0) * (1.0 + 2.0 * kFitMargin);
  const Eigen::Vector2d turned(c * size.x() + s * size.y(), s * size.x() + c * size.y());
  camera.metres_per_px =
      std::max(turned.x() / std::max(where.width, 1.0), turned.y() / std::max(where.height, 1.0));
  camera.centre_in_enu_m =
      look.is_following ? look.centre_in_enu_m : Eigen::Vector2d((all.low + all.high) / 2.0);
  return camera;
}

MapCamera with_ground_at(MapCamera camera,
                         const Eigen::Vector2d& point_in_enu_m,
                         const Eigen::Vector2d& on_page,
                         const PageRect& where) {
  camera.centre_in_enu_m += point_in_enu_m - camera.enu_from_page(on_page, where);
  return camera;
}

MapCamera zoomed_at(const MapCamera& camera,
                    double factor,
                    const Eigen::Vector2d& on_page,
                    const PageRect& where) {
  const Eigen::Vector2d stays = camera.enu_from_page(on_page, where);
  MapCamera made = camera;
  made.metres_per_px /= factor;
  return with_ground_at(made, stays, on_page, where);
}

double turned_deg(const Eigen::Vector2d& from, const Eigen::Vector2d& to, const PageRect& where) {
  constexpr double kLeastArmPx = 2.0;
  const Eigen::Vector2d a = from - where.centre();
  const Eigen::Vector2d b = to - where.centre();
  if (a.norm() < kLeastArmPx || b.norm() < kLeastArmPx) return 0.0;
  return Angle::radians(std::atan2(cross(a, b), a.dot(b))).degrees();
}

Measured measure(std::span<const Eigen::Vector2d> points) {
  Measured made;
  for (std::size_t i = 1; i < points.size(); ++i) {
    made.length_m += (points[i] - points[i - 1]).norm();
  }
  if (points.size() >= 2) {
    const Eigen::Vector2d leg = points.back() - points[points.size() - 2];
    made.last_leg_m = leg.norm();
    if (leg.norm() > 0.0) {
      made.bearing_deg = compass_deg_from_yaw(Angle::radians(std::atan2(leg.y(), leg.x())));
    }
  }
  if (points.size() >= 3) {
    double twice_area = 0.0;
    for (std::size_t i = 1; i + 1 < points.size();
         ++i) {  // from one of them, as places are far from 0
      twice_area += cross(points[i] - points[0], points[i + 1] - points[0]);
    }
    made.area_m2 = std::abs(twice_area) / 2.0;
  }
  return made;
}

std::string distance_text(double length_m) {
  if (length_m >= 999.995) return fmt::format("{:.3f} km", length_m / 1000.0);
  return fmt::format("{:.2f} m", length_m);
}

std::string area_text(double area_m2) {
  if (area_m2 >= 999'500.0) return fmt::format("{:.2f} km²", area_m2 / 1e6);
  if (area_m2 >= 9'999.5) return fmt::format("{:.2f} ha", area_m2 / 1e4);
  return fmt::format("{:.1f} m²", area_m2);
}

std::string bearing_text(double bearing_deg) {
  return fmt::format("{:05.1f}°", bearing_deg >= 359.95 ? 0.0 : bearing_deg);
}

std::string metres_text(double metres, int decimals) {
  std::string text = fmt::format("{:.{}f}", metres, decimals);
  const bool is_zero = text.find_first_not_of("-0.") == std::string::npos;
  return is_zero && text.front() == '-' ? text.substr(1) : text;
}

std::optional<int> nearest_particle(const ParticleSet& particles,
                                    const MapCamera& camera,
                                    const PageRect& where,
                                    const Eigen::Vector2d& on_page,
                                    double most_px) {
  const Eigen::Vector2d wanted = camera.enu_from_page(on_page, where);
  const double most_m = most_px * camera.metres_per_px;
  double least_m2 = most_m * most_m;
  std::optional<int> found;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const double east_m = particles.x_in_enu_m[i] - wanted.x();
    const double north_m = particles.y_in_enu_m[i] - wanted.y();
    const double distance_m2 = east_m * east_m + north_m * north_m;
    if (found ? distance_m2 < least_m2 : distance_m2 <= least_m2) {
      least_m2 = distance_m2;
      found = static_cast<int>(i);
    }
  }
  return found;
}

MapReadout map_readout(const Eigen::Vector2d& point_in_enu_m,
                       const OverheadMap* map,
                       const ProjectPlane* plane) {
  MapReadout made;
  made.in_enu_m = point_in_enu_m;
  if (map != nullptr) {
    if (map->contains(point_in_enu_m)) {
      made.class_id = map->class_at(point_in_enu_m);
      made.class_name = class_info(*made.class_id).name;
    } else {
      made.class_name = "off the map";
    }
  }
  constexpr double kFarthestM = 2e6;  // beyond it a plane is no good description of the Earth
  if (plane != nullptr && point_in_enu_m.norm() < kFarthestM) {
    const Geodetic place = plane->geodetic_from_enu(point_in_enu_m);
    made.geodetic = geodetic_text(place);
    made.utm = utm_text(place);
    made.mgrs = mgrs_text(place);
  }
  return made;
}

}  // namespace nadir
