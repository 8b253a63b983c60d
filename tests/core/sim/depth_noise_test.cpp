// SPDX-License-Identifier: Apache-2.0
#include "core/sim/depth_noise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/base/parallel.h"

namespace nadir {
namespace depth_noise_test {

TEST(DepthNoise, OnlyCutsTheRangeWhereThereIsNoNoise) {
  const Raster<float> truth(5, 1, {0.0F, 3.5F, 20.0F, 20.5F, 1.0F});
  const auto depth_m = measure_depth(truth, {0.0, 20.0}, 1, 0);
  EXPECT_EQ(depth_m, Raster<float>(5, 1, {0.0F, 3.5F, 20.0F, 0.0F, 1.0F}));
}

TEST(DepthNoise, GivesNoDepthForDepthsThatAreNone) {
  const float infinity = std::numeric_limits<float>::infinity();
  const Raster<float> truth(4, 1, {std::nanf(""), -1.0F, infinity, 0.0F});
  EXPECT_EQ(measure_depth(truth, {0.05, 12.0}, 1, 0), Raster<float>(4, 1, 0.0F));
}

TEST(DepthNoise, IsGaussianInInverseDepth) {
  // At 2 m the noise of 0.05 / m never reaches the range, so no draw is lost.
  const auto depth_m = measure_depth(Raster<float>(401, 301, 2.0F), {0.05, 20.0}, 3, 9);
  double sum = 0.0;
  double squares = 0.0;
  double within_one_sigma = 0.0;
  for (const float depth : depth_m.values()) {
    ASSERT_GT(depth, 0.0F);
    const double error = 1.0 / static_cast<double>(depth) - 0.5;
    sum += error;
    squares += error * error;
    within_one_sigma += std::abs(error) < 0.05 ? 1.0 : 0.0;
  }
  const auto count = static_cast<double>(depth_m.size());
  EXPECT_NEAR(sum / count, 0.0, 6e-4);
  EXPECT_NEAR(std::sqrt(squares / count), 0.05, 5e-4);
  EXPECT_NEAR(within_one_sigma / count, 0.6827, 0.006);
}

TEST(DepthNoise, NeverLeavesTheRange) {
  const auto depth_m = measure_depth(Raster<float>(200, 200, 11.0F), {0.05, 12.0}, 3, 9);
  int none = 0;
  for (const float depth : depth_m.values()) {
    EXPECT_GE(depth, 0.0F);
    EXPECT_LE(depth, 12.0F);
    none += depth == 0.0F ? 1 : 0;
  }
  // 1/11 + noise < 1/12 for noise < -0.00758, which is 44 % of the draws.
  EXPECT_NEAR(none / 40000.0, 0.44, 0.01);
}

TEST(DepthNoise, IsAFunctionOfSeedAndFrameOnAnyNumberOfThreads) {
  const Raster<float> truth(321, 241, 4.0F);
  const auto on_threads = [&](int threads, std::uint64_t seed, std::uint32_t frame) {
    const ThreadLimit limit(threads);
    return measure_depth(truth, {0.05, 12.0}, seed, frame);
  };
  EXPECT_EQ(on_threads(1, 7, 2), on_threads(2, 7, 2));
  EXPECT_NE(on_threads(1, 7, 2), on_threads(1, 7, 3));
  EXPECT_NE(on_threads(1, 7, 2), on_threads(1, 8, 2));
}

}  // namespace depth_noise_test
}  // namespace nadir
