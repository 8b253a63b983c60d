// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "core/geo/trajectory_file.h"
#include "core/map/class_statistics.h"
#include "core/map/map_import.h"
#include "tests/core/map/raster_files.h"
#include "tests/support/error_text.h"
#include "tests/support/scratch_folder.h"

namespace nadir {
namespace recorded_map_data_test {

namespace fs = std::filesystem;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

class RecordedMap : public testing::Test {
 protected:
  void SetUp() override {
    // Read before any thread is started.
    const char* const root = std::getenv("NADIR_TEST_DATA");  // NOLINT(concurrency-mt-unsafe)
    if (root == nullptr) {
      GTEST_SKIP() << "NADIR_TEST_DATA is not set: rasters of other makers are left out";
    }
    folder = root;
  }

  [[nodiscard]] fs::path geotiff(const std::string& name) const {
    return folder / "geotiff" / name;
  }

  fs::path folder;
};

ClassRemap remap_of(std::string_view text) { return ClassRemap::parse(text, "remap").value(); }

TEST_F(RecordedMap, OfTheDrawnTownIsImportedCellByCell) {
  ImportOptions options{.anchor = Geodetic{48.987721, 8.387722},
                        .metres_per_pixel = 1.0 / 3.058,
                        .flip_vertically = true,
                        .inside_value = 0};
  options.remap = ClassRemap::read(NADIR_SOURCE_DIR "/resources/remaps/kitti00-drawn.toml").value();
  const auto result = import_map(folder / "maps" / "kitti00_drawn", options);
  ASSERT_TRUE(result) << error_text(result);
  const OverheadMap& map = result->map;
  EXPECT_EQ(map.labels.width(), 2101);
  EXPECT_EQ(map.labels.height(), 2508);
  EXPECT_NEAR(map.width_m(), 687.05, 0.01);
  EXPECT_THAT(result->notices, Contains(HasSubstr("map_viz.png stands for no class")));
  const ClassStatistics statistics = class_statistics(map.labels);
  EXPECT_EQ(statistics.present_classes(), 4);
  EXPECT_GT(statistics.share_of_all(kRoad), 0.05);
  EXPECT_GT(statistics.share_of_all(kBuilding), 0.1);

  // The whole drive lies on road. KITTI's camera: x right, z ahead; the similarity puts it on the
  // *stored* raster, in pixels.
  const auto truth = read_trajectory(folder / "kitti_odometry_00" / "poses_gt.txt");
  ASSERT_TRUE(truth) << error_text(truth);
  constexpr double kTurn = 5.7515;
  constexpr double kScale = 3.055;
  int on_road = 0;
  for (const TimedPose& timed : truth->poses()) {
    const double ahead = timed.pose.translation_m.x();
    const double right = -timed.pose.translation_m.y();
    const double px = 592.6 + kScale * (std::cos(kTurn) * right - std::sin(kTurn) * ahead);
    const double py = 746.5 + kScale * (std::sin(kTurn) * right + std::cos(kTurn) * ahead);
    on_road += map.class_at(map.enu_from_overhead({px, 2508.0 - py})) == kRoad ? 1 : 0;
  }
  EXPECT_GT(on_road, 0.98 * static_cast<double>(truth->size()));
}

TEST_F(RecordedMap, OfTheDrawnTownLiesWhereTheSatellitesSawTheCar) {
  ImportOptions options{.anchor = Geodetic{48.987721, 8.387722},
                        .metres_per_pixel = 1.0 / 3.058,
                        .flip_vertically = true,
                        .inside_value = 0};
  options.remap = ClassRemap::read(NADIR_SOURCE_DIR "/resources/remaps/kitti00-drawn.toml").value();
  const auto result = import_map(folder / "maps" / "kitti00_drawn", options);
  ASSERT_TRUE(result) << error_text(result);
  std::ifstream lines(folder / "kitti_odometry_00" / "oxts_00.txt");
  int fixes = 0;
  int on_road = 0;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    Geodetic position;
    if (!(words >> position.latitude_deg >> position.longitude_deg)) continue;
    ++fixes;
    const ClassId id = result->map.class_at(result->map.plane.enu_from_geodetic(position));
    on_road += id == kRoad ? 1 : 0;
  }
  ASSERT_GT(fixes, 4000);
  EXPECT_GT(on_road, 0.95 * fixes);
}

TEST_F(RecordedMap, InWebMercatorIsMeasuredOnTheGround) {
  const fs::path picture = geotiff("rasterio_cogeo.tif");
  EXPECT_THAT(error_text(import_map(picture, {})), HasSubstr("labels need one band"));
  // Labels of the same place, for the recorded file is a picture.
  RasterFile labels{.ids = patchwork(1024, 1024), .crs = "EPSG:3857"};
  labels.crs_from_pixel = Affine2::from_gdal({14321853.115736903622746, 0.597164034843445, 0.0,
                                              4533021.525424092076719, 0.0, -0.597164034843445});
  const ScratchFolder scratch;
  const fs::path source = scratch.path() / "labels.tif";
  write_raster(labels, source);
  const auto result = import_map(source, {.image = picture});
  ASSERT_TRUE(result) << error_text(result);
  EXPECT_NEAR(result->map.metres_per_cell, 0.4713, 1e-4);  // 0.597164 nominal, 0.4727 by cosine
  EXPECT_EQ(cells_that_disagree(result->map, labels), 0);
  ASSERT_TRUE(result->image);
  const auto& pixels = result->image->values();
  EXPECT_LT(std::count(pixels.begin(), pixels.end(), Colour{}), 0.02 * 1024 * 1024);
}

TEST_F(RecordedMap, ThatIsRotatedIsWarped) {
  ImportOptions options{.crs = "EPSG:32617"};
  options.remap = remap_of("unknown = \"terrain\"\n[ids]\n0 = \"road\"\n");
  const auto result = import_map(geotiff("rasterio_rotated.tif"), options);
  ASSERT_TRUE(result) << error_text(result);
  // Column norms 20 and 10 m, 15 x 10 pixels, turned by 30 degrees.
  EXPECT_NEAR(result->map.metres_per_cell, 10.0, 0.05);
  EXPECT_NEAR(result->map.width_m(), 200 * std::sqrt(0.75) + 150 * 0.5, 12.0);
  EXPECT_NEAR(result->map.height_m(), 200 * 0.5 + 150 * std::sqrt(0.75), 12.0);
}

TEST_F(RecordedMap, ThatIsTruncatedIsRefusedInOneSentence) {
  testing::internal::CaptureStderr();
  ImportOptions options{.anchor = Geodetic{33.0, 2.0}, .metres_per_pixel = 1.0};
  const std::string text = error_text(import_map(geotiff("rasterio_corrupt.tif"), options));
  EXPECT_THAT(text, HasSubstr("rasterio_corrupt.tif: "));
  EXPECT_THAT(text, testing::Not(HasSubstr("\n")));
  EXPECT_THAT(testing::internal::GetCapturedStderr(), IsEmpty());
}

TEST_F(RecordedMap, WithLatitudesBeyondThePoleIsRefused) {
  for (const char* name : {"urban_residential_DOP.tif", "urban_residential_xDOP.tif"}) {
    EXPECT_THAT(error_text(import_map(geotiff(name), {})),
                HasSubstr("claims to be in degrees but reaches latitude 92.8"));
  }
}

TEST_F(RecordedMap, OfTheAustrianCapitalsHasThemInTheSamePlaceInEveryEncoding) {
  ImportOptions options;
  options.remap = remap_of("unknown = \"terrain\"\n[ids]\n255 = \"building\"\n");
  for (const std::string kind : {"area", "point"}) {
    std::vector<Raster<ClassId>> labels;
    for (const std::string encoding :
         {"tie_point_and_pixel_scale", "tie_points", "transformation"}) {
      const auto result = import_map(
          geotiff(fmt::format("austrian_capitals_model_{}_pixel_is_{}.tif", encoding, kind)),
          options);
      ASSERT_TRUE(result) << error_text(result);
      const OverheadMap& map = result->map;
      labels.push_back(map.labels);
      // The raster's own statement about Vienna and Innsbruck: where the pixel's point is in
      // EPSG:3035.
      for (const Eigen::Vector2d& tie :
           {Eigen::Vector2d(4794000, 2811000), Eigen::Vector2d(4426000, 2685000)}) {
        const Eigen::Vector2d centre =
            tie + (kind == "area" ? Eigen::Vector2d(500, -500) : Eigen::Vector2d(0, 0));
        const Eigen::Vector2d lon_lat = lon_lat_from_crs("EPSG:3035", centre);
        const Eigen::Vector2d at = map.plane.enu_from_geodetic({lon_lat.y(), lon_lat.x()});
        EXPECT_EQ(map.class_at(at), kBuilding) << encoding << " " << kind;
      }
    }
    EXPECT_EQ(labels[0], labels[1]) << kind;
    EXPECT_EQ(labels[0], labels[2]) << kind;
  }
}

}  // namespace recorded_map_data_test
}  // namespace nadir
