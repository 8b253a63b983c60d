// SPDX-License-Identifier: Apache-2.0
#include "core/map/overhead_image.h"

#include <gmock/gmock.h>

#include <cmath>
#include <fstream>

#include "core/geo/control_points.h"
#include "core/geo/world_file.h"
#include "tests/core/map/image_files.h"
#include "tests/core/map/raster_files.h"
#include "tests/support/error_text.h"
#include "tests/support/scratch_folder.h"

namespace nadir {
namespace overhead_image_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr const char* kUtm = "EPSG:32632";
constexpr const char* kMercator = "EPSG:3857";

/// Pixels of so many units of the reference system, turned counter-clockwise.
Affine2 placed(const Eigen::Vector2d& corner, double column, double row, double turn_deg = 0.0) {
  const double turn = turn_deg * 0.017453292519943295;
  Affine2 crs_from_pixel;
  crs_from_pixel.linear << column * std::cos(turn), row * std::sin(turn), column * std::sin(turn),
      -row * std::cos(turn);
  crs_from_pixel.offset = corner;
  return crs_from_pixel;
}

class ImageOnTheGround : public testing::Test {
 protected:
  [[nodiscard]] std::filesystem::path written(const DrawnImage& image,
                                              const std::string& name = "image.tif") const {
    std::filesystem::path path = scratch.path() / name;
    write_image(image, path);
    return path;
  }
  [[nodiscard]] OpenedImage opened(const DrawnImage& image,
                                   const ImageOptions& options = {}) const {
    auto result = open_overhead_image(written(image), options);
    if (!result) throw std::runtime_error(error_text(result));
    return std::move(*result);
  }

  /// Goes from the middles of squares of the mosaic by latitude and longitude to the plane, and compares the colours there.
  static void expect_each_square_in_its_place(const OpenedImage& opened, const DrawnImage& image) {
    int compared = 0;
    for (int row = 8; row < image.pixels.height(); row += 32) {
      for (int column = 8; column < image.pixels.width(); column += 32) {
        const Eigen::Vector2d lon_lat =
            lon_lat_from_crs(image.crs, *image.crs_from_pixel * Eigen::Vector2d(column, row));
        const Eigen::Vector2d point =
            opened.image.plane->enu_from_geodetic({lon_lat.y(), lon_lat.x()});
        const ImagePixel seen = shown_at(opened.tiles, point);
        const ImagePixel drawn = image.pixels.at(column, row);
        EXPECT_NEAR(seen.red, drawn.red, 1) << column << ", " << row;
        EXPECT_NEAR(seen.green, drawn.green, 1) << column << ", " << row;
        EXPECT_EQ(seen.alpha, 255);
        const auto pixel = opened.tiles.pixels_from_enu(point);
        ASSERT_TRUE(pixel);
        EXPECT_NEAR(pixel->x(), column, 0.01);
        EXPECT_NEAR(pixel->y(), row, 0.01);
        ++compared;
      }
    }
    EXPECT_GT(compared, 4);
  }

  ScratchFolder scratch;
};

struct PlacedImage {
  std::string name, crs;
  Affine2 crs_from_pixel;
};
void PrintTo(const PlacedImage& image, std::ostream* out) { *out << image.name; }

class ImageOfAnyPlace : public ImageOnTheGround, public testing::WithParamInterface<PlacedImage> {};

INSTANTIATE_TEST_SUITE_P(
    Places,
    ImageOfAnyPlace,
    testing::Values(PlacedImage{"UTM", kUtm, placed({500'000, 5'300'000}, 0.25, 0.25)},
                    PlacedImage{"EdgeOfAZone", "EPSG:32631",
                                placed({780'000, 5'300'000}, 0.25, 0.25)},
                    PlacedImage{"WebMercator", kMercator, placed({934'000, 6'271'000}, 0.5, 0.5)},
                    PlacedImage{"Degrees", "EPSG:4326", placed({8.4, 49.0}, 3e-6, 2e-6)},
                    PlacedImage{"Turned", kUtm, placed({500'000, 5'300'000}, 0.25, 0.25, 33.0)},
                    PlacedImage{"SouthUp", kUtm, placed({500'000, 5'300'000}, 0.25, -0.25)},
                    PlacedImage{"Oblong", kUtm, placed({500'000, 5'300'000}, 0.25, 0.5)},
                    PlacedImage{"Feet", "+proj=utm +zone=32 +datum=WGS84 +units=us-ft +no_defs",
                                placed({1'640'000, 17'388'000}, 1.0, 1.0)}),
    [](const auto& test) { return test.param.name; });

TEST_P(ImageOfAnyPlace, HasEachSquareInItsPlace) {
  const DrawnImage image{.pixels = mosaic(160, 128),
                         .crs_from_pixel = GetParam().crs_from_pixel,
                         .crs = GetParam().crs};
  const OpenedImage on_ground = opened(image);
  EXPECT_EQ(on_ground.image.place, ImagePlace::kOwn);
  expect_each_square_in_its_place(on_ground, image);
}

TEST_F(ImageOnTheGround, LiesOnThePlaneThatItIsAskedFor) {
  const DrawnImage image{.pixels = mosaic(96, 96),
                         .crs_from_pixel = placed({500'000, 5'300'000}, 0.25, 0.25),
                         .crs = kUtm};
  const ProjectPlane plane = ProjectPlane::create({47.86, 9.02}).value();
  const OpenedImage on_ground = opened(image, {.plane = plane});
  EXPECT_EQ(on_ground.image.plane, plane);
  expect_each_square_in_its_place(on_ground, image);
}

TEST_F(ImageOnTheGround, InWebMercatorSaysItsTrueResolution) {
  const OpenedImage on_ground = opened(
      {.pixels = mosaic(64, 64),
       .crs_from_pixel = placed({14'321'853.1157, 4'533'021.5254}, 0.597164034843, 0.597164034843),
       .crs = kMercator});
  EXPECT_NEAR(on_ground.image.ground_m_per_pixel->x(), 0.4733, 1e-4);
  EXPECT_NEAR(on_ground.image.ground_m_per_pixel->y(), 0.4713, 1e-4);
  EXPECT_NEAR(on_ground.tiles.metres_per_cell(), 0.4713, 1e-4);
  EXPECT_EQ(on_ground.image.crs_name, "WGS 84 / Pseudo-Mercator");
  EXPECT_THAT(on_ground.image.notices,
              ElementsAre(HasSubstr("0.5972 m in WGS 84 / Pseudo-Mercator "
                                    "but 0.4733 x 0.4713 m on the ground")));
}

TEST_F(ImageOnTheGround, DiffersByHalfAPixelWherePixelsArePoints) {
  const ProjectPlane plane = ProjectPlane::create({47.85, 9.0}).value();
  DrawnImage image{.pixels = mosaic(64, 64),
                   .crs_from_pixel = placed({500'000, 5'300'000}, 0.25, 0.25),
                   .crs = kUtm};
  const OpenedImage areas = opened(image, {.plane = plane});
  // Written with the same numbers: they then name the first pixel's centre.
  image.crs_from_pixel->offset += Eigen::Vector2d(-0.125, 0.125);
  image.is_pixel_is_point = true;
  const OpenedImage points = opened(image, {.plane = plane});
  const Eigen::Vector2d somewhere = areas.tiles.top_left_in_enu_m() + Eigen::Vector2d(5.0, -7.0);
  const Eigen::Vector2d apart =
      *points.tiles.pixels_from_enu(somewhere) - *areas.tiles.pixels_from_enu(somewhere);
  EXPECT_NEAR(apart.x(), 0.5, 1e-5);
  EXPECT_NEAR(apart.y(), 0.5, 1e-5);
}

TEST_F(ImageOnTheGround, ThatLiesOnThePlaneAlreadyKeepsItsPixels) {
  const ProjectPlane plane = ProjectPlane::create({47.85, 9.0}).value();
  const DrawnImage image{.pixels = mosaic(700, 530),
                         .crs_from_pixel = placed({-80.0, 60.0}, 0.25, 0.25),
                         .crs = plane.wkt()};
  for (const auto& asked : {std::optional<ProjectPlane>(), std::optional(plane)}) {
    const OpenedImage on_ground = opened(image, {.plane = asked});
    EXPECT_EQ(on_ground.tiles.top_left_in_enu_m(), Eigen::Vector2d(-80.0, 60.0));
    EXPECT_EQ(on_ground.tiles.metres_per_cell(), 0.25);
    EXPECT_THAT(on_ground.image.notices, IsEmpty());
    EXPECT_EQ(whole_picture(on_ground.tiles), image.pixels);
  }
}

TEST_F(ImageOnTheGround, WithoutReferenceOpensAMetreAPixel) {
  const OpenedImage unplaced = opened({.pixels = mosaic(40, 30)});
  EXPECT_EQ(unplaced.image.place, ImagePlace::kNone);
  EXPECT_FALSE(unplaced.image.plane);
  EXPECT_FALSE(unplaced.image.ground_m_per_pixel);
  EXPECT_EQ(unplaced.tiles.top_left_in_enu_m(), Eigen::Vector2d::Zero());
  EXPECT_EQ(whole_picture(unplaced.tiles), mosaic(40, 30));
  EXPECT_TRUE(unplaced.tiles.pixels_from_enu({12.5, -7.5})->isApprox(Eigen::Vector2d(12.5, 7.5)));
}

TEST_F(ImageOnTheGround, LiesWhereControlPointsPutIt) {
  const ProjectPlane plane = ProjectPlane::create({47.85, 9.0}).value();
  const Affine2 truth = placed({120.0, 80.0}, 0.3, 0.3, 21.0);
  std::vector<ControlPoint> points;
  for (const Eigen::Vector2d& pixel :
       {Eigen::Vector2d(3.5, 4.5), Eigen::Vector2d(90.5, 11.5), Eigen::Vector2d(40.5, 70.5)}) {
    points.push_back(ControlPoint{pixel, truth * pixel, ""});
  }
  const auto fit = fit_control_points(points, ControlModel::kSimilarity);
  ASSERT_TRUE(fit) << error_text(fit);
  const DrawnImage image{.pixels = mosaic(96, 96)};
  const OpenedImage on_ground =
      opened(image, {.plane = plane, .enu_from_pixels = fit->enu_from_pixels});
  EXPECT_EQ(on_ground.image.place, ImagePlace::kByHand);
  EXPECT_NEAR(on_ground.tiles.metres_per_cell(), 0.3, 1e-9);
  for (const int at : {8, 24, 56, 88}) {
    const Eigen::Vector2d point = truth * Eigen::Vector2d(at, 8.0);
    EXPECT_NEAR(shown_at(on_ground.tiles, point).red, mosaic_colour(at, 8).red, 1);
    EXPECT_NEAR(on_ground.tiles.pixels_from_enu(point)->x(), at, 1e-3);
  }
}

TEST_F(ImageOnTheGround, IsMovedByAnOffsetThatLeavesItsReferenceAlone) {
  const DrawnImage image{.pixels = mosaic(64, 64),
                         .crs_from_pixel = placed({500'000, 5'300'000}, 0.25, 0.25),
                         .crs = kUtm};
  OpenedImage on_ground = opened(image);
  const Eigen::Vector2d corner = on_ground.tiles.top_left_in_enu_m();
  const Eigen::Vector2d point = corner + Eigen::Vector2d(6.0, -6.0);
  const Eigen::Vector2d pixel = *on_ground.tiles.pixels_from_enu(point);
  const Eigen::Vector2d offset(1.5, -2.25);
  on_ground.tiles.set_offset(offset);
  EXPECT_TRUE(on_ground.tiles.top_left_in_enu_m().isApprox(corner + offset));
  EXPECT_TRUE(on_ground.tiles.pixels_from_enu(point + offset)->isApprox(pixel, 1e-9));
  on_ground.tiles.set_offset(Eigen::Vector2d::Zero());
  EXPECT_EQ(on_ground.tiles.top_left_in_enu_m(), corner);
}

/// A PNG and what other programs put beside it.
class ImageWithAWorldFile : public ImageOnTheGround {
 protected:
  DrawnImage image{.pixels = mosaic(96, 64),
                   .driver = "PNG",
                   .crs_from_pixel = placed({500'000, 5'300'000}, 0.25, 0.25, 12.0)};
  std::filesystem::path beside(const std::string& name, const std::string& text) {
    if (path.empty()) {
      DrawnImage bare = image;
      bare.crs_from_pixel.reset();
      path = written(bare, "town.png");
    }
    return scratch.file(name, text);
  }
  std::filesystem::path path;
};

TEST_F(ImageWithAWorldFile, LiesInTheSystemThatIsNamed) {
  for (const char* const name : {"town.wld", "town.pgw"}) {
    beside(name, world_file_text(*image.crs_from_pixel));
    const auto on_ground = open_overhead_image(path, {.crs = kUtm});
    ASSERT_TRUE(on_ground) << error_text(on_ground);
    image.crs = kUtm;
    expect_each_square_in_its_place(*on_ground, image);
    std::filesystem::remove(scratch.path() / name);
  }
}

TEST_F(ImageWithAWorldFile, LiesInTheSystemOfThePrjBesideIt) {
  beside("town.pgw", world_file_text(*image.crs_from_pixel));
  beside("town.prj",
         "PROJCS[\"WGS_1984_UTM_Zone_32N\",GEOGCS[\"GCS_WGS_1984\",DATUM[\"D_WGS_1984\",SPHEROID["
         "\"WGS_"
         "1984\",6378137.0,298.257223563]],PRIMEM[\"Greenwich\",0.0],UNIT[\"Degree\",0."
         "0174532925199433]],PROJECTION[\"Transverse_Mercator\"],PARAMETER[\"False_Easting\","
         "500000.0],"
         "PARAMETER[\"False_Northing\",0.0],PARAMETER[\"Central_Meridian\",9.0],PARAMETER[\"Scale_"
         "Factor\",0.9996],PARAMETER[\"Latitude_Of_Origin\",0.0],UNIT[\"Meter\",1.0]]");
  const auto on_ground = open_overhead_image(path);
  ASSERT_TRUE(on_ground) << error_text(on_ground);
  image.crs = kUtm;
  expect_each_square_in_its_place(*on_ground, image);
  beside("town.prj", "somewhere");
  EXPECT_THAT(error_text(open_overhead_image(path)),
              HasSubstr("town.prj: holds no coordinate reference system"));
}

TEST_F(ImageWithAWorldFile, AsksForTheSystemWhereNobodyNamesIt) {
  beside("town.pgw", world_file_text(*image.crs_from_pixel));
  const auto unplaced = open_overhead_image(path);
  ASSERT_TRUE(unplaced) << error_text(unplaced);
  EXPECT_EQ(unplaced->image.place, ImagePlace::kWithoutSystem);
  EXPECT_EQ(whole_picture(unplaced->tiles), image.pixels);
}

TEST_F(ImageWithAWorldFile, IsRefusedWhereThatIsDamaged) {
  beside("town.pgw", "0.25\n0\n0\n-0.25\n500000\n");
  EXPECT_THAT(error_text(open_overhead_image(path)), HasSubstr("town.pgw: holds 5 of the six"));
  beside("town.pgw", "0.25 feet\n0\n0\n-0.25\n500000\n5300000\n");
  EXPECT_THAT(error_text(open_overhead_image(path)), HasSubstr("town.pgw: "));
  beside("town.pgw", "0\n0\n0\n0\n500000\n5300000\n");
  EXPECT_THAT(error_text(open_overhead_image(path)), HasSubstr("town.pgw: "));
}

}  // namespace overhead_image_test
}  // namespace nadir
