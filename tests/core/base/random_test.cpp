// SPDX-License-Identifier: Apache-2.0
#include "core/base/random.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "core/base/parallel.h"

namespace nadir {
namespace random_test {

using testing::ElementsAre;

constexpr std::uint32_t kTestStream = 99;

std::uint64_t seed_of(std::uint32_t low, std::uint32_t high) {
  return (static_cast<std::uint64_t>(high) << 32U) | low;
}

// The vectors of Random123's file kat_vectors, philox4x32 with 10 rounds; counter words are draw,
// particle, step, stream.
TEST(RandomWords, AgreeWithThePublishedAnswerForZero) {
  EXPECT_THAT(random_words({0, 0, 0, 0, 0}),
              ElementsAre(0x6627e8d5U, 0xe169c58dU, 0xbc57ac4cU, 0x9b00dbd8U));
}

TEST(RandomWords, AgreeWithThePublishedAnswerForAllOnes) {
  constexpr std::uint32_t kOnes = 0xffffffffU;
  EXPECT_THAT(random_words({seed_of(kOnes, kOnes), kOnes, kOnes, kOnes, kOnes}),
              ElementsAre(0x408f276dU, 0x41c83b0eU, 0xa20bc7c6U, 0x6d5451fdU));
}

TEST(RandomWords, AgreeWithThePublishedAnswerForTheDigitsOfPi) {
  const DrawId id{.seed = seed_of(0xa4093822U, 0x299f31d0U),
                  .stream = 0x03707344U,
                  .step = 0x13198a2eU,
                  .particle = 0x85a308d3U,
                  .draw = 0x243f6a88U};
  EXPECT_THAT(random_words(id), ElementsAre(0xd16cfe09U, 0x94fdcceb, 0x5001e420U, 0x24126ea1U));
}

TEST(RandomWords, EveryPartOfTheIdChangesEveryWord) {
  const DrawId base{1, kTestStream, 2, 3, 4};
  std::vector<DrawId> others(6, base);
  others[0].seed = 2;
  others[1].seed = 1ULL + (1ULL << 32U);
  others[2].stream = kTestStream + 1;
  others[3].step = 7;
  others[4].particle = 8;
  others[5].draw = 9;
  const auto words = random_words(base);
  for (const DrawId& other : others) {
    const auto changed = random_words(other);
    for (std::size_t i = 0; i < words.size(); ++i) EXPECT_NE(changed[i], words[i]);
  }
}

TEST(RandomStream, PurposesDoNotShareNumbers) {
  std::set<std::uint32_t> first_words;
  const std::vector<std::uint32_t> streams = {
      kInitialPose, kMotionNoise, kResampling,   kBlur,     kOdometryNoise,
      kDepthNoise,  kLabelNoise,  kWorldObjects, kAttitude, kTownDrawing};
  for (const std::uint32_t stream : streams)
    first_words.insert(random_words({1, stream, 0, 0, 0})[0]);
  EXPECT_EQ(first_words.size(), streams.size());
}

TEST(Uniforms, LieInTheUnitIntervalWithoutItsEnd) {
  for (std::uint32_t i = 0; i < 100'000; ++i) {
    for (const double value : uniforms({3, kTestStream, 0, i, 0})) {
      ASSERT_GE(value, 0.0);
      ASSERT_LT(value, 1.0);
    }
  }
}

TEST(Uniforms, FillTheIntervalEvenly) {
  constexpr int kBins = 64;
  constexpr std::uint32_t kDraws = 100'000;
  std::vector<int> counts(kBins);
  for (std::uint32_t i = 0; i < kDraws; ++i) {
    for (const double value : uniforms({4, kTestStream, i, 0, 0})) {
      ++counts[static_cast<std::size_t>(value * kBins)];
    }
  }
  const double expected = 2.0 * kDraws / kBins;
  double chi_square = 0.0;
  for (const int count : counts) chi_square += (count - expected) * (count - expected) / expected;
  EXPECT_LT(chi_square, 103.4);  // 63 degrees of freedom, one in a thousand
  EXPECT_GT(chi_square, 33.0);
}

TEST(StandardNormals, HaveTheMomentsOfTheNormalDistribution) {
  constexpr std::uint32_t kDraws = 200'000;
  double sum = 0.0, sum2 = 0.0, sum3 = 0.0, sum4 = 0.0, product = 0.0;
  for (std::uint32_t i = 0; i < kDraws; ++i) {
    const auto [a, b] = standard_normals({5, kTestStream, 0, i, 0});
    for (const double x : {a, b}) {
      sum += x;
      sum2 += x * x;
      sum3 += x * x * x;
      sum4 += x * x * x * x;
    }
    product += a * b;
  }
  constexpr double kCount = 2.0 * kDraws;
  // Five standard errors each: 1, sqrt 2, sqrt 15 and sqrt 96 over the root of the count.
  const double error = 5.0 / std::sqrt(kCount);
  EXPECT_NEAR(sum / kCount, 0.0, error);
  EXPECT_NEAR(sum2 / kCount, 1.0, error * std::sqrt(2.0));
  EXPECT_NEAR(sum3 / kCount, 0.0, error * std::sqrt(15.0));
  EXPECT_NEAR(sum4 / kCount, 3.0, error * std::sqrt(96.0));
  EXPECT_NEAR(product / kDraws, 0.0, 5.0 / std::sqrt(1.0 * kDraws));
}

TEST(StandardNormals, FollowTheNormalDistributionFunction) {
  constexpr std::uint32_t kDraws = 50'000;
  std::vector<double> values;
  for (std::uint32_t i = 0; i < kDraws; ++i) {
    const auto pair = standard_normals({6, kTestStream, 0, 0, i});
    values.insert(values.end(), pair.begin(), pair.end());
  }
  std::sort(values.begin(), values.end());
  double largest = 0.0;  // Kolmogorov and Smirnov's distance
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double expected = 0.5 * std::erfc(-values[i] / std::sqrt(2.0));
    const double found = (static_cast<double>(i) + 0.5) / static_cast<double>(values.size());
    largest = std::max(largest, std::abs(found - expected));
  }
  EXPECT_LT(largest, 1.95 / std::sqrt(static_cast<double>(values.size())));  // one in a thousand
}

TEST(StandardNormals, AreAlwaysFinite) {
  for (std::uint32_t i = 0; i < 200'000; ++i) {
    const auto [a, b] = standard_normals({i, i, i, i, i});
    ASSERT_TRUE(std::isfinite(a) && std::isfinite(b));
  }
}

TEST(StandardNormals, DoNotDependOnTheThreadThatDrawsThem) {
  constexpr std::size_t kDraws = 10'000;
  const auto drawn_on = [](int threads) {
    const ThreadLimit limit(threads);
    std::vector<double> values(kDraws);
    parallel_for(kDraws, 64, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        values[i] = standard_normals({1, kTestStream, 0, static_cast<std::uint32_t>(i), 0})[0];
      }
    });
    return values;
  };
  EXPECT_EQ(drawn_on(1), drawn_on(4));
}

}  // namespace random_test
}  // namespace nadir
