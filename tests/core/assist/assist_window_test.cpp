// SPDX-License-Identifier: Apache-2.0
#include "core/assist/assist_window.h"

#include <gmock/gmock.h>

#include "core/map/overhead_image.h"
#include "tests/core/assist/drawn_windows.h"
#include "tests/core/map/image_files.h"
#include "tests/support/scratch_folder.h"

namespace nadir {
namespace assist_window_test {

using testing::HasSubstr;

/// Images without a place: a metre a pixel, from the origin to the right and down.
class WindowOfAnImage : public testing::Test {
 protected:
  [[nodiscard]] OpenedImage opened(const DrawnImage& image) const {
    write_image(image, scratch.path() / "image.tif");
    auto result = open_overhead_image(scratch.path() / "image.tif");
    if (!result) throw std::runtime_error(error_text(result));
    return std::move(*result);
  }
  [[nodiscard]] static AssistWindow around(const OverheadTiles& tiles,
                                           const Eigen::Vector2d& at,
                                           const AssistWindowOptions& options) {
    auto window = read_assist_window(tiles, at, options);
    if (!window) throw std::runtime_error(error_text(window));
    return std::move(*window);
  }
  [[nodiscard]] static Eigen::Vector2d centre(const AssistWindow& window, int column, int row) {
    return window.enu_from_pixels() * Eigen::Vector2d(column + 0.5, row + 0.5);
  }

  ScratchFolder scratch;
};

TEST_F(WindowOfAnImage, HasThePixelsThatTilesShowAtTheirCentres) {
  const OpenedImage image = opened({.pixels = mosaic(700, 600)});
  // Across the corner of four tiles.
  const AssistWindow window = around(image.tiles, {515.25, -509.75}, {40.0, 512});
  EXPECT_EQ(window.width(), 81);  // Whoever is touched.
  EXPECT_EQ(window.height(), 81);
  EXPECT_EQ(window.metres_per_pixel(), 1.0);
  for (int row = 0; row < window.height(); ++row) {
    for (int column = 0; column < window.width(); ++column) {
      ASSERT_EQ(window.pixels().at(column, row), shown_at(image.tiles, centre(window, column, row)))
          << column << ", " << row;
    }
  }
}

TEST_F(WindowOfAnImage, MovesWithTheImagesOffset) {
  OpenedImage image = opened({.pixels = mosaic(100, 100)});
  const ImagePixel before = around(image.tiles, {50.5, -50.5}, {5.0, 64}).pixels().at(5, 5);
  image.tiles.set_offset({3.25, -7.5});
  const AssistWindow window = around(image.tiles, {53.75, -58.0}, {5.0, 64});
  const auto pixel = window.pixel_at({53.75, -58.0});
  ASSERT_TRUE(pixel);
  EXPECT_EQ(window.pixels().at(pixel->column, pixel->row), before);
}

TEST_F(WindowOfAnImage, IsCoarserWhereItIsLargeAndStaysInItsPlace) {
  ImageRaster ramp(1500, 1100);
  for (int row = 0; row < 1100; ++row) {
    for (int column = 0; column < 1500; ++column) {
      ramp.at(column, row) = {static_cast<std::uint8_t>(column / 6),
                              static_cast<std::uint8_t>(row / 6), 0, 255};
    }
  }
  const OpenedImage image = opened({.pixels = ramp, .options = {"TILED=YES"}});
  const AssistWindow window = around(image.tiles, {1300.0, -1000.0}, {300.0, 256});
  EXPECT_EQ(window.metres_per_pixel(), 4.0);
  EXPECT_LE(window.width(), 256);
  for (const int row : {0, 40, window.height() - 1}) {
    for (const int column : {0, 70, window.width() - 1}) {
      const Eigen::Vector2d at = centre(window, column, row);
      EXPECT_LT(at.x(), 1500.0);
      EXPECT_GT(at.y(), -1100.0);
      EXPECT_NEAR(window.pixels().at(column, row).red, (at.x() - 0.5) / 6.0, 1.25);
      EXPECT_NEAR(window.pixels().at(column, row).green, (-at.y() - 0.5) / 6.0, 1.25);
    }
  }
}

TEST_F(WindowOfAnImage, NeverHasMorePixelsThanAllowed) {
  const OpenedImage image = opened({.pixels = mosaic(700, 600), .options = {"TILED=YES"}});
  for (const double x : {0.0, 3.7, 350.0, 699.9}) {
    for (const int most : {16, 17, 100}) {
      const AssistWindow window = around(image.tiles, {x, -300.5}, {9'000.0, most});
      EXPECT_LE(window.width(), most);
      EXPECT_LE(window.height(), most);
      EXPECT_TRUE(window.pixel_at({x, -300.5})) << x << " of " << most;
    }
  }
}

TEST_F(WindowOfAnImage, HoldsAPlaceOnTheSliverThatACoarsePixelHalfCovers) {
  const OpenedImage image = opened({.pixels = mosaic(1501, 1101), .options = {"TILED=YES"}});
  const Eigen::Vector2d at(1500.9, -1100.9);
  const AssistWindow window = around(image.tiles, at, {300.0, 256});
  EXPECT_EQ(window.metres_per_pixel(), 4.0);
  EXPECT_EQ(error_text(window.seen_pixel_at(at)), "(no error)");
}

TEST_F(WindowOfAnImage, EndsWhereTheImageEnds) {
  const OpenedImage image = opened({.pixels = mosaic(30, 20)});
  const AssistWindow window = around(image.tiles, {1.5, -18.5}, {5.0, 512});
  EXPECT_EQ(window.width(), 7);
  EXPECT_EQ(window.height(), 7);
  EXPECT_EQ(window.enu_from_pixels().offset, Eigen::Vector2d(0.0, -13.0));
  EXPECT_EQ(window.pixels().at(0, 6), mosaic_colour(0, 19));
}

TEST_F(WindowOfAnImage, OfOnePixelIsOnePixel) {
  const OpenedImage image = opened({.pixels = ImageRaster(1, 1, kRoof)});
  const AssistWindow window = around(image.tiles, {0.5, -0.5}, {25.0, 512});
  ASSERT_EQ(window.pixels().size(), 1U);
  EXPECT_EQ(window.pixels().at(0, 0), kRoof);
}

TEST_F(WindowOfAnImage, OutsideOfItIsRefused) {
  const OpenedImage image = opened({.pixels = mosaic(30, 20)});
  const double nan = std::nan("");
  for (const Eigen::Vector2d& at : {Eigen::Vector2d(-0.1, -5.0), Eigen::Vector2d(5.0, 0.1),
                                    Eigen::Vector2d(30.0, -5.0), Eigen::Vector2d(nan, -5.0)}) {
    EXPECT_EQ(error_text(read_assist_window(image.tiles, at)), "the place is outside of the image");
  }
  EXPECT_THAT(error_text(read_assist_window(image.tiles, {5.0, -5.0}, {0.0, 512})),
              HasSubstr("--assist-radius: 0 is not in"));
  EXPECT_THAT(error_text(read_assist_window(image.tiles, {5.0, -5.0}, {5.0, 4096})),
              HasSubstr("--assist-pixels: 4096 is not in"));
}

TEST_F(WindowOfAnImage, KeepsWhatWasNotSeenClear) {
  DrawnImage image{.pixels = ImageRaster(30, 20, kRoof), .has_alpha = true};
  image.pixels.at(4, 7) = {9, 9, 9, 0};
  const OpenedImage read = opened(image);
  const AssistWindow window = around(read.tiles, {15.0, -10.0}, {50.0, 512});
  EXPECT_FALSE(window.is_seen(4, 7));
  EXPECT_TRUE(window.is_seen(5, 7));
  EXPECT_EQ(error_text(window.seen_pixel_at({4.5, -7.5})), "the image shows nothing at the place");
}

TEST_F(WindowOfAnImage, ReadsGreyAndSixteenBits) {
  ImageRaster steps(256, 4);
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 256; ++column) {
      const auto value = static_cast<std::uint8_t>(column);
      steps.at(column, row) = {value, value, value, 255};
    }
  }
  for (const int factor : {1, 200}) {
    const OpenedImage read = opened({.pixels = steps, .is_grey = true, .value_factor = factor});
    const AssistWindow window = around(read.tiles, {128.0, -2.0}, {128.0, 512});
    ASSERT_EQ(window.width(), 256);
    for (int column = 1; column < 256; ++column) {
      const LabColour& colour = window.colours().at(column, 1);
      EXPECT_GE(colour.lightness, window.colours().at(column - 1, 1).lightness);
      EXPECT_NEAR(colour.a, 0.0, 0.2);
      EXPECT_NEAR(colour.b, 0.0, 0.2);
    }
    EXPECT_NEAR(window.colours().at(255, 1).lightness, 100.0, 0.1);
  }
}

TEST(AssistWindow, HasTheColoursOfTheStandard) {
  // IEC 61966-2-1 with D65: the corners of sRGB in CIE L*a*b*.
  ImageRaster pixels(3, 1);
  pixels.at(0, 0) = {255, 0, 0, 255};
  pixels.at(1, 0) = {0, 0, 255, 255};
  pixels.at(2, 0) = {255, 255, 255, 255};
  const AssistWindow window = window_of(pixels, plain_place());
  const auto expect_near = [&](int column, double lightness, double a, double b) {
    const LabColour& colour = window.colours().at(column, 0);
    EXPECT_NEAR(colour.lightness, lightness, 0.1);
    EXPECT_NEAR(colour.a, a, 0.2);
    EXPECT_NEAR(colour.b, b, 0.2);
  };
  expect_near(0, 53.24, 80.09, 67.20);
  expect_near(1, 32.30, 79.19, -107.86);
  expect_near(2, 100.0, 0.0, 0.0);
  EXPECT_NEAR(colour_difference({50.0F, 3.0F, 4.0F}, {50.0F, 0.0F, 0.0F}), 5.0, 1e-6);
}

TEST(AssistWindow, FindsThePixelThatHoldsAPlaceHoweverItLies) {
  const AssistWindow window = window_of(ImageRaster(9, 7, kGrass), turned_place());
  EXPECT_NEAR(window.metres_per_pixel(), std::sqrt(0.5 * 0.75), 1e-12);
  for (int row = 0; row < 7; ++row) {
    for (int column = 0; column < 9; ++column) {
      for (const double beside : {0.01, 0.5, 0.99}) {
        const Eigen::Vector2d at(column + beside, row + 1.0 - beside);
        EXPECT_EQ(window.pixel_at(window.enu_from_pixels() * at), (PixelPlace{column, row}));
      }
    }
  }
  EXPECT_FALSE(window.pixel_at(window.enu_from_pixels() * Eigen::Vector2d(-0.01, 3.0)));
  EXPECT_FALSE(window.pixel_at(window.enu_from_pixels() * Eigen::Vector2d(4.0, 7.01)));
}

TEST(AssistWindow, WithoutAPlaceIsRefused) {
  Affine2 flat;
  flat.linear << 1.0, 2.0, 2.0, 4.0;
  EXPECT_FALSE(AssistWindow::create(ImageRaster(2, 2, kGrass), flat));
}

}  // namespace assist_window_test
}  // namespace nadir
