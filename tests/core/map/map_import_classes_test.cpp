// SPDX-License-Identifier: Apache-2.0
// What an imported map holds.
#include <gmock/gmock.h>

#include <set>

#include "tests/core/map/map_import_fixture.h"

namespace nadir {
namespace map_import_classes_test {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

std::set<int> ids_in(const OverheadMap& map) {
  return {map.labels.values().begin(), map.labels.values().end()};
}

// Trap 11: labels are warped by nearest neighbour, so that no class appears between two others.
TEST_F(MapImport, InventsNoClass) {
  RasterFile file{.ids = patchwork(80, 80),
                  .crs_from_pixel = affine(0.8, 0.6, 0.6, -0.8, 230000, 3705000),
                  .crs = "EPSG:32617"};
  for (std::uint8_t& id : file.ids.values()) id = id == kRoad ? kRoad : kLaneMarking;
  for (const double metres_per_cell : {0.3, 1.0, 3.7}) {
    const OverheadMap map = imported(file, {.metres_per_cell = metres_per_cell}).map;
    EXPECT_EQ(map.metres_per_cell, metres_per_cell);
    EXPECT_THAT(ids_in(map), ElementsAre(kRoad, kLaneMarking, kUnclassified));
  }
}

TEST_F(MapImport, TakesTheSourcesNoDataForUnclassified) {
  RasterFile file = placed("EPSG:32617", -83.9, 33.45, 1.0);
  file.no_data = kTerrain;
  EXPECT_THAT(ids_in(imported(file).map), ElementsAre(kRoad, kSidewalk, kUnclassified));
}

TEST_F(MapImport, RefusesIdsThatAreNoClassUnlessARemapNamesThem) {
  RasterFile file = placed("EPSG:32617", -83.9, 33.45, 1.0);
  for (std::uint8_t& id : file.ids.values()) id = static_cast<std::uint8_t>(id + 40);
  EXPECT_THAT(fault(file), HasSubstr("is no class; name the source's classes with --remap"));
  ImportOptions options;
  options.remap = ClassRemap::parse("[ids]\n40 = \"curb\"\n48 = \"fence\"\n", "r.toml").value();
  EXPECT_THAT(ids_in(imported(file, options).map), ElementsAre(kFence, kCurb, kUnclassified));
}

TEST_F(MapImport, RemapsByTheNamesThatTheSourceGivesItsIds) {
  RasterFile file = placed("EPSG:32617", -83.9, 33.45, 1.0);
  file.category_names = {"Strasse", "Gehweg"};
  ImportOptions options;
  options.remap = ClassRemap::parse("[classes]\nGehweg = \"sidewalk\"\n", "r.toml").value();
  EXPECT_THAT(ids_in(imported(file, options).map), ElementsAre(kSidewalk, kUnclassified));
}

TEST_F(MapImport, SaysWhichValuesOfAForeignRasterBecameWhichClasses) {
  RasterFile file = placed("EPSG:32617", -83.9, 33.45, 1.0);
  file.category_names.clear();
  const std::string begin =
      path().string() + ": without --remap its values were taken as this program's classes: ";
  EXPECT_THAT(imported(file).notices,
              ElementsAre(begin + "0 as road, 1 as sidewalk, 8 as terrain"));
  file.category_names = {"Road", "water", "building"};
  EXPECT_THAT(imported(file).notices,
              ElementsAre(begin + "0 as road, 1 (\"water\") as sidewalk, 8 as terrain"));
  ImportOptions options;
  options.remap = ClassRemap::parse("[ids]\n0 = \"curb\"\n", "r.toml").value();
  EXPECT_THAT(imported(file, options).notices, IsEmpty()) << "the remap has said it";
  file.category_names = our_class_names();
  EXPECT_THAT(imported(file).notices, IsEmpty()) << "the source has said it";
}

TEST_F(MapImport, OfThePackagesOwnLabelsIsTheIdentity) {
  const fs::path bundled = NADIR_SOURCE_DIR "/maps/proving-ground";
  const OverheadMap map = read_overhead_map(bundled).value();
  // With the names of its classes beside it, and, as after a copy of the one file, without.
  fs::copy_file(bundled / "labels.tif", folder.path() / "labels.tif");
  for (const fs::path& source : {bundled / "labels.tif", folder.path() / "labels.tif"}) {
    const auto result = import_map(source, {});
    ASSERT_TRUE(result) << error_text(result);
    EXPECT_TRUE(result->map.plane == map.plane);
    EXPECT_EQ(result->map.metres_per_cell, map.metres_per_cell);
    EXPECT_EQ(result->map.top_left_in_enu_m, map.top_left_in_enu_m);
    EXPECT_EQ(result->map.labels, map.labels);
    EXPECT_THAT(result->notices, IsEmpty());
  }
}

TEST_F(MapImport, OfAnyPackageIsTheIdentityWhereverItsPlaneLies) {
  OverheadMap map{"east of its plane",
                  ProjectPlane::create({47.123456789012345, -1.0 / 3.0}).value(),
                  0.1234567890123,
                  {1234.5678901234, -987.65432109876},
                  patchwork(61, 44)};
  const fs::path package = folder.path() / "map";
  ASSERT_TRUE(write_overhead_map(map, {}, ColourRaster(61, 44, Colour{1, 2, 3}), package));
  const auto result = import_map(package / "labels.tif", {.image = package / "image.tif"});
  ASSERT_TRUE(result) << error_text(result);
  // GDAL writes reference systems with 15 digits: a tenth of a micrometre.
  EXPECT_NEAR(result->map.plane.origin().latitude_deg, map.plane.origin().latitude_deg, 1e-12);
  EXPECT_NEAR(result->map.plane.origin().longitude_deg, map.plane.origin().longitude_deg, 1e-12);
  EXPECT_EQ(result->map.metres_per_cell, map.metres_per_cell);
  EXPECT_EQ(result->map.top_left_in_enu_m, map.top_left_in_enu_m);
  EXPECT_EQ(result->map.labels, map.labels);
  EXPECT_EQ(result->image->width(), 61);
  EXPECT_THAT(result->notices, IsEmpty());
  const auto finer = import_map(package / "labels.tif", {.metres_per_cell = 0.05});
  ASSERT_TRUE(finer) << error_text(finer);
  EXPECT_EQ(finer->map.metres_per_cell, 0.05);
  const auto same = import_map(package / "labels.tif", {.metres_per_cell = map.metres_per_cell});
  ASSERT_TRUE(same) << error_text(same);
  EXPECT_EQ(same->map.top_left_in_enu_m, map.top_left_in_enu_m) << "the resolution that it has";
  EXPECT_EQ(same->map.labels, map.labels);
}

TEST_F(MapImport, ARasterFarFromTheOriginOfItsPlaneGetsAPlaneOfItsOwn) {
  // A quarter of a degree of longitude from the central meridian, the plane's metres are 7 ppm too
  // long and its north is off by 0.14 degrees.
  const RasterFile file = placed("+proj=tmerc +lat_0=33.45 +lon_0=-83.9 +k=1 +datum=WGS84 +units=m",
                                 -83.65, 33.45, 1.0);
  const OverheadMap map = imported(file).map;
  EXPECT_EQ(cells_that_disagree(map, file), 0);
  const Eigen::Vector2d centre =
      lon_lat_from_crs(file.crs, *file.crs_from_pixel * Eigen::Vector2d(30.0, 22.5));
  EXPECT_NEAR(map.plane.origin().longitude_deg, centre.x(), 1e-9);
  EXPECT_NEAR(map.plane.origin().latitude_deg, centre.y(), 1e-9);
}

TEST_F(MapImport, ARasterInAnotherTransverseMercatorIsNoPackage) {
  // Same kind of projection, but scaled, shifted or in feet: it is warped like any other.
  for (const char* crs :
       {"+proj=tmerc +lat_0=33.45 +lon_0=-83.9 +k=0.9996 +datum=WGS84 +units=m",
        "+proj=tmerc +lat_0=33.45 +lon_0=-83.9 +k=1 +x_0=500 +datum=WGS84 +units=m",
        "+proj=tmerc +lat_0=33.45 +lon_0=-83.9 +k=1 +datum=WGS84 +units=us-ft",
        "+proj=tmerc +lat_0=33.45 +lon_0=-83.9 +k=1 +ellps=bessel +units=m"}) {
    const RasterFile file = placed(crs, -83.9, 33.45, 1.0);
    const OverheadMap map = imported(file).map;
    EXPECT_EQ(cells_that_disagree(map, file), 0) << crs;
    EXPECT_LT(map.enu_from_overhead({30.0, 22.5}).norm(), 1.0) << "centred on the map: " << crs;
  }
}

TEST_F(MapImport, LeavesOutWhatNoOverheadHolds) {
  RasterFile file = placed("EPSG:32617", -83.9, 33.45, 1.0);
  for (std::uint8_t& id : file.ids.values())
    if (id == kTerrain) id = kCar;
  const ImportedMap result = imported(file);
  EXPECT_THAT(ids_in(result.map), ElementsAre(kRoad, kSidewalk, kUnclassified));
  EXPECT_THAT(result.notices, ElementsAre(HasSubstr("of car, pedestrian or sky")));
}

TEST_F(MapImport, DerivesBuildingContours) {
  RasterFile file{.ids = Raster<std::uint8_t>(12, 12, kTerrain)};
  for (int row = 2; row < 10; ++row) {
    for (int column = 2; column < 10; ++column) file.ids.at(column, row) = kBuilding;
  }
  const OverheadMap map = imported(file, {.anchor = Geodetic{33.45, -83.9},
                                          .metres_per_pixel = 0.5,
                                          .building_contours_m = 0.5})
                              .map;
  EXPECT_EQ(map.labels.at(2, 5), kBuilding);
  EXPECT_EQ(map.labels.at(3, 5), kUnclassified);
  EXPECT_EQ(map.labels.at(5, 5), kUnclassified);
  EXPECT_EQ(map.labels.at(1, 5), kTerrain);
}

TEST_F(MapImport, TakesAPictureOfTheSameSizeAlong) {
  const RasterFile file{.ids = patchwork(30, 20)};
  ColourRaster picture(30, 20, Colour{10, 20, 30});
  picture.at(29, 0) = {200, 100, 50};
  const fs::path png = folder.path() / "photo.png";
  write_picture(picture, png);
  ImportOptions options{.anchor = Geodetic{33.45, -83.9}, .metres_per_pixel = 0.5};
  options.image = png;
  EXPECT_EQ(imported(file, options).image, picture);
  options.flip_vertically = true;
  EXPECT_EQ(imported(file, options).image->at(29, 19), (Colour{200, 100, 50}));
  write_picture(ColourRaster(31, 20), png);
  EXPECT_THAT(fault(file, options), HasSubstr("its 31 x 20 pixels are not the labels' 30 x 20"));
}

TEST_F(MapImport, WarpsAPictureOntoTheSameGrid) {
  RasterFile file = placed("EPSG:32617", -83.9, 33.45, 1.0);
  file.crs_from_pixel = affine(0.8, 0.6, 0.6, -0.8, 230000, 3705000);
  // Red grows along the rows, green along the columns, so that a colour tells its place.
  ColourRaster picture(60, 45);
  for (int row = 0; row < 45; ++row) {
    for (int column = 0; column < 60; ++column) {
      picture.at(column, row) = {static_cast<std::uint8_t>(4 * column),
                                 static_cast<std::uint8_t>(4 * row), 0};
    }
  }
  const fs::path png = folder.path() / "photo.png";
  write_picture(picture, png);
  const ImportedMap result = imported(file, {.image = png});
  ASSERT_TRUE(result.image);
  ASSERT_EQ(result.image->width(), result.map.labels.width());
  const Eigen::Vector2d pixel(40.5, 20.5);
  const Eigen::Vector2d lon_lat = lon_lat_from_crs("EPSG:32617", *file.crs_from_pixel * pixel);
  const Eigen::Vector2d cell =
      result.map.overhead_from_enu(result.map.plane.enu_from_geodetic({lon_lat.y(), lon_lat.x()}));
  const Colour colour = result.image->at(static_cast<int>(cell.x()), static_cast<int>(cell.y()));
  EXPECT_NEAR(colour.red, 160, 4);  // within a cell
  EXPECT_NEAR(colour.green, 80, 4);
}

TEST_F(MapImport, MakesMapsThatAreWrittenAndReadAsTheyAre) {
  const ImportedMap result = imported(placed("EPSG:3857", 9.0, 60.0, 0.6));
  const fs::path package = folder.path() / "map";
  const auto written = write_overhead_map(result.map, {}, result.image, package);
  ASSERT_TRUE(written) << error_text(written);
  const auto read = read_overhead_map(package);
  ASSERT_TRUE(read) << error_text(read);
  EXPECT_TRUE(read->plane == result.map.plane);
  EXPECT_EQ(read->metres_per_cell, result.map.metres_per_cell);
  EXPECT_EQ(read->top_left_in_enu_m, result.map.top_left_in_enu_m);
  EXPECT_EQ(read->labels, result.map.labels);
  EXPECT_EQ(read->name, "source");
}

}  // namespace map_import_classes_test
}  // namespace nadir
