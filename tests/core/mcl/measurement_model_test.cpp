// SPDX-License-Identifier: Apache-2.0
#include "core/mcl/measurement_model.h"

#include <gmock/gmock.h>

#include <numeric>

#include "core/base/parallel.h"
#include "core/mcl/error_surface.h"
#include "tests/support/drawn_map.h"
#include "tests/support/made_topview.h"
#include "tests/support/scenery.h"

namespace nadir {
namespace measurement_model_test {

using testing::DoubleNear;
using testing::HasSubstr;

LocaliserOptions thesis() { return localiser_preset("thesis").value(); }

ParticleSet equal_particles(const std::vector<Rigid2>& poses) {
  ParticleSet particles;
  particles.resize(poses.size());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    particles.set_pose(i, poses[i]);
    particles.weight[i] = 1.0 / static_cast<double>(poses.size());
  }
  return particles;
}

TEST(MapMatcher, CountsMismatchesOfTheThesisByHand) {
  // Looking east from the left edge, cells 0 to 3 ahead in the lower row: R R T T on the map.
  const auto index = index_of(drawn_map(1.0, {"TTTT", "RRTT"}));
  LocaliserOptions options = thesis();
  options.alpha = ImportanceReading::kUniform;
  const auto matcher = MapMatcher::create(index, options).value();
  const auto seen =
      topview_of({{{0, 0}, kRoad}, {{1, 0}, kTerrain}, {{2, 0}, kTerrain}, {{3, 0}, kRoad}}, 1.0);
  EXPECT_DOUBLE_EQ(matcher.mean_cost(matcher.prepare(seen), {0.0, 0.0, 0.0}), 0.5);
}

TEST(MapMatcher, WeighsARareClassMoreByItsInverseShare) {
  const auto index = index_of(drawn_map(1.0, {"RRRRRRRT"}));
  const auto matcher = MapMatcher::create(index, thesis()).value();
  const auto wrong_road = topview_of({{{7, 0}, kRoad}, {{0, 0}, kRoad}}, 1.0);
  const auto wrong_terrain = topview_of({{{0, 0}, kTerrain}, {{1, 0}, kRoad}}, 1.0);
  EXPECT_DOUBLE_EQ(matcher.mean_cost(matcher.prepare(wrong_road), {}), 0.5);
  EXPECT_DOUBLE_EQ(matcher.mean_cost(matcher.prepare(wrong_terrain), {}), 7.0 / 8.0);
}

TEST(MapMatcher, LetsAParameterSayWhetherUnknownGroundIsAnError) {
  const auto index = index_of(drawn_map(1.0, {"RT.."}));
  const auto seen =
      topview_of({{{2, 0}, kRoad}, {{9, 0}, kRoad}}, 1.0);  // unclassified, and off the map
  LocaliserOptions options = thesis();
  for (const double unknown_cost : {0.0, 1.0}) {
    options.unknown_cost = unknown_cost;
    const auto matcher = MapMatcher::create(index, options).value();
    EXPECT_DOUBLE_EQ(matcher.mean_cost(matcher.prepare(seen), {}), unknown_cost);
  }
}

TEST(MapMatcher, LeavesOutClassesThatTheMapCannotAnswer) {
  const auto index = index_of(drawn_map(1.0, {"RRTT"}));
  const auto matcher = MapMatcher::create(index, thesis()).value();
  const auto cells = matcher.prepare(topview_of({{{0, 0}, kCar}, {{1, 0}, kCar}}, 1.0));
  EXPECT_TRUE(cells.empty());
}

TEST(MapMatcher, CostsADistanceThatGrowsUpToItsTruncation) {
  const auto index = index_of(drawn_map(1.0, {"RTTTTTTT"}));
  LocaliserOptions options;
  options.truncation_m = 4.0;
  const auto matcher = MapMatcher::create(index, options).value();
  const auto cost_at = [&](std::int16_t forward) {
    return matcher.mean_cost(matcher.prepare(topview_of({{{forward, 0}, kRoad}}, 1.0)), {});
  };
  EXPECT_THAT(cost_at(0), DoubleNear(0.0, 1e-9));
  EXPECT_THAT(cost_at(1), DoubleNear(0.25, 0.003));
  EXPECT_THAT(cost_at(2), DoubleNear(0.5, 0.003));
  EXPECT_THAT(cost_at(6), DoubleNear(1.0, 1e-9));
}

TEST(ClassCostRaster, OfAPartIsThatOfTheWholeButNearItsCut) {
  const auto whole = index_of(patchwork_map(120, 90, 0.2));
  OverheadMap part = whole->map();
  part.labels = Raster<ClassId>(70, 60);
  for (int row = 0; row < 60; ++row) {
    for (int column = 0; column < 70; ++column) {
      part.labels.at(column, row) = whole->map().labels.at(25 + column, 15 + row);
    }
  }
  const auto index = index_of(part);
  for (const MatchKind match : {MatchKind::kClass, MatchKind::kDistance}) {
    LocaliserOptions options;
    options.match = match;
    const int margin = match == MatchKind::kClass ? 0 : 5;  // the truncation of 1 m
    const CostRaster of_whole = class_cost_raster(*whole, kCurb, options);
    const CostRaster of_part = class_cost_raster(*index, kCurb, options);
    for (int row = margin; row < 60 - margin; ++row) {
      for (int column = margin; column < 70 - margin; ++column) {  // the border is one cell
        ASSERT_EQ(of_part.values[static_cast<std::size_t>((row + 1) * 72 + column + 1)],
                  of_whole.values[static_cast<std::size_t>((row + 16) * 122 + column + 26)]);
      }
    }
  }
}

TEST(MapMatcher, KeepsTheWeightOfAClassWhenItsCellsAreThinned) {
  const auto index = index_of(patchwork_map(200, 200, 0.2));
  const auto seen = perfect_topview(index->map(), {20.0, 20.0, 0.4}, 12.0);
  LocaliserOptions all;
  all.max_cells_per_class = 0;
  LocaliserOptions thinned;
  thinned.max_cells_per_class = 100;
  const auto full = MapMatcher::create(index, all).value();
  const auto thin = MapMatcher::create(index, thinned).value();
  const auto full_cells = full.prepare(seen);
  const auto thin_cells = thin.prepare(seen);
  EXPECT_NEAR(full_cells.total_weight, thin_cells.total_weight, 1e-9 * full_cells.total_weight);
  EXPECT_DOUBLE_EQ(full_cells.area_m2, thin_cells.area_m2);
  for (const auto& group : thin_cells.classes) EXPECT_LE(group.cells.size(), 100U);
  const Rigid2 elsewhere{22.0, 21.0, 0.9};
  EXPECT_NEAR(full.mean_cost(full_cells, elsewhere), thin.mean_cost(thin_cells, elsewhere), 0.05);
}

TEST(MapMatcher, CostsNothingAtTheTruePoseOfAPerfectObserverAndMoreElsewhere) {
  const auto index = index_of(patchwork_map(200, 200, 0.2));
  const Rigid2 truth{20.0, 18.0, 0.7};
  const auto matcher = MapMatcher::create(index, thesis()).value();
  const auto cells = matcher.prepare(perfect_topview(index->map(), truth, 12.0));
  EXPECT_LT(matcher.mean_cost(cells, truth), 0.002);  // fixed point, at borders
  for (const Rigid2& offset :
       {Rigid2{2.0, 0.0, 0.0}, Rigid2{0.0, -2.0, 0.0}, Rigid2{0.0, 0.0, 0.3}}) {
    EXPECT_GT(matcher.mean_cost(cells, truth * offset), 0.2);
  }
}

TEST(MapMatcher, RefusesAMapThatCannotTellPlacesApart) {
  const auto created = MapMatcher::create(index_of(drawn_map(1.0, {"RRRR"})), {});
  ASSERT_FALSE(created.has_value());
  EXPECT_THAT(created.error().message, HasSubstr("one class"));
}

TEST(ApplyLikelihood, IsTheFormulaOfTheThesis) {
  ParticleSet particles = equal_particles({{}, {}, {}});
  LocaliserOptions options = thesis();
  options.gamma0 = 0.5;
  apply_likelihood(particles, {0.2, 0.4, 0.1}, 1.0, options);
  const double eta = 0.5 * 0.4;
  const double w0 = 1.0 / std::exp(0.2 / eta);
  const double w1 = 1.0 / std::exp(0.4 / eta);
  const double w2 = 1.0 / std::exp(0.1 / eta);
  EXPECT_NEAR(particles.weight[0], w0 / (w0 + w1 + w2), 1e-15);
  EXPECT_NEAR(particles.weight[1], w1 / (w0 + w1 + w2), 1e-15);
  EXPECT_NEAR(particles.weight[2], w2 / (w0 + w1 + w2), 1e-15);
}

TEST(ApplyLikelihood, LeavesWeightsAsTheyAreWhenAllCostsAreEqual) {
  for (const char* preset : {"thesis", "default"}) {
    for (const double cost : {0.0, 0.7}) {
      ParticleSet particles = equal_particles({{}, {}});
      particles.weight = {0.25, 0.75};
      apply_likelihood(particles, {cost, cost}, 1.0, localiser_preset(preset).value());
      EXPECT_NEAR(particles.weight[0], 0.25, 1e-15);
    }
  }
}

TEST(ApplyLikelihood, SurvivesCostsThatWouldUnderflow) {
  ParticleSet particles = equal_particles({{}, {}});
  particles.weight = {0.0, 1.0};  // the better particle has lost all its weight before
  LocaliserOptions options;
  options.temperature = 1e-6;
  apply_likelihood(particles, {0.0, 1.0}, 1.0, options);
  EXPECT_EQ(particles.weight[0], 0.0);
  EXPECT_EQ(particles.weight[1], 1.0);
}

TEST(ApplyLikelihood, NeverLeavesFewerEffectiveParticlesThanAsked) {
  ParticleSet particles = equal_particles(std::vector<Rigid2>(1000));
  std::vector<double> costs(1000, 0.6);
  for (std::size_t i = 0; i < costs.size(); ++i) costs[i] -= 0.0005 * static_cast<double>(i);
  LocaliserOptions options;
  options.temperature = 1e-5;
  options.min_effective_fraction = 0.0;
  ParticleSet decided = particles;
  apply_likelihood(decided, costs, 1.0, options);
  EXPECT_LT(effective_sample_size(decided), 2.0);
  options.min_effective_fraction = 0.05;
  apply_likelihood(particles, costs, 1.0, options);
  EXPECT_GE(effective_sample_size(particles), 50.0);
  EXPECT_LT(effective_sample_size(particles), 200.0);
  EXPECT_EQ(
      std::max_element(particles.weight.begin(), particles.weight.end()) - particles.weight.begin(),
      999);
}

TEST(ApplyLikelihood, SaysLessWithLessEvidence) {
  LocaliserOptions options;
  options.min_effective_fraction = 0.0;
  ParticleSet full = equal_particles({{}, {}});
  ParticleSet weak = full;
  apply_likelihood(full, {0.1, 0.12}, 1.0, options);
  apply_likelihood(weak, {0.1, 0.12}, 0.25, options);
  EXPECT_GT(full.weight[0], weak.weight[0]);
  EXPECT_GT(weak.weight[0], 0.5);
  EXPECT_NEAR(std::log(full.weight[0] / full.weight[1]),
              4.0 * std::log(weak.weight[0] / weak.weight[1]), 1e-9);
}

TEST(Agreement, IsTheShareOfKnownCellsWithTheClassOfTheMap) {
  const OverheadMap map = drawn_map(1.0, {"RRT."});
  const auto seen =
      topview_of({{{0, 0}, kRoad}, {{1, 0}, kTerrain}, {{2, 0}, kTerrain}, {{3, 0}, kRoad}}, 1.0);
  EXPECT_NEAR(agreement(seen, map, {}).value(), 2.0 / 3.0, 1e-12);
  EXPECT_FALSE(agreement(seen, map, {100.0, 0.0, 0.0}).has_value());
}

TEST(ErrorSurface, HasItsLeastCostAtTheTruePoseAndTheKernelsValuesEverywhere) {
  const auto index = index_of(patchwork_map(200, 200, 0.2));
  const Rigid2 truth{20.0, 18.0, 0.7};
  const auto matcher = MapMatcher::create(index, {}).value();
  const auto seen = perfect_topview(index->map(), truth, 12.0);
  const auto surface = error_surface(matcher, seen, truth, {21, 21, 5, 0.2, 0.05}).value();
  const auto least = std::min_element(surface.mean_cost.begin(), surface.mean_cost.end());
  EXPECT_EQ(least - surface.mean_cost.begin(), (2 * 21 + 10) * 21 + 10);
  EXPECT_EQ(surface.pose(10, 10, 2), truth);
  const auto cells = matcher.prepare(seen);
  EXPECT_FLOAT_EQ(surface.at(3, 17, 4),
                  static_cast<float>(matcher.mean_cost(cells, surface.pose(3, 17, 4))));
  EXPECT_GT(surface.pose(20, 10, 2).x_m, truth.x_m);
  EXPECT_GT(surface.pose(10, 20, 2).y_m, truth.y_m);
}

TEST(ErrorSurface, IsTheSameOnOneAndOnFourThreads) {
  const auto index = index_of(patchwork_map(100, 100, 0.2));
  const auto matcher = MapMatcher::create(index, {}).value();
  const auto seen = perfect_topview(index->map(), {10.0, 10.0, 0.7}, 6.0);
  const auto surface_on = [&](int threads) {
    const ThreadLimit limit(threads);
    return error_surface(matcher, seen, {10.0, 10.0, 0.5}).value().mean_cost;
  };
  EXPECT_EQ(surface_on(1), surface_on(4));
}

TEST(ErrorSurface, RefusesGridsThatMakeNoSense) {
  const auto index = index_of(drawn_map(1.0, {"RRTT"}));
  const auto matcher = MapMatcher::create(index, {}).value();
  const auto seen = topview_of({{{0, 0}, kRoad}}, 1.0);
  EXPECT_THAT(error_surface(matcher, seen, {}, {.count_x = 0}).error().message,
              HasSubstr("0 x 41 x 1"));
  EXPECT_THAT(error_surface(matcher, seen, {}, {.step_m = -1.0}).error().message,
              HasSubstr("not positive"));
  EXPECT_THAT(error_surface(matcher, topview_of({{{0, 0}, kCar}}, 1.0), {}).error().message,
              HasSubstr("no cell"));
}

}  // namespace measurement_model_test
}  // namespace nadir
