// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <cmath>
#include <tuple>

#include "core/map/crs.h"
#include "core/map/map_import.h"
#include "core/map/map_warp.h"
#include "tests/core/map/raster_files.h"
#include "tests/support/error_text.h"
#include "tests/support/scratch_folder.h"

namespace nadir {
namespace map_grid_test {

Affine2 north_up(const Eigen::Vector2d& corner, double column, double row) {
  Affine2 crs_from_pixel;
  crs_from_pixel.linear << column, 0.0, 0.0, -row;
  crs_from_pixel.offset = corner;
  return crs_from_pixel;
}

/// Lines of one pixel, columns or rows, every fifth.
Raster<std::uint8_t> lines(int width, int height, bool are_columns) {
  Raster<std::uint8_t> ids(width, height, kTerrain);
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      if ((are_columns ? column : row) % 5 == 2) ids.at(column, row) = kRoad;
    }
  }
  return ids;
}

/// How far, in cells, the road lines of the map lie from those of the source, to the right and
/// down: the mean over all road cells.
Eigen::Vector2d offset_of_lines(const OverheadMap& map,
                                const RasterFile& source,
                                bool are_columns) {
  const Affine2 pixel_from_crs = source.crs_from_pixel.value().inverse().value();
  const CrsTransform crs_from_geodetic =
      CrsTransform::create(wgs84(), crs_from_text(source.crs, GdalMessages()).value()).value();
  const int axis = are_columns ? 0 : 1;
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  int count = 0;
  for (int row = 0; row < map.labels.height(); ++row) {
    for (int column = 0; column < map.labels.width(); ++column) {
      if (map.labels.at(column, row) != kRoad) continue;
      const Geodetic geodetic =
          map.plane.geodetic_from_enu(map.enu_from_overhead({column + 0.5, row + 0.5}));
      const Eigen::Vector2d pixel =
          pixel_from_crs *
          crs_from_geodetic({geodetic.longitude_deg, geodetic.latitude_deg}).value();
      // Lines are at 2.5, 7.5, ...; the remainder is in [-2.5, 2.5].
      sum(axis) += std::remainder(pixel(axis) - 2.5, 5.0);
      ++count;
    }
  }
  return sum / std::max(count, 1);
}

class MapGridOf : public testing::TestWithParam<std::tuple<std::string, double, double>> {
 protected:
  [[nodiscard]] RasterFile source(int width, int height, bool are_columns, double pixel) const {
    const auto& [crs, longitude, latitude] = GetParam();
    RasterFile file{.ids = lines(width, height, are_columns), .crs = crs};
    file.crs_from_pixel = north_up(crs_from_lon_lat(crs, {longitude, latitude}), pixel, pixel);
    return file;
  }
  [[nodiscard]] OverheadMap imported(const RasterFile& file,
                                     const ImportOptions& options = {}) const {
    write_raster(file, folder.path() / "lines.tif");
    auto result = import_map(folder.path() / "lines.tif", options);
    if (!result) throw std::runtime_error(error_text(result));
    return std::move(result->map);
  }

  ScratchFolder folder;
};

TEST_P(MapGridOf, LeavesThinLinesWhereTheyAre) {
  for (const int width : {100, 101}) {
    for (const int height : {80, 81}) {
      for (const bool are_columns : {false, true}) {
        const RasterFile file = source(width, height, are_columns, 0.597164);
        const OverheadMap map = imported(file);
        EXPECT_LT(offset_of_lines(map, file, are_columns).norm(), 0.1)
            << width << " x " << height << (are_columns ? " columns" : " rows");
      }
    }
  }
}

TEST_P(MapGridOf, LeavesThinLinesWhereTheyAreAtAnyResolution) {
  for (const double pixels_per_cell : {0.5, 1.0 / 3.0, 0.25}) {
    for (const bool are_columns : {false, true}) {
      const RasterFile file = source(60, 45, are_columns, 1.0);
      const double ground = imported(file).metres_per_cell;
      const OverheadMap map = imported(file, {.metres_per_cell = ground * pixels_per_cell});
      EXPECT_LT(offset_of_lines(map, file, are_columns).norm(), 0.1) << pixels_per_cell;
    }
  }
}

TEST_P(MapGridOf, HoldsTheWholeSourceWithLittleMore) {
  const RasterFile file = source(100, 80, true, 0.597164);
  const OverheadMap map = imported(file);
  for (const double column : {0.05, 99.95}) {
    for (const double row : {0.05, 79.95}) {
      const Eigen::Vector2d lon_lat =
          lon_lat_from_crs(file.crs, *file.crs_from_pixel * Eigen::Vector2d(column, row));
      const Eigen::Vector2d cell =
          map.overhead_from_enu(map.plane.enu_from_geodetic({lon_lat.y(), lon_lat.x()}));
      EXPECT_TRUE(cell.x() > 0.0 && cell.y() > 0.0 && cell.x() < map.labels.width() &&
                  cell.y() < map.labels.height())
          << column << ", " << row << " is at " << cell.transpose();
    }
  }
  // Convergence of a degree or two turns the source; beyond that there is a cell at each side.
  EXPECT_LE(map.labels.width(), 100 + 2 + 4);
  EXPECT_LE(map.labels.height(), 80 + 2 + 5);
}

INSTANTIATE_TEST_SUITE_P(Systems,
                         MapGridOf,
                         testing::Values(std::tuple("EPSG:3857", 9.0, 60.0),
                                         std::tuple("EPSG:3857", -122.1, 37.7),
                                         std::tuple("EPSG:3857", 20.0, 1.0),
                                         std::tuple("EPSG:32617", -81.0, 48.0),
                                         std::tuple("EPSG:32617", -83.9, 33.45)));

TEST(MapGrid, HasASourcesCellsWhereNothingIsWarped) {
  const ProjectPlane plane = ProjectPlane::create({33.45, -83.9}).value();
  for (const int width : {1, 2, 61, 62}) {
    const Placement placement{north_up({-0.25 * width, 10.0}, 0.5, 0.5), plane.wkt(), width, 40};
    const auto planned = plan_grid(placement, {}, "plane.tif");
    ASSERT_TRUE(planned) << error_text(planned);
    EXPECT_EQ(planned->grid.width, width);
    EXPECT_EQ(planned->grid.height, 40);
    EXPECT_NEAR(planned->grid.metres_per_cell, 0.5, 1e-9);
  }
}

/// 40 x 20 cells whose centre is at `centre_in_enu_m` of the plane.
Placement on_plane(const ProjectPlane& plane, const Eigen::Vector2d& centre_in_enu_m, double cell) {
  const Eigen::Vector2d corner = centre_in_enu_m + cell * Eigen::Vector2d(-20.0, 10.0);
  return {north_up(corner, cell, cell), plane.wkt(), 40, 20};
}

TEST(OwnGrid, IsThatOfARasterWhoseCentreIsNearThePlanesOrigin) {
  const ProjectPlane plane = ProjectPlane::create({33.45, -83.9}).value();
  for (const Eigen::Vector2d& centre_m :
       {Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(4'990.0, 0.0), Eigen::Vector2d(-3e3, 3.9e3)}) {
    const Placement placement = on_plane(plane, centre_m, 0.5);
    const auto grid = own_grid(placement);
    ASSERT_TRUE(grid) << centre_m.transpose();
    EXPECT_EQ(grid->top_left_in_enu_m, placement.crs_from_pixel.offset);
    EXPECT_EQ(grid->metres_per_cell, 0.5);
    EXPECT_EQ(grid->width, 40);
    EXPECT_EQ(grid->height, 20);
  }
  for (const Eigen::Vector2d& centre_m :
       {Eigen::Vector2d(5'010.0, 0.0), Eigen::Vector2d(-3e3, 4.1e3), Eigen::Vector2d(0.0, 4e5),
        Eigen::Vector2d(0.0, std::nan(""))}) {
    EXPECT_FALSE(own_grid(on_plane(plane, centre_m, 0.5))) << centre_m.transpose();
  }
}

TEST(OwnGrid, KeepsTheLimitsOfEveryMap) {
  const ProjectPlane plane = ProjectPlane::create({33.45, -83.9}).value();
  EXPECT_TRUE(own_grid(on_plane(plane, {0.0, 0.0}, 24'900.0)));   // 996 km wide
  EXPECT_FALSE(own_grid(on_plane(plane, {0.0, 0.0}, 25'100.0)));  // 1004 km
  Placement large = on_plane(plane, {0.0, 0.0}, 0.001);
  large.width = 40'000;
  large.height = 25'000;
  EXPECT_TRUE(own_grid(large));
  large.height = 25'001;
  EXPECT_FALSE(own_grid(large)) << "more than a thousand million cells";
}

}  // namespace map_grid_test
}  // namespace nadir
