// SPDX-License-Identifier: Apache-2.0
// Sources without a place, what cannot be, and imports that are stopped.
#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "tests/core/map/map_import_fixture.h"

namespace nadir {
namespace map_import_options_test {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::IsEmpty;

TEST_F(MapImport, TakesAnAnchoredSourceCellByCell) {
  const RasterFile file{.ids = patchwork(61, 44), .category_names = our_class_names()};
  const Geodetic corner{48.987721, 8.387722};
  const ImportedMap result = imported(file, {.anchor = corner, .metres_per_pixel = 0.327});
  EXPECT_EQ(result.map.labels, file.ids);
  EXPECT_EQ(result.map.metres_per_cell, 0.327);
  const Geodetic found = result.map.plane.geodetic_from_enu(result.map.top_left_in_enu_m);
  EXPECT_NEAR(found.latitude_deg, corner.latitude_deg, 1e-11);
  EXPECT_NEAR(found.longitude_deg, corner.longitude_deg, 1e-11);
  // Centred: the map's middle is the plane's origin within centimetres.
  const Eigen::Vector2d middle = result.map.enu_from_overhead({30.5, 22.0});
  EXPECT_LT(middle.norm(), 0.01);
  EXPECT_THAT(result.notices, IsEmpty());
}

TEST_F(MapImport, PlacesTheCentreWhereToldTo) {
  const RasterFile file{.ids = patchwork(40, 30)};
  const ImportedMap result = imported(file, {.anchor = Geodetic{33.45, -83.9},
                                             .metres_per_pixel = 0.5,
                                             .anchor_point = AnchorPoint::kCentre});
  EXPECT_EQ(result.map.plane.origin().latitude_deg, 33.45);
  EXPECT_EQ(result.map.top_left_in_enu_m, Eigen::Vector2d(-10.0, 7.5));
}

TEST_F(MapImport, FlipsASourceThatIsStoredSouthUp) {
  const RasterFile file{.ids = patchwork(10, 7)};
  const ImportedMap result = imported(
      file, {.anchor = Geodetic{33.45, -83.9}, .metres_per_pixel = 0.5, .flip_vertically = true});
  for (int row = 0; row < 7; ++row) {
    for (int column = 0; column < 10; ++column) {
      EXPECT_EQ(result.map.labels.at(column, row), file.ids.at(column, 6 - row));
    }
  }
}

TEST_F(MapImport, ResamplesAnAnchoredSourceWhenAskedTo) {
  const RasterFile file{.ids = patchwork(60, 40)};
  ImportOptions options{.anchor = Geodetic{33.45, -83.9}, .metres_per_pixel = 1.0};
  options.metres_per_cell = 0.5;
  const OverheadMap map = imported(file, options).map;
  ASSERT_EQ(map.labels.width(), 120);
  ASSERT_EQ(map.labels.height(), 80);
  for (int row = 0; row < 80; ++row) {
    for (int column = 0; column < 120; ++column) {
      ASSERT_EQ(map.labels.at(column, row), file.ids.at(column / 2, row / 2));
    }
  }
}

TEST_F(MapImport, NeedsOnePlaceAndNotTwo) {
  EXPECT_THAT(fault({.ids = patchwork(20, 20)}), HasSubstr("place it with --anchor"));
  const RasterFile file = placed("EPSG:32617", -83.9, 33.45, 1.0);
  EXPECT_THAT(fault(file, {.anchor = Geodetic{33.45, -83.9}, .metres_per_pixel = 1.0}),
              HasSubstr("--anchor: "));
  EXPECT_THAT(fault(file, {.flip_vertically = true}), HasSubstr("--flip: "));
  EXPECT_THAT(fault(file, {.crs = "EPSG:32616"}), HasSubstr("--crs EPSG:32616 is refused"));
}

TEST_F(MapImport, RefusesOptionsThatMakeNoSense) {
  const RasterFile file{.ids = patchwork(20, 20)};
  const Geodetic anchor{33.45, -83.9};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(fault(file, {.anchor = anchor}), HasSubstr("--anchor: needs --metres-per-pixel"));
  EXPECT_THAT(fault(file, {.anchor = anchor, .metres_per_pixel = 0.0}),
              HasSubstr("--metres-per-pixel: 0 is not in"));
  EXPECT_THAT(fault(file, {.anchor = anchor, .metres_per_pixel = nan}),
              HasSubstr("--metres-per-pixel: nan is not in"));
  EXPECT_THAT(fault(file, {.anchor = Geodetic{95.0, 0.0}, .metres_per_pixel = 1.0}),
              HasSubstr("--anchor: map origin: latitude 95"));
  EXPECT_THAT(fault(file, {.inside_value = 7}), HasSubstr("--inside: 7"));
  EXPECT_EQ(fault(file, {.anchor = anchor, .metres_per_pixel = 1.0, .inside_value = 255}),
            "--inside: " + path().string() + " is no folder of class images");
  EXPECT_THAT(fault(file, {.anchor = anchor, .metres_per_pixel = 1.0, .crs = "EPSG:banana"}),
              HasSubstr("--crs: EPSG:banana is no"));
  const RasterFile utm{.ids = patchwork(20, 20),
                       .crs_from_pixel = affine(1, 0, 0, -1, 230000, 3705000)};
  EXPECT_THAT(fault(utm, {.crs = "EPSG:banana"}), HasSubstr("--crs: EPSG:banana is no"));
  const RasterFile wide = placed("EPSG:32617", -83.9, 33.45, 5000.0);
  EXPECT_THAT(fault(wide, {.metres_per_cell = 0.01}), HasSubstr("more than a map may have"));
}

TEST_F(MapImport, SaysThatAFileIsMissingOrNoRaster) {
  EXPECT_EQ(error_text(import_map(folder.path() / "no.tif", {})),
            (folder.path() / "no.tif").string() + ": no such file");
  const fs::path text = folder.file("text.tif", "no raster at all");
  testing::internal::CaptureStderr();
  EXPECT_THAT(error_text(import_map(text, {})), HasSubstr("text.tif: is no readable raster"));
  EXPECT_THAT(testing::internal::GetCapturedStderr(), IsEmpty());
}

TEST_F(MapImport, StopsWhenAsked) {
  write_raster(placed("EPSG:32617", -83.9, 33.45, 1.0), path());
  std::stop_source source;
  source.request_stop();
  WorkContext context;
  context.stop = source.get_token();
  const auto result = import_map(path(), {}, context);
  ASSERT_FALSE(result);
  EXPECT_EQ(error_code(result), ErrorCode::kCancelled);
}

TEST_F(MapImport, StopsWhileItWarpsAndLeavesNothing) {
  write_raster(placed("EPSG:32617", -83.9, 33.45, 1.0), path());
  const auto before = folder.entries();
  std::stop_source source;
  WorkContext context;
  context.stop = source.get_token();
  bool has_warped = false;
  context.progress = [&](double, const std::string& activity) {
    if (activity.find("warping") == std::string::npos) return;
    has_warped = true;
    source.request_stop();
  };
  const auto result = import_map(path(), {}, context);
  ASSERT_FALSE(result);
  EXPECT_EQ(error_code(result), ErrorCode::kCancelled);
  EXPECT_TRUE(has_warped);
  EXPECT_EQ(folder.entries(), before);
}

TEST_F(MapImport, StopsWhereNothingIsWarped) {
  write_raster({.ids = patchwork(20, 20)}, path());
  std::stop_source source;
  WorkContext context;
  context.stop = source.get_token();
  context.progress = [&](double, const std::string&) { source.request_stop(); };
  const auto result =
      import_map(path(), {.anchor = Geodetic{33.45, -83.9}, .metres_per_pixel = 0.5}, context);
  ASSERT_FALSE(result);
  EXPECT_EQ(error_code(result), ErrorCode::kCancelled);
}

TEST_F(MapImport, NamesTheMapAfterTheWholeFolderAndTheFileWithoutItsKind) {
  const ImportOptions options{.anchor = Geodetic{33.45, -83.9}, .metres_per_pixel = 0.5};
  const fs::path city = folder.path() / "city.v2";
  fs::create_directory(city);
  write_raster({.ids = Raster<std::uint8_t>(4, 4, 255), .driver = "PNG"}, city / "road.png");
  EXPECT_EQ(import_map(city, options).value().map.name, "city.v2");
  EXPECT_EQ(import_map(city / "", options).value().map.name, "city.v2");
  write_raster({.ids = patchwork(20, 20)}, folder.path() / "town.v3.tif");
  EXPECT_EQ(import_map(folder.path() / "town.v3.tif", options).value().map.name, "town.v3");
}

}  // namespace map_import_options_test
}  // namespace nadir
