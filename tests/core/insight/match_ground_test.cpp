// SPDX-License-Identifier: Apache-2.0
#include "core/insight/match_ground.h"

#include <gmock/gmock.h>

#include "core/base/random.h"
#include "tests/support/scenery.h"

namespace nadir {
namespace match_ground_test {

constexpr double kCellM = 0.2;

/// A rectangle that may reach beyond the map, and other labels for it, some of them none.
std::pair<CellRect, Raster<ClassId>> random_patch(std::uint32_t number) {
  const auto words = random_words({.seed = 3, .particle = number});
  const auto width = static_cast<int>(1 + words[0] % 40);
  const auto height = static_cast<int>(1 + words[1] % 40);
  const auto left = static_cast<std::int64_t>(words[2] % 150) - 20;
  const auto top = static_cast<std::int64_t>(words[3] % 120) - 20;
  Raster<ClassId> labels(width, height);
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      constexpr ClassId kLabels[] = {kRoad, kTerrain, kCurb, kBuilding, kUnclassified, kSidewalk};
      labels.at(column, row) =
          kLabels[(words[0] + static_cast<std::uint32_t>(column / 7 + row / 5)) % 6];
    }
  }
  return {{left, top, left + width, top + height}, std::move(labels)};
}

void expect_the_numbers_of_a_fresh_one(const MatchGround& ground) {
  const auto fresh = MatchGround::create(ground.map(), ground.options(), 1.0).value();
  for (ClassId id = 0; id < kClassCount; ++id) {
    if (ground.weights()[id] <= 0.0 || fresh.weights()[id] <= 0.0) continue;
    ASSERT_EQ(ground.cost_raster(id).values, fresh.cost_raster(id).values) << int{id};
  }
}

TEST(MatchGround, HasTheCostsOfTheFiltersOwnMatcher) {
  const auto index = index_of(patchwork_map(140, 110, kCellM));
  for (const MatchKind match : {MatchKind::kDistance, MatchKind::kClass}) {
    LocaliserOptions options;
    options.match = match;
    const auto ground = MatchGround::create(index->map(), options, 0.05).value();
    const auto matcher = MapMatcher::create(index, options).value();
    EXPECT_EQ(ground.weights(), importance_weights(index->statistics(), options.alpha));
    for (ClassId id = 0; id < kClassCount; ++id) {
      if (ground.weights()[id] <= 0.0) continue;
      ASSERT_EQ(ground.cost_raster(id).values, matcher.cost_raster(id).values) << int{id};
    }
  }
}

TEST(MatchGround, RedrawnHasTheCostsOfAFreshOne) {
  for (const MatchKind match : {MatchKind::kDistance, MatchKind::kClass}) {
    LocaliserOptions options;
    options.match = match;
    options.truncation_m = 1.5;
    auto ground = MatchGround::create(patchwork_map(140, 110, kCellM), options, 1.0).value();
    for (std::uint32_t i = 0; i < 12; ++i) {
      const auto [cells, labels] = random_patch(i);
      ground.redraw(cells, labels);
      expect_the_numbers_of_a_fresh_one(ground);
    }
  }
}

TEST(MatchGround, TakesWeightsAnewOnceTheyAreTooFarOff) {
  auto exact = MatchGround::create(patchwork_map(140, 110, kCellM), {}, 0.0).value();
  auto patient = MatchGround::create(patchwork_map(140, 110, kCellM), {}, 0.2).value();
  const ClassWeights first = patient.weights();
  const Raster<ClassId> spot(3, 3, kBuilding);
  EXPECT_TRUE(exact.redraw({50, 50, 53, 53}, spot));
  EXPECT_EQ(exact.weights(),
            importance_weights(class_statistics(exact.map().labels), exact.options().alpha));
  EXPECT_FALSE(patient.redraw({50, 50, 53, 53}, spot));
  EXPECT_EQ(patient.weights(), first);
  // A class that the map did not hold had no weight at all.
  EXPECT_TRUE(patient.redraw({60, 50, 63, 53}, Raster<ClassId>(3, 3, kLaneMarking)));
  EXPECT_GT(patient.weights()[kLaneMarking], 0.0);
  expect_the_numbers_of_a_fresh_one(patient);
}

TEST(MatchGround, OfNoLabelsHasNoWeights) {
  OverheadMap map = patchwork_map(20, 20, kCellM);
  map.labels = Raster<ClassId>(20, 20, kUnclassified);
  auto ground = MatchGround::create(map, {}, 0.05).value();
  EXPECT_EQ(ground.weights(), ClassWeights{});
  EXPECT_TRUE(ground.redraw({0, 0, 2, 2}, Raster<ClassId>(2, 2, kRoad))) << "the first label";
  EXPECT_GT(ground.weights()[kRoad], 0.0);
  EXPECT_FALSE(ground.redraw({30, 30, 32, 32}, Raster<ClassId>(2, 2, kRoad))) << "off the map";
}

}  // namespace match_ground_test
}  // namespace nadir
