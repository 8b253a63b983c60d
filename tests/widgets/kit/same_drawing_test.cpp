// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <cstdlib>

#include "tests/support/error_text.h"
#include "tests/widgets/views/sample_charts.h"
#include "widgets/canvas/cairo_canvas.h"
#include "widgets/canvas/png_file.h"
#include "widgets/gl/offscreen_context.h"
#include "widgets/kit/ui_context.h"
#include "widgets/kit/ui_renderer.h"
#include "widgets/views/map_furniture.h"
#include "widgets/views/map_overlays.h"
#include "widgets/views/mode_marks.h"

namespace nadir::kit {
namespace same_drawing_test {

/// Draws the same on a figure's canvas and in the window, and compares pixels.
class SameDrawing : public testing::Test {
 protected:
  using Draw = std::function<void(Canvas&)>;

  SameDrawing() {
    auto made = OffscreenContext::create();
    if (made) opengl_ = std::move(*made);
  }

  static Raster<Rgba> on_paper(const Draw& draw) {
    const auto canvas = CairoCanvas::for_pixels(kPageWidth, kPageHeight, light_theme().page);
    draw(*canvas);
    return canvas->pixels();
  }

  Raster<Rgba> in_window(const Draw& draw) {
    EXPECT_NE(opengl_, nullptr);
    UiContext context(ThemeName::kLight);
    FrameInput input;
    input.size_px = {kPageWidth, kPageHeight};
    for (int i = 0; i < 2; ++i) {
      Ui& ui = context.begin_frame(input);
      {
        RegionStyle style;
        style.padding = 0.0;
        const auto region = ui.region("Page", ui.screen(), style);
        (void)ui.area("page");
        draw(ui.canvas());
      }
      context.end_frame();
    }
    auto renderer = UiRenderer::create(context);
    EXPECT_TRUE(renderer) << error_text(renderer);
    auto pixels = (*renderer)->draw_to_pixels();
    EXPECT_TRUE(pixels) << error_text(pixels);
    return *pixels;
  }

  /// Mean of 3 x 3 pixels: how edges and letters are smoothed does not count, where they lie does.
  static double lightness(const Raster<Rgba>& pixels, int column, int row) {
    double sum = 0.0;
    for (int y = row - 1; y <= row + 1; ++y) {
      for (int x = column - 1; x <= column + 1; ++x) {
        const Rgba colour = pixels.at(x, y);
        sum += colour.red + colour.green + colour.blue;
      }
    }
    return sum / (27.0 * 255.0);
  }

  void expect_same(const Draw& draw, const std::string& name) {
    const Raster<Rgba> paper = on_paper(draw);
    const Raster<Rgba> window = in_window(draw);
    if (const char* const folder = std::getenv("NADIR_UI_PICTURES");
        folder != nullptr) {  // NOLINT(concurrency-mt-unsafe)
      std::ofstream(std::filesystem::path(folder) / (name + "-paper.png"), std::ios::binary)
          << encode_png(paper);
      std::ofstream(std::filesystem::path(folder) / (name + "-window.png"), std::ios::binary)
          << encode_png(window);
    }
    ASSERT_EQ(window.width(), paper.width());
    int inked = 0;
    int different = 0;
    for (int row = 1; row + 1 < paper.height(); ++row) {
      for (int column = 1; column + 1 < paper.width(); ++column) {
        const double there = lightness(paper, column, row);
        if (there < 0.99) ++inked;
        if (std::abs(lightness(window, column, row) - there) > 0.22) ++different;
      }
    }
    EXPECT_GT(inked, 500);
    EXPECT_LT(different, 0.02 * inked) << "of " << inked;
  }

  std::unique_ptr<OffscreenContext> opengl_;
};

MapFrame frame_of_page() {
  return {{0.0, 0.0, kPageWidth, kPageHeight}, {{100.0, 50.0}, 0.5}, kPxPerPt};
}

TEST_F(SameDrawing, OfACurveWithItsBand) {
  const XyChart chart(sample_chart(), light_theme(), kPxPerPt);
  expect_same([&chart](Canvas& canvas) { chart.draw(canvas, kChartRoom, kPageWidth, kPageHeight); },
              "chart");
}

TEST_F(SameDrawing, OfBars) {
  const XyChart chart(sample_bars(), light_theme(), kPxPerPt);
  expect_same([&chart](Canvas& canvas) { chart.draw(canvas, kChartRoom, kPageWidth, kPageHeight); },
              "bars");
}

TEST_F(SameDrawing, OfPathsMarksAndEllipses) {
  std::vector<Eigen::Vector2d> path;
  for (int i = 0; i < 200; ++i) {
    path.emplace_back(100.0 + 90.0 * std::cos(0.05 * i),
                      50.0 + 0.6 * (i - 100) * std::sin(0.05 * i));
  }
  expect_same(
      [&path](Canvas& canvas) {
        const MapFrame frame = frame_of_page();
        const PathLook solid{light_theme().estimate, 2.5, false, {255, 255, 255}};
        const PathLook dashed{light_theme().odometry, 2.0, true, {20, 23, 26}};
        draw_path(canvas, frame, path, solid);
        draw_path(canvas, frame, {path.data(), 80}, dashed);
        draw_path_mark(canvas, frame, PathMark::kStart, path.front(), 0.0, solid);
        draw_path_mark(canvas, frame, PathMark::kEnd, path.back(), 0.0, solid);
        Eigen::Matrix2d covariance;
        covariance << 90.0, 40.0, 40.0, 60.0;
        const std::vector<double> sigmas = {1.0, 3.0};
        draw_ellipses(canvas, frame, {110.0, 60.0}, covariance, sigmas, solid);
        draw_pose(canvas, frame, {70.0, 60.0, 0.6}, 14.0, solid);
      },
      "overlays");
}

TEST_F(SameDrawing, OfModesScaleBarAndNorth) {
  expect_same(
      [](Canvas& canvas) {
        const MapFrame frame = frame_of_page();
        ModeLook look;
        look.arrow = {light_theme().estimate, 1.0};
        look.plate = light_theme().page;
        look.words.colour = light_theme().text;
        const std::vector<PoseMode> modes = {
            {0.62, {{60.0, 40.0, 0.3}, Eigen::Matrix3d::Identity()}},
            {0.38, {{150.0, 70.0, 2.0}, Eigen::Matrix3d::Identity()}}};
        draw_modes(canvas, frame, modes, look);
        draw_scale_bar(canvas, frame, light_theme());
        draw_north_arrow(canvas, frame, light_theme());
      },
      "modes");
}

}  // namespace same_drawing_test
}  // namespace nadir::kit
