// SPDX-License-Identifier: Apache-2.0
#include "core/map/image_stack.h"

#include <gmock/gmock.h>

#include "core/map/image_date.h"
#include "tests/support/error_text.h"

namespace nadir {
namespace image_stack_test {

using testing::HasSubstr;

ImageStack two_images() {
  StackedImage summer;
  summer.name = "summer \"2019\"";
  summer.path = "/maps/town/images/ortho.tif";
  summer.offset_in_enu_m = {1.25, -0.1};
  summer.look = {.is_visible = false, .opacity = 0.3, .brightness = -0.2, .contrast = 1.0 / 3.0};
  StackedImage infrared;
  infrared.name = "infrared";
  infrared.path = "/maps/elsewhere/ir.png";
  infrared.crs = "EPSG:25832";
  infrared.control_model = ControlModel::kAffine;
  infrared.control_points = {ControlPoint{{0.5, 10.5}, {100.0, 200.0}, "church"},
                             ControlPoint{{99.5, 10.5}, {120.0, 200.0}, ""},
                             ControlPoint{{0.5, 90.5}, {100.0, 184.0}, "mast"}};
  infrared.known_distance = KnownDistance{{1.5, 2.5}, {101.5, 2.5}, 20.0, {7.0, 8.0}};
  return {{summer, infrared}};
}

TEST(ImageStack, ComesBackFromItsTextToTheLastBit) {
  const std::string text = image_stack_text(two_images(), "/maps/town");
  const auto read = parse_image_stack(text, "/maps/town", "images");
  ASSERT_TRUE(read) << error_text(read);
  EXPECT_EQ(image_stack_text(*read, "/maps/town"), text);
  ASSERT_EQ(read->images.size(), 2U);
  EXPECT_EQ(read->images[0].look, two_images().images[0].look);
  EXPECT_EQ(read->images[0].path, two_images().images[0].path);
  EXPECT_EQ(read->images[0].offset_in_enu_m, Eigen::Vector2d(1.25, -0.1));
  EXPECT_EQ(read->images[1].control_points[2].in_enu_m, Eigen::Vector2d(100.0, 184.0));
  EXPECT_EQ(read->images[1].control_points[0].name, "church");
  EXPECT_EQ(read->images[1].known_distance->distance_m, 20.0);
}

TEST(ImageStack, MovesWithItsMap) {
  const std::string text = image_stack_text(two_images(), "/maps/town");
  EXPECT_THAT(text, HasSubstr("path = \"images/ortho.tif\""));
  const auto moved = parse_image_stack(text, "/media/stick/town", "images");
  ASSERT_TRUE(moved) << error_text(moved);
  EXPECT_EQ(moved->images[0].path, "/media/stick/town/images/ortho.tif");
  EXPECT_EQ(moved->images[1].path, "/media/stick/elsewhere/ir.png");
}

TEST(ImageStack, OfNothingIsEmptyText) {
  EXPECT_EQ(image_stack_text({}, "/maps"), "");
  EXPECT_TRUE(parse_image_stack("", "/maps", "images").value().images.empty());
}

TEST(ImageStack, IsRefusedWithTheReason) {
  const auto refusal = [](const std::string& text) {
    return error_text(parse_image_stack("[[image]]\n" + text, "/maps", "labels.gpkg"));
  };
  EXPECT_THAT(refusal("name = \"x\""), HasSubstr("labels.gpkg: "));
  EXPECT_THAT(refusal("path = \"a.tif\"\nopacity = 1.5"),
              HasSubstr("opacity is 1.5 and not in [0, 1]"));
  EXPECT_THAT(refusal("path = \"a.tif\"\ncontrast = nan"), HasSubstr("contrast"));
  EXPECT_THAT(refusal("path = \"a.tif\"\ncontrol_points = [1.0, 2.0, 3.0]"),
              HasSubstr("control_points has 3 numbers instead of a multiple of 4"));
  EXPECT_THAT(refusal("path = \"a.tif\"\noffset_in_enu_m = [1.0]"),
              HasSubstr("1 numbers instead of 2"));
  EXPECT_THAT(refusal("path = \"a.tif\"\nopacty = 0.5"), HasSubstr("did you mean opacity"));
  EXPECT_THAT(
      refusal("path = \"a.tif\"\ncontrol_points = [1.0, 2.0, 3.0, 4.0]\ncontrol_model = \"tps\""),
      HasSubstr("tps is neither"));
}

TEST(ImageStack, OpensAnImageByItsPointsElseByItsDistanceElseByItsFile) {
  const ProjectPlane plane = ProjectPlane::create({47.85, 9.0}).value();
  StackedImage image = two_images().images[1];
  const auto by_points = options_of(image, plane, "/cache");
  ASSERT_TRUE(by_points) << error_text(by_points);
  EXPECT_TRUE((*by_points->enu_from_pixels * Eigen::Vector2d(99.5, 10.5))
                  .isApprox(Eigen::Vector2d(120.0, 200.0), 1e-9));
  EXPECT_EQ(by_points->crs, "EPSG:25832");
  EXPECT_EQ(by_points->cache, "/cache");
  image.control_points.clear();
  const auto by_distance = options_of(image, plane, {});
  EXPECT_NEAR(by_distance->enu_from_pixels->pixel_size().x(), 0.2, 1e-12);
  EXPECT_EQ(by_distance->enu_from_pixels->offset, Eigen::Vector2d(7.0, 8.0));
  image.known_distance.reset();
  EXPECT_FALSE(options_of(image, plane, {})->enu_from_pixels);
  image.control_points = {ControlPoint{{1.0, 1.0}, {2.0, 2.0}, ""}};
  EXPECT_THAT(error_text(options_of(image, plane, {})), HasSubstr("infrared: "));
}

TEST(ImageLook, AsItIsChangesNothing) {
  const auto table = tone_table({});
  for (int i = 0; i < 256; ++i) EXPECT_EQ(table.at(static_cast<std::size_t>(i)), i);
}

TEST(ImageLook, BrightensAndSpreadsWithoutTurningBack) {
  const auto bright = tone_table({.brightness = 0.2});
  EXPECT_EQ(bright[100], 151);
  EXPECT_EQ(bright[250], 255);
  EXPECT_EQ(tone_table({.brightness = -1.0})[255], 0);
  EXPECT_EQ(tone_table({.brightness = 1.0})[0], 255);
  const auto hard = tone_table({.contrast = 1.0 / 3.0});  // twice as much
  EXPECT_EQ(hard[100], 73);
  EXPECT_EQ(hard[137], 147);
  const auto flat = tone_table({.contrast = -1.0});
  EXPECT_EQ(flat[0], 112);
  EXPECT_EQ(flat[255], 143);
  for (const double contrast : {-1.0, -0.3, 0.4, 1.0}) {
    const auto table = tone_table({.brightness = 0.1, .contrast = contrast});
    EXPECT_TRUE(std::is_sorted(table.begin(), table.end()));
  }
}

TEST(ImageLook, LeavesAlphaAlone) {
  ImageRaster pixels(1, 1, ImagePixel{10, 20, 30, 40});
  apply_tones(tone_table({.brightness = 0.2}), pixels);
  EXPECT_EQ(pixels.at(0, 0), (ImagePixel{61, 71, 81, 40}));
}

TEST(ImageDate, IsReadAsTiffAndExifAndIsoWriteIt) {
  EXPECT_EQ(day_of("2019:05:01 10:11:12"), "2019-05-01");
  EXPECT_EQ(day_of("2019-05-01T10:11:12Z"), "2019-05-01");
  EXPECT_EQ(day_of("2019/05/01"), "2019-05-01");
  EXPECT_EQ(day_of("20190501"), "2019-05-01");
  for (const char* const none : {"", "0000:00:00 00:00:00", "2019:02:30", "2019:13:01",
                                 "2019:05-01", "201905011", "May 2019", "1776:07:04", "2019"}) {
    EXPECT_EQ(day_of(none), std::nullopt) << none;
  }
}

TEST(ImageDate, IsFoundInAName) {
  EXPECT_EQ(day_in_name("ortho_2019-05-01_rgb.tif"), "2019-05-01");
  EXPECT_EQ(day_in_name("20190501_town.jp2"), "2019-05-01");
  EXPECT_EQ(day_in_name("dop.2019.05.01.tif"), "2019-05-01");
  EXPECT_EQ(day_in_name("x1_2019_05_01.png"), "2019-05-01");
  for (const char* const none : {"town_2019.tif", "dop20_32470_5300000.tif", "1234567890123.tif",
                                 "", "2019-5-1.tif", "99999999.tif"}) {
    EXPECT_EQ(day_in_name(none), std::nullopt) << none;
  }
}

}  // namespace image_stack_test
}  // namespace nadir
