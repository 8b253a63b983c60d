// SPDX-License-Identifier: Apache-2.0
#include "core/map/distance_field.h"

#include <gmock/gmock.h>

#include <cmath>

#include "core/base/parallel.h"
#include "core/base/random.h"
#include "tests/support/drawn_map.h"

namespace nadir {
namespace distance_field_test {

using testing::DoubleNear;
using testing::Each;
using testing::ElementsAre;

auto near_m(double value) { return DoubleNear(value, 0.05); }

/// Few cells of road at random places.
OverheadMap sprinkled_map(int width, int height, std::uint32_t one_in, std::uint64_t seed) {
  OverheadMap map = drawn_map(0.5, {"."});
  map.labels = Raster<ClassId>(width, height, kTerrain);
  for (std::size_t i = 0; i < map.labels.size(); ++i) {
    const DrawId draw{seed, 0, 0, static_cast<std::uint32_t>(i), 0};
    if (random_words(draw)[0] % one_in == 0) map.labels.values()[i] = kRoad;
  }
  return map;
}

/// The definition, cell by cell.
std::uint8_t expected_code(const OverheadMap& map, int column, int row, double truncation_m) {
  double nearest_m = truncation_m;
  for (int y = 0; y < map.labels.height(); ++y) {
    for (int x = 0; x < map.labels.width(); ++x) {
      if (map.labels.at(x, y) != kRoad) continue;
      const double squared = (x - column) * (x - column) + (y - row) * (y - row);
      nearest_m = std::min(nearest_m, map.metres_per_cell * std::sqrt(squared));
    }
  }
  return static_cast<std::uint8_t>(std::lround(255.0 * nearest_m / truncation_m));
}

TEST(ClassDistanceField, IsZeroOnTheClassAndGrowsInMetres) {
  const OverheadMap map = drawn_map(2.0 /* metres_per_cell */, {"..R..",  //
                                                                "..R..",  //
                                                                "....."});
  const DistanceField field = build_class_distance_field(map, kRoad);
  EXPECT_THAT(field.row_m(0), ElementsAre(near_m(4.0), near_m(2.0), 0.0, near_m(2.0), near_m(4.0)));
  EXPECT_THAT(field.row_m(2),
              ElementsAre(near_m(4.47), near_m(2.83), near_m(2.0), near_m(2.83), near_m(4.47)));
}

TEST(ClassDistanceField, EqualsTheDefinitionOnRandomMaps) {
  std::uint64_t seed = 1;
  for (const auto& [width, height] : {std::pair(37, 23), std::pair(1, 40), std::pair(40, 1),
                                      std::pair(300, 7), std::pair(5, 290)}) {
    for (const std::uint32_t one_in : {3U, 40U, 1000U}) {
      for (const double truncation_m : {1.3, 6.0, 200.0}) {
        const OverheadMap map = sprinkled_map(width, height, one_in, seed++);
        const DistanceField field = build_class_distance_field(map, kRoad, truncation_m);
        for (int row = 0; row < height; ++row) {
          for (int column = 0; column < width; ++column) {
            ASSERT_EQ(field.codes.at(column, row), expected_code(map, column, row, truncation_m))
                << width << " x " << height << " at " << column << ", " << row;
          }
        }
      }
    }
  }
}

TEST(ClassDistanceField, IsTheTruncationWhereTheMapHasNoSuchClass) {
  const OverheadMap map = drawn_map(1.0, {"RRR", "RRR"});
  const DistanceField field = build_class_distance_field(map, kCurb, 7.0);
  EXPECT_THAT(field.codes.values(), Each(255));
  EXPECT_DOUBLE_EQ(field.distance_m(1, 1), 7.0);
}

TEST(ClassDistanceField, IsTruncatedFarFromTheClass) {
  const OverheadMap map = drawn_map(1.0, {"R........."});
  const DistanceField field = build_class_distance_field(map, kRoad, 5.0);
  EXPECT_DOUBLE_EQ(field.distance_m(5, 0), 5.0);
  EXPECT_DOUBLE_EQ(field.distance_m(9, 0), 5.0);
  EXPECT_NEAR(field.distance_m(4, 0), 4.0, 5.0 / 510.0);
}

TEST(ClassDistanceField, IsTheSameOnOneAndFourThreads) {
  const OverheadMap map = sprinkled_map(700, 600, 500, 9);
  const auto codes_on = [&](int threads) {
    const ThreadLimit limit(threads);
    return build_class_distance_field(map, kRoad, 12.0).codes;
  };
  EXPECT_EQ(codes_on(1), codes_on(4));
}

TEST(ClassDistanceField, NeedsAPositiveTruncation) {
  const OverheadMap map = drawn_map(1.0, {"RT"});
  EXPECT_THROW(static_cast<void>(build_class_distance_field(map, kRoad, 0.0)), std::logic_error);
}

}  // namespace distance_field_test
}  // namespace nadir
