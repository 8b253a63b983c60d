// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <vtkStdString.h>

#include <array>

#include "tests/widgets/canvas/device_page.h"

namespace nadir {
namespace canvas_device_text_test {

struct Placing {
  int justification = VTK_TEXT_LEFT;
  int vertical = VTK_TEXT_BOTTOM;
  double degrees = 0.0;
};

class DeviceText : public testing::Test {
 protected:
  void place(const Placing& placing) const {
    vtkTextProperty* const text = page.painter->GetTextProp();
    text->SetFontFamilyToArial();
    text->SetFontSize(20);
    text->SetColor(0.0, 0.0, 0.0);
    text->SetOpacity(1.0);
    text->SetBold(0);
    text->SetItalic(0);
    text->SetJustification(placing.justification);
    text->SetVerticalJustification(placing.vertical);
    text->SetOrientation(placing.degrees);
  }
  /// Of a text at the origin.
  [[nodiscard]] PageRect bounds(const std::string& line, const Placing& placing = {}) const {
    place(placing);
    std::array<float, 4> box{};
    page.painter->ComputeJustifiedStringBounds(line.c_str(), box.data());
    return {box[0], box[1], box[2], box[3]};
  }

  DevicePage page{200, 200};
};

void expect_near(const PageRect& box, const PageRect& expected) {
  EXPECT_NEAR(box.left, expected.left, 0.01);
  EXPECT_NEAR(box.bottom, expected.bottom, 0.01);
  EXPECT_NEAR(box.width, expected.width, 0.01);
  EXPECT_NEAR(box.height, expected.height, 0.01);
}

TEST_F(DeviceText, HasBoundsThatTurnWithIt) {
  const TextExtent extent = measure_text("Hg 12", {.size_px = 20.0});
  const double width = extent.width;
  const double height = extent.cap_height + extent.descent;
  const int left = VTK_TEXT_LEFT;
  const int bottom = VTK_TEXT_BOTTOM;
  expect_near(bounds("Hg 12", {left, bottom, 0.0}), {0.0, 0.0, width, height});
  expect_near(bounds("Hg 12", {left, bottom, 90.0}), {-height, 0.0, height, width});
  expect_near(bounds("Hg 12", {left, bottom, 180.0}), {-width, -height, width, height});
  expect_near(bounds("Hg 12", {left, bottom, 270.0}), {0.0, -width, height, width});
  expect_near(bounds("Hg 12", {VTK_TEXT_RIGHT, VTK_TEXT_TOP, 0.0}),
              {-width, -height, width, height});
  expect_near(bounds("Hg 12", {VTK_TEXT_RIGHT, VTK_TEXT_TOP, 180.0}), {0.0, 0.0, width, height});
  expect_near(bounds("Hg 12", {VTK_TEXT_CENTERED, bottom, 90.0}),
              {-height, -width / 2.0, height, width});
}

TEST_F(DeviceText, IsCentredByItsCapitals) {
  const TextExtent extent = measure_text("Hg 12", {.size_px = 20.0});
  const PageRect box = bounds("Hg 12", {VTK_TEXT_CENTERED, VTK_TEXT_CENTERED, 0.0});
  EXPECT_NEAR(box.top(), extent.cap_height / 2.0, 0.01);
  EXPECT_NEAR(box.centre().x(), 0.0, 0.01);
}

TEST_F(DeviceText, LiesInsideItsBoundsHoweverItIsPlaced) {
  for (const int justification : {VTK_TEXT_LEFT, VTK_TEXT_CENTERED, VTK_TEXT_RIGHT}) {
    for (const int vertical : {VTK_TEXT_BOTTOM, VTK_TEXT_CENTERED, VTK_TEXT_TOP}) {
      for (const double degrees : {0.0, 30.0, 90.0, 180.0, -45.0}) {
        for (const std::string line : {"Hg 12", "Hg 12\nHgH"}) {
          DevicePage drawn(200, 200);
          const Placing placing{justification, vertical, degrees};
          const PageRect box = bounds(line, placing);
          drawn.painter->ApplyTextProp(page.painter->GetTextProp());
          drawn.painter->DrawString(100.0F, 100.0F, vtkStdString(line));
          const PageRect ink = drawn.ink();
          SCOPED_TRACE(line + " at " + std::to_string(degrees) + " degrees, " +
                       std::to_string(justification) + " " + std::to_string(vertical));
          EXPECT_GT(ink.width, 10.0);
          constexpr double kRounded = 1.5;  // Cairo sets letters on whole pixels
          EXPECT_GE(ink.left, 100.0 + box.left - kRounded);
          EXPECT_GE(ink.bottom, 100.0 + box.bottom - kRounded);
          EXPECT_LE(ink.right(), 100.0 + box.right() + kRounded);
          EXPECT_LE(ink.top(), 100.0 + box.top() + kRounded);
          if (degrees == 0.0) {  // and fills them
            EXPECT_NEAR(ink.width, box.width, 5.0);
            EXPECT_NEAR(ink.height, box.height, 2.0);
          }
        }
      }
    }
  }
}

TEST_F(DeviceText, WithoutPlacingStartsAtTheOrigin) {
  place({VTK_TEXT_RIGHT, VTK_TEXT_TOP, 90.0});
  std::array<float, 4> box{};
  page.painter->ComputeStringBounds("Hg 12", box.data());
  const TextExtent extent = measure_text("Hg 12", {.size_px = 20.0});
  EXPECT_EQ(box[0], 0.0F);
  EXPECT_EQ(box[1], 0.0F);
  EXPECT_NEAR(box[2], extent.width, 0.01);
  EXPECT_NEAR(box[3], extent.cap_height + extent.descent, 0.01);
}

TEST_F(DeviceText, IsAsWideAsItsLongestLineAndATextSizeAndAThirdHigherByLine) {
  const PageRect one = bounds("HHHH");
  const PageRect three = bounds("HHHH\nH\nHH");
  EXPECT_NEAR(three.width, one.width, 0.01);
  EXPECT_NEAR(three.height, one.height + 2.0 * 1.3 * 20.0, 0.01);
}

TEST_F(DeviceText, InCourierHasTheFaceOfNumbers) {
  const PageRect words = bounds("11111");
  page.painter->GetTextProp()->SetFontFamilyToCourier();
  std::array<float, 4> box{};
  page.painter->ComputeJustifiedStringBounds("11111", box.data());
  EXPECT_NEAR(box[2], measure_text("11111", {.face = FontFace::kNumbers, .size_px = 20.0}).width,
              0.01);
  EXPECT_NEAR(words.width, measure_text("11111", {.size_px = 20.0}).width, 0.01);
}

TEST_F(DeviceText, HasItsColourAndOpacity) {
  place({});
  page.painter->GetTextProp()->SetColor(1.0, 0.0, 0.0);
  page.painter->GetTextProp()->SetFontSize(150);
  page.painter->GetTextProp()->SetBold(1);
  page.painter->GetTextProp()->SetOpacity(0.5);
  page.painter->DrawString(20.0F, 20.0F, "I");
  const Raster<Rgba> pixels = page.pixels();
  EXPECT_TRUE(std::any_of(pixels.values().begin(), pixels.values().end(), [](Rgba pixel) {
    return difference(pixel, {255, 127, 127}) <= 1;
  }));
}

TEST_F(DeviceText, ThatIsTransparentOrEmptyIsNotDrawn) {
  place({});
  page.painter->DrawString(20.0F, 20.0F, "");
  page.painter->GetTextProp()->SetOpacity(0.0);
  page.painter->DrawString(20.0F, 20.0F, "H");
  EXPECT_EQ(page.ink(), PageRect{});
}

}  // namespace canvas_device_text_test
}  // namespace nadir
