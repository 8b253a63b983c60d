// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/geo/project_plane.h"
#include "core/map/gdal_raster.h"
#include "core/map/overhead_map_file.h"

namespace nadir {

/// Taking a raster of any coordinate reference system onto a map's plane. Private to this module.

/// North-up square cells on a plane.
struct MapGrid {
  ProjectPlane plane;
  double metres_per_cell = 0.0;
  Eigen::Vector2d top_left_in_enu_m = Eigen::Vector2d::Zero();
  int width = 0;
  int height = 0;
};

/// Where the grid lies, on its own plane.
[[nodiscard]] Placement placement_on(const MapGrid& grid);

/// The grid of a raster that is one of ours already: north-up square cells on a plane as
/// ProjectPlane::wkt describes it, whose origin is at most 5 km from the raster's centre, such as
/// the labels of a map package. Nothing where it is not: farther out the plane's metres are none,
/// and the raster is warped like any other.
[[nodiscard]] std::optional<MapGrid> own_grid(const Placement& placement,
                                              std::int64_t most_cells = kMaxMapCells);

struct PlannedGrid {
  MapGrid grid;
  /// Of the raster's centre pixel, measured: along a row and along a column.
  Eigen::Vector2d ground_m_per_pixel = Eigen::Vector2d::Zero();
  std::vector<std::string>
      notices;  ///< What the user should know: the pixels are not what the file says they are.
};

/// A grid that holds the whole raster, on a plane centred on it. Its cells lie on the raster's
/// centre pixel as that pixel lies: no cell's centre is on the pixel's edge.
/// @param metres_per_cell  Where empty, the smaller side of the raster's centre pixel as measured
/// on the ground.
/// @errors kMalformed: coordinates that contradict their CRS; kUnsupported: more than 1000 km or
/// kMaxMapCells.
[[nodiscard]] Result<PlannedGrid> plan_grid(const Placement& placement,
                                            std::optional<double> metres_per_cell,
                                            const std::string& name);

/// The same on a plane that is there already. @errors as plan_grid; kUnsupported where it leaves the plane.
[[nodiscard]] Result<PlannedGrid> plan_grid_on(const ProjectPlane& plane,
                                               const Placement& placement,
                                               std::optional<double> metres_per_cell,
                                               const std::string& name,
                                               std::int64_t most_cells);
/// The plane that is centred on a raster. @errors as plan_grid.
[[nodiscard]] Result<ProjectPlane> plane_centred_on(const Placement& placement,
                                                    const std::string& name);

/// By nearest neighbour; kUnclassified where the source has nothing. @errors kCancelled,
/// kMalformed.
[[nodiscard]] Result<Raster<ClassId>> warp_labels(const Raster<ClassId>& source,
                                                  const Placement& placement,
                                                  const MapGrid& grid,
                                                  const std::string& name,
                                                  const WorkContext& context);
/// Bilinear; black where the source has nothing. @errors kCancelled, kMalformed.
[[nodiscard]] Result<ColourRaster> warp_colours(const ColourRaster& source,
                                                const Placement& placement,
                                                const MapGrid& grid,
                                                const std::string& name,
                                                const WorkContext& context);

}  // namespace nadir
