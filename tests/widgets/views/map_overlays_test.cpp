// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/map_overlays.h"

#include <gmock/gmock.h>

#include <array>
#include <limits>
#include <numbers>

#include "tests/widgets/views/drawn_chart.h"

namespace nadir {
namespace map_overlays_test {

constexpr PageRect kMap{60, 40, 400, 300};
constexpr Rgba kLine{10, 20, 30};
constexpr Rgba kCasing{200, 210, 220};
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

MapFrame frame(double up_rad = std::numbers::pi / 2.0) {
  return {kMap, {{100.0, 50.0}, 0.5, up_rad}, 2.0};
}
PathLook cased() { return {kLine, 1.5, false, kCasing, 0.5}; }

TEST(Path, HasItsPointsAndBreaksWhereOneIsNotFinite) {
  const std::vector<Eigen::Vector2d> points = {{90, 50},  {100, 50}, {kNaN, 50}, {110, 60},
                                               {120, 60}, {120, 70}, {80, kNaN}, {1, 2}};
  RecordingCanvas canvas;
  draw_path(canvas, frame(), points, {kLine, 1.5});
  ASSERT_EQ(canvas.strokes.size(), 2U);  // the last point is alone
  EXPECT_EQ(canvas.strokes[0].points.size(), 2U);
  ASSERT_EQ(canvas.strokes[1].points.size(), 3U);
  EXPECT_LT((canvas.strokes[1].points[2] - frame().page({120, 70})).norm(), 1e-9);
  EXPECT_DOUBLE_EQ(canvas.strokes[0].style.width_px, 3.0);
}

TEST(Path, HasItsCasingBelow) {
  RecordingCanvas canvas;
  draw_path(canvas, frame(), std::vector<Eigen::Vector2d>{{90, 50}, {100, 50}}, cased());
  ASSERT_EQ(canvas.strokes.size(), 2U);
  EXPECT_EQ(canvas.strokes[0].style.colour, kCasing);
  EXPECT_DOUBLE_EQ(canvas.strokes[0].style.width_px, 5.0);
  EXPECT_EQ(canvas.strokes[1].style.colour, kLine);
}

TEST(Path, KeepsItsEndsWhereItsPointsLieDense) {
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i <= 10'000; ++i) points.emplace_back(90.0 + 0.001 * i, 50.0);
  RecordingCanvas canvas;
  draw_path(canvas, frame(), points, {kLine, 1.5});
  ASSERT_EQ(canvas.strokes.size(), 1U);
  EXPECT_LE(canvas.strokes[0].points.size(), 62U);
  EXPECT_LT((canvas.strokes[0].points.back() - frame().page(points.back())).norm(), 1e-9);
}

TEST(Ellipses, LieAtTheirDeviationsWhereverTheCovarianceTurns) {
  Eigen::Matrix2d covariance;
  covariance << 4.0, 1.5, 1.5, 1.0;
  const Eigen::Vector2d centre(105, 48);
  constexpr std::array<double, 3> kSigmas = {3.0, 2.0, 1.0};
  for (const double up_rad : {std::numbers::pi / 2.0, 0.4}) {
    RecordingCanvas canvas;
    draw_ellipses(canvas, frame(up_rad), centre, covariance, kSigmas, {kLine, 1.0});
    ASSERT_EQ(canvas.strokes.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
      for (const Eigen::Vector2d& point : canvas.strokes[i].points) {
        const Eigen::Vector2d offset = frame(up_rad).camera.enu_from_page(point, kMap) - centre;
        EXPECT_NEAR(std::sqrt(offset.dot(covariance.inverse() * offset)), kSigmas.at(i), 1e-9);
      }
    }
    EXPECT_EQ(canvas.fills.size(), 1U);  // the innermost
  }
}

TEST(Ellipses, OfAFadedLookAreFadedInEveryPart) {
  constexpr std::array<double, 3> kSigmas = {3.0, 2.0, 1.0};
  const auto drawn = [&](std::uint8_t alpha) {
    PathLook look = cased();
    look.colour.alpha = look.casing.alpha = alpha;
    RecordingCanvas canvas;
    draw_ellipses(canvas, frame(), {100, 50}, Eigen::Matrix2d::Identity(), kSigmas, look);
    return canvas;
  };
  const RecordingCanvas full = drawn(255), half = drawn(128), none = drawn(0);
  ASSERT_EQ(full.strokes.size(), 6U);  // a casing and a line each
  ASSERT_EQ(half.strokes.size(), 6U);
  for (std::size_t i = 0; i < full.strokes.size(); ++i) {
    EXPECT_NEAR(half.strokes[i].style.colour.alpha, full.strokes[i].style.colour.alpha / 2.0, 1.0);
  }
  EXPECT_NEAR(half.fills.at(0).colour.alpha, full.fills.at(0).colour.alpha / 2.0, 1.0);
  for (const auto& stroke : none.strokes) EXPECT_EQ(stroke.style.colour.alpha, 0);
  EXPECT_EQ(none.fills.at(0).colour.alpha, 0);
}

TEST(Ellipses, OfNoCovarianceAreNotDrawn) {
  constexpr std::array<double, 1> kSigmas = {1.0};
  Eigen::Matrix2d flat;
  flat << 1.0, 1.0, 1.0, 1.0;
  for (const Eigen::Matrix2d& covariance :
       {Eigen::Matrix2d(Eigen::Matrix2d::Zero()), Eigen::Matrix2d(-Eigen::Matrix2d::Identity()),
        Eigen::Matrix2d(Eigen::Matrix2d::Constant(kNaN))}) {
    RecordingCanvas canvas;
    draw_ellipses(canvas, frame(), {100, 50}, covariance, kSigmas, {kLine, 1.0});
    EXPECT_TRUE(canvas.strokes.empty());
  }
}

TEST(Pose, PointsAlongItsHeadingOnATurnedMap) {
  for (const double up_rad : {std::numbers::pi / 2.0, 0.0, 2.2}) {
    for (const double yaw_rad : {0.0, 1.0, -2.0}) {
      RecordingCanvas canvas;
      draw_pose(canvas, frame(up_rad), {100, 50, yaw_rad}, 10.0, {kLine, 1.0});
      ASSERT_EQ(canvas.fills.size(), 1U);
      const Eigen::Vector2d ahead(100 + std::cos(yaw_rad), 50 + std::sin(yaw_rad));
      const Eigen::Vector2d along =
          (frame(up_rad).page(ahead) - frame(up_rad).page({100, 50})).normalized();
      const Eigen::Vector2d tip = canvas.fills[0].outline[0] - frame(up_rad).page({100, 50});
      EXPECT_LT((tip - 13.0 * along).norm(), 1e-9);
    }
  }
}

TEST(PathMark, OfATickLiesAcrossThePath) {
  RecordingCanvas canvas;
  draw_path_mark(canvas, frame(), PathMark::kTick, {100, 50}, 0.0, {kLine, 1.5, true});
  ASSERT_EQ(canvas.strokes.size(), 1U);
  EXPECT_NEAR(canvas.strokes[0].points[0].x(), canvas.strokes[0].points[1].x(), 1e-9);
  EXPECT_TRUE(canvas.strokes[0].style.dashes_px.empty());
  draw_path_mark(canvas, frame(), PathMark::kStart, {kNaN, 50}, 0.0, {kLine, 1.5});
  EXPECT_TRUE(canvas.fills.empty());
}

TEST(Plate, HoldsItsWords) {
  RecordingCanvas canvas;
  TextStyle style;
  style.size_px = 14.0;
  draw_plate(canvas, {200, 100}, "62 %", style, kCasing, 2.0);
  const PageRect plate = plate_at({200, 100}, "62 %", style, 2.0);
  ASSERT_EQ(canvas.fills.size(), 1U);
  EXPECT_EQ(canvas.fills[0].outline[0], Eigen::Vector2d(plate.left, plate.bottom));
  EXPECT_EQ(canvas.fills[0].outline[2], Eigen::Vector2d(plate.right(), plate.top()));
  EXPECT_LT((plate.centre() - Eigen::Vector2d(200, 100)).norm(), 1e-9);
  const Eigen::AlignedBox2d letters = canvas.texts[0].box();
  EXPECT_GT(letters.min().x(), plate.left);
  EXPECT_LT(letters.max().x(), plate.right());
  EXPECT_LT(letters.max().y(), plate.top());
}

}  // namespace map_overlays_test
}  // namespace nadir
