// SPDX-License-Identifier: Apache-2.0
// Where an imported map lies.
#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "tests/core/map/map_import_fixture.h"

namespace nadir {
namespace map_import_test {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr double kEccentricitySquared = 6.69437999014e-3;

double share_classified(const OverheadMap& map) {
  const auto& values = map.labels.values();
  return 1.0 - static_cast<double>(std::count(values.begin(), values.end(), kUnclassified)) /
                   static_cast<double>(values.size());
}

// Trap 1: GDAL itself moves the half pixel of PixelIsPoint; moving it again would be a cell's half
// off.
TEST_F(MapImport, PutsPixelIsPointWherePixelIsAreaLies) {
  RasterFile file = placed("EPSG:32617", -83.9, 33.45, 1.0);
  const OverheadMap area = imported(file).map;
  file.is_pixel_is_point = true;
  const OverheadMap point = imported(file).map;
  EXPECT_TRUE(area.plane == point.plane);
  EXPECT_EQ(area.labels, point.labels);
  EXPECT_EQ(cells_that_disagree(point, file), 0);
}

// Trap 2: a world file gives the centre of the upper-left pixel, in the order A D B E C F.
TEST_F(MapImport, ReadsAWorldFileBesideAPng) {
  const Affine2 truth = affine(0.8, 0.3, 0.25, -0.9, 230000.0, 3705000.0);
  const RasterFile source{.ids = patchwork(60, 45), .crs_from_pixel = truth, .crs = "EPSG:32617"};
  const fs::path png = folder.path() / "drawn.png";
  write_raster({.ids = source.ids, .driver = "PNG"}, png);
  // Centre of the upper-left pixel: corner + half a column + half a row.
  static_cast<void>(folder.file("drawn.pgw", "0.8\n0.25\n0.3\n-0.9\n230000.55\n3704999.675\n"));
  const auto result = import_map(png, {.crs = "EPSG:32617"});
  ASSERT_TRUE(result) << error_text(result);
  EXPECT_EQ(cells_that_disagree(result->map, source), 0);
  EXPECT_EQ(result->map.name, "drawn");
}

TEST_F(MapImport, NeedsTheReferenceSystemOfAWorldFile) {
  const fs::path png = folder.path() / "drawn.png";
  write_raster({.ids = patchwork(20, 20), .driver = "PNG"}, png);
  static_cast<void>(folder.file("drawn.pgw", "1\n0\n0\n-1\n230000\n3705000\n"));
  EXPECT_THAT(error_text(import_map(png, {})), HasSubstr("name it with --crs"));
}

// Trap 3: EPSG:4326 is latitude first in GDAL; swapped coordinates do not fail, they lie.
TEST_F(MapImport, KeepsLongitudeAndLatitudeApart) {
  const RasterFile file = placed("EPSG:4326", -83.9, 33.45, 1e-5);
  const OverheadMap map = imported(file).map;
  EXPECT_NEAR(map.plane.origin().latitude_deg, 33.45 - 22.5e-5, 1e-9);
  EXPECT_NEAR(map.plane.origin().longitude_deg, -83.9 + 30e-5, 1e-9);
  EXPECT_EQ(cells_that_disagree(map, file), 0);
}

// Trap 4: both sides of a UTM zone edge share one frame.
TEST_F(MapImport, PutsOnePlaceAtOnePlaceInBothUtmZones) {
  for (const char* crs : {"EPSG:32616", "EPSG:32617"}) {
    const RasterFile file = placed(crs, -84.0002, 33.45, 1.0);
    const OverheadMap map = imported(file).map;
    EXPECT_EQ(cells_that_disagree(map, file), 0) << crs;
    const Eigen::Vector2d corner_in_enu = map.plane.enu_from_geodetic({33.45, -84.0002});
    // The plane lies on the map's centre, so the source's corner is half the map's diagonal away,
    // whichever zone it is from.
    EXPECT_NEAR(corner_in_enu.norm(), std::hypot(30.0, 22.5), 0.05) << crs;
  }
}

// Trap 5: UTM is neither true metres nor true north.
TEST_F(MapImport, MeasuresUtmOnTheGround) {
  const OverheadMap middle = imported(placed("EPSG:32617", -81.0, 48.0, 1.0)).map;
  EXPECT_NEAR(middle.metres_per_cell, 1.0 / 0.9996, 1e-6);
  const RasterFile edge = placed("EPSG:32617", -78.02, 48.0, 1.0);
  const ImportedMap turned = imported(edge);
  EXPECT_EQ(cells_that_disagree(turned.map, edge), 0);
  // Two degrees of convergence over 60 m are two cells at the edges, and they are unclassified.
  EXPECT_LT(share_classified(turned.map), 0.97);
  EXPECT_GT(share_classified(turned.map), 0.88);
}

// Trap 6: with rotation or shear the pixel's size is the column's norm, and pixels need not be
// square.
TEST_F(MapImport, WarpsRotatedShearedAndOblongPixels) {
  for (const Affine2& crs_from_pixel :
       {affine(0.8, 0.6, 0.6, -0.8, 230000, 3705000), affine(1, 0.4, 0, -1, 230000, 3705000),
        affine(1, 0, 0, -2.5, 230000, 3705000), affine(-1, 0, 0, 1, 230000, 3705000),
        affine(0.2, -0.7, -1.1, -0.3, 230000, 3705000)}) {
    const RasterFile file{
        .ids = patchwork(60, 45), .crs_from_pixel = crs_from_pixel, .crs = "EPSG:32617"};
    const ImportedMap result = imported(file);
    EXPECT_EQ(cells_that_disagree(result.map, file), 0);
    const double ground = crs_from_pixel.pixel_size().minCoeff();
    EXPECT_NEAR(result.map.metres_per_cell / ground, 1.0, 2e-3);
  }
}

TEST_F(MapImport, SaysThatOblongPixelsBecameSquare) {
  RasterFile file = placed("EPSG:32617", -83.9, 33.45, 1.0);
  file.crs_from_pixel->linear(1, 1) = -2.0;
  const ImportedMap result = imported(file);
  ASSERT_EQ(result.notices.size(), 1U);
  EXPECT_THAT(result.notices[0], HasSubstr("became square cells"));
}

// Trap 7: Web Mercator's metre is no metre; cos(latitude) is only spherical.
TEST_F(MapImport, MeasuresWebMercatorOnTheEllipsoid) {
  constexpr double kNominalMetres = 0.597164;
  const RasterFile file = placed("EPSG:3857", 9.0, 60.0, kNominalMetres);
  const ImportedMap result = imported(file);
  const double latitude = result.map.plane.origin().latitude_deg * std::numbers::pi / 180.0;
  const double w = 1.0 - kEccentricitySquared * std::sin(latitude) * std::sin(latitude);
  const double across = kNominalMetres * std::cos(latitude) / std::sqrt(w);
  const double along = across * (1.0 - kEccentricitySquared) / w;
  EXPECT_NEAR(result.map.metres_per_cell, std::min(across, along), 1e-6);
  EXPECT_GT(std::abs(result.map.metres_per_cell / (kNominalMetres * std::cos(latitude)) - 1.0),
            5e-4);
  EXPECT_EQ(cells_that_disagree(result.map, file), 0);
  ASSERT_EQ(result.notices.size(), 1U);
  EXPECT_THAT(result.notices[0], HasSubstr("0.5972 m in WGS 84 / Pseudo-Mercator but 0.29"));
  EXPECT_NEAR(across / along, 1.0017, 1e-3);
}

// Trap 13: coordinates that contradict their reference system.
TEST_F(MapImport, RefusesLatitudesBeyondThePole) {
  RasterFile file{.ids = patchwork(60, 45), .crs = "EPSG:4326"};
  file.crs_from_pixel = affine(0.18, 0, 0, -0.18, -92.8, 92.8);
  EXPECT_EQ(fault(file), path().string() + ": claims to be in degrees but reaches latitude 92.8");
}

TEST_F(MapImport, RefusesPlacesThatAreNone) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Affine2& crs_from_pixel :
       {affine(1, 0, 0, -1, 1e12, 1e12), affine(1, 0, 0, -1, nan, 3705000),
        affine(1, 2, -2, -4, 230000, 3705000), affine(1e6, 0, 0, -1e6, 230000, 3705000)}) {
    const RasterFile file{
        .ids = patchwork(60, 45), .crs_from_pixel = crs_from_pixel, .crs = "EPSG:32617"};
    EXPECT_THAT(fault(file), testing::StartsWith(path().string() + ": "));
  }
}

TEST_F(MapImport, RefusesThePole) {
  RasterFile file{.ids = patchwork(60, 45), .crs = "EPSG:3413"};
  file.crs_from_pixel = affine(10, 0, 0, -10, -300, 225);
  EXPECT_THAT(fault(file), HasSubstr("is not in [-89, 89] degrees"));
}

}  // namespace map_import_test
}  // namespace nadir
