// SPDX-License-Identifier: Apache-2.0
#include "widgets/canvas/cairo_canvas.h"

#include <gmock/gmock.h>

#include <limits>
#include <numbers>
#include <stdexcept>

#include "tests/support/page_pixels.h"

namespace nadir {
namespace cairo_canvas_test {

class CairoPage : public testing::Test {
 protected:
  void fill(const PageRect& area, Rgba colour) const { canvas->fill(outline_of(area), colour); }
  void stroke(const std::vector<Eigen::Vector2d>& points, const StrokeStyle& style) const {
    canvas->stroke(points, style);
  }
  [[nodiscard]] int wrong(const PageRect& area, Rgba inside = kRed, Rgba outside = kWhite) const {
    return wrong_pixels(canvas->pixels(), area, inside, outside);
  }

  std::unique_ptr<CairoCanvas> canvas = CairoCanvas::for_pixels(20, 16, kWhite);
};

TEST_F(CairoPage, AFilledRectangleCoversExactlyItsPixels) {
  fill({3, 2, 5, 4}, kRed);
  const Raster<Rgba> page = canvas->pixels();
  ASSERT_EQ(page.width(), 20);
  ASSERT_EQ(page.height(), 16);
  EXPECT_EQ(wrong({3, 2, 5, 4}), 0);
  // y is up: two rows are free below, so the last rows of the raster.
  EXPECT_EQ(page.at(3, 13), kRed);
  EXPECT_EQ(page.at(3, 14), kWhite);
}

TEST_F(CairoPage, AHalfCoveredPixelIsHalfMixed) {
  fill({2.5, 0, 3.0, 16}, kBlack);
  const Raster<Rgba> page = canvas->pixels();
  EXPECT_LE(difference(page.at(2, 8), {127, 127, 127}), 2);
  EXPECT_EQ(page.at(3, 8), kBlack);
  EXPECT_LE(difference(page.at(5, 8), {127, 127, 127}), 2);
}

TEST_F(CairoPage, AHalfTransparentFillMixesWithWhatLiesBelow) {
  fill({0, 0, 10, 16}, {40, 200, 90});
  fill({0, 0, 20, 16}, {200, 40, 0, 128});
  const auto mixed = [](int above, int below) {
    return static_cast<std::uint8_t>(std::lround((above * 128.0 + below * 127.0) / 255.0));
  };
  const Raster<Rgba> page = canvas->pixels();
  EXPECT_LE(difference(page.at(5, 8), {mixed(200, 40), mixed(40, 200), mixed(0, 90)}), 1);
  EXPECT_LE(difference(page.at(15, 8), {mixed(200, 255), mixed(40, 255), mixed(0, 255)}), 1);
  EXPECT_EQ(page.at(5, 8).alpha, 255);
}

TEST(CairoCanvas, KeepsColoursApartFromOpacityOnATransparentBackground) {
  const auto canvas = CairoCanvas::for_pixels(9, 3, kNothing);
  const Rgba opaque{10, 200, 77};
  const Rgba half{200, 100, 50, 128};
  canvas->fill(outline_of({0, 0, 3, 3}), opaque);
  canvas->fill(outline_of({3, 0, 3, 3}), half);
  const Raster<Rgba> page = canvas->pixels();
  EXPECT_EQ(page.at(1, 1), opaque);
  // Eight bits that were multiplied by a half and divided again know no better than to two.
  EXPECT_LE(difference(page.at(4, 1), half), 2);
  EXPECT_NEAR(page.at(4, 1).alpha, 128, 1);
  EXPECT_EQ(page.at(7, 1), kNothing);
}

TEST(CairoCanvas, HasTheBackgroundThatWasAskedFor) {
  EXPECT_EQ(CairoCanvas::for_pixels(2, 2, {12, 34, 56})->pixels().at(1, 0), (Rgba{12, 34, 56}));
  const Rgba smoked{200, 100, 0, 51};
  EXPECT_LE(difference(CairoCanvas::for_pixels(2, 2, smoked)->pixels().at(1, 0), smoked), 4);
}

TEST(CairoCanvas, LeavesAHoleWhereAnOutlineWindsTwice) {
  const auto canvas = CairoCanvas::for_pixels(101, 101, kWhite);
  std::vector<Eigen::Vector2d> star;
  for (int i = 0; i < 5; ++i) {
    const double angle = std::numbers::pi * (0.5 + 0.8 * i);
    star.emplace_back(50.5 + 50.0 * std::cos(angle), 50.5 + 50.0 * std::sin(angle));
  }
  canvas->fill(star, kRed);
  const Raster<Rgba> page = canvas->pixels();
  EXPECT_EQ(pixel_at(page, 50.5, 50.5), kWhite);
  EXPECT_EQ(pixel_at(page, 50.5, 85.0), kRed);    // the arm that points up
  EXPECT_EQ(pixel_at(page, 50.5, 10.0), kWhite);  // between the two that point down
}

TEST_F(CairoPage, ClipsNestAndEndWhereTheyWereOpened) {
  canvas->push_clip({0, 0, 8, 12});
  canvas->push_clip({5, 4, 10, 12});
  fill({0, 0, 20, 16}, kRed);
  EXPECT_EQ(wrong({5, 4, 3, 8}), 0);
  canvas->pop_clip();
  fill({0, 0, 20, 16}, kBlue);
  EXPECT_EQ(wrong({0, 0, 8, 12}, kBlue), 0);
  canvas->pop_clip();
  fill({0, 0, 20, 16}, kGreen);
  EXPECT_EQ(wrong({0, 0, 20, 16}, kGreen), 0);
}

TEST_F(CairoPage, ClipsThatDoNotMeetLeaveNothing) {
  canvas->push_clip({0, 0, 8, 12});
  canvas->push_clip({12, 0, 8, 12});
  fill({0, 0, 20, 16}, kRed);
  stroke({{0, 8}, {20, 8}}, {kRed, 6.0});
  EXPECT_EQ(wrong({0, 0, 20, 16}, kWhite), 0);
}

TEST_F(CairoPage, AnImageHasItsTopRowOnTop) {
  Raster<Rgba> image(3, 2);
  image.at(0, 0) = kRed;
  image.at(1, 0) = kGreen;
  image.at(2, 0) = kBlue;
  image.at(0, 1) = {1, 2, 3};
  image.at(1, 1) = kNothing;
  image.at(2, 1) = {250, 251, 252};
  canvas->image({4, 5, 3, 2}, image);
  const Raster<Rgba> page = canvas->pixels();
  for (int row = 0; row < 2; ++row) {
    for (int column = 0; column < 3; ++column) {
      const Rgba drawn = image.at(column, row);
      EXPECT_EQ(pixel_at(page, 4.5 + column, 6.5 - row), drawn == kNothing ? kWhite : drawn);
    }
  }
  EXPECT_EQ(pixel_at(page, 3.5, 6.5), kWhite);
  EXPECT_EQ(pixel_at(page, 7.5, 5.5), kWhite);
  EXPECT_EQ(pixel_at(page, 4.5, 7.5), kWhite);
}

TEST_F(CairoPage, AnEnlargedImageHasSharpSquares) {
  Raster<Rgba> image(3, 2, Rgba{40, 0, 0});
  image.at(0, 0) = kRed;
  image.at(1, 1) = kGreen;
  image.at(2, 0) = kBlue;
  canvas->image({2, 3, 12, 8}, image);
  const Raster<Rgba> page = canvas->pixels();
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 12; ++x) {
      EXPECT_EQ(pixel_at(page, 2.5 + x, 3.5 + y), image.at(x / 4, 1 - y / 4)) << x << " " << y;
    }
  }
}

TEST(CairoCanvas, AReducedImageKeepsItsColourUpToTheBorder) {
  const auto canvas = CairoCanvas::for_pixels(20, 16, kWhite);
  canvas->image({2, 3, 10, 6}, Raster<Rgba>(40, 24, Rgba{30, 130, 230}));
  EXPECT_EQ(wrong_pixels(canvas->pixels(), {2, 3, 10, 6}, {30, 130, 230}, kWhite), 0);
}

TEST(CairoCanvas, AReducedImageIsAveragedAndNotThinnedOut) {
  Raster<Rgba> stripes(80, 80);
  for (int row = 0; row < 80; ++row) {
    for (int column = 0; column < 80; ++column) {
      stripes.at(column, row) = column % 2 == 0 ? kBlack : kWhite;
    }
  }
  const auto canvas = CairoCanvas::for_pixels(20, 20, kRed);
  canvas->image({0, 0, 20, 20}, stripes);
  EXPECT_LE(difference(canvas->pixels().at(10, 10), {127, 127, 127}), 16);
}

TEST(CairoCanvas, AHalfTransparentImageMixes) {
  const auto canvas = CairoCanvas::for_pixels(4, 4, kWhite);
  canvas->image({0, 0, 4, 4}, Raster<Rgba>(4, 4, Rgba{200, 40, 0, 128}));
  EXPECT_LE(difference(canvas->pixels().at(2, 2), {227, 147, 127}), 1);
}

TEST_F(CairoPage, ALineIsAsWideAsAskedAndItsEndsAreFlat) {
  stroke({{2, 5}, {9, 5}}, {kRed, 4.0});
  EXPECT_EQ(wrong({2, 3, 7, 4}), 0);
}

TEST_F(CairoPage, DashesGoOnAndOffFromTheFirstPoint) {
  stroke({{0, 8}, {20, 8}}, {kRed, 2.0, {3.0, 2.0}});
  const Raster<Rgba> page = canvas->pixels();
  for (int x = 0; x < 20; ++x) {
    EXPECT_EQ(pixel_at(page, x + 0.5, 8.5), x % 5 < 3 ? kRed : kWhite) << x;
  }
  // The next line is whole again.
  stroke({{0, 8}, {20, 8}}, {kRed, 2.0});
  EXPECT_EQ(wrong({0, 7, 20, 2}), 0);
}

TEST_F(CairoPage, CornersOfALineAreRound) {
  stroke({{2, 10}, {10, 10}, {10, 2}}, {kRed, 6.0});
  const Raster<Rgba> page = canvas->pixels();
  EXPECT_EQ(pixel_at(page, 11.5, 11.5), kRed);  // a bevel would halve it
  // A mitre would fill this one, of which the arc reaches a hundredth.
  EXPECT_LE(difference(pixel_at(page, 12.8, 12.8), kWhite), 10);
}

TEST_F(CairoPage, WhatIsDrawnLaterLiesAbove) {
  fill({0, 0, 10, 10}, kRed);
  canvas->image({0, 0, 10, 10}, Raster<Rgba>(1, 1, kBlue));
  stroke({{0, 5}, {10, 5}}, {kGreen, 2.0});
  const Raster<Rgba> page = canvas->pixels();
  EXPECT_EQ(pixel_at(page, 2.5, 2.5), kBlue);
  EXPECT_EQ(pixel_at(page, 2.5, 5.5), kGreen);
}

TEST_F(CairoPage, NothingIsDrawnOfTooFewPointsOrAnEmptyImage) {
  stroke({{5, 5}}, {kRed, 4.0});
  stroke({}, {kRed, 4.0});
  fill({1, 1, 0, 0}, kRed);
  canvas->fill(std::vector<Eigen::Vector2d>{{0, 0}, {20, 16}}, kRed);
  canvas->image({0, 0, 10, 10}, {});
  canvas->image({0, 0, 0, 10}, Raster<Rgba>(2, 2, kRed));
  fill({3, 2, 5, 4}, kBlue);  // and what comes next is drawn
  EXPECT_EQ(wrong({3, 2, 5, 4}, kBlue), 0);
}

// Somebody zooms into a trajectory that goes on for hundreds of kilometres.
TEST_F(CairoPage, ALineToAFarPointLeavesThePageInItsDirection) {
  for (const double far : {1e4, 1e6, 1e8, 1e12}) {
    canvas = CairoCanvas::for_pixels(20, 16, kWhite);
    stroke({{4, 8}, {far, 8}}, {kRed, 2.0});
    EXPECT_EQ(wrong({4, 7, 16, 2}), 0) << far;
    canvas = CairoCanvas::for_pixels(20, 16, kWhite);
    stroke({{-far, -far}, {far, far}}, {kRed, 2.0});
    EXPECT_EQ(pixel_at(canvas->pixels(), 9.5, 9.5), kRed) << far;
    EXPECT_EQ(pixel_at(canvas->pixels(), 14.5, 4.5), kWhite) << far;
  }
}

TEST_F(CairoPage, AnAreaThatReachesFarCoversThePage) {
  for (const double far : {1e4, 1e6, 1e8, 1e12}) {
    canvas = CairoCanvas::for_pixels(20, 16, kWhite);
    fill({-far, 4, 2.0 * far, far}, kRed);
    EXPECT_EQ(wrong({0, 4, 20, 12}), 0) << far;
  }
}

TEST_F(CairoPage, DashesKeepTheirPlaceOnALineThatBeginsFarAway) {
  stroke({{-1e6, 8}, {20, 8}}, {kRed, 2.0, {3.0, 2.0}});
  const Raster<Rgba> page = canvas->pixels();
  for (int x = 0; x < 20; ++x) {
    EXPECT_LE(difference(pixel_at(page, x + 0.5, 8.5), x % 5 < 3 ? kRed : kWhite), 2) << x;
  }
}

TEST_F(CairoPage, PointsThatAreNotFiniteLeaveAGap) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  stroke({{0, 8}, {5, 8}, {kNone, 8}, {10, 8}, {15, 8}}, {kRed, 2.0});
  const Raster<Rgba> page = canvas->pixels();
  for (int x = 0; x < 20; ++x) {
    EXPECT_EQ(pixel_at(page, x + 0.5, 8.5), x < 5 || (x >= 10 && x < 15) ? kRed : kWhite) << x;
  }
}

TEST(CairoCanvas, DrawsTheSameBytesTwice) {
  const auto draw = [] {
    const auto canvas = CairoCanvas::for_pixels(60, 40, kNothing);
    canvas->push_clip({2.3, 4.1, 50.0, 30.0});
    canvas->fill(std::vector<Eigen::Vector2d>{{3, 3}, {55.5, 20.2}, {12.1, 39}}, {9, 99, 199, 90});
    canvas->text({30, 20}, "12.5 m", {.align = TextAlign::kCentre, .rotation_deg = 21.0});
    canvas->pop_clip();
    return canvas->pixels();
  };
  EXPECT_EQ(draw(), draw());
}

TEST(CairoCanvas, SaysThatAPageIsTooLarge) {
  EXPECT_THROW((void)CairoCanvas::for_pixels(100'000, 100'000, kWhite), std::runtime_error);
}

}  // namespace cairo_canvas_test
}  // namespace nadir
