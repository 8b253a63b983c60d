// SPDX-License-Identifier: Apache-2.0
// Images of other makers, each by name: where gdalinfo says that its corner and pixels are, or why it is refused.
#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>

#include "core/map/overhead_image.h"
#include "tests/core/map/image_files.h"
#include "tests/core/map/raster_files.h"
#include "tests/support/error_text.h"

namespace nadir {
namespace overhead_image_data_test {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;

class RecordedImage : public testing::Test {
 protected:
  void SetUp() override {
    // Read before any thread is started.
    const char* const root = std::getenv("NADIR_TEST_DATA");  // NOLINT(concurrency-mt-unsafe)
    if (root == nullptr) {
      GTEST_SKIP() << "NADIR_TEST_DATA is not set: images of other makers are left out";
    }
    folder = fs::path(root) / "geotiff";
  }
  fs::path folder;
};

/// As gdalinfo prints them: "Size is", "Origin" and "Pixel Size"; ground resolution by the ellipsoid's radii.
struct KnownImage {
  std::string file, crs;
  int width, height;
  Eigen::Vector2d origin, pixel;
  Eigen::Vector2d ground_m;
  double tolerance_m;
  bool is_bright;  ///< Shows something in its middle.
};

void expect_as_known(const fs::path& folder, const KnownImage& known) {
  SCOPED_TRACE(known.file);
  const auto opened = open_overhead_image(folder / known.file);
  ASSERT_TRUE(opened) << error_text(opened);
  const OverheadImage& image = opened->image;
  EXPECT_EQ(image.width, known.width);
  EXPECT_EQ(image.height, known.height);
  EXPECT_EQ(image.place, ImagePlace::kOwn);
  EXPECT_NEAR(image.ground_m_per_pixel->x(), known.ground_m.x(), known.tolerance_m);
  EXPECT_NEAR(image.ground_m_per_pixel->y(), known.ground_m.y(), known.tolerance_m);
  EXPECT_NEAR(opened->tiles.metres_per_cell(), known.ground_m.minCoeff(), known.tolerance_m);
  // Corners and centre, by PROJ to latitude and longitude, and from there to the image's own pixels.
  for (const Eigen::Vector2d& share : {Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 0),
                                       Eigen::Vector2d(0, 1), Eigen::Vector2d(0.5, 0.5)}) {
    const Eigen::Vector2d at = share.cwiseProduct(Eigen::Vector2d(known.width, known.height));
    const Eigen::Vector2d lon_lat =
        lon_lat_from_crs(known.crs, known.origin + at.cwiseProduct(known.pixel));
    const auto found =
        opened->tiles.pixels_from_enu(image.plane->enu_from_geodetic({lon_lat.y(), lon_lat.x()}));
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->x(), at.x(), 0.01);
    EXPECT_NEAR(found->y(), at.y(), 0.01);
  }
  int shown = 0, bright = 0;
  const ImageRaster whole = opened->tiles.picture({opened->tiles.level_count() - 1, 0, 0}).value();
  for (const ImagePixel& pixel : whole.values()) {
    shown += pixel.alpha > 0 ? 1 : 0;
    bright += pixel.green > 20 ? 1 : 0;
  }
  EXPECT_GT(shown, 0);
  EXPECT_EQ(bright > 100, known.is_bright);
}

TEST_F(RecordedImage, LiesWhereGdalSaysAndIsMeasuredOnTheGround) {
  for (const KnownImage& known :
       {KnownImage{"rasterio_cogeo.tif",
                   "EPSG:3857",
                   1024,
                   1024,
                   {14'321'853.115736903622746, 4'533'021.525424092076719},
                   {0.597164034843445, -0.597164034843445},
                   {0.473, 0.471},
                   5e-4,
                   true},
        KnownImage{"rasterio_RGB.byte.tif",
                   "EPSG:32618",
                   791,
                   718,
                   {101'985.0, 2'826'915.0},
                   {300.037926675094809, -300.041782729804993},
                   {299.87, 299.87},
                   0.02,
                   true},
        KnownImage{"spacenet_sample_geotiff.tif",
                   "EPSG:32616",
                   900,
                   900,
                   {733'601.0, 3'725'139.0},
                   {0.5, -0.5},
                   {0.4999, 0.4999},
                   1e-4,
                   true},
        KnownImage{"spacenet_road_mask_input.tif",
                   "EPSG:4326",
                   1300,
                   1300,
                   {-115.2338076, 36.1423376998},
                   {2.7e-6, -2.7e-6},
                   {0.2430, 0.2996},
                   1e-4,
                   true}}) {
    expect_as_known(folder, known);
  }
}

TEST_F(RecordedImage, OfSixReferencesForOnePlaceLiesThereHalfAPixelApartWherePixelsArePoints) {
  const ProjectPlane plane = ProjectPlane::create({47.5, 13.1}).value();
  const Eigen::Vector2d lon_lat = lon_lat_from_crs("EPSG:3035", {4'555'000.0, 2'716'000.0});
  const Eigen::Vector2d somewhere = plane.enu_from_geodetic({lon_lat.y(), lon_lat.x()});
  for (const char* const kind :
       {"model_tie_point_and_pixel_scale", "model_tie_points", "model_transformation"}) {
    std::vector<Eigen::Vector2d> pixels;
    for (const char* const meaning : {"area", "point"}) {
      const std::string name = fmt::format("austrian_capitals_{}_pixel_is_{}.tif", kind, meaning);
      const auto opened = open_overhead_image(folder / name, {.plane = plane});
      ASSERT_TRUE(opened) << error_text(opened);
      EXPECT_NEAR(opened->image.ground_m_per_pixel->x(), 999.5, 0.1);
      EXPECT_NEAR(opened->image.ground_m_per_pixel->y(), 1000.5, 0.1);
      pixels.push_back(*opened->tiles.pixels_from_enu(somewhere));
    }
    EXPECT_NEAR(pixels[0].x(), 253.0, 1e-4) << kind;  // (4555000 - 4302000) / 1000
    EXPECT_NEAR(pixels[0].y(), 95.0, 1e-4) << kind;   // (2811000 - 2716000) / 1000
    EXPECT_NEAR(pixels[1].x() - pixels[0].x(), 0.5, 1e-6) << kind;
    EXPECT_NEAR(pixels[1].y() - pixels[0].y(), 0.5, 1e-6) << kind;
  }
}

TEST_F(RecordedImage, ThatIsTurnedAsksForItsSystemAndThenLiesTurned) {
  const auto unplaced = open_overhead_image(folder / "rasterio_rotated.tif");
  ASSERT_TRUE(unplaced) << error_text(unplaced);
  EXPECT_EQ(unplaced->image.place, ImagePlace::kWithoutSystem);
  const auto placed = open_overhead_image(folder / "rasterio_rotated.tif", {.crs = "EPSG:32632"});
  ASSERT_TRUE(placed) << error_text(placed);
  // Sides of 20 and 10, turned by 30 degrees: the geotransform's columns.
  EXPECT_NEAR(placed->image.ground_m_per_pixel->x() / placed->image.ground_m_per_pixel->y(), 2.0,
              1e-4);
  const Eigen::Vector2d lon_lat = lon_lat_from_crs("EPSG:32632", {273.20508075688775, 300.0});
  const auto corner = placed->tiles.pixels_from_enu(
      placed->image.plane->enu_from_geodetic({lon_lat.y(), lon_lat.x()}));
  EXPECT_NEAR(corner->x(), 10.0, 0.01);
  EXPECT_NEAR(corner->y(), 0.0, 0.01);
}

TEST_F(RecordedImage, ThatCannotBeRightIsRefusedWithTheReason) {
  const auto refusal = [&](const char* name) {
    return error_text(open_overhead_image(folder / name));
  };
  EXPECT_THAT(
      refusal("rasterio_corrupt.tif"),
      EndsWith("rasterio_corrupt.tif: is cut short: 1 of 4 blocks of pixels lie beyond its end"));
  EXPECT_THAT(
      refusal("urban_residential_DOP.tif"),
      EndsWith("urban_residential_DOP.tif: claims to be in degrees but reaches latitude 92.8362"));
  EXPECT_THAT(
      refusal("urban_residential_xDOP.tif"),
      EndsWith("urban_residential_xDOP.tif: claims to be in degrees but reaches latitude 92.8278"));
  EXPECT_THAT(refusal("rasterio_red.tif"),  // 32 degrees a side
              EndsWith("rasterio_red.tif: spans more than the 1000 km that one plane can hold"));
  EXPECT_THAT(refusal("spacenet_sample.geojson"),
              HasSubstr("spacenet_sample.geojson: is no readable GeoTIFF"));
}

}  // namespace overhead_image_data_test
}  // namespace nadir
