// SPDX-License-Identifier: Apache-2.0
#include "core/assist/scissors.h"

#include <gmock/gmock.h>

#include "tests/core/assist/drawn_windows.h"

namespace nadir {
namespace scissors_test {

using testing::HasSubstr;

Scissors scissors(const AssistWindow& window, const ScissorsOptions& options = {}) {
  auto made = Scissors::create(window, options);
  if (!made) throw std::runtime_error(error_text(made));
  return std::move(*made);
}

/// From one place to another, given and returned in pixels.
Ring line_between(Scissors& at_work,
                  const AssistWindow& window,
                  const Eigen::Vector2d& from,
                  const Eigen::Vector2d& to) {
  const auto begun = at_work.begin_at(window.enu_from_pixels() * from);
  if (!begun) throw std::runtime_error(error_text(begun));
  auto line = at_work.line_to(window.enu_from_pixels() * to);
  if (!line) throw std::runtime_error(error_text(line));
  for (Eigen::Vector2d& place : *line) place = window.pixels_from_enu() * place;
  return std::move(*line);
}

/// All along, not only where there are places.
double farthest(const Ring& line, const std::function<double(const Eigen::Vector2d&)>& distance) {
  double most = 0.0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    for (int step = 0; step <= 20; ++step) {
      most = std::max(most, std::abs(distance(line[i] + (line[i + 1] - line[i]) * (step / 20.0))));
    }
  }
  return most;
}

TEST(Scissors, RunWithinHalfAPixelOfAStraightEdge) {
  for (const double turn_deg : {0.0, 9.0, 30.0, 45.0, 77.0, 90.0}) {
    const double turn = turn_deg * std::acos(-1.0) / 180.0;
    const Eigen::Vector2d normal(std::cos(turn), std::sin(turn));
    const Eigen::Vector2d along(-normal.y(), normal.x());
    // Through a place that is neither corner nor centre of a pixel.
    const Eigen::Vector2d middle(50.3, 50.2);
    const auto beside = [&](const Eigen::Vector2d& at) { return normal.dot(at - middle); };
    const AssistWindow window =
        window_of(drawn_picture(
                      100, 100, [&](const Eigen::Vector2d& at) { return beside(at) > 0.0; }, 8),
                  turned_place());
    // Not simplified, so that it is more than a straight line between its ends.
    Scissors at_work = scissors(window, {.simplify_px = 0.0});
    const Ring line = line_between(at_work, window, middle - 35.0 * along, middle + 35.0 * along);
    EXPECT_LT(farthest(line, beside), 0.25) << turn_deg;
    Scissors usual = scissors(window);
    EXPECT_EQ(line_between(usual, window, middle - 35.0 * along, middle + 35.0 * along).size(), 2U);
  }
}

TEST(Scissors, RunAroundADiscWithinHalfAPixel) {
  const Eigen::Vector2d middle(80.4, 74.7);
  const double radius = 45.3;
  const AssistWindow window = window_of(
      noisy(drawn_picture(160, 150, disc(middle.x(), middle.y(), radius), 8), 3.0), turned_place());
  Scissors at_work = scissors(window);
  const auto on_rim = [&](double turn_deg) {
    const double turn = turn_deg * std::acos(-1.0) / 180.0;
    return Eigen::Vector2d(middle + radius * Eigen::Vector2d(std::cos(turn), std::sin(turn)));
  };
  const auto off_rim = [&](const Eigen::Vector2d& at) { return (at - middle).norm() - radius; };
  double length = 0.0;
  for (const double from_deg : {0.0, 90.0, 180.0, 270.0}) {
    const Ring line =
        line_between(at_work, window, on_rim(from_deg + 7.0), on_rim(from_deg + 97.0));
    EXPECT_LT(farthest(line, off_rim), 0.5) << from_deg;
    for (std::size_t i = 1; i < line.size(); ++i) length += (line[i] - line[i - 1]).norm();
  }
  EXPECT_NEAR(length, 2.0 * std::acos(-1.0) * radius, 3.0);
}

TEST(Scissors, EndExactlyWhereTheyWereAskedTo) {
  const AssistWindow window =
      window_of(drawn_picture(60, 60, disc(30.0, 30.0, 20.0), 4), turned_place());
  Scissors at_work = scissors(window);
  const Eigen::Vector2d from = window.enu_from_pixels() * Eigen::Vector2d(11.7, 21.3);
  const Eigen::Vector2d to = window.enu_from_pixels() * Eigen::Vector2d(48.1, 22.9);
  ASSERT_TRUE(at_work.begin_at(from));
  const auto line = at_work.line_to(to);
  ASSERT_TRUE(line);
  EXPECT_EQ(line->front(), from);
  EXPECT_EQ(line->back(), to);
  // Also where both are the same, or in one pixel.
  EXPECT_EQ(*at_work.line_to(from), (Ring{from, from}));
}

TEST(Scissors, SnapToTheStrongestEdgeNearby) {
  const Eigen::Vector2d middle(80.4, 74.7);
  const AssistWindow window =
      window_of(drawn_picture(160, 150, disc(middle.x(), middle.y(), 45.3), 8), turned_place());
  const Scissors at_work = scissors(window, {.snap_px = 4.0});
  for (int turn_deg = 0; turn_deg < 360; turn_deg += 13) {
    const double turn = turn_deg * std::acos(-1.0) / 180.0;
    const Eigen::Vector2d way(std::cos(turn), std::sin(turn));
    const Eigen::Vector2d near = window.enu_from_pixels() * (middle + 47.8 * way);
    const Eigen::Vector2d on = window.pixels_from_enu() * at_work.snapped(near);
    EXPECT_NEAR((on - middle).norm(), 45.3, 0.25) << turn_deg;
    const Eigen::Vector2d far = window.enu_from_pixels() * (middle + 55.0 * way);
    EXPECT_EQ(at_work.snapped(far), far);
  }
  const Eigen::Vector2d outside = window.enu_from_pixels() * Eigen::Vector2d(-2.0, 5.0);
  EXPECT_EQ(at_work.snapped(outside), outside);
}

TEST(Scissors, HaveFewerPlacesWithMoreTolerance) {
  const AssistWindow window =
      window_of(drawn_picture(160, 150, disc(80.0, 75.0, 50.0), 8), plain_place());
  std::size_t before = 1000;
  for (const double tolerance_px : {0.05, 0.4, 2.0}) {
    Scissors at_work = scissors(window, {.simplify_px = tolerance_px});
    const Ring line = line_between(at_work, window, {130.0, 75.0}, {80.0, 125.0});
    EXPECT_LT(line.size(), before);
    before = line.size();
    EXPECT_LT(farthest(line,
                       [](const Eigen::Vector2d& at) {
                         return (at - Eigen::Vector2d(80.0, 75.0)).norm() - 50.0;
                       }),
              tolerance_px + 0.5);
  }
}

TEST(Scissors, AreTheSameEachTime) {
  const AssistWindow window =
      window_of(noisy(drawn_picture(100, 100, disc(50.0, 50.0, 30.0), 4), 25.0), plain_place());
  Scissors one = scissors(window);
  Scissors other = scissors(window);
  EXPECT_EQ(line_between(one, window, {20.5, 50.5}, {80.5, 50.5}),
            line_between(other, window, {20.5, 50.5}, {80.5, 50.5}));
}

TEST(Scissors, FindSomeWayWithoutEdges) {
  const AssistWindow plain = window_of(ImageRaster(50, 40, kGrass), plain_place());
  Scissors at_work = scissors(plain);
  const Ring line = line_between(at_work, plain, {3.5, 3.5}, {44.5, 30.5});
  EXPECT_LT(line.size(), 45U);
  EXPECT_EQ(at_work.snapped({20.0, -20.0}), Eigen::Vector2d(20.0, -20.0));
  const AssistWindow one = window_of(ImageRaster(1, 1, kGrass), plain_place());
  Scissors tiny = scissors(one);
  EXPECT_EQ(line_between(tiny, one, {0.25, 0.5}, {0.75, 0.5}), (Ring{{0.25, 0.5}, {0.75, 0.5}}));
}

TEST(Scissors, OutsideOfTheWindowAreRefused) {
  const AssistWindow window = window_of(ImageRaster(50, 40, kGrass), plain_place());
  Scissors at_work = scissors(window);
  EXPECT_EQ(error_text(at_work.begin_at({60.0, -5.0})),
            "the place is outside of what is looked at");
  EXPECT_THROW((void)at_work.line_to({5.0, -5.0}), std::logic_error);
  ASSERT_TRUE(at_work.begin_at({5.0, -5.0}));
  EXPECT_EQ(error_text(at_work.line_to({5.0, std::nan("")})),
            "the place is outside of what is looked at");
  EXPECT_THAT(error_text(Scissors::create(window, {.least_edge = 0.0})),
              HasSubstr("--scissors-least-edge"));
}

}  // namespace scissors_test
}  // namespace nadir
