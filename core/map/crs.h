// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ogr_spatialref.h>

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/map/gdal_raster.h"

namespace nadir {

/// Coordinate reference systems by way of OGR. Private to this module and, unlike the other
/// headers, full of GDAL. All use the traditional order, x before y and longitude before latitude,
/// because swapped coordinates do not fail, they lie.

[[nodiscard]] std::string wkt_of(const OGRSpatialReference& crs);
/// From what wkt_of or ProjectPlane::wkt gave; empty where the text is none.
[[nodiscard]] OGRSpatialReference crs_from_wkt(const std::string& wkt);
/// From "EPSG:25832", WKT or a PROJ string; never from the network or a file. @errors
/// kInvalidOptions.
[[nodiscard]] Result<OGRSpatialReference> crs_from_text(const std::string& text,
                                                        const GdalMessages& messages);
[[nodiscard]] OGRSpatialReference wgs84();

/// Takes points from one system to another.
class CrsTransform {
 public:
  /// @errors kUnsupported: the systems have no relation, such as a local engineering grid.
  [[nodiscard]] static Result<CrsTransform> create(const OGRSpatialReference& source,
                                                   const OGRSpatialReference& target);
  /// Nothing where the point has no place in the target system.
  [[nodiscard]] std::optional<Eigen::Vector2d> operator()(const Eigen::Vector2d& point) const;

 private:
  explicit CrsTransform(std::unique_ptr<OGRCoordinateTransformation> transformation)
      : transformation_(std::move(transformation)) {}
  std::unique_ptr<OGRCoordinateTransformation> transformation_;
};

}  // namespace nadir
