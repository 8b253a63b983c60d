// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <cstdlib>

#include "tests/support/error_text.h"
#include "tests/widgets/kit/demo_sheet.h"
#include "widgets/canvas/png_file.h"
#include "widgets/gl/offscreen_context.h"
#include "widgets/kit/headless_ui.h"
#include "widgets/kit/ui_look.h"
#include "widgets/kit/ui_renderer.h"

namespace nadir::kit {
namespace rendering_test {

/// Draws frames with a graphics context of its own, which needs no display.
class Rendering : public testing::Test {
 protected:
  Rendering() {
    auto made = OffscreenContext::create();
    if (made) opengl_ = std::move(*made);
  }

  /// The picture of a frame drawn three times: windows take two to know their size.
  template <class Draw>
  Raster<Rgba> picture(UiContext& context, const FrameInput& input, const Draw& draw) {
    EXPECT_NE(opengl_, nullptr);
    for (int i = 0; i < 3; ++i) {
      draw(context.begin_frame(input));
      context.end_frame();
    }
    auto renderer = UiRenderer::create(context);
    EXPECT_TRUE(renderer) << error_text(renderer);
    auto pixels = (*renderer)->draw_to_pixels();
    EXPECT_TRUE(pixels) << error_text(pixels);
    return *pixels;
  }

  /// Where NADIR_UI_PICTURES names a folder, everybody may look.
  static void keep(const Raster<Rgba>& pixels, const std::string& name) {
    const char* const folder =
        std::getenv("NADIR_UI_PICTURES");  // NOLINT(concurrency-mt-unsafe): nobody sets any
    if (folder == nullptr) return;
    std::ofstream(std::filesystem::path(folder) / (name + ".png"), std::ios::binary)
        << encode_png(pixels);
  }

  std::unique_ptr<OffscreenContext> opengl_;
};

TEST_F(Rendering, ShowsTheDemoSheetInBothThemesAtSeveralScales) {
  for (const ThemeName theme : {ThemeName::kDark, ThemeName::kLight}) {
    for (const double scale : {1.0, 1.5}) {
      UiContext context(theme, scale);
      context.set_motion_reduced(true);
      DemoSheet sheet;
      sheet.shows_palette = scale > 1.0 && theme == ThemeName::kLight;
      FrameInput input;
      input.size_px = {1280.0 * scale, 800.0 * scale};
      const Raster<Rgba> pixels = picture(context, input, [&sheet](Ui& ui) { sheet.draw(ui); });
      keep(pixels, fmt::format("demo-{}-{:.0f}", enum_name(theme), 100.0 * scale));
      ASSERT_EQ(pixels.width(), static_cast<int>(1280.0 * scale));
      // The menu bar's free middle is panel, nothing else.
      if (!sheet.shows_palette) {
        EXPECT_EQ(pixels.at(static_cast<int>(900 * scale), static_cast<int>(20 * scale)),
                  nadir::theme(theme).page);
      }
    }
  }
}

/// Where a picture has this colour, in a rectangle.
int count_of(const Raster<Rgba>& pixels, const Rect& where, Rgba colour) {
  int found = 0;
  for (int row = static_cast<int>(where.top); row < static_cast<int>(where.bottom()); ++row) {
    for (int column = static_cast<int>(where.left); column < static_cast<int>(where.right());
         ++column) {
      found += pixels.at(column, row) == colour ? 1 : 0;
    }
  }
  return found;
}

TEST_F(Rendering, WritesTextThatCanBeReadInBothThemes) {
  for (const ThemeName name : {ThemeName::kLight, ThemeName::kDark}) {
    UiContext context(name);
    FrameInput input;
    input.size_px = {200.0, 60.0};
    const Raster<Rgba> pixels = picture(context, input, [](Ui& ui) {
      const auto region = ui.region("R", ui.screen());
      ui.text("HHHH");
    });
    double most = 0.0;
    for (const Rgba& colour : pixels.values())
      most = std::max(most, contrast(colour, theme(name).page));
    EXPECT_GE(most, 4.5);
    EXPECT_EQ(pixels.at(199, 59), theme(name).page);
  }
}

TEST_F(Rendering, OfTheSameFrameIsTheSameEachTime) {
  UiContext context(ThemeName::kDark);
  context.set_motion_reduced(true);
  FrameInput input;
  DemoSheet sheet;
  const auto draw = [&sheet](Ui& ui) { sheet.draw(ui); };
  EXPECT_EQ(picture(context, input, draw), picture(context, input, draw));
}

TEST_F(Rendering, ShowsPicturesAndShapesOfTheCanvas) {
  UiContext context(ThemeName::kLight);
  FrameInput input;
  input.size_px = {300.0, 200.0};
  Raster<Rgba> colours(64, 64);
  for (int row = 0; row < 64; ++row) {
    for (int column = 0; column < 64; ++column) {
      colours.at(column, row) = {static_cast<std::uint8_t>(4 * column),
                                 static_cast<std::uint8_t>(4 * row), 77};
    }
  }
  const Rgba ink{200, 0, 100};
  const Raster<Rgba> pixels = picture(context, input, [&](Ui& ui) {
    RegionStyle style;
    style.padding = 0.0;
    const auto region = ui.region("R", ui.screen(), style);
    (void)ui.area("map");
    ui.canvas().image({0.0, 0.0, 64.0, 64.0}, colours);
    ui.canvas().fill(
        std::vector<Eigen::Vector2d>{
            {100, 100}, {160, 100}, {160, 120}, {120, 120}, {120, 160}, {100, 160}},
        ink);
  });
  keep(pixels, "canvas");
  // Its top row is on top: row 136 of the window.
  EXPECT_EQ(pixels.at(10, 136), colours.at(10, 0));
  EXPECT_EQ(pixels.at(63, 199), colours.at(63, 63));
  EXPECT_NEAR(count_of(pixels, {90.0, 30.0, 100.0, 100.0}, ink), 60 * 20 + 20 * 40, 40);
  EXPECT_FALSE(pixels.at(140, 60) == ink) << "outside of the L";
}

TEST_F(Rendering, FollowsTheLookToAnotherScale) {
  UiContext context(ThemeName::kLight);
  FrameInput input;
  input.size_px = {300.0, 100.0};
  const auto draw = [](Ui& ui) {
    const auto region = ui.region("R", ui.screen());
    (void)ui.button("Localise", ButtonLook::kPrimary);
  };
  const Rgba accent = theme(ThemeName::kLight).accent;
  const int small = count_of(picture(context, input, draw), {0.0, 0.0, 300.0, 100.0}, accent);
  context.set_look(ThemeName::kLight, 2.0);
  const int large = count_of(picture(context, input, draw), {0.0, 0.0, 300.0, 100.0}, accent);
  EXPECT_NEAR(static_cast<double>(large) / small, 4.0, 0.6);
}

TEST_F(Rendering, RefusesPicturesLargerThanOpenGlDraws) {
  UiContext context;
  FrameInput input;
  input.size_px = {100'000.0, 10.0};
  context.begin_frame(input).text("wide");
  context.end_frame();
  auto renderer = UiRenderer::create(context);
  ASSERT_TRUE(renderer) << error_text(renderer);
  const auto pixels = (*renderer)->draw_to_pixels();
  EXPECT_EQ(error_code(pixels), ErrorCode::kUnsupported);
  EXPECT_THAT(
      error_text(pixels),
      testing::StartsWith("a picture of 100000 x 10 pixels is larger than OpenGL can draw"));
}

}  // namespace rendering_test
}  // namespace nadir::kit
