// SPDX-License-Identifier: Apache-2.0
#include "widgets/gl/offscreen_renderer.h"

#include <gmock/gmock.h>
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCameraPass.h>
#include <vtkOpaquePass.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderPassCollection.h>
#include <vtkRenderer.h>
#include <vtkSequencePass.h>
#include <vtkTranslucentPass.h>

#include <cstdlib>
#include <stdexcept>

#include "tests/support/error_text.h"
#include "tests/support/page_pixels.h"

namespace nadir {
namespace offscreen_renderer_test {

/// Rectangles on a page: a unit of the scene is a pixel of a picture of that size, the origin its lower left corner.
struct FlatScene {
  FlatScene(int width, int height) {
    renderer->SetBackground(0.0, 0.0, 0.0);
    renderer->SetBackgroundAlpha(0.0);
    vtkCamera* const camera = renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetFocalPoint(width / 2.0, height / 2.0, 0.0);
    camera->SetPosition(width / 2.0, height / 2.0, 10.0);
    camera->SetViewUp(0.0, 1.0, 0.0);
    camera->SetParallelScale(height / 2.0);
    camera->SetClippingRange(1.0, 20.0);
    // One layer over the other. VTK's usual way averages transparent things, for it does not know their order.
    const vtkNew<vtkRenderPassCollection> steps;
    steps->AddItem(vtkNew<vtkOpaquePass>());
    steps->AddItem(vtkNew<vtkTranslucentPass>());
    const vtkNew<vtkSequencePass> sequence;
    sequence->SetPasses(steps);
    const vtkNew<vtkCameraPass> pass;
    pass->SetDelegatePass(sequence);
    renderer->SetPass(pass);
  }

  void add(const PageRect& area, Rgba colour) const {
    const vtkNew<vtkPlaneSource> plane;
    plane->SetOrigin(area.left, area.bottom, 0.0);
    plane->SetPoint1(area.right(), area.bottom, 0.0);
    plane->SetPoint2(area.left, area.top(), 0.0);
    const vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(plane->GetOutputPort());
    const vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->LightingOff();
    actor->GetProperty()->SetColor(colour.red / 255.0, colour.green / 255.0, colour.blue / 255.0);
    actor->GetProperty()->SetOpacity(colour.alpha / 255.0);
    renderer->AddActor(actor);
  }

  vtkNew<vtkRenderer> renderer;
};

class Offscreen : public testing::Test {
 protected:
  void SetUp() override {
    auto made = OffscreenRenderer::create();
    ASSERT_TRUE(made) << error_text(made);
    offscreen = std::move(*made);
  }
  [[nodiscard]] Raster<Rgba> draw(const FlatScene& scene,
                                  int width,
                                  int height,
                                  int supersampling = 1) const {
    auto drawn = offscreen->render(*scene.renderer, width, height, supersampling);
    EXPECT_TRUE(drawn) << error_text(drawn);
    return drawn ? *drawn : Raster<Rgba>(width, height);
  }

  std::unique_ptr<OffscreenRenderer> offscreen;
};

TEST_F(Offscreen, NeedsNoDisplay) {
  // Set by CTest; whoever calls the program by hand may have one.
  if (std::getenv("DISPLAY") != nullptr) {  // NOLINT(concurrency-mt-unsafe): tests set no variables
    GTEST_SKIP() << "DISPLAY is set";
  }
  EXPECT_EQ(draw(FlatScene(4, 4), 4, 4), Raster<Rgba>(4, 4, kNothing));
}

TEST_F(Offscreen, ARectangleCoversItsPixelsUprightAndNotMirrored) {
  const FlatScene scene(40, 30);
  scene.add({4, 2, 9, 5}, {200, 100, 50});
  EXPECT_EQ(wrong_pixels(draw(scene, 40, 30), {4, 2, 9, 5}, {200, 100, 50}, kNothing), 0);
}

TEST_F(Offscreen, ABackgroundFillsThePicture) {
  const FlatScene scene(40, 30);
  scene.add({4, 2, 9, 5}, kRed);
  scene.renderer->SetBackground(1.0, 1.0, 1.0);
  scene.renderer->SetBackgroundAlpha(1.0);
  EXPECT_EQ(wrong_pixels(draw(scene, 40, 30), {4, 2, 9, 5}, kRed, kWhite), 0);
}

TEST_F(Offscreen, WhatIsHalfTransparentKeepsItsColourOverNothing) {
  const FlatScene scene(40, 30);
  scene.add({4, 2, 9, 5}, {200, 100, 50, 128});
  const Raster<Rgba> drawn = draw(scene, 40, 30);
  EXPECT_LE(difference(pixel_at(drawn, 6, 4), {200, 100, 50, 128}), 2)
      << testing::PrintToString(pixel_at(drawn, 6, 4));
  EXPECT_EQ(pixel_at(drawn, 20, 20), kNothing);
}

TEST_F(Offscreen, WhatIsHalfTransparentMixesWithTheBackground) {
  const FlatScene scene(40, 30);
  scene.add({4, 2, 9, 5}, {200, 100, 50, 128});
  scene.renderer->SetBackground(1.0, 1.0, 1.0);
  scene.renderer->SetBackgroundAlpha(1.0);
  const Rgba mixed = pixel_at(draw(scene, 40, 30), 6, 4);
  EXPECT_LE(difference(mixed, {227, 177, 152, 255}), 1) << testing::PrintToString(mixed);
}

TEST_F(Offscreen, DrawsTheSameBytesTwice) {
  const FlatScene scene(40, 30);
  scene.add({4.3, 2.7, 9.1, 5.9}, {200, 100, 50, 77});
  scene.add({6.1, 4.2, 19.4, 7.3}, {20, 110, 250, 177});
  const Raster<Rgba> first = draw(scene, 80, 60, 3);
  EXPECT_EQ(draw(scene, 80, 60, 3), first);
  // And so does another one, in another context.
  auto other = OffscreenRenderer::create();
  ASSERT_TRUE(other) << error_text(other);
  EXPECT_EQ((*other)->render(*scene.renderer, 80, 60, 3).value(), first);
}

TEST_F(Offscreen, SupersamplingAveragesWhatAPixelHolds) {
  const FlatScene scene(40, 30);
  scene.add({4.5, 2.25, 9, 5}, kRed);
  const Raster<Rgba> over_nothing = draw(scene, 40, 30, 4);
  EXPECT_EQ(pixel_at(over_nothing, 8, 4), kRed);
  EXPECT_LE(difference(pixel_at(over_nothing, 4.5, 4.5), {255, 0, 0, 128}), 2);  // half of it red
  EXPECT_LE(difference(pixel_at(over_nothing, 8.5, 2.5), {255, 0, 0, 191}), 2);  // three quarters
  EXPECT_LE(difference(pixel_at(over_nothing, 4.5, 2.5), {255, 0, 0, 96}), 2);
  EXPECT_EQ(pixel_at(over_nothing, 20, 20), kNothing);
  scene.renderer->SetBackground(1.0, 1.0, 1.0);
  scene.renderer->SetBackgroundAlpha(1.0);
  const Raster<Rgba> over_white = draw(scene, 40, 30, 4);
  EXPECT_LE(difference(pixel_at(over_white, 4.5, 4.5), {255, 128, 128}), 2);
  EXPECT_LE(difference(pixel_at(over_white, 8.5, 2.5), {255, 64, 64}), 2);
  EXPECT_EQ(pixel_at(over_white, 20, 20), kWhite);
}

TEST_F(Offscreen, SupersamplingChangesNothingWhereEdgesLieBetweenPixels) {
  const FlatScene scene(40, 30);
  scene.add({4, 2, 9, 5}, {200, 100, 50});
  EXPECT_EQ(draw(scene, 40, 30, 3), draw(scene, 40, 30));
}

TEST_F(Offscreen, DrawsEachSizeThatItIsAskedFor) {
  const FlatScene scene(40, 30);
  scene.add({4, 2, 9, 5}, kRed);
  for (const int factor : {3, 1, 2, 5, 1}) {
    const PageRect area{4.0 * factor, 2.0 * factor, 9.0 * factor, 5.0 * factor};
    const Raster<Rgba> drawn = draw(scene, 40 * factor, 30 * factor);
    ASSERT_EQ(drawn.width(), 40 * factor);
    EXPECT_EQ(wrong_pixels(drawn, area, kRed, kNothing), 0) << factor;
  }
}

TEST_F(Offscreen, DrawsOneSceneAfterAnotherAndNoneOverTheOther) {
  const FlatScene red(40, 30);
  red.add({4, 2, 9, 5}, kRed);
  const FlatScene blue(40, 30);
  blue.add({20, 20, 9, 5}, kBlue);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(wrong_pixels(draw(red, 40, 30), {4, 2, 9, 5}, kRed, kNothing), 0);
    EXPECT_EQ(wrong_pixels(draw(blue, 40, 30), {20, 20, 9, 5}, kBlue, kNothing), 0);
  }
}

TEST_F(Offscreen, ASceneMayGoFirst) {
  {
    const FlatScene scene(40, 30);
    scene.add({4, 2, 9, 5}, kRed);
    (void)draw(scene, 40, 30);
  }
  const FlatScene scene(40, 30);
  scene.add({4, 2, 9, 5}, kGreen);
  EXPECT_EQ(wrong_pixels(draw(scene, 40, 30), {4, 2, 9, 5}, kGreen, kNothing), 0);
}

TEST_F(Offscreen, TwoDrawInTurn) {
  auto other = OffscreenRenderer::create();
  ASSERT_TRUE(other) << error_text(other);
  const FlatScene red(40, 30);
  red.add({4, 2, 9, 5}, kRed);
  const FlatScene blue(20, 10);
  blue.add({2, 3, 9, 5}, kBlue);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(wrong_pixels(draw(red, 40, 30), {4, 2, 9, 5}, kRed, kNothing), 0);
    EXPECT_EQ(wrong_pixels((*other)->render(*blue.renderer, 20, 10).value(), {2, 3, 9, 5}, kBlue,
                           kNothing),
              0);
  }
  // What one has drawn the other can draw when the first is gone.
  offscreen.reset();
  EXPECT_EQ(
      wrong_pixels((*other)->render(*red.renderer, 40, 30).value(), {4, 2, 9, 5}, kRed, kNothing),
      0);
}

TEST_F(Offscreen, TooLargeAPictureIsAnErrorAfterWhichItStillDraws) {
  const FlatScene scene(40, 30);
  scene.add({4, 2, 9, 5}, kRed);
  struct Size {
    int width, height, supersampling;
  };
  for (const auto& [width, height, supersampling] :
       {Size{16'385, 1, 1}, Size{1, 16'385, 1}, Size{8'193, 4, 2}, Size{100'000, 100'000, 1}}) {
    const auto drawn = offscreen->render(*scene.renderer, width, height, supersampling);
    ASSERT_FALSE(drawn) << width;
    EXPECT_EQ(error_code(drawn), ErrorCode::kUnsupported);
    EXPECT_EQ(error_text(drawn), std::to_string(width * supersampling) + " x " +
                                     std::to_string(height * supersampling) +
                                     " pixels are more than OpenGL can draw at once");
  }
  EXPECT_EQ(wrong_pixels(draw(scene, 40, 30), {4, 2, 9, 5}, kRed, kNothing), 0);
}

TEST_F(Offscreen, TheLargestPictureIsDrawnToItsEnd) {
  constexpr int kLargest = 16'384;
  const FlatScene scene(kLargest, 2);
  scene.add({kLargest - 3.0, 0, 2, 1}, kRed);
  EXPECT_EQ(wrong_pixels(draw(scene, kLargest, 2), {kLargest - 3.0, 0, 2, 1}, kRed, kNothing), 0);
}

TEST_F(Offscreen, APictureWithoutPixelsIsABrokenPrecondition) {
  const FlatScene scene(40, 30);
  EXPECT_THROW((void)offscreen->render(*scene.renderer, 0, 30), std::logic_error);
  EXPECT_THROW((void)offscreen->render(*scene.renderer, 40, -1), std::logic_error);
  EXPECT_THROW((void)offscreen->render(*scene.renderer, 40, 30, 0), std::logic_error);
}

}  // namespace offscreen_renderer_test
}  // namespace nadir
