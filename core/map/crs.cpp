// SPDX-License-Identifier: Apache-2.0
#include "core/map/crs.h"

#include <cpl_conv.h>

#include <cmath>
#include <utility>

namespace nadir {

std::string wkt_of(const OGRSpatialReference& crs) {
  char* text = nullptr;
  const char* const options[] = {"FORMAT=WKT2_2019", nullptr};
  crs.exportToWkt(&text, options);
  std::string wkt = text != nullptr ? text : "";
  CPLFree(text);
  return wkt;
}

OGRSpatialReference crs_from_wkt(const std::string& wkt) {
  OGRSpatialReference crs;
  crs.importFromWkt(wkt.c_str());
  crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return crs;
}

Result<OGRSpatialReference> crs_from_text(const std::string& text, const GdalMessages& messages) {
  OGRSpatialReference crs;
  crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  if (crs.SetFromUserInput(text.c_str(),
                           OGRSpatialReference::SET_FROM_USER_INPUT_LIMITATIONS_get()) !=
      OGRERR_NONE) {
    return fail(ErrorCode::kInvalidOptions, "--crs: {} is no coordinate reference system ({})",
                text.size() > 60 ? text.substr(0, 60) + "..." : text, messages.text());
  }
  return crs;
}

OGRSpatialReference wgs84() {
  OGRSpatialReference crs;
  crs.SetWellKnownGeogCS("WGS84");
  crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return crs;
}

Result<CrsTransform> CrsTransform::create(const OGRSpatialReference& source,
                                          const OGRSpatialReference& target) {
  if (!source.IsProjected() && !source.IsGeographic()) {
    return fail(ErrorCode::kUnsupported,
                "coordinate reference system {} is neither geographic nor projected",
                source.GetName() != nullptr ? source.GetName() : "without name");
  }
  std::unique_ptr<OGRCoordinateTransformation> transformation(
      OGRCreateCoordinateTransformation(&source, &target));
  if (transformation == nullptr) {
    return fail(ErrorCode::kUnsupported,
                "coordinate reference system {} has no known relation to WGS 84",
                source.GetName() != nullptr ? source.GetName() : "without name");
  }
  return CrsTransform(std::move(transformation));
}

std::optional<Eigen::Vector2d> CrsTransform::operator()(const Eigen::Vector2d& point) const {
  double x = point.x();
  double y = point.y();
  int is_done = FALSE;
  transformation_->Transform(1, &x, &y, nullptr, &is_done);
  if (is_done == FALSE || !std::isfinite(x) || !std::isfinite(y)) return std::nullopt;
  return Eigen::Vector2d(x, y);
}

}  // namespace nadir
