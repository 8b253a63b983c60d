// SPDX-License-Identifier: Apache-2.0
#include "core/map/map_import.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <set>

#include "tests/core/map/raster_files.h"
#include "tests/support/error_text.h"
#include "tests/support/scratch_folder.h"

namespace nadir {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

constexpr double kEccentricitySquared = 6.69437999014e-3;

Affine2 affine(double a, double b, double c, double d, double x, double y) {
  Affine2 crs_from_pixel;
  crs_from_pixel.linear << a, b, c, d;
  crs_from_pixel.offset = {x, y};
  return crs_from_pixel;
}

/// North-up square pixels whose top-left corner is at a longitude and latitude.
RasterFile placed(const std::string& crs, double longitude, double latitude, double pixel) {
  const Eigen::Vector2d corner = crs_from_lon_lat(crs, {longitude, latitude});
  RasterFile file{.ids = patchwork(60, 45), .crs = crs};
  file.crs_from_pixel = affine(pixel, 0, 0, -pixel, corner.x(), corner.y());
  return file;
}

class MapImport : public testing::Test {
 protected:
  [[nodiscard]] ImportedMap imported(const RasterFile& file, const ImportOptions& options = {}) {
    write_raster(file, path());
    auto result = import_map(path(), options);
    if (!result) throw std::runtime_error(error_text(result));
    return std::move(*result);
  }
  [[nodiscard]] std::string fault(const RasterFile& file, const ImportOptions& options = {}) {
    write_raster(file, path());
    return error_text(import_map(path(), options));
  }
  [[nodiscard]] fs::path path() const { return folder.path() / "source.tif"; }

  ScratchFolder folder;
};

std::set<int> ids_in(const OverheadMap& map) {
  return {map.labels.values().begin(), map.labels.values().end()};
}

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

TEST_F(MapImport, LeavesOutWhatNoOverheadHolds) {
  RasterFile file = placed("EPSG:32617", -83.9, 33.45, 1.0);
  for (std::uint8_t& id : file.ids.values())
    if (id == kTerrain) id = kCar;
  const ImportedMap result = imported(file);
  EXPECT_THAT(ids_in(result.map), ElementsAre(kRoad, kSidewalk, kUnclassified));
  EXPECT_THAT(result.notices, ElementsAre(HasSubstr("of car, pedestrian or sky")));
}

TEST_F(MapImport, TakesAnAnchoredSourceCellByCell) {
  const RasterFile file{.ids = patchwork(61, 44)};
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

}  // namespace
}  // namespace nadir
