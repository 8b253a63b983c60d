// SPDX-License-Identifier: Apache-2.0
#include "widgets/kit/ui_canvas.h"

#include <gmock/gmock.h>
#include <imgui.h>

#include <limits>
#include <numbers>

#include "widgets/kit/headless_ui.h"

namespace nadir::kit {
namespace ui_canvas_test {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
const Rgba kInk{10, 20, 30};

double area_of(const std::vector<Eigen::Vector2d>& triangles) {
  double area = 0.0;
  for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
    const Eigen::Vector2d a = triangles[i + 1] - triangles[i];
    const Eigen::Vector2d b = triangles[i + 2] - triangles[i];
    area += std::abs(a.x() * b.y() - a.y() * b.x()) / 2.0;
  }
  return area;
}

TEST(TrianglesInside, CoverAConcaveOutlineOnce) {
  // An L of three unit squares, times 10.
  const std::vector<Eigen::Vector2d> outline = {{0, 0},   {20, 0},  {20, 10},
                                                {10, 10}, {10, 20}, {0, 20}};
  EXPECT_DOUBLE_EQ(area_of(triangles_inside(outline)), 300.0);
}

TEST(TrianglesInside, AreEvenOddWhereAnOutlineCrossesItself) {
  const std::vector<Eigen::Vector2d> bow_tie = {{0, 0}, {10, 10}, {10, 0}, {0, 10}};
  EXPECT_NEAR(area_of(triangles_inside(bow_tie)), 50.0, 1e-9);
  std::vector<Eigen::Vector2d> star;
  for (int i = 0; i < 5; ++i) {
    const double angle = 4.0 * std::numbers::pi * i / 5.0;
    star.emplace_back(std::sin(angle), std::cos(angle));
  }
  // Once around its five points less the pentagon in the middle, which is smaller by the golden ratio squared.
  const double outline = 1.1225699;
  const double pentagon = 2.5 * std::pow(0.381966, 2.0) * std::sin(2.0 * std::numbers::pi / 5.0);
  EXPECT_NEAR(area_of(triangles_inside(star)), outline - pentagon, 1e-5);
}

TEST(TrianglesInside, LeaveOutPointsThatAreNotFinite) {
  const std::vector<Eigen::Vector2d> outline = {{0, 0}, {4, 0}, {kNan, 3}, {4, 4}, {0, 4}};
  EXPECT_DOUBLE_EQ(area_of(triangles_inside(outline)), 16.0);
  EXPECT_TRUE(triangles_inside(std::vector<Eigen::Vector2d>{{0, 0}, {1, 0}}).empty());
}

TEST(Dashed, CutsALineByItsLength) {
  const std::vector<Eigen::Vector2d> line = {{0, 0}, {10, 0}, {10, 10}};
  const auto pieces = dashed(line, std::vector<double>{6, 4});
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_THAT(pieces[0], testing::ElementsAre(Eigen::Vector2d(0, 0), Eigen::Vector2d(6, 0)));
  EXPECT_EQ(pieces[1].front(), Eigen::Vector2d(10, 0));
  EXPECT_EQ(pieces[1].back(), Eigen::Vector2d(10, 6));
}

TEST(Dashed, GoesRoundCornersAndBeginsWhereItIsTold) {
  const std::vector<Eigen::Vector2d> line = {{0, 0}, {10, 0}, {10, 10}};
  const auto pieces = dashed(line, std::vector<double>{6, 4}, 2.0);
  ASSERT_EQ(pieces.size(), 3U);
  EXPECT_EQ(pieces[0].back(), Eigen::Vector2d(4, 0));
  EXPECT_THAT(pieces[1], testing::ElementsAre(Eigen::Vector2d(8, 0), Eigen::Vector2d(10, 0),
                                              Eigen::Vector2d(10, 4)));
  EXPECT_THAT(dashed(line, std::vector<double>{}), testing::SizeIs(1));
  EXPECT_EQ(dashed(line, std::vector<double>{5}).size(), 2U) << "5 on, 5 off";
}

/// Draws on a canvas of 200 x 100 at (50, 30) of the window and looks at the list of triangles.
class DrawnOnUi : public testing::Test {
 protected:
  template <class Draw>
  void draw(const Draw& draw_on) {
    HeadlessUi screen;
    screen.frame([&](Ui&) {
      ImDrawList list(ImGui::GetDrawListSharedData());
      list._ResetForNewFrame();
      list.PushClipRectFullScreen();
      list.PushTextureID(UiPictures::font_id());
      UiPictures pictures;
      UiCanvas canvas(list, {50.0, 30.0, 200.0, 100.0}, *FontSet::of_scale(1.0), pictures);
      draw_on(canvas);
      for (const ImDrawVert& vertex : list.VtxBuffer) {
        points.emplace_back(vertex.pos.x, vertex.pos.y);
        colours.push_back(vertex.col);
      }
      for (const ImDrawCmd& command : list.CmdBuffer) {
        if (command.ElemCount > 0)
          clips.push_back({command.ClipRect.x, command.ClipRect.y,
                           command.ClipRect.z - command.ClipRect.x,
                           command.ClipRect.w - command.ClipRect.y});
      }
      picture_count = pictures.all().size();
    });
  }
  [[nodiscard]] Rect bounds() const {
    double left = 1e9;
    double top = 1e9;
    double right = -1e9;
    double bottom = -1e9;
    for (const auto& point : points) {
      left = std::min(left, point.x());
      right = std::max(right, point.x());
      top = std::min(top, point.y());
      bottom = std::max(bottom, point.y());
    }
    return {left, top, right - left, bottom - top};
  }

  std::vector<Eigen::Vector2d> points;
  std::vector<ImU32> colours;
  std::vector<Rect> clips;
  std::size_t picture_count = 0;
};

TEST_F(DrawnOnUi, PagesCountUpFromTheAreasLowerLeftCorner) {
  draw([](Canvas& canvas) {
    canvas.fill(std::vector<Eigen::Vector2d>{{0, 0}, {10, 0}, {10, 20}, {0, 20}}, kInk);
  });
  const Rect drawn = bounds();
  EXPECT_NEAR(drawn.left, 50.0, 1.0);
  EXPECT_NEAR(drawn.bottom(), 130.0, 1.0);
  EXPECT_NEAR(drawn.top, 110.0, 1.0);
  EXPECT_NEAR(drawn.right(), 60.0, 1.0);
  EXPECT_THAT(clips, testing::ElementsAre(Rect{50.0, 30.0, 200.0, 100.0}));
}

TEST_F(DrawnOnUi, StrokesAreAsWideAsTheyAskFor) {
  draw([](Canvas& canvas) {
    canvas.stroke(std::vector<Eigen::Vector2d>{{10, 50}, {110, 50}}, {kInk, 6.0, {}});
  });
  const Rect drawn = bounds();
  EXPECT_NEAR(drawn.height, 6.0, 2.1) << "and a pixel of smoothing on each side";
  EXPECT_NEAR(drawn.width, 100.0, 2.1);
}

TEST_F(DrawnOnUi, StrokesHaveGapsAtPointsThatAreNotFinite) {
  draw([](Canvas& canvas) {
    canvas.stroke(std::vector<Eigen::Vector2d>{{10, 50}, {20, 50}, {kNan, 0}, {80, 50}, {90, 50}},
                  {kInk, 2.0, {}});
  });
  for (const auto& point : points)
    EXPECT_TRUE(point.x() < 50.0 + 22.0 || point.x() > 50.0 + 78.0) << point.x();
  EXPECT_FALSE(points.empty());
}

TEST_F(DrawnOnUi, DashesLieWhereTheyShould) {
  draw([](Canvas& canvas) {
    canvas.stroke(std::vector<Eigen::Vector2d>{{0, 50}, {100, 50}}, {kInk, 2.0, {10.0, 10.0}});
  });
  for (const auto& point : points) {
    const double along = std::fmod(point.x() - 50.0 + 1.0, 20.0);
    EXPECT_LE(along, 12.0) << "in a gap";
  }
}

TEST_F(DrawnOnUi, ClipsLieWithinEachOther) {
  draw([](Canvas& canvas) {
    const std::vector<Eigen::Vector2d> square = {{0, 0}, {100, 0}, {100, 100}, {0, 100}};
    canvas.push_clip({10, 10, 50, 50});
    canvas.push_clip({0, 0, 20, 500});
    canvas.fill(square, kInk);
    canvas.pop_clip();
    canvas.fill(square, kInk);
    canvas.pop_clip();
    EXPECT_THROW(canvas.pop_clip(), std::logic_error);
  });
  EXPECT_THAT(clips,
              testing::ElementsAre(Rect{60.0, 70.0, 10.0, 50.0}, Rect{60.0, 70.0, 50.0, 50.0}));
}

TEST_F(DrawnOnUi, WhatIsFarAwayIsCutOffBefore) {
  draw([](Canvas& canvas) {
    canvas.stroke(std::vector<Eigen::Vector2d>{{-1e9, 50}, {1e9, 50}}, {kInk, 2.0, {5.0, 5.0}});
  });
  EXPECT_LT(points.size(), 30'000U);
  EXPECT_GT(points.size(), 8U);
}

TEST_F(DrawnOnUi, NothingIsDrawnOfWhatCannotBeSeen) {
  draw([](Canvas& canvas) {
    canvas.stroke(std::vector<Eigen::Vector2d>{{0, 0}, {9, 9}}, {{0, 0, 0, 0}, 2.0, {}});
    canvas.fill(std::vector<Eigen::Vector2d>{{0, 0}, {9, 9}}, kInk);
    canvas.text({kNan, 0.0}, "nowhere", {});
    canvas.image({0, 0, 10, 10}, {});
  });
  EXPECT_TRUE(points.empty());
}

TEST_F(DrawnOnUi, TextStandsOnItsBaselineAndIsAsWideAsMeasured) {
  for (const FontFace face : {FontFace::kText, FontFace::kNumbers}) {
    for (const bool is_bold : {false, true}) {
      for (const double size : {9.0, 10.67, 12.0, 15.0}) {
        TextStyle style;
        style.face = face;
        style.is_bold = is_bold && face == FontFace::kText;
        style.size_px = size;
        points.clear();
        draw([&style](Canvas& canvas) { canvas.text({20.0, 40.0}, "Heading 12.34 H", style); });
        const TextExtent extent = measure_text("Heading 12.34 H", style);
        const Rect drawn = bounds();
        EXPECT_NEAR(drawn.left, 70.0, 2.5);
        EXPECT_NEAR(drawn.width, extent.width, std::max(2.6, 0.03 * extent.width)) << size;
        // The lowest is the g; capitals reach their height above the baseline at 130 - 40.
        EXPECT_NEAR(drawn.bottom() - 90.0, extent.descent, 1.8);
        EXPECT_NEAR(90.0 - drawn.top, extent.cap_height, 2.2);
      }
    }
  }
}

TEST_F(DrawnOnUi, TextIsAlignedAtItsPointAndTurnsAboutIt) {
  TextStyle style;
  style.size_px = 12.0;
  style.align = TextAlign::kRight;
  draw([&style](Canvas& canvas) { canvas.text({100.0, 40.0}, "HHHH", style); });
  EXPECT_NEAR(bounds().right(), 150.0, 2.0);
  points.clear();
  style.align = TextAlign::kCentre;
  style.rotation_deg = 90.0;
  draw([&style](Canvas& canvas) { canvas.text({100.0, 50.0}, "HHHH", style); });
  const Rect drawn = bounds();
  EXPECT_GT(drawn.height, drawn.width);
  EXPECT_NEAR(drawn.centre().y(), 80.0, 1.5);
  EXPECT_NEAR(drawn.right(), 150.0, 1.5) << "turned counter-clockwise its baseline is at the right";
}

TEST_F(DrawnOnUi, SmallImagesAreRectanglesAndLargeOnesTextures) {
  Raster<Rgba> two(2, 1, kInk);
  two.at(1, 0) = {200, 0, 0};
  draw([&two](Canvas& canvas) { canvas.image({0, 0, 20, 10}, two); });
  EXPECT_EQ(points.size(), 8U);
  EXPECT_EQ(bounds(), (Rect{50.0, 120.0, 20.0, 10.0}));
  EXPECT_EQ(picture_count, 0U);
  Raster<Rgba> many(40, 40);
  for (int row = 0; row < 40; ++row) {
    for (int column = 0; column < 40; ++column)
      many.at(column, row) = {static_cast<std::uint8_t>(6 * column),
                              static_cast<std::uint8_t>(6 * row), 0};
  }
  points.clear();
  draw([&many](Canvas& canvas) {
    canvas.image({0, 0, 20, 10}, many);
    canvas.image({50, 0, 20, 10}, many);
  });
  EXPECT_EQ(points.size(), 8U);
  EXPECT_EQ(picture_count, 1U) << "the same pixels are one texture";
}

}  // namespace ui_canvas_test
}  // namespace nadir::kit
