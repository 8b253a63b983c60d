// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "core/map/map_import.h"
#include "tests/core/map/raster_files.h"
#include "tests/support/error_text.h"
#include "tests/support/scratch_folder.h"

namespace nadir {
namespace map_placement_test {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr const char* kUtm = "EPSG:32617";

Affine2 truth() {
  Affine2 crs_from_pixel;
  crs_from_pixel.linear << 0.8, 0.1, 0.1, -0.8;
  crs_from_pixel.offset = {500000.0, 3705000.0};
  return crs_from_pixel;
}

/// Nine control points, the middle one off by some pixels.
RasterFile with_control_points(double error_px) {
  RasterFile file{.ids = patchwork(60, 45), .crs = kUtm, .category_names = our_class_names()};
  for (const double column : {0.0, 30.0, 60.0}) {
    for (const double row : {0.0, 22.0, 45.0}) {
      const bool is_wrong = column == 30.0 && row == 22.0;
      const Eigen::Vector2d moved(column + (is_wrong ? error_px : 0.0), row);
      file.control_points.push_back({{column, row}, truth() * moved});
    }
  }
  return file;
}

class PlacementOfARaster : public testing::Test {
 protected:
  [[nodiscard]] Result<ImportedMap> imported(const RasterFile& file,
                                             const ImportOptions& options = {}) const {
    write_raster(file, path());
    return import_map(path(), options);
  }
  [[nodiscard]] fs::path path() const { return folder.path() / "source.tif"; }

  ScratchFolder folder;
};

TEST_F(PlacementOfARaster, MayBeGivenByControlPoints) {
  const auto result = imported(with_control_points(0.0));
  ASSERT_TRUE(result) << error_text(result);
  RasterFile source = with_control_points(0.0);
  source.crs_from_pixel = truth();
  EXPECT_EQ(cells_that_disagree(result->map, source), 0);
  EXPECT_THAT(result->notices, IsEmpty());
}

TEST_F(PlacementOfARaster, SaysHowFarControlPointsAreFromTheFit) {
  // The fit moves by a ninth of the error, so that eight ninths of it remain.
  const auto slight = imported(with_control_points(0.5));
  ASSERT_TRUE(slight) << error_text(slight);
  EXPECT_THAT(slight->notices, IsEmpty());
  const auto worse = imported(with_control_points(0.9));
  ASSERT_TRUE(worse) << error_text(worse);
  EXPECT_THAT(worse->notices,
              ElementsAre(HasSubstr("source.tif: its ground control points are up to 0.80 pixels "
                                    "from where it was placed")));
}

TEST_F(PlacementOfARaster, IsRefusedWhereControlPointsContradictEachOther) {
  const auto result = imported(with_control_points(36.0));
  EXPECT_EQ(error_text(result),
            path().string() +
                ": its ground control points contradict each other, the worst at pixel (30, 22) by "
                "32.0 pixels");
  EXPECT_TRUE(imported(with_control_points(3.3)));
  EXPECT_FALSE(imported(with_control_points(3.5)));
}

TEST_F(PlacementOfARaster, IsRefusedWhereAWorldFileHoldsNoNumbers) {
  const fs::path png = folder.path() / "drawn.png";
  write_raster({.ids = patchwork(20, 20), .driver = "PNG"}, png);
  for (const char* text : {"nan\n0\n0\n-1\n500000\n3705000\n", "1\n0\n0\n-1\nnan\n3705000\n",
                           "1\n0\n0\n-1\n500000\ninf\n", "1\n2\n2\n4\n500000\n3705000\n"}) {
    static_cast<void>(folder.file("drawn.pgw", text));
    EXPECT_THAT(error_text(import_map(png, {.crs = kUtm})),
                testing::StartsWith(png.string() + ": "))
        << text;
  }
}

/// A picture beside UTM labels, red growing along its rows.
class PlacementOfAPicture : public PlacementOfARaster {
 protected:
  void SetUp() override {
    ColourRaster picture(60, 45);
    for (int row = 0; row < 45; ++row) {
      for (int column = 0; column < 60; ++column) {
        picture.at(column, row).red = static_cast<std::uint8_t>(4 * column);
      }
    }
    write_picture(picture, png());
  }
  [[nodiscard]] fs::path png() const { return folder.path() / "photo.png"; }
  [[nodiscard]] RasterFile labels() const {
    return {.ids = patchwork(60, 45), .crs_from_pixel = truth(), .crs = kUtm};
  }
};

TEST_F(PlacementOfAPicture, WithoutReferenceSystemIsInTheLabelsOne) {
  Affine2 moved = truth();
  moved.offset = truth() * Eigen::Vector2d(10.0, 0.0);
  static_cast<void>(folder.file("photo.pgw", world_file(moved)));
  const auto result = imported(labels(), {.image = png()});
  ASSERT_TRUE(result) << error_text(result);
  const Eigen::Vector2d lon_lat = lon_lat_from_crs(kUtm, truth() * Eigen::Vector2d(40.5, 20.5));
  const Eigen::Vector2d cell = result->map.overhead_from_enu(
      result->map.plane.enu_from_geodetic({lon_lat.y(), lon_lat.x()}));
  ASSERT_TRUE(result->image);
  EXPECT_NEAR(result->image->at(static_cast<int>(cell.x()), static_cast<int>(cell.y())).red, 4 * 30,
              4);
}

TEST_F(PlacementOfAPicture, OfAnchoredLabelsNeedsAReferenceSystem) {
  static_cast<void>(folder.file("photo.pgw", world_file(truth())));
  ImportOptions options{.anchor = Geodetic{33.45, -81.0}, .metres_per_pixel = 0.8, .image = png()};
  EXPECT_THAT(error_text(imported({.ids = patchwork(60, 45)}, options)),
              HasSubstr("photo.png: has a georeference without a coordinate reference system; name "
                        "it with --crs"));
  options.crs = kUtm;
  EXPECT_TRUE(imported({.ids = patchwork(60, 45)}, options));
}

TEST_F(PlacementOfAPicture, KeepsItsOwnFaultWhenItIsRefused) {
  static_cast<void>(folder.file("photo.pgw", "1\n2\n2\n4\n500000\n3705000\n"));
  const std::string text = error_text(imported(labels(), {.image = png()}));
  EXPECT_THAT(text, testing::StartsWith(png().string() + ": "));
  EXPECT_THAT(text, testing::Not(HasSubstr("--crs")));
}

}  // namespace map_placement_test
}  // namespace nadir
