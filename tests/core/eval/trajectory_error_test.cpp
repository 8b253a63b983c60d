// SPDX-License-Identifier: Apache-2.0
#include "core/eval/trajectory_error.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

namespace nadir {
namespace trajectory_error_test {

using testing::DoubleNear;
using testing::ElementsAre;

constexpr double kPi = std::numbers::pi;

PosePair pair_at(
    double time_s, const Rigid2& truth, double east_m, double north_m, double turn_rad = 0.0) {
  return {
      time_s, {truth.x_m + east_m, truth.y_m + north_m, wrap_rad(truth.yaw_rad + turn_rad)}, truth};
}

TEST(OrderStatistic, LiesLinearlyBetweenNeighbours) {
  const std::vector<double> values = {1.0, 2.0, 4.0, 8.0, 16.0};
  EXPECT_DOUBLE_EQ(order_statistic(values, 0.0), 1.0);
  EXPECT_DOUBLE_EQ(order_statistic(values, 0.5), 4.0);
  EXPECT_DOUBLE_EQ(order_statistic(values, 0.9), 12.8);  // numpy.percentile([1, 2, 4, 8, 16], 90)
  EXPECT_DOUBLE_EQ(order_statistic(values, 1.0), 16.0);
  EXPECT_DOUBLE_EQ(order_statistic(std::vector{3.0, 5.0}, 0.5), 4.0);
  EXPECT_DOUBLE_EQ(order_statistic(std::vector{7.0}, 0.9), 7.0);
  EXPECT_THROW(static_cast<void>(order_statistic(std::vector<double>{}, 0.5)), std::logic_error);
  EXPECT_THROW(static_cast<void>(order_statistic(values, std::nan(""))), std::logic_error);
}

TEST(ErrorStatistics, AreThoseOfTheSizesOfTheErrors) {
  const ErrorStatistics statistics = summarise_errors({-3.0, 1.0, 2.0, -4.0});
  EXPECT_DOUBLE_EQ(statistics.mean, 2.5);
  EXPECT_DOUBLE_EQ(statistics.mean_square, 7.5);
  EXPECT_DOUBLE_EQ(statistics.root_mean_square, std::sqrt(7.5));
  EXPECT_DOUBLE_EQ(statistics.median, 2.5);
  EXPECT_DOUBLE_EQ(statistics.p90, 3.7);
  EXPECT_DOUBLE_EQ(statistics.maximum, 4.0);
}

TEST(PoseErrors, AreUnknownWithoutPairs) { EXPECT_FALSE(summarise_pose_errors({})); }

TEST(PoseErrors, AreThoseComputedByHand) {
  const std::vector<PosePair> pairs = {pair_at(0, {0, 0, 0}, 3, 4), pair_at(1, {1, 0, 0}, 0, 1),
                                       pair_at(2, {2, 0, 0}, 0, 0)};
  const auto summary = summarise_pose_errors(pairs);
  ASSERT_TRUE(summary);
  EXPECT_EQ(summary->matched_pairs, 3U);
  EXPECT_DOUBLE_EQ(summary->position_m.mean_square, 26.0 / 3.0);
  EXPECT_DOUBLE_EQ(summary->position_m.mean, 2.0);
  EXPECT_DOUBLE_EQ(summary->position_m.median, 1.0);
  EXPECT_DOUBLE_EQ(summary->position_m.p90, 4.2);
  EXPECT_DOUBLE_EQ(summary->position_m.maximum, 5.0);
  EXPECT_DOUBLE_EQ(summary->recall_1m, 2.0 / 3.0) << "an error of exactly 1 m counts as found";
  EXPECT_DOUBLE_EQ(summary->recall_3m, 2.0 / 3.0);
  EXPECT_DOUBLE_EQ(summary->recall_5m, 1.0);
  EXPECT_FALSE(summary->relative) << "2 m of path are too short for a drift";
}

TEST(PoseErrors, SplitAlongAndAcrossTheTrueHeading) {
  // Flying north, 2 m too far east is 2 m to the right: lateral. 5 m too far north is 5 m ahead.
  const std::vector<PosePair> pairs = {pair_at(0, {10, 20, kPi / 2}, 2, 5)};
  const auto summary = summarise_pose_errors(pairs);
  ASSERT_TRUE(summary);
  EXPECT_NEAR(summary->lateral_m.maximum, 2.0, 1e-12);
  EXPECT_NEAR(summary->longitudinal_m.maximum, 5.0, 1e-12);
}

TEST(PoseErrors, LateralAndLongitudinalSquaresSumToThePositionSquare) {
  std::vector<PosePair> pairs;
  for (int i = 0; i < 40; ++i) {
    pairs.push_back(pair_at(i, {i * 0.7, std::sin(i), 0.3 * i}, std::cos(2.0 * i), 0.1 * i));
  }
  const auto summary = summarise_pose_errors(pairs);
  ASSERT_TRUE(summary);
  EXPECT_NEAR(summary->lateral_m.mean_square + summary->longitudinal_m.mean_square,
              summary->position_m.mean_square, 1e-12);
}

TEST(PoseErrors, OrientationWrapsAcrossTheTurn) {
  const std::vector<PosePair> pairs = {{0, {0, 0, kPi - 0.1}, {0, 0, -kPi + 0.1}}};
  EXPECT_NEAR(summarise_pose_errors(pairs)->orientation_rad.maximum, 0.2, 1e-12);
}

TEST(PoseErrors, TravelledIsTheLengthOfTheTruePath) {
  const std::vector<PosePair> pairs = {{0, {9, 9, 0}, {0, 0, 0}},
                                       {1, {9, 9, 0}, {3, 4, 0}},
                                       {2, {9, 9, 0}, {3, 4, 1}},
                                       {3, {9, 9, 0}, {3, 0, 0}}};
  EXPECT_THAT(travelled_m(pairs), ElementsAre(0.0, 5.0, 5.0, 9.0));
}

std::vector<PosePair> straight(double length_m, double scale, double turn_rad_per_m) {
  std::vector<PosePair> pairs;
  for (double m = 0.0; m <= length_m; m += 1.0) {
    pairs.push_back({m, {m * scale, 0.0, wrap_rad(m * turn_rad_per_m)}, {m, 0.0, 0.0}});
  }
  return pairs;
}

TEST(RelativeError, IsTheScaleErrorOfAStretchedPath) {
  const auto relative = summarise_pose_errors(straight(250, 1.02, 0.0))->relative;
  ASSERT_TRUE(relative);
  EXPECT_EQ(relative->segment_m, 100.0);
  EXPECT_EQ(relative->segments, 151U);
  EXPECT_THAT(relative->position_m_per_m, DoubleNear(0.02, 1e-12));
  EXPECT_EQ(relative->orientation_rad_per_m, 0.0);
}

TEST(RelativeError, TakesTheLongestSegmentThatFitsTwice) {
  EXPECT_EQ(summarise_pose_errors(straight(200, 1, 0))->relative->segment_m, 100.0);
  EXPECT_EQ(summarise_pose_errors(straight(199, 1, 0))->relative->segment_m, 50.0);
  EXPECT_EQ(summarise_pose_errors(straight(99, 1, 0))->relative->segment_m, 10.0);
  EXPECT_FALSE(summarise_pose_errors(straight(19, 1, 0))->relative);
}

TEST(RelativeError, SeesTheTurnPerMetreAndNotAConstantOffset) {
  auto pairs = straight(40, 1.0, 0.001);
  for (PosePair& pair : pairs) pair.estimate_in_enu = Rigid2{500, -20, 0} * pair.estimate_in_enu;
  const auto summary = summarise_pose_errors(pairs);
  ASSERT_TRUE(summary->relative);
  EXPECT_NEAR(summary->relative->orientation_rad_per_m, 0.001, 1e-12);
  EXPECT_LT(summary->relative->position_m_per_m, 0.05) << "the offset of 500 m is no drift";
  EXPECT_GT(summary->position_m.mean, 400.0);
}

}  // namespace trajectory_error_test
}  // namespace nadir
