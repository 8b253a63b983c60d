// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <span>

#include "core/base/random.h"
#include "core/eval/series.h"

namespace nadir {
namespace decimate_test {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::IsNan;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::vector<double> count_up(std::size_t count) {
  std::vector<double> x(count);
  for (std::size_t i = 0; i < count; ++i) x[i] = static_cast<double>(i);
  return x;
}

/// A random walk at uneven times, with gaps of different lengths in some seeds.
PointLine random_line(std::uint64_t seed, std::uint32_t count, bool with_gaps) {
  PointLine line;
  double time_s = 3.0;
  double value = 0.0;
  std::uint32_t gap_until = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto [u, v] = uniforms({.seed = seed, .step = i});
    time_s += i % 7 == 0 ? 0.0 : u;  // sometimes two at the same time
    value += standard_normals({.seed = seed, .step = i, .draw = 1})[0];
    if (with_gaps && v < 0.02) gap_until = i + 1 + static_cast<std::uint32_t>(600.0 * v);
    line.x.push_back(time_s);
    line.y.push_back(i < gap_until ? kNaN : value);
  }
  return line;
}

using Points = std::vector<std::pair<double, double>>;

/// The pieces between the breaks of a line.
std::vector<Points> pieces_of(const PointLine& line) {
  std::vector<Points> pieces;
  bool is_broken = true;
  for (std::size_t i = 0; i < line.x.size(); ++i) {
    if (!std::isfinite(line.y[i])) {
      is_broken = true;
      continue;
    }
    if (is_broken) pieces.emplace_back();
    is_broken = false;
    pieces.back().emplace_back(line.x[i], line.y[i]);
  }
  return pieces;
}

TEST(DecimateMinMax, KeepsTheEndsAndTheExtremesOfEachBucketInOrder) {
  //                                 bucket 0: x in [0, 4)     bucket 1: x in [4, 8]
  const std::vector<double> y = {1.0, 5.0, -2.0, 3.0, /**/ 2.0, 2.5, 9.0, 0.0, 4.0};
  const PointLine line = decimate_min_max(count_up(9), y, 2);
  EXPECT_THAT(line.x, ElementsAre(0.0, 1.0, 2.0, 6.0, 7.0, 8.0));
  EXPECT_THAT(line.y, ElementsAre(1.0, 5.0, -2.0, 9.0, 0.0, 4.0));
}

TEST(DecimateMinMax, KeepsABreakAndTheWidthOfItsGap) {
  const std::vector<double> y = {0.0, 3.0, 1.0, kNaN, kNaN, kNaN, 2.0, 8.0, 5.0, 6.0};
  const PointLine line = decimate_min_max(count_up(10), y, 1);
  EXPECT_THAT(line.x, ElementsAre(0.0, 1.0, 2.0, 3.0, 6.0, 7.0, 9.0));
  EXPECT_THAT(line.y, ElementsAre(0.0, 3.0, 1.0, IsNan(), 2.0, 8.0, 6.0));
}

TEST(DecimateMinMax, LeavesOutBreaksThatSeparateNothing) {
  const std::vector<double> y = {kNaN, kNaN, 1.0, kInfinity, 2.0, -kInfinity};
  const PointLine line = decimate_min_max(count_up(6), y, 100);
  EXPECT_THAT(line.x, ElementsAre(2.0, 3.0, 4.0));
  EXPECT_THAT(line.y, ElementsAre(1.0, IsNan(), 2.0)) << "what is infinite breaks as well";
  EXPECT_THAT(decimate_min_max(count_up(3), std::vector(3, kNaN), 2).x, IsEmpty());
  EXPECT_THAT(decimate_min_max({}, {}, 2).x, IsEmpty());
}

TEST(DecimateMinMax, LeavesAShortLineAsItIs) {
  const PointLine whole = random_line(1, 200, false);
  const PointLine line = decimate_min_max(whole.x, whole.y, 100);
  EXPECT_EQ(line.x, whole.x);
  EXPECT_EQ(line.y, whole.y);
  EXPECT_LT(decimate_min_max(whole.x, whole.y, 99).x.size(), 200U);
  const std::span most_x = std::span(whole.x).first(199);
  const std::span most_y = std::span(whole.y).first(199);
  EXPECT_LT(decimate_min_max(most_x, most_y, 99).x.size(), 199U) << "one point too many";
}

TEST(DecimateMinMax, HasTheSameExtremesInEveryBucketOfEveryPiece) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const PointLine whole = random_line(seed, 5000, seed > 3);
    for (const std::size_t buckets : {1U, 7U, 300U, 2400U}) {
      const PointLine line = decimate_min_max(whole.x, whole.y, buckets);
      const auto bucket_of = [&](double x) {
        const double share = (x - whole.x.front()) / (whole.x.back() - whole.x.front());
        return std::min(static_cast<std::size_t>(share * static_cast<double>(buckets)),
                        buckets - 1);
      };
      const auto extremes = [&](const Points& piece) {
        std::map<std::size_t, std::pair<double, double>> found;
        for (const auto& [x, y] : piece) {
          auto& [least, most] = found.try_emplace(bucket_of(x), y, y).first->second;
          least = std::min(least, y);
          most = std::max(most, y);
        }
        return found;
      };
      const auto pieces = pieces_of(whole);
      const auto kept = pieces_of(line);
      ASSERT_EQ(kept.size(), pieces.size());
      for (std::size_t i = 0; i < pieces.size(); ++i) {
        EXPECT_EQ(kept[i].front(), pieces[i].front());
        EXPECT_EQ(kept[i].back(), pieces[i].back());
        EXPECT_EQ(extremes(kept[i]), extremes(pieces[i]));
        const auto least =
            std::min_element(pieces[i].begin(), pieces[i].end(),
                             [](const auto& a, const auto& b) { return a.second < b.second; });
        EXPECT_NE(std::find(kept[i].begin(), kept[i].end(), *least), kept[i].end());
        EXPECT_TRUE(std::includes(pieces[i].begin(), pieces[i].end(), kept[i].begin(),
                                  kept[i].end(),
                                  [](const auto& a, const auto& b) { return a.first < b.first; }));
      }
      EXPECT_LE(line.x.size(), 2 * buckets + 5 * pieces.size() - 3);
      EXPECT_LE(line.x.size(), whole.x.size());
      EXPECT_TRUE(std::is_sorted(line.x.begin(), line.x.end()));
    }
  }
}

TEST(DecimateMinMax, LeavesOfHalfAMillionPointsNoMoreThanTwiceTheBuckets) {
  const PointLine whole = random_line(2, 500'000, false);
  const PointLine line = decimate_min_max(whole.x, whole.y, 1600);
  EXPECT_LE(line.x.size(), 3202U);
  EXPECT_GT(line.x.size(), 3000U);
  EXPECT_EQ(line.x.front(), whole.x.front());
  EXPECT_EQ(line.y.back(), whole.y.back());
  EXPECT_EQ(*std::max_element(line.y.begin(), line.y.end()),
            *std::max_element(whole.y.begin(), whole.y.end()));
}

TEST(DecimateMinMax, KeepsASpikeOfOnePoint) {
  std::vector<double> y(10'000, 0.0);
  y[6789] = 1.0;
  const PointLine line = decimate_min_max(count_up(y.size()), y, 50);
  const auto spike = std::find(line.y.begin(), line.y.end(), 1.0);
  ASSERT_NE(spike, line.y.end());
  EXPECT_EQ(line.x[static_cast<std::size_t>(spike - line.y.begin())], 6789.0);
}

TEST(DecimateMinMax, CountsPointsAtTheLastTimeIntoTheLastBucket) {
  const std::vector<double> x = {0.0, 1.0, 2.0, 3.0, 3.0, 3.0, 3.0};
  const PointLine line = decimate_min_max(x, std::vector{0.0, -5.0, 5.0, 1.0, 3.0, -1.0, 2.0}, 1);
  EXPECT_THAT(line.y, ElementsAre(0.0, -5.0, 5.0, 2.0));
}

TEST(DecimateMinMax, TakesPointsAtOneAndTheSameTime) {
  const std::vector<double> x(6, 4.0);
  const PointLine line = decimate_min_max(x, std::vector{1.0, 3.0, -1.0, 2.0, 0.0, 0.5}, 2);
  EXPECT_THAT(line.y, ElementsAre(1.0, 3.0, -1.0, 0.5));
}

TEST(DecimateMinMax, RefusesWhatIsNoLine) {
  const auto decimate = [](const std::vector<double>& x, std::size_t ys, std::size_t buckets) {
    static_cast<void>(decimate_min_max(x, std::vector<double>(ys, 0.0), buckets));
  };
  EXPECT_THROW(decimate({0.0, 1.0}, 3, 1), std::logic_error);
  EXPECT_THROW(decimate({0.0, 1.0}, 2, 0), std::logic_error);
  EXPECT_THROW(decimate({0.0, 2.0, 1.0, 3.0}, 4, 1), std::logic_error);
  EXPECT_THROW(decimate({0.0, kNaN, 1.0}, 3, 1), std::logic_error);
  EXPECT_THROW(decimate({kInfinity}, 1, 1), std::logic_error);
  EXPECT_THROW(decimate({-1e308, 1e308}, 2, 1), std::logic_error);
}

}  // namespace decimate_test
}  // namespace nadir
