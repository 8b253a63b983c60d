// SPDX-License-Identifier: Apache-2.0
#include "core/session/moment_surface.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "core/base/angle.h"
#include "core/base/parallel.h"
#include "tests/support/drawn_map.h"
#include "tests/support/error_text.h"
#include "tests/support/made_topview.h"
#include "tests/support/scenery.h"

namespace nadir {
namespace moment_surface_test {

constexpr double kCellM = 0.2;
const Rigid2 kTruth{20.0, 16.0, 0.7};

const MapMatcher& matcher() {
  static const auto the_matcher =
      MapMatcher::create(index_of(patchwork_map(200, 160, kCellM)), {}).value();
  return the_matcher;
}

/// What is seen perfectly at kTruth, estimated elsewhere.
RunStep step_at(const Rigid2& estimate) {
  RunStep step;
  step.step = 4;
  step.estimate.moments.mean = estimate;
  step.truth_in_enu = kTruth;
  step.topview = perfect_topview(matcher().map(), kTruth, 10.0);
  return step;
}

TEST(MomentSurface, HasItsLeastCostAtTheTruthWhereThatWasSeenPerfectly) {
  const RunStep step = step_at({21.6, 15.2, kTruth.yaw_rad - Angle::degrees(8.0).radians()});
  const auto surface = moment_surface(step, matcher()).value();
  EXPECT_EQ(
      surface.volume.grid.count_x * surface.volume.grid.count_y * surface.volume.grid.count_yaw,
      63 * 63 * 37);
  EXPECT_NEAR(surface.least_in_enu.x_m, kTruth.x_m, 1e-9);
  EXPECT_NEAR(surface.least_in_enu.y_m, kTruth.y_m, 1e-9);
  EXPECT_NEAR(surface.least_in_enu.yaw_rad, kTruth.yaw_rad, 1e-9);
  EXPECT_TRUE(surface.is_truth_inside);
  EXPECT_NEAR(surface.truth->x, 31.0 - 8.0, 1e-9);
  EXPECT_NEAR(surface.truth->y, 31.0 + 4.0, 1e-9);
  EXPECT_NEAR(surface.truth->yaw, 18.0 + 4.0, 1e-9);
  EXPECT_NEAR(*surface.cost_at_truth, surface.least_cost, 1e-3);
  EXPECT_GT(surface.cost_at_estimate, surface.least_cost + 0.02F);
}

TEST(MomentSurface, IsCutThroughTheEstimateItself) {
  const RunStep step = step_at({20.6, 16.3, 0.55});
  const auto surface = moment_surface(step, matcher(), {9, 7, 5, kCellM, 0.1}).value();
  const auto cells = matcher().prepare(*step.topview);
  const auto cost_at = [&](const Rigid2& pose) {
    return static_cast<float>(matcher().mean_cost(cells, pose));
  };
  const Rigid2& estimate = step.estimate.moments.mean;
  EXPECT_EQ(surface.cost_at_estimate, cost_at(estimate));
  ASSERT_EQ(surface.plane.size(), 63U);
  ASSERT_EQ(surface.turn.size(), 5U);
  EXPECT_EQ(surface.plane[3 * 9 + 4], surface.cost_at_estimate);
  EXPECT_EQ(surface.turn[2], surface.cost_at_estimate);
  for (int iy = 0; iy < 7; ++iy) {
    for (int ix = 0; ix < 9; ++ix) {
      const auto i = static_cast<std::size_t>(9 * iy + ix);
      EXPECT_EQ(surface.plane[i], cost_at(surface.volume.pose(ix, iy, 2)));
      float best = 1.0F;
      for (int iyaw = 0; iyaw < 5; ++iyaw) best = std::min(best, surface.volume.at(ix, iy, iyaw));
      EXPECT_EQ(surface.best_turn[i], best);
    }
  }
  for (int iyaw = 0; iyaw < 5; ++iyaw) {
    EXPECT_EQ(surface.turn[static_cast<std::size_t>(iyaw)],
              cost_at({estimate.x_m, estimate.y_m, estimate.yaw_rad + 0.1 * (iyaw - 2)}));
  }
  EXPECT_EQ(surface.least_cost,
            *std::min_element(surface.best_turn.begin(), surface.best_turn.end()));
}

TEST(MomentSurface, NamesOfSeveralLeastPosesTheOneNearestToTheEstimate) {
  // Road as far as the eye sees, but for a far corner: every pose costs the same.
  OverheadMap map = drawn_map(1.0, {"R"});
  map.labels = Raster<ClassId>(60, 60, kRoad);
  map.labels.at(0, 0) = kSidewalk;
  map.top_left_in_enu_m = {0.0, 60.0};
  const auto plain = MapMatcher::create(index_of(std::move(map)), {}).value();
  RunStep step;
  step.estimate.moments.mean = {30.25, 30.25, 0.3};
  step.topview = topview_of({{{0, 0}, kRoad}, {{1, 1}, kRoad}}, 1.0);
  const auto surface = moment_surface(step, plain, {5, 5, 5, 1.0, 0.1}).value();
  EXPECT_EQ(surface.least_in_enu, step.estimate.moments.mean);
  EXPECT_EQ(surface.least_cost, surface.cost_at_estimate);
  EXPECT_FALSE(surface.truth || surface.cost_at_truth || surface.is_truth_inside);
}

TEST(MomentSurface, FindsThePlaceOfEveryOneOfItsPoses) {
  const auto surface =
      moment_surface(step_at({20.6, 16.3, 3.1}), matcher(), {9, 7, 5, kCellM, 0.1}).value();
  for (int iyaw = 0; iyaw < 5; ++iyaw) {  // beyond pi the yaw comes back at -pi
    const GridPlace place = surface.place_of(surface.volume.pose(2, 5, iyaw));
    EXPECT_NEAR(place.x, 2.0, 1e-9);
    EXPECT_NEAR(place.y, 5.0, 1e-9);
    EXPECT_NEAR(place.yaw, iyaw, 1e-9);
  }
}

TEST(MomentSurface, KnowsWhenTheTruthIsOffItsGrid) {
  const auto surface =
      moment_surface(step_at({22.0, 16.0, 0.7}), matcher(), {9, 7, 5, kCellM, 0.1}).value();
  EXPECT_FALSE(surface.is_truth_inside);
  EXPECT_NEAR(surface.truth->x, 4.0 - 10.0, 1e-9);
  EXPECT_LT(*surface.cost_at_truth, surface.cost_at_estimate);
}

TEST(MomentSurface, IsTheSameOnAnyNumberOfThreads) {
  const auto surface_on = [](int threads) {
    const ThreadLimit limit(threads);
    return moment_surface(step_at({20.6, 16.3, 0.55}), matcher()).value().volume.mean_cost;
  };
  EXPECT_EQ(surface_on(1), surface_on(3));
}

TEST(MomentSurface, RefusesWhatItCannotCut) {
  RunStep step = step_at(kTruth);
  EXPECT_EQ(error_text(moment_surface(step, matcher(), {9, 8, 5, kCellM, 0.1})),
            "error surface: 8 poses put none on the estimate; an odd number does");
  EXPECT_FALSE(moment_surface(step, matcher(), {9, 7, -1, kCellM, 0.1}).has_value());
  step.topview = topview_of({{{0, 0}, kCar}}, kCellM);
  EXPECT_THAT(error_text(moment_surface(step, matcher())),
              testing::HasSubstr("no cell of a class"));
  step.topview->metres_per_cell = 0.5;
  EXPECT_THAT(error_text(moment_surface(step, matcher())), testing::HasSubstr("cells of 0.5 m"));
  step.topview.reset();
  EXPECT_EQ(error_text(moment_surface(step, matcher())), "step 4: its topview was not recorded");
}

TEST(MomentGrid, IsOfWholeCellsNearTwoDecimetres) {
  RunStep step;
  for (const double cell_m : {0.05, 0.1, 0.2, 0.3270111, 1.0}) {
    const ErrorSurfaceGrid grid = moment_grid(step, cell_m);
    const double cells = grid.step_m / cell_m;
    EXPECT_NEAR(cells, std::max(1.0, std::round(0.2 / cell_m)), 1e-9) << cell_m;
    EXPECT_EQ(grid.count_x % 2 * (grid.count_y % 2) * (grid.count_yaw % 2), 1);
    EXPECT_NEAR(Angle::radians(grid.step_rad).degrees(), 2.0, 1e-9);
  }
}

TEST(MomentGrid, IsAsWideAsTheTruthNeeds) {
  const auto inside = [](const ErrorSurfaceGrid& grid, const RunStep& step) {
    const Rigid2& truth = *step.truth_in_enu;
    return std::max(std::abs(truth.x_m), std::abs(truth.y_m)) <= 31.0 * grid.step_m &&
           std::abs(truth.yaw_rad) <= 18.0 * grid.step_rad;
  };
  RunStep step;
  for (const double away_m : {0.0, 5.0, 8.0, 15.0, 25.0}) {
    for (const double yaw_deg : {0.0, 30.0, -90.0, 149.0}) {
      step.truth_in_enu = Rigid2{-away_m, 0.3 * away_m, Angle::degrees(yaw_deg).radians()};
      for (const double cell_m : {0.1, 0.3}) {
        EXPECT_TRUE(inside(moment_grid(step, cell_m), step)) << away_m << ' ' << yaw_deg;
      }
    }
  }
  step.truth_in_enu = Rigid2{500.0, 0.0, 3.1};
  EXPECT_NEAR(moment_grid(step, 0.1).step_m, 1.0, 1e-9);
  EXPECT_NEAR(Angle::radians(moment_grid(step, 0.1).step_rad).degrees(), 10.0, 1e-9);
}

}  // namespace moment_surface_test
}  // namespace nadir
