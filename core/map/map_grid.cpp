// SPDX-License-Identifier: Apache-2.0
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/map/crs.h"
#include "core/map/map_warp.h"

namespace nadir {
namespace {

constexpr double kMaxSpanMetres = 1e6;

Eigen::Vector2d size_of(const Placement& placement) {
  return {static_cast<double>(placement.width), static_cast<double>(placement.height)};
}

/// Latitude and longitude of the raster's centre, after a look at its corners.
/// @errors kMalformed: a corner that has no place on the Earth.
Result<Geodetic> centre_of(const Placement& placement,
                           const OGRSpatialReference& crs,
                           const std::string& name) {
  const auto geodetic_from_crs = CrsTransform::create(crs, wgs84());
  if (!geodetic_from_crs) return forward_error(geodetic_from_crs, name);
  const Eigen::Vector2d size = size_of(placement);
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& share :
       {Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 0), Eigen::Vector2d(0, 1), Eigen::Vector2d(1, 1),
        Eigen::Vector2d(0.5, 0.5)}) {
    const Eigen::Vector2d point_in_crs = placement.crs_from_pixel * size.cwiseProduct(share);
    const auto geodetic = (*geodetic_from_crs)(point_in_crs);
    if (!geodetic || !(std::abs(geodetic->y()) <= 90.0)) {
      return fail(ErrorCode::kMalformed,
                  "{}: coordinate ({:.6g}, {:.6g}) has no place in its coordinate reference system",
                  name, point_in_crs.x(), point_in_crs.y());
    }
    centre = *geodetic;
  }
  return Geodetic{centre.y(), std::remainder(centre.x(), 360.0)};
}

/// Bounding box on the plane of the raster's edge, which bends where the systems differ. Nothing
/// where it leaves the plane.
std::optional<Eigen::AlignedBox2d> bounds_on_plane(const Placement& placement,
                                                   const CrsTransform& enu_from_crs) {
  constexpr int kSteps = 64;
  const Eigen::Vector2d size = size_of(placement);
  Eigen::AlignedBox2d bounds;
  for (int i = 0; i <= kSteps; ++i) {
    const double along = static_cast<double>(i) / kSteps;
    for (const Eigen::Vector2d& share :
         {Eigen::Vector2d(along, 0.0), Eigen::Vector2d(along, 1.0), Eigen::Vector2d(0.0, along),
          Eigen::Vector2d(1.0, along)}) {
      const auto point = enu_from_crs(placement.crs_from_pixel * size.cwiseProduct(share));
      if (!point) return std::nullopt;
      bounds.extend(*point);
    }
  }
  return bounds;
}

/// Sides on the ground of the raster's centre pixel, along a row and along a column. Measured,
/// because what a file calls a metre is none in Web Mercator, and even cos(latitude) is only
/// spherical.
std::optional<Eigen::Vector2d> ground_pixel_m(const Placement& placement,
                                              const CrsTransform& enu_from_crs) {
  const Eigen::Vector2d centre = 0.5 * size_of(placement);
  Eigen::Vector2d sides_m;
  for (const int axis : {0, 1}) {
    const Eigen::Vector2d half = 0.5 * Eigen::Vector2d::Unit(axis);
    const auto before = enu_from_crs(placement.crs_from_pixel * (centre - half));
    const auto after = enu_from_crs(placement.crs_from_pixel * (centre + half));
    if (!before || !after) return std::nullopt;
    sides_m(axis) = (*after - *before).norm();
  }
  return sides_m;
}

std::vector<std::string> notices_about(const Placement& placement,
                                       const OGRSpatialReference& crs,
                                       const Eigen::Vector2d& ground_m,
                                       double metres_per_cell) {
  constexpr double kWorthTelling = 0.005;
  std::vector<std::string> notices;
  if (crs.IsProjected()) {
    const Eigen::Vector2d nominal_m =
        placement.crs_from_pixel.pixel_size() * crs.GetLinearUnits(nullptr);
    if (std::abs(nominal_m.x() / ground_m.x() - 1.0) > kWorthTelling) {
      notices.push_back(fmt::format(
          "its pixels are {:.4f} m in {} but {:.4f} x {:.4f} m on the ground, which the map uses",
          nominal_m.x(),
          crs.GetName() != nullptr ? crs.GetName() : "its coordinate reference system",
          ground_m.x(), ground_m.y()));
    }
  }
  // Web Mercator's pixels are up to 0.7 % longer one way, which nobody calls "not square".
  if (std::abs(ground_m.x() / ground_m.y() - 1.0) > 0.01) {
    notices.push_back(fmt::format("its pixels of {:.4g} x {:.4g} m became square cells of {:.4g} m",
                                  ground_m.x(), ground_m.y(), metres_per_cell));
  }
  return notices;
}

}  // namespace

Result<PlannedGrid> plan_grid(const Placement& placement,
                              std::optional<double> metres_per_cell,
                              const std::string& name) {
  const GdalMessages messages;
  OGRSpatialReference crs;
  crs.importFromWkt(placement.crs_wkt.c_str());
  crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  const auto centre = centre_of(placement, crs, name);
  if (!centre) return forward_error(centre);
  const auto plane = ProjectPlane::create(*centre);
  if (!plane) return fail(ErrorCode::kMalformed, "{}: {}", name, plane.error().message);

  OGRSpatialReference plane_crs;
  plane_crs.importFromWkt(plane->wkt().c_str());
  plane_crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  const auto enu_from_crs = CrsTransform::create(crs, plane_crs);
  if (!enu_from_crs) return forward_error(enu_from_crs, name);
  const auto bounds = bounds_on_plane(placement, *enu_from_crs);
  const auto ground_m = ground_pixel_m(placement, *enu_from_crs);
  if (!bounds || !ground_m || !(bounds->sizes().maxCoeff() <= kMaxSpanMetres)) {
    return fail(ErrorCode::kUnsupported,
                "{}: spans more than the {:.0f} km that one plane can hold", name,
                kMaxSpanMetres / 1e3);
  }
  const double cell_m = metres_per_cell.value_or(ground_m->minCoeff());
  // A millionth of a cell of arithmetic must not cost a row or column.
  const Eigen::Array2d cells = (bounds->sizes().array() / cell_m - 1e-6).ceil().max(1.0);
  if (!(cell_m > 0.0) || !(cells.prod() <= static_cast<double>(kMaxMapCells))) {
    return fail(ErrorCode::kUnsupported,
                "{}: {:.0f} x {:.0f} cells of {:.4g} m are more than a map may have", name,
                cells.x(), cells.y(), cell_m);
  }
  const Eigen::Vector2d half_m = 0.5 * cell_m * cells.matrix();
  const Eigen::Vector2d middle = bounds->center();
  MapGrid grid{*plane,
               cell_m,
               {middle.x() - half_m.x(), middle.y() + half_m.y()},
               static_cast<int>(cells.x()),
               static_cast<int>(cells.y())};
  return PlannedGrid{std::move(grid), notices_about(placement, crs, *ground_m, cell_m)};
}

}  // namespace nadir
