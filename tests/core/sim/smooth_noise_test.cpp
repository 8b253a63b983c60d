// SPDX-License-Identifier: Apache-2.0
#include "core/sim/smooth_noise.h"

#include <gtest/gtest.h>

#include <cmath>

namespace nadir {
namespace smooth_noise_test {

TEST(SmoothNoise, IsStandardNormalAtLatticePointsAndBetweenThem) {
  for (const double offset : {0.0, 0.5, 0.3}) {
    double sum = 0.0;
    double squares = 0.0;
    int below = 0;
    constexpr int kPoints = 200;
    const SmoothNoise noise(11, 77);
    for (int row = 0; row < kPoints; ++row) {
      for (int column = 0; column < kPoints; ++column) {
        const double value = noise.at(column + offset, row + 0.7 * offset);
        sum += value;
        squares += value * value;
        below += value < normal_quantile(0.1) ? 1 : 0;
      }
    }
    const double count = kPoints * kPoints;
    EXPECT_NEAR(sum / count, 0.0, 0.03);
    EXPECT_NEAR(squares / count, 1.0, 0.04);
    EXPECT_NEAR(below / count, 0.1, 0.01);
  }
}

TEST(SmoothNoise, HasNoStepsNotEvenWhereItRepeats) {
  const SmoothNoise noise(3, 1);
  for (double x = -2.0; x < 2.0; x += 0.001) {
    EXPECT_NEAR(noise.at(x, 5.5), noise.at(x + 0.001, 5.5), 0.02) << x;
    EXPECT_NEAR(noise.at(5.5, x), noise.at(5.5, x + 0.001), 0.02) << x;
  }
  EXPECT_NEAR(noise.at(1.25, -3.5), noise.at(257.25, 252.5), 1e-9);
}

TEST(SmoothNoise, DiffersBetweenSeedsAndBetweenStreams) {
  EXPECT_NE(SmoothNoise(1, 1).at(0.5, 0.5), SmoothNoise(2, 1).at(0.5, 0.5));
  EXPECT_NE(SmoothNoise(1, 1).at(0.5, 0.5), SmoothNoise(1, 2).at(0.5, 0.5));
}

TEST(NormalQuantile, IsTheInverseOfTheShareAndMatchesTables) {
  EXPECT_NEAR(normal_quantile(0.975), 1.959963985, 1e-8);
  EXPECT_NEAR(normal_quantile(0.5), 0.0, 1e-9);
  for (const double share : {1e-6, 0.01, 0.3, 0.9, 0.9999}) {
    EXPECT_NEAR(normal_share_below(normal_quantile(share)), share, 1e-9);
  }
}

}  // namespace smooth_noise_test
}  // namespace nadir
