// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "tests/support/page_pixels.h"
#include "widgets/canvas/cairo_canvas.h"

namespace nadir {
namespace cairo_text_test {

/// Where the ink is when a line is written at the middle of a page of 200 x 200 pixels.
PageRect ink_of(const std::string& line, TextStyle style) {
  style.colour = kBlack;
  const auto canvas = CairoCanvas::for_pixels(200, 200, kWhite);
  canvas->text({100, 100}, line, style);
  return ink_box(canvas->pixels(), kWhite);
}

double width_of(const std::string& line, const TextStyle& style) {
  return measure_text(line, style).width;
}

TEST(MeasureText, GrowsInProportionToTheSize) {
  const TextExtent small = measure_text("Euclidean error, m", {.size_px = 10.0});
  EXPECT_GT(small.width, 50.0);
  EXPECT_GT(small.cap_height, 5.0);
  EXPECT_LT(small.cap_height, 10.0);
  EXPECT_GT(small.descent, 0.5);
  for (const double factor : {0.7, 1.5, 2.0, 3.3, 10.0}) {
    const TextExtent large = measure_text("Euclidean error, m", {.size_px = 10.0 * factor});
    EXPECT_NEAR(large.width, factor * small.width, 0.002 * factor * small.width);
    EXPECT_NEAR(large.cap_height, factor * small.cap_height, 0.05 * factor);
    EXPECT_NEAR(large.descent, factor * small.descent, 0.05 * factor);
  }
}

TEST(MeasureText, IsTheSumOfItsLettersWhereNumbersLineUp) {
  const TextStyle numbers{.face = FontFace::kNumbers, .size_px = 14.0};
  const double digit = width_of("0", numbers);
  for (const char* other : {"1", "4", "7", "9"}) EXPECT_NEAR(width_of(other, numbers), digit, 1e-6);
  EXPECT_NEAR(width_of("0123456789", numbers), 10.0 * digit, 0.01);
}

TEST(MeasureText, CountsSpacesAndReadsUtf8) {
  const TextStyle style{.size_px = 20.0};
  EXPECT_EQ(width_of("", style), 0.0);
  EXPECT_GT(width_of("a ", style), width_of("a", style));
  EXPECT_NEAR(width_of("\xc3\xa4", style), width_of("a", style),
              0.01);  // a with two dots is one letter
  EXPECT_GT(width_of("error", {.is_bold = true, .size_px = 20.0}), width_of("error", style));
}

// Capital H has the same margins on both sides in every face.
TEST(CairoText, BeginsEndsOrIsCentredAtItsPoint) {
  const TextStyle left{.size_px = 24.0};
  TextStyle centred = left;
  centred.align = TextAlign::kCentre;
  TextStyle right = left;
  right.align = TextAlign::kRight;
  const double width = width_of("HHHH", left);
  const PageRect begun = ink_of("HHHH", left);
  EXPECT_NEAR(begun.centre().x(), 100.0 + width / 2.0, 0.75);
  EXPECT_GE(begun.left, 99.0);
  EXPECT_LE(begun.right(), 101.0 + width);
  EXPECT_NEAR(ink_of("HHHH", centred).centre().x(), 100.0, 0.75);
  EXPECT_NEAR(ink_of("HHHH", right).centre().x(), 100.0 - width / 2.0, 0.75);
}

TEST(CairoText, StandsOnItsBaselineAndReachesAsHighAsMeasured) {
  for (const FontFace face : {FontFace::kText, FontFace::kNumbers}) {
    const TextStyle style{.face = face, .size_px = 40.0};
    const TextExtent extent = measure_text("H", style);
    const PageRect capital = ink_of("H", style);
    EXPECT_NEAR(capital.bottom, 100.0, 1.0);
    EXPECT_NEAR(capital.height, extent.cap_height, 1.5);
    EXPECT_NEAR(ink_of("g", style).bottom, 100.0 - extent.descent, 1.5);
  }
}

TEST(CairoText, TurnsCounterClockwiseAboutItsPoint) {
  const TextStyle style{.size_px = 24.0};
  const TextExtent extent = measure_text("HHHH", style);
  TextStyle turned = style;
  turned.rotation_deg = 90.0;
  const PageRect up = ink_of("HHHH", turned);
  EXPECT_NEAR(up.centre().y(), 100.0 + extent.width / 2.0, 0.75);
  EXPECT_NEAR(up.right(), 100.0, 1.0);
  EXPECT_NEAR(up.width, extent.cap_height, 1.5);
  turned.rotation_deg = 180.0;
  const PageRect back = ink_of("HHHH", turned);
  EXPECT_NEAR(back.centre().x(), 100.0 - extent.width / 2.0, 0.75);
  EXPECT_NEAR(back.top(), 100.0, 1.0);
}

TEST(CairoText, HasItsColour) {
  const auto canvas = CairoCanvas::for_pixels(200, 200, kWhite);
  canvas->text({20, 20}, "I", {.is_bold = true, .size_px = 150.0, .colour = {10, 120, 230}});
  const Raster<Rgba> page = canvas->pixels();
  EXPECT_TRUE(std::any_of(page.values().begin(), page.values().end(), [](Rgba pixel) {
    return pixel == Rgba{10, 120, 230};
  }));
}

TEST(CairoText, IsCutByTheClip) {
  const auto canvas = CairoCanvas::for_pixels(200, 200, kWhite);
  canvas->push_clip({0, 0, 60, 200});
  canvas->text({10, 100}, "HHHHHHHHHH", {.size_px = 30.0, .colour = kBlack});
  canvas->pop_clip();
  EXPECT_LE(ink_box(canvas->pixels(), kWhite).right(), 60.0);
  EXPECT_GT(ink_box(canvas->pixels(), kWhite).right(), 50.0);
}

// A recording may be called anything, also in Latin-1. Cairo would draw nothing more after such a text.
TEST(CairoText, ThatIsNotUtf8SpoilsNothingElse) {
  const std::string latin1 = "M\xfcnchen \xff\xfe";
  const auto canvas = CairoCanvas::for_pixels(200, 200, kWhite);
  canvas->text({10, 100}, latin1, {.size_px = 20.0, .colour = kBlack});
  const PageRect written = ink_box(canvas->pixels(), kWhite);
  EXPECT_GT(written.width, 50.0);  // the letters that can be read
  canvas->fill(outline_of({0, 0, 10, 10}), kRed);
  EXPECT_EQ(pixel_at(canvas->pixels(), 5, 5), kRed);
  EXPECT_GT(width_of(latin1, {.size_px = 20.0}), 50.0);
}

}  // namespace cairo_text_test
}  // namespace nadir
