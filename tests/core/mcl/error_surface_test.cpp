// SPDX-License-Identifier: Apache-2.0
#include "core/mcl/error_surface.h"

#include <gmock/gmock.h>

#include <limits>

#include "core/base/parallel.h"
#include "tests/support/drawn_map.h"
#include "tests/support/made_topview.h"
#include "tests/support/scenery.h"

namespace nadir {
namespace error_surface_test {

constexpr double kCellM = 0.2;

const std::shared_ptr<const MapIndex>& patchwork() {
  static const auto index = index_of(patchwork_map(200, 160, kCellM));  // 40 m x 32 m
  return index;
}

/// Every number by the matcher itself, one pose at a time.
std::vector<float> one_by_one(const ErrorSurface& surface,
                              const MapMatcher& matcher,
                              const SemanticTopview& seen) {
  const MatchCells cells = matcher.prepare(seen);
  std::vector<float> costs;
  for (int iyaw = 0; iyaw < surface.grid.count_yaw; ++iyaw) {
    for (int iy = 0; iy < surface.grid.count_y; ++iy) {
      for (int ix = 0; ix < surface.grid.count_x; ++ix) {
        costs.push_back(static_cast<float>(matcher.mean_cost(cells, surface.pose(ix, iy, iyaw))));
      }
    }
  }
  return costs;
}

void expect_the_matchers_numbers(const Rigid2& centre,
                                 const ErrorSurfaceGrid& grid,
                                 const SemanticTopview& seen,
                                 const LocaliserOptions& options = {}) {
  const auto matcher = MapMatcher::create(patchwork(), options).value();
  const auto surface = error_surface(matcher, seen, centre, grid);
  ASSERT_TRUE(surface.has_value()) << surface.error().message;
  EXPECT_EQ(surface->mean_cost, one_by_one(*surface, matcher, seen))
      << grid.count_x << " x " << grid.count_y << " x " << grid.count_yaw << " poses "
      << grid.step_m << " m apart around " << centre.x_m << ' ' << centre.y_m;
}

TEST(ErrorSurfaceOfWholeCells, HasTheMatchersNumbersForAnyStepAndCount) {
  const auto seen = perfect_topview(patchwork()->map(), {20.0, 16.0, 0.7}, 10.0);
  for (const double cells : {1.0, 2.0, 3.0, 10.0}) {
    expect_the_matchers_numbers({20.03, 16.07, 0.65}, {21, 17, 3, cells * kCellM, 0.3}, seen);
  }
  for (const int count : {1, 2, 63, 64, 65, 130}) {
    expect_the_matchers_numbers({19.77, 15.5, -2.9}, {count, 2, 2, kCellM, 0.1}, seen);
    expect_the_matchers_numbers({19.77, 15.5, 3.1}, {3, count, 1, 2 * kCellM, 0.1}, seen);
  }
}

TEST(ErrorSurfaceOfWholeCells, HasTheMatchersNumbersAtTheEdgeOfTheMapAndFarOffIt) {
  const auto seen = random_topview(3, 40, 6, kCellM);
  for (const Rigid2& centre :
       {Rigid2{0.0, 0.0, 0.4}, Rigid2{40.0, 32.0, 2.0}, Rigid2{-7.0, 50.0, -1.0},
        Rigid2{-1e4, 3.0, 0.0}, Rigid2{850.0, 16.0, 1.0}, Rigid2{1e7, 1e7, 0.3}}) {
    expect_the_matchers_numbers(centre, {31, 31, 2, kCellM, 0.5}, seen);
  }
}

TEST(ErrorSurfaceOfWholeCells, HasTheMatchersNumbersWhereThereIsNoPose) {
  const auto seen = random_topview(3, 10, 6, kCellM);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Rigid2& centre : {Rigid2{nan, 10.0, 0.0}, Rigid2{10.0, nan, 0.0},
                               Rigid2{10.0, 10.0, nan}, Rigid2{nan, nan, nan}}) {
    expect_the_matchers_numbers(centre, {5, 4, 2, kCellM, 0.5}, seen);
    expect_the_matchers_numbers(centre, {1, 1, 2, kCellM, 0.5}, seen);
  }
}

TEST(ErrorSurfaceOfWholeCells, HasTheMatchersNumbersWithAllCellsAndOtherCosts) {
  const auto seen = random_topview(4, 30, 6, kCellM);
  for (const char* preset : {"thesis", "thesis-literal-alpha"}) {
    expect_the_matchers_numbers({20.0, 16.0, 0.3}, {25, 9, 2, kCellM, 0.2}, seen,
                                localiser_preset(preset).value());
  }
}

TEST(ErrorSurfaceOfWholeCells, IsTheSameWithEveryInstructionSetAndAnyNumberOfThreads) {
  const auto seen = perfect_topview(patchwork()->map(), {20.0, 16.0, 0.7}, 10.0);
  const auto surface_with = [&](InstructionSet set, int threads) {
    const ThreadLimit limit(threads);
    const auto matcher = MapMatcher::create(patchwork(), {}, set).value();
    return error_surface(matcher, seen, {20.0, 16.0, 0.6}, {41, 41, 5, 2 * kCellM, 0.1})
        .value()
        .mean_cost;
  };
  const auto expected = surface_with(InstructionSet::kPortable, 1);
  for (const auto set :
       {InstructionSet::kPortable, InstructionSet::kAvx2, InstructionSet::kAvx512}) {
    if (!is_available(set)) continue;
    EXPECT_EQ(surface_with(set, 1), expected);
    EXPECT_EQ(surface_with(set, 3), expected);
  }
}

TEST(ErrorSurfaceOfOtherSteps, HasTheMatchersNumbersToo) {
  const auto seen = perfect_topview(patchwork()->map(), {20.0, 16.0, 0.7}, 10.0);
  for (const double step_m : {0.01, 0.15, 0.25, 0.2001}) {
    expect_the_matchers_numbers({20.03, 16.07, 0.65}, {21, 17, 2, step_m, 0.3}, seen);
  }
}

TEST(ErrorSurfaceOfOtherSteps, HasTheMatchersNumbersWhereTheGroundIsTooLargeToCopy) {
  const auto seen = random_topview(3, 10, 6, kCellM);
  // 3,000 poses 45,000 cells apart would see 135 million columns.
  expect_the_matchers_numbers({20.0, 16.0, 0.3}, {3'000, 1, 1, 45'000 * kCellM, 0.2}, seen);
}

TEST(WholeCells, TakesTheNearestNumberOfCellsAndAtLeastOne) {
  EXPECT_DOUBLE_EQ(whole_cells({.step_m = 0.25}, 0.1).step_m, 0.3);
  EXPECT_DOUBLE_EQ(whole_cells({.step_m = 0.24}, 0.1).step_m, 0.2);
  EXPECT_DOUBLE_EQ(whole_cells({.step_m = 0.01}, 0.1).step_m, 0.1);
  EXPECT_DOUBLE_EQ(whole_cells({.step_m = 0.2}, 0.3270111).step_m, 0.3270111);
  const ErrorSurfaceGrid grid = whole_cells({5, 6, 7, 1.0, 0.2}, 0.5);
  EXPECT_EQ(grid.count_x, 5);
  EXPECT_EQ(grid.count_yaw, 7);
  EXPECT_DOUBLE_EQ(grid.step_rad, 0.2);
}

TEST(ClassCosts, SumToTheMeanCost) {
  const auto matcher = MapMatcher::create(patchwork(), {}).value();
  const auto cells = matcher.prepare(random_topview(3, 20, 6, kCellM));
  for (const Rigid2& pose : {Rigid2{20.0, 16.0, 0.7}, Rigid2{3.0, 30.0, -2.0}}) {
    double sum = 0.0;
    for (const double cost : matcher.class_costs(cells, pose)) sum += cost;
    EXPECT_NEAR(sum, matcher.mean_cost(cells, pose), 1e-12);
  }
}

TEST(ClassCosts, BlamesTheClassThatDoesNotFit) {
  const auto index = index_of(drawn_map(1.0, {"RRRRTTTT"}));
  const auto matcher = MapMatcher::create(index, localiser_preset("thesis").value()).value();
  // Both cells lie on road: the terrain cell is wrong.
  const auto cells = matcher.prepare(topview_of({{{0, 0}, kRoad}, {{1, 0}, kTerrain}}, 1.0));
  const auto costs = matcher.class_costs(cells, {1.0, 0.0, 0.0});
  EXPECT_DOUBLE_EQ(costs[kRoad], 0.0);
  EXPECT_DOUBLE_EQ(costs[kTerrain], matcher.mean_cost(cells, {1.0, 0.0, 0.0}));
  EXPECT_GT(costs[kTerrain], 0.1);
}

}  // namespace error_surface_test
}  // namespace nadir
