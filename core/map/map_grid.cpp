// SPDX-License-Identifier: Apache-2.0
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string_view>

#include "core/map/crs.h"
#include "core/map/map_warp.h"

namespace nadir {
namespace {

constexpr double kMaxSpanMetres = 1e6;
constexpr double kMostCellsOfASide = 1e8;

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

/// The raster's centre pixel on the plane.
struct GroundPixel {
  Eigen::Vector2d centre_in_enu_m;
  Eigen::Matrix2d sides_in_enu_m;  ///< Columns: its side along a row and along a column.

  [[nodiscard]] Eigen::Vector2d side_lengths_m() const {
    return sides_in_enu_m.colwise().norm().transpose();
  }
};

/// Measured, because what a file calls a metre is none in Web Mercator, and even cos(latitude) is
/// only spherical.
std::optional<GroundPixel> ground_pixel(const Placement& placement,
                                        const CrsTransform& enu_from_crs) {
  const Eigen::Vector2d centre =
      Eigen::Vector2d(placement.width / 2, placement.height / 2) + Eigen::Vector2d(0.5, 0.5);
  const auto centre_in_enu = enu_from_crs(placement.crs_from_pixel * centre);
  if (!centre_in_enu) return std::nullopt;
  GroundPixel pixel{*centre_in_enu, Eigen::Matrix2d::Zero()};
  for (const int axis : {0, 1}) {
    const Eigen::Vector2d half = 0.5 * Eigen::Vector2d::Unit(axis);
    const auto before = enu_from_crs(placement.crs_from_pixel * (centre - half));
    const auto after = enu_from_crs(placement.crs_from_pixel * (centre + half));
    if (!before || !after) return std::nullopt;
    pixel.sides_in_enu_m.col(axis) = *after - *before;
  }
  return pixel;
}

/// How cells lie along one axis of the plane.
struct CellAxis {
  double first_edge_m = 0.0;
  double cells = 0.0;  ///< A whole number, which may be too large for an int.
};

/// Cells that hold [low_m, high_m] and lie so that their centres fall into pixels and not onto the
/// edges between them, where rounding would move the map by half a pixel: the pixel at `pixel_m`
/// holds a whole number of cells.
CellAxis cells_along(
    double low_m, double high_m, double pixel_m, double pixel_side_m, double cell_m) {
  // A hundredth of a cell, by which edges bend, must not cost a row of nothing.
  constexpr double kSpareCells = 0.01;
  const double cells_in_pixel = std::max(1.0, std::round(pixel_side_m / cell_m));
  const double edge_m = pixel_m - 0.5 * cells_in_pixel * cell_m;
  const double before = std::ceil((edge_m - low_m) / cell_m - kSpareCells);
  const double after = std::ceil((high_m - edge_m) / cell_m - kSpareCells);
  return {edge_m - before * cell_m, std::max(1.0, before + after)};
}

std::vector<std::string> notices_about(const Placement& placement,
                                       const OGRSpatialReference& crs,
                                       const Eigen::Vector2d& ground_m,
                                       double metres_per_cell) {
  constexpr double kWorthTelling = 0.005;
  constexpr double kWorthTellingPixels = 0.5;
  std::vector<std::string> notices;
  if (placement.control_point_error_px > kWorthTellingPixels) {
    notices.push_back(
        fmt::format("its ground control points are up to {:.2f} pixels from where it was placed",
                    placement.control_point_error_px));
  }
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

/// The plane that a reference system is; nothing where it is none.
std::optional<ProjectPlane> plane_of(const OGRSpatialReference& crs) {
  const char* projection = crs.GetAttrValue("PROJECTION");
  if (!crs.IsProjected() || projection == nullptr ||
      std::string_view(projection) != SRS_PT_TRANSVERSE_MERCATOR) {
    return std::nullopt;
  }
  const auto plane = ProjectPlane::create({crs.GetProjParm(SRS_PP_LATITUDE_OF_ORIGIN, 0.0),
                                           crs.GetProjParm(SRS_PP_CENTRAL_MERIDIAN, 0.0)});
  if (!plane) return std::nullopt;
  // Scale, unit, false origin and ellipsoid all show in where two points lie, to a tenth of a
  // millimetre.
  constexpr double kToleranceDeg = 1e-9;
  const auto geodetic_from_crs = CrsTransform::create(crs, wgs84());
  if (!geodetic_from_crs) return std::nullopt;
  for (const Eigen::Vector2d& point : {Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(1e4, 1e4)}) {
    const Geodetic expected = plane->geodetic_from_enu(point);
    const auto found = (*geodetic_from_crs)(point);
    if (!found || !(std::abs(found->x() - expected.longitude_deg) < kToleranceDeg) ||
        !(std::abs(found->y() - expected.latitude_deg) < kToleranceDeg)) {
      return std::nullopt;
    }
  }
  return *plane;
}

}  // namespace

std::optional<MapGrid> own_grid(const Placement& placement, std::int64_t most_cells) {
  const Affine2& affine = placement.crs_from_pixel;
  const double cell_m = affine.linear(0, 0);
  if (!affine.is_north_up() || affine.linear(1, 1) != -cell_m) return std::nullopt;
  const GdalMessages messages;
  const auto plane = plane_of(crs_from_wkt(placement.crs_wkt));
  if (!plane) return std::nullopt;
  // 0.31 ppm of scale and 0.05 degrees of convergence, which a map's centre may have.
  constexpr double kFarthestCentreMetres = 5e3;
  const Eigen::Vector2d size = size_of(placement);
  const Eigen::Vector2d centre_in_enu = affine * (0.5 * size);
  if (!(centre_in_enu.norm() <= kFarthestCentreMetres) ||
      !(size.maxCoeff() * cell_m <= kMaxSpanMetres) ||
      !(size.prod() <= static_cast<double>(most_cells))) {
    return std::nullopt;
  }
  return MapGrid{*plane, cell_m, affine.offset, placement.width, placement.height};
}

Result<ProjectPlane> plane_centred_on(const Placement& placement, const std::string& name) {
  const GdalMessages messages;
  const auto centre = centre_of(placement, crs_from_wkt(placement.crs_wkt), name);
  if (!centre) return forward_error(centre);
  auto plane = ProjectPlane::create(*centre);
  if (!plane) return fail(ErrorCode::kMalformed, "{}: {}", name, plane.error().message);
  return plane;
}

Result<PlannedGrid> plan_grid(const Placement& placement,
                              std::optional<double> metres_per_cell,
                              const std::string& name) {
  const auto plane = plane_centred_on(placement, name);
  if (!plane) return forward_error(plane);
  return plan_grid_on(*plane, placement, metres_per_cell, name, kMaxMapCells);
}

Result<PlannedGrid> plan_grid_on(const ProjectPlane& plane,
                                 const Placement& placement,
                                 std::optional<double> metres_per_cell,
                                 const std::string& name,
                                 std::int64_t most_cells) {
  const GdalMessages messages;
  const OGRSpatialReference crs = crs_from_wkt(placement.crs_wkt);
  const auto enu_from_crs = CrsTransform::create(crs, crs_from_wkt(plane.wkt()));
  if (!enu_from_crs) return forward_error(enu_from_crs, name);
  const auto bounds = bounds_on_plane(placement, *enu_from_crs);
  const auto pixel = ground_pixel(placement, *enu_from_crs);
  if (!bounds || !pixel || !(bounds->sizes().maxCoeff() <= kMaxSpanMetres)) {
    return fail(ErrorCode::kUnsupported,
                "{}: spans more than the {:.0f} km that one plane can hold", name,
                kMaxSpanMetres / 1e3);
  }
  const Eigen::Vector2d ground_m = pixel->side_lengths_m();
  const double cell_m = metres_per_cell.value_or(ground_m.minCoeff());
  const Eigen::Vector2d extent_m = pixel->sides_in_enu_m.cwiseAbs().rowwise().sum();
  const CellAxis east = cells_along(bounds->min().x(), bounds->max().x(),
                                    pixel->centre_in_enu_m.x(), extent_m.x(), cell_m);
  const CellAxis south = cells_along(-bounds->max().y(), -bounds->min().y(),
                                     -pixel->centre_in_enu_m.y(), extent_m.y(), cell_m);
  if (!(cell_m > 0.0) || !(east.cells * south.cells <= static_cast<double>(most_cells)) ||
      !(std::max(east.cells, south.cells) <= kMostCellsOfASide)) {
    return fail(ErrorCode::kUnsupported,
                "{}: {:.0f} x {:.0f} cells of {:.4g} m are more than a map may have", name,
                east.cells, south.cells, cell_m);
  }
  MapGrid grid{plane,
               cell_m,
               {east.first_edge_m, -south.first_edge_m},
               static_cast<int>(east.cells),
               static_cast<int>(south.cells)};
  return PlannedGrid{std::move(grid), ground_m, notices_about(placement, crs, ground_m, cell_m)};
}

Placement placement_on(const MapGrid& grid) {
  Affine2 enu_from_pixel;
  enu_from_pixel.linear << grid.metres_per_cell, 0.0, 0.0, -grid.metres_per_cell;
  enu_from_pixel.offset = grid.top_left_in_enu_m;
  return {enu_from_pixel, grid.plane.wkt(), grid.width, grid.height};
}

}  // namespace nadir
