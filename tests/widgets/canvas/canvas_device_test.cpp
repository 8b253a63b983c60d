// SPDX-License-Identifier: Apache-2.0
#include "widgets/canvas/canvas_device.h"

#include <gmock/gmock.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkRect.h>
#include <vtkRenderingCoreEnums.h>
#include <vtkTransform2D.h>

#include <array>
#include <numbers>

#include "tests/widgets/canvas/device_page.h"
#include "widgets/canvas/svg_canvas.h"
#include "widgets/canvas/vtk_image.h"

namespace nadir {
namespace canvas_device_test {

class Device : public testing::Test {
 protected:
  /// Rectangle of the brush's colour.
  void fill(float left, float bottom, float width, float height) const {
    std::array<float, 8> corners = {left,         bottom,          left + width, bottom,
                                    left + width, bottom + height, left,         bottom + height};
    page.device->DrawPolygon(corners.data(), 4);
  }
  void clip(std::array<int, 4> box, bool enable = true) const {
    page.device->SetClipping(box.data());
    page.device->EnableClipping(enable);
  }
  void expect_ink(const PageRect& expected, double tolerance) const {
    const PageRect ink = page.ink();
    EXPECT_NEAR(ink.left, expected.left, tolerance);
    EXPECT_NEAR(ink.bottom, expected.bottom, tolerance);
    EXPECT_NEAR(ink.right(), expected.right(), tolerance);
    EXPECT_NEAR(ink.top(), expected.top(), tolerance);
  }

  DevicePage page{200, 150};
};

TEST_F(Device, KnowsItsPage) {
  EXPECT_EQ(page.device->GetWidth(), 200);
  EXPECT_EQ(page.device->GetHeight(), 150);
}

TEST_F(Device, ALineLandsWhereTheTransformSays) {
  // Doubled, turned by 90 degrees, moved to (100, 50).
  const vtkNew<vtkMatrix3x3> placed;
  placed->SetElement(0, 0, 0.0);
  placed->SetElement(0, 1, -2.0);
  placed->SetElement(0, 2, 100.0);
  placed->SetElement(1, 0, 2.0);
  placed->SetElement(1, 1, 0.0);
  placed->SetElement(1, 2, 50.0);
  const vtkNew<vtkTransform2D> transform;
  transform->SetMatrix(placed);
  page.painter->SetTransform(transform);
  page.painter->GetPen()->SetWidth(4.0F);
  page.painter->DrawLine(0.0F, 5.0F, 20.0F, 5.0F);  // to (90, 50) and (90, 90); as wide as before
  EXPECT_EQ(wrong_pixels(page.pixels(), {88, 50, 4, 40}, kBlack, kWhite), 0);
}

TEST_F(Device, TransformsAddUpAndAreTakenBack) {
  const vtkNew<vtkTransform2D> right;
  right->Translate(40, 0);
  const vtkNew<vtkTransform2D> twice;
  twice->Scale(2, 2);
  page.painter->PushMatrix();
  page.painter->AppendTransform(right);
  page.painter->AppendTransform(twice);  // first doubled, then moved
  fill(5, 5, 10, 10);
  EXPECT_EQ(wrong_pixels(page.pixels(), {50, 10, 20, 20}, kBlack, kWhite), 0);
  page.painter->PopMatrix();
  page.painter->GetBrush()->SetColor(255, 255, 255, 255);
  fill(50, 10, 20, 20);
  EXPECT_EQ(wrong_pixels(page.pixels(), {0, 0, 200, 150}, kWhite, kWhite), 0);
}

TEST_F(Device, GivesItsMatrixBack) {
  const vtkNew<vtkMatrix3x3> set;
  for (int row = 0; row < 2; ++row) {
    for (int column = 0; column < 3; ++column) set->SetElement(row, column, 1 + 3 * row + column);
  }
  page.device->SetMatrix(set);
  const vtkNew<vtkMatrix3x3> got;
  page.device->GetMatrix(got);
  for (int i = 0; i < 9; ++i) EXPECT_EQ(got->GetData()[i], set->GetData()[i]);
}

TEST_F(Device, PairsOfPointsAreSeparateLines) {
  page.painter->GetPen()->SetWidth(2.0F);
  std::array<float, 8> points = {10, 10, 50, 10, 80, 10, 120, 10};
  page.device->DrawLines(points.data(), 4, nullptr, 0);
  const Raster<Rgba> pixels = page.pixels();
  EXPECT_EQ(pixel_at(pixels, 30, 10), kBlack);
  EXPECT_EQ(pixel_at(pixels, 65, 10), kWhite);
  EXPECT_EQ(pixel_at(pixels, 100, 10), kBlack);
}

TEST_F(Device, LinesTakeTheColoursOfTheirPoints) {
  page.painter->GetPen()->SetWidth(2.0F);
  std::array<float, 8> points = {10, 10, 50, 10, 80, 10, 120, 10};
  std::array<unsigned char, 12> colours = {255, 0, 0, 255, 0, 0, 0, 0, 255, 0, 0, 255};
  page.device->DrawLines(points.data(), 4, colours.data(), 3);
  EXPECT_EQ(pixel_at(page.pixels(), 30, 10), kRed);
  EXPECT_EQ(pixel_at(page.pixels(), 100, 10), kBlue);
}

TEST_F(Device, APenWithoutLineDrawsNone) {
  page.painter->GetPen()->SetLineType(vtkPen::NO_PEN);
  page.painter->DrawLine(0, 50, 200, 50);
  page.painter->GetPen()->SetLineType(vtkPen::SOLID_LINE);
  page.painter->GetPen()->SetOpacity(0);
  page.painter->DrawLine(0, 60, 200, 60);
  EXPECT_EQ(page.ink(), PageRect{});
}

TEST_F(Device, DashesGrowWithTheLine) {
  const auto changes = [](float width) {
    DevicePage drawn(200, 150);
    drawn.painter->GetPen()->SetLineType(vtkPen::DASH_LINE);
    drawn.painter->GetPen()->SetWidth(width);
    drawn.painter->DrawLine(0, 75, 200, 75);
    const Raster<Rgba> pixels = drawn.pixels();
    int count = 0;
    for (int x = 1; x < 200; ++x) {
      count += difference(pixels.at(x, 75), pixels.at(x - 1, 75)) > 127 ? 1 : 0;
    }
    return count;
  };
  // A dash and a gap are 6.5 widths, with two changes each.
  EXPECT_NEAR(changes(2.0F), 2.0 * 200.0 / 13.0, 2.0);
  EXPECT_NEAR(changes(4.0F), 2.0 * 200.0 / 26.0, 2.0);
}

TEST_F(Device, AQuadStripIsOneAreaWithoutSeams) {
  page.painter->GetBrush()->SetColor(0, 0, 0, 128);
  std::array<float, 16> strip = {10,    10, 10,    40, 30.5F, 10, 30.5F, 40,
                                 50.3F, 10, 50.3F, 40, 80,    10, 80,    40};
  page.painter->DrawQuadStrip(strip.data(), 8);
  const Rgba inside = pixel_at(page.pixels(), 20, 20);
  EXPECT_LE(difference(inside, {127, 127, 127}), 1);
  EXPECT_EQ(wrong_pixels(page.pixels(), {10, 10, 70, 30}, inside, kWhite), 0);
}

TEST_F(Device, AQuadStripWhoseSidesCrossIsFilledOnBothSides) {
  std::array<float, 8> strip = {10, 10, 10, 50, 90, 50, 90, 10};
  page.painter->DrawQuadStrip(strip.data(), 4);
  const Raster<Rgba> pixels = page.pixels();
  EXPECT_EQ(pixel_at(pixels, 15, 30), kBlack);
  EXPECT_EQ(pixel_at(pixels, 85, 30), kBlack);
  EXPECT_EQ(pixel_at(pixels, 50, 45), kWhite);
  EXPECT_NEAR(ink_area(pixels), 80.0 * 40.0 / 2.0, 10.0);
}

TEST_F(Device, QuadsAndPolygonsAreFilledWithTheBrush) {
  page.painter->GetPen()->SetLineType(vtkPen::NO_PEN);
  page.painter->DrawRect(10, 20, 30, 40);
  EXPECT_EQ(wrong_pixels(page.pixels(), {10, 20, 30, 40}, kBlack, kWhite), 0);
  std::array<float, 16> two = {10, 20, 40, 20, 40, 60, 10, 60, 100, 20, 130, 20, 130, 60, 100, 60};
  page.device->DrawQuad(two.data(), 8);
  EXPECT_EQ(pixel_at(page.pixels(), 115, 40), kBlack);
  EXPECT_NEAR(ink_area(page.pixels()), 2.0 * 30.0 * 40.0, 0.1);
}

TEST_F(Device, ATransparentBrushFillsNothing) {
  page.painter->GetBrush()->SetColor(0, 0, 0, 0);
  fill(10, 10, 50, 50);
  EXPECT_EQ(page.ink(), PageRect{});
}

TEST_F(Device, MarkersAreCentredAndAsLargeAsThePen) {
  struct Shape {
    int shape;
    double area;  ///< In squares of its size; below zero where it does not matter.
  };
  constexpr double kCrossArms = 2.0 * 0.28 - 0.28 * 0.28;
  for (const auto& [shape, area] :
       {Shape{VTK_MARKER_SQUARE, 1.0}, Shape{VTK_MARKER_DIAMOND, 0.5},
        Shape{VTK_MARKER_CIRCLE, std::numbers::pi / 4.0}, Shape{VTK_MARKER_PLUS, kCrossArms},
        Shape{VTK_MARKER_CROSS, -1.0}}) {
    DevicePage drawn(200, 150);
    drawn.painter->GetPen()->SetWidth(40.0F);
    std::array<float, 2> point = {100, 70};
    drawn.device->DrawMarkers(shape, false, point.data(), 1, nullptr, 0);
    const PageRect ink = drawn.ink();
    EXPECT_NEAR(ink.centre().x(), 100, 1.0) << shape;
    EXPECT_NEAR(ink.centre().y(), 70, 1.0) << shape;
    EXPECT_NEAR(ink.width, 40.0, 2.0 + (area < 0.0 ? 4.0 : 0.0)) << shape;
    if (area > 0.0) {
      // Two bars that cross are drawn one after the other, with the middle only once.
      EXPECT_NEAR(ink_area(drawn.pixels()), area * 1600.0, 16.0) << shape;
    }
  }
}

TEST_F(Device, MarkersStandOnTransformedPointsInTheirOwnColours) {
  const vtkNew<vtkTransform2D> twice;
  twice->Scale(2, 2);
  page.painter->SetTransform(twice);
  page.painter->GetPen()->SetWidth(8.0F);
  std::array<float, 4> points = {20, 20, 60, 40};
  std::array<unsigned char, 8> colours = {255, 0, 0, 255, 0, 0, 255, 128};
  page.device->DrawMarkers(VTK_MARKER_SQUARE, false, points.data(), 2, colours.data(), 4);
  EXPECT_EQ(pixel_at(page.pixels(), 40, 40), kRed);
  EXPECT_LE(difference(pixel_at(page.pixels(), 120, 80), {127, 127, 255}), 1);
  EXPECT_EQ(pixel_at(page.pixels(), 46, 40), kWhite);  // the marker itself is not doubled
}

TEST_F(Device, ClippingStartsAndStops) {
  clip({20, 30, 50, 40});
  fill(0, 0, 200, 150);
  EXPECT_EQ(wrong_pixels(page.pixels(), {20, 30, 50, 40}, kBlack, kWhite), 0);
  page.device->DisableClipping();
  page.painter->GetBrush()->SetColor(255, 0, 0, 255);
  fill(0, 0, 200, 150);
  EXPECT_EQ(wrong_pixels(page.pixels(), {0, 0, 200, 150}, kRed, kWhite), 0);
}

TEST_F(Device, AClipBoxAloneClipsNothing) {
  clip({20, 30, 50, 40}, false);
  fill(0, 0, 200, 150);
  EXPECT_EQ(wrong_pixels(page.pixels(), {0, 0, 200, 150}, kBlack, kWhite), 0);
}

TEST_F(Device, ClippingTwiceReplacesTheFirstBox) {
  clip({20, 30, 50, 40});
  clip({60, 30, 50, 40});
  fill(0, 0, 200, 150);
  EXPECT_EQ(wrong_pixels(page.pixels(), {60, 30, 50, 40}, kBlack, kWhite), 0);
}

// As VTK's own device does, which hands the box to OpenGL at once.
TEST_F(Device, AClipBoxSetWhileClippingTakesEffect) {
  clip({20, 30, 50, 40});
  std::array<int, 4> box = {60, 30, 50, 40};
  page.device->SetClipping(box.data());
  fill(0, 0, 200, 150);
  EXPECT_EQ(wrong_pixels(page.pixels(), {60, 30, 50, 40}, kBlack, kWhite), 0);
}

TEST_F(Device, ANewPageBeginsWithoutWhatTheLastOneLeft) {
  clip({20, 30, 50, 40});
  const vtkNew<vtkTransform2D> far;
  far->Translate(1000, 1000);
  page.painter->SetTransform(far);
  SvgCanvas svg(200, 150, 96.0, "t", "");
  page.device->draw_on(svg, 200, 150);
  page.device->DisableClipping();  // would close a group that this page has not
  fill(1, 2, 3, 4);
  EXPECT_THAT(svg.finish(), testing::HasSubstr("points=\"1,148 4,148 4,144 1,144\""));
}

TEST_F(Device, AnEllipseHasItsArea) {
  page.painter->GetPen()->SetLineType(vtkPen::NO_PEN);
  page.painter->DrawEllipse(100, 75, 60, 30);
  EXPECT_NEAR(ink_area(page.pixels()), std::numbers::pi * 60 * 30, 0.005 * std::numbers::pi * 1800);
  expect_ink({40, 45, 120, 60}, 1.0);
}

TEST_F(Device, AWedgeLiesBetweenItsRadiiAndAngles) {
  page.painter->GetPen()->SetLineType(vtkPen::NO_PEN);
  page.painter->DrawEllipseWedge(100, 50, 60, 60, 30, 30, 0, 90);
  EXPECT_NEAR(ink_area(page.pixels()), std::numbers::pi * (3600 - 900) / 4.0, 25.0);
  expect_ink({100, 50, 60, 60}, 1.0);
  DevicePage ring(200, 150);
  ring.painter->GetPen()->SetLineType(vtkPen::NO_PEN);
  ring.painter->DrawEllipseWedge(100, 75, 60, 60, 30, 30, 0, 360);
  EXPECT_EQ(pixel_at(ring.pixels(), 100, 75), kWhite);
  EXPECT_NEAR(ink_area(ring.pixels()), std::numbers::pi * 2700, 60.0);
}

TEST_F(Device, AnImageFillsItsRectangleTopRowOnTop) {
  Raster<Rgba> image(2, 2);
  image.at(0, 0) = kRed;
  image.at(1, 0) = kGreen;
  image.at(0, 1) = kBlue;
  const auto vtk = vtk_image_of(image);
  page.painter->DrawImage(vtkRectf(40, 30, 20, 10), vtk);
  EXPECT_EQ(pixel_at(page.pixels(), 41, 39), kRed);
  EXPECT_EQ(pixel_at(page.pixels(), 59, 36), kGreen);
  EXPECT_EQ(pixel_at(page.pixels(), 41, 31), kBlue);
  EXPECT_EQ(pixel_at(page.pixels(), 59, 34), kBlack);
  expect_ink({40, 30, 20, 10}, 0.0);
}

TEST_F(Device, AnImageAtAPointIsScaled) {
  page.painter->DrawImage(100.0F, 20.0F, 3.0F, vtk_image_of(Raster<Rgba>(4, 2, kRed)));
  EXPECT_EQ(wrong_pixels(page.pixels(), {100, 20, 12, 6}, kRed, kWhite), 0);
}

}  // namespace canvas_device_test
}  // namespace nadir
