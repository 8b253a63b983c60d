// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/chart_series.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace nadir {
namespace chart_series_test {

using testing::Each;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Le;
using testing::SizeIs;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kPxPerPt = 2.0;

const ChartFrame kFrame{{0.0, 10.0}, {-1.0, 1.0}, {}, 100.0};

LineSpec line_of(std::vector<double> x, std::vector<double> y) {
  return {.x = std::move(x), .y = std::move(y)};
}

/// `count` points over the x axis of kFrame.
LineSpec wave(std::size_t count) {
  LineSpec line;
  for (std::size_t i = 0; i < count; ++i) {
    line.x.push_back(10.0 * static_cast<double>(i) / static_cast<double>(count - 1));
    line.y.push_back(std::sin(77.0 * line.x.back()));
  }
  return line;
}

TEST(DrawnLine, IsTheDataWhereTheyAreFew) {
  const auto pieces = drawn_pieces(line_of({1, 2, 4}, {0.5, -0.5, 0.1}), kFrame, kPxPerPt);
  ASSERT_THAT(pieces, SizeIs(1));
  EXPECT_THAT(pieces[0].x, ElementsAre(1, 2, 4));
  EXPECT_THAT(pieces[0].y, ElementsAre(0.5, -0.5, 0.1));
}

TEST(DrawnLine, BreaksWhereAValueIsNotFinite) {
  const auto pieces =
      drawn_pieces(line_of({0, 1, 2, 3, 4, 5, 6, 7}, {0.1, 0.2, kNan, 0.3, 0.4, kInfinity, 0, 0}),
                   kFrame, kPxPerPt);
  ASSERT_THAT(pieces, SizeIs(3));
  EXPECT_THAT(pieces[0].x, ElementsAre(0, 1));
  EXPECT_THAT(pieces[1].x, ElementsAre(3, 4));
  EXPECT_THAT(pieces[2].x, ElementsAre(6, 7));
}

TEST(DrawnLine, BreaksWhereAnXIsNotFinite) {
  EXPECT_THAT(drawn_pieces(line_of({0, 1, kNan, 3, 4}, {0, 0, 0, 0, 0}), kFrame, kPxPerPt),
              SizeIs(2));
}

TEST(DrawnLine, IsNothingWithoutPoints) {
  EXPECT_THAT(drawn_pieces(LineSpec{}, kFrame, kPxPerPt), IsEmpty());
  EXPECT_THAT(drawn_pieces(line_of({1, 2}, {kNan, kNan}), kFrame, kPxPerPt), IsEmpty());
}

TEST(DrawnLine, OfOnePointIsADashAsLongAsTheLineIsWide) {
  LineSpec line = line_of({5}, {0.5});
  line.width_pt = 3.0;  // 6 px of 100 for 10 units
  const auto pieces = drawn_pieces(line, kFrame, kPxPerPt);
  ASSERT_THAT(pieces, SizeIs(1));
  EXPECT_THAT(pieces[0].x, ElementsAre(4.7, 5.3));
  EXPECT_THAT(pieces[0].y, ElementsAre(0.5, 0.5));
}

TEST(DrawnLine, RefusesArraysOfDifferentLength) {
  EXPECT_THROW((void)drawn_pieces(line_of({1, 2}, {1}), kFrame, kPxPerPt), std::logic_error);
}

TEST(DrawnLine, KeepsEveryPointUpToFourAPixel) {
  EXPECT_THAT(drawn_pieces(wave(400), kFrame, kPxPerPt)[0].x, SizeIs(400));
}

TEST(DrawnLine, KeepsLowestAndHighestOfEachPixelBeyond) {
  const LineSpec line = wave(100'000);
  const auto pieces = drawn_pieces(line, kFrame, kPxPerPt);
  ASSERT_THAT(pieces, SizeIs(1));
  EXPECT_LE(pieces[0].x.size(), 202U);
  EXPECT_TRUE(std::is_sorted(pieces[0].x.begin(), pieces[0].x.end()));
  for (int pixel = 0; pixel < 100; ++pixel) {
    const auto reach = [pixel](const std::vector<double>& x, const std::vector<double>& y) {
      AxisRange found{kInfinity, -kInfinity};
      for (std::size_t i = 0; i < x.size(); ++i) {
        if (static_cast<int>(std::min(99.0, 10.0 * x[i])) != pixel) continue;
        found.low = std::min(found.low, y[i]);
        found.high = std::max(found.high, y[i]);
      }
      return found;
    };
    const AxisRange all = reach(line.x, line.y);
    const AxisRange kept = reach(pieces[0].x, pieces[0].y);
    EXPECT_NEAR(kept.low, all.low, 0.01) << pixel;
    EXPECT_NEAR(kept.high, all.high, 0.01) << pixel;
  }
}

TEST(DrawnLine, ThatGoesBackInXIsNotThinned) {
  LineSpec line = wave(10'000);
  std::reverse(line.x.begin(), line.x.end());
  EXPECT_THAT(drawn_pieces(line, kFrame, kPxPerPt)[0].x, SizeIs(10'000));
}

TEST(DrawnLine, OfStepsHasCorners) {
  LineSpec line = line_of({0, 2, 3}, {0.0, 0.5, 1.0});
  line.is_stepped = true;
  const auto pieces = drawn_pieces(line, kFrame, kPxPerPt);
  ASSERT_THAT(pieces, SizeIs(1));
  EXPECT_THAT(pieces[0].x, ElementsAre(0, 2, 2, 3, 3));
  EXPECT_THAT(pieces[0].y, ElementsAre(0.0, 0.0, 0.5, 0.5, 1.0));
}

TEST(DrawnLine, LeavesOutWhatLiesBesideTheAxis) {
  const auto pieces =
      drawn_pieces(line_of({-5, -4, -3, 1, 2, 12, 13, 14}, {0, 0, 0, 0, 0, 0, 0, 0}), kFrame, 1.0);
  ASSERT_THAT(pieces, SizeIs(1));
  EXPECT_THAT(pieces[0].x, ElementsAre(-3, 1, 2, 12));  // with the ends that lead out of sight
}

TEST(DrawnLine, ThatPassesOverTheAxisInOneStepIsKept) {
  const auto pieces = drawn_pieces(line_of({-5, 20}, {0, 0}), kFrame, 1.0);
  ASSERT_THAT(pieces, SizeIs(1));
  EXPECT_THAT(pieces[0].x, ElementsAre(-5, 20));
}

TEST(DrawnLine, ThatLeavesTheAxisAndComesBackHasTwoPieces) {
  const auto pieces =
      drawn_pieces(line_of({8, 12, 13, 14, 9}, {0, 0.1, 0.2, 0.3, 0.4}), kFrame, 1.0);
  ASSERT_THAT(pieces, SizeIs(2));
  EXPECT_THAT(pieces[0].x, ElementsAre(8, 12));
  EXPECT_THAT(pieces[1].x, ElementsAre(14, 9));
}

TEST(DrawnLine, AlonePointBesideTheAxisIsNotDrawn) {
  EXPECT_THAT(drawn_pieces(line_of({11}, {0}), kFrame, 1.0), IsEmpty());
  EXPECT_THAT(drawn_pieces(line_of({11, 12, 13}, {0, 0, 0}), kFrame, 1.0), IsEmpty());
}

TEST(DrawnLine, StaysWhereDevicesCanCount) {
  const auto pieces =
      drawn_pieces(line_of({-1e60, 1, 2, 3, 1e60}, {0, 1e50, 0, -1e50, 0}), kFrame, 1.0);
  ASSERT_THAT(pieces, SizeIs(1));
  for (const double y : pieces[0].y) EXPECT_LE(std::abs(y), 1001.0 * 2.0);
  for (const double x : pieces[0].x) EXPECT_LE(std::abs(x), 1001.0 * 10.0);
}

TEST(DrawnLine, OnALogarithmicAxisBreaksAtZero) {
  ChartFrame frame = kFrame;
  frame.scale = {true, -1.0};
  frame.y = {0.0, 3.0};
  const auto pieces = drawn_pieces(line_of({0, 1, 2, 3, 4}, {0.1, 1, 0, 10, 100}), frame, 1.0);
  ASSERT_THAT(pieces, SizeIs(2));
  EXPECT_THAT(pieces[0].y, ElementsAre(0.0, 1.0));
  EXPECT_THAT(pieces[1].y, ElementsAre(2.0, 3.0));
}

TEST(DrawnBand, IsTheDataWhereTheyAreFew) {
  const auto pieces = drawn_pieces(
      BandSpec{.x = {1, 2, 3}, .low = {-0.5, -0.4, -0.3}, .high = {0.5, 0.4, 0.3}}, kFrame);
  ASSERT_THAT(pieces, SizeIs(1));
  EXPECT_THAT(pieces[0].x, ElementsAre(1, 2, 3));
  EXPECT_THAT(pieces[0].low, ElementsAre(-0.5, -0.4, -0.3));
  EXPECT_THAT(pieces[0].high, ElementsAre(0.5, 0.4, 0.3));
}

TEST(DrawnBand, BreaksWhereEitherSideIsNotFinite) {
  const auto pieces = drawn_pieces(BandSpec{.x = {0, 1, 2, 3, 4, 5, 6, 7},
                                            .low = {0, 0, kNan, 0, 0, 0, 0, 0},
                                            .high = {1, 1, 1, 1, 1, kInfinity, 1, 1}},
                                   kFrame);
  ASSERT_THAT(pieces, SizeIs(3));
  EXPECT_THAT(pieces[1].x, ElementsAre(3, 4));
}

TEST(DrawnBand, OfOnePointIsNothing) {
  EXPECT_THAT(drawn_pieces(BandSpec{.x = {1}, .low = {0}, .high = {1}}, kFrame), IsEmpty());
  EXPECT_THAT(drawn_pieces(BandSpec{}, kFrame), IsEmpty());
}

TEST(DrawnBand, CoversAllOfALongOneWithOnePointAPixel) {
  BandSpec band;
  const LineSpec middle = wave(50'000);
  band.x = middle.x;
  for (const double y : middle.y) {
    band.low.push_back(y - 0.1);
    band.high.push_back(y + 0.1);
  }
  const auto pieces = drawn_pieces(band, kFrame);
  ASSERT_THAT(pieces, SizeIs(1));
  EXPECT_LE(pieces[0].x.size(), 101U);
  EXPECT_EQ(pieces[0].x.front(), 0.0);
  EXPECT_EQ(pieces[0].x.back(), 10.0);
  EXPECT_THAT(*std::min_element(pieces[0].low.begin(), pieces[0].low.end()), Le(-1.099));
  for (std::size_t i = 0; i < pieces[0].x.size(); ++i) {
    EXPECT_LE(pieces[0].low[i], pieces[0].high[i]);
  }
}

TEST(DrawnBand, OfManyPointsAtOneXIsDrawnWithoutDivisionByZero) {
  const std::size_t count = 1000;
  const BandSpec band{.x = std::vector<double>(count, 3.0),
                      .low = std::vector<double>(count, -0.5),
                      .high = std::vector<double>(count, 0.5)};
  const auto pieces = drawn_pieces(band, kFrame);
  ASSERT_THAT(pieces, SizeIs(1));
  EXPECT_THAT(pieces[0].x, Each(3.0));
}

}  // namespace chart_series_test
}  // namespace nadir
