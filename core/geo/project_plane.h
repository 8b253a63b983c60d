// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>

#include "core/base/result.h"

namespace nadir {

/// WGS 84, degrees. Only at the edges; arithmetic happens in `enu`.
struct Geodetic {
  double latitude_deg = 0.0;
  double longitude_deg = 0.0;
};

/// The plane that a map lives in: transverse Mercator centred on the map with k = 1; `enu` is its
/// east and north in metres. UTM would cost 0.4 m a kilometre and up to 2 degrees of yaw.
class ProjectPlane {
 public:
  /// @errors kInvalidOptions: NaN, |latitude| > 89 (no east at the pole) or |longitude| > 180.
  [[nodiscard]] static Result<ProjectPlane> create(const Geodetic& origin);

  [[nodiscard]] const Geodetic& origin() const { return origin_; }
  [[nodiscard]] Eigen::Vector2d enu_from_geodetic(const Geodetic& position) const;
  [[nodiscard]] Geodetic geodetic_from_enu(const Eigen::Vector2d& position_in_enu_m) const;
  /// Angle from true north to grid north at a point, counter-clockwise positive, degrees.
  [[nodiscard]] double convergence_deg(const Eigen::Vector2d& position_in_enu_m) const;
  /// WKT of the coordinate reference system, for GDAL.
  [[nodiscard]] std::string wkt() const;

  friend bool operator==(const ProjectPlane& a, const ProjectPlane& b) {
    return a.origin_.latitude_deg == b.origin_.latitude_deg &&
           a.origin_.longitude_deg == b.origin_.longitude_deg;
  }

 private:
  explicit ProjectPlane(const Geodetic& origin) : origin_(origin) {}
  Geodetic origin_;
};

/// Read-outs for people: "33.450112 N 83.901223 W", "17S 230567.1 E 3705123.4 N", "17S KT 30567
/// 05123".
[[nodiscard]] std::string geodetic_text(const Geodetic& position);
[[nodiscard]] std::string utm_text(const Geodetic& position);
/// @param digits  per coordinate: 5 is one metre, 4 ten.
[[nodiscard]] std::string mgrs_text(const Geodetic& position, int digits = 5);

}  // namespace nadir
