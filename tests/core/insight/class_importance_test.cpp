// SPDX-License-Identifier: Apache-2.0
#include "core/insight/class_importance.h"

#include <gmock/gmock.h>

#include "core/base/parallel.h"
#include "tests/core/insight/driven_flight.h"
#include "tests/support/error_text.h"
#include "tests/support/scenery.h"

namespace nadir {
namespace class_importance_test {

/// Along the road only the bars say where one is, and the odometry goes a fifth too far.
ImportanceTask barred_task() {
  ImportanceTask task;
  task.flight = std::make_shared<const DrivenFlight>(barred_road(), 25, 1.2);
  task.map = index_of(barred_road());
  task.options = quick_options();
  task.seeds = {1, 2, 3, 4};
  return task;
}

TEST(ClassImportance, FindsTheClassThatTellsWhereOneIs) {
  const ImportanceTask task = barred_task();
  const auto table = class_importance(task);
  ASSERT_TRUE(table.has_value()) << error_text(table);
  const auto weights = importance_weights(task.map->statistics(), task.options.localiser.alpha);
  std::vector<ClassId> ids;
  for (const ClassImportance& row : table->classes) {
    ids.push_back(row.id);
    EXPECT_EQ(row.weight, weights[row.id]);
    EXPECT_EQ(row.share, task.map->statistics().share_of_classified(row.id));
    EXPECT_EQ(row.error_change_m.seeds, 4);
    EXPECT_NEAR(row.error_change_m.mean, row.without.error_m.mean - table->with_all.error_m.mean,
                1e-9);
  }
  EXPECT_THAT(ids, testing::ElementsAre(kRoad, kVegetation, kTerrain, kLaneMarking));
  const ClassImportance& bars = table->classes.back();
  EXPECT_GT(bars.error_change_m.mean, 0.5);
  EXPECT_TRUE(bars.sigma_change_m.is_more_than_chance());
  EXPECT_GT(bars.sigma_change_m.mean, 0.3) << "and the filter knows that it knows less";
  const ClassImportance& copse = table->classes[1];
  EXPECT_LT(std::abs(copse.error_change_m.mean), 0.3) << "which no frame shows";
}

TEST(ClassImportance, IsThatOfRunsOneByOneOnAnyNumberOfThreads) {
  ImportanceTask task = barred_task();
  task.seeds = {7, 9};
  task.classes = {kLaneMarking};
  task.to_s = 2.0;
  const auto table = class_importance(task).value();
  std::vector<double> errors;
  for (const std::uint64_t seed : task.seeds) {
    LocaliseRequest request;
    request.options = task.options;
    request.options.localiser.seed = seed;
    request.most_frames = 9;  // 0 to 2 s
    double sum_m = 0.0;
    const auto done = localise_flight(*task.flight, task.map, request, [&](const RunStep& step) {
      const Rigid2& mean = step.estimate.moments.mean;
      sum_m += std::hypot(mean.x_m - step.truth_in_enu->x_m, mean.y_m - step.truth_in_enu->y_m);
      return Result<void>();
    });
    ASSERT_EQ(done->steps, 9);
    errors.push_back(sum_m / 9.0);
  }
  EXPECT_NEAR(table.with_all.error_m.mean, 0.5 * (errors[0] + errors[1]), 1e-12);
  const ThreadLimit one(1);
  const auto again = class_importance(task).value();
  EXPECT_EQ(again.classes.front().without.error_m.mean, table.classes.front().without.error_m.mean);
}

TEST(ClassImportance, HidesAClassFromMapAndFlightAlike) {
  const ImportanceTask task = barred_task();
  const auto hidden = flight_without_class(task.flight, kLaneMarking);
  const SemanticFrame all = task.flight->load(5).value();
  const SemanticFrame rest = hidden->load(5).value();
  EXPECT_EQ(rest.depth_m, all.depth_m);
  int marked = 0;
  for (std::size_t i = 0; i < all.labels.size(); ++i) {
    const bool is_hidden = all.labels.values()[i] == kLaneMarking;
    marked += is_hidden ? 1 : 0;
    ASSERT_EQ(rest.labels.values()[i], is_hidden ? ClassId{kUnclassified} : all.labels.values()[i]);
  }
  EXPECT_GT(marked, 0);
  const auto map = map_without_class(task.map->map(), kLaneMarking);
  EXPECT_EQ(map->statistics().cells[kLaneMarking], 0);
  EXPECT_EQ(map->statistics().cells[kRoad], task.map->statistics().cells[kRoad]);
}

TEST(ClassImportance, TellsHowFarItIsAndStops) {
  ImportanceTask task = barred_task();
  task.to_s = 1.0;
  std::stop_source stop;
  std::vector<double> fractions;
  std::size_t rows = 0;
  const auto stopped = class_importance(
      task,
      {.stop = stop.get_token(),
       .progress = [&](double fraction, const std::string&) { fractions.push_back(fraction); }},
      [&](const ImportanceTable& table) {
        rows = table.classes.size();
        if (rows == 2) stop.request_stop();
      });
  EXPECT_EQ(error_code(stopped), ErrorCode::kCancelled);
  EXPECT_EQ(rows, 2U);
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  EXPECT_NEAR(fractions.back(), 3.0 / 5.0, 1e-9) << "with all, without two, of five";
}

TEST(ClassImportance, NeedsSeedsAndFrames) {
  ImportanceTask task = barred_task();
  task.seeds = {};
  EXPECT_THAT(error_text(class_importance(task)), testing::HasSubstr("no seed"));
  task.seeds = {1};
  task.to_s = -1.0;
  EXPECT_THAT(error_text(class_importance(task)), testing::HasSubstr("no frame of the flight"));
}

TEST(SeedMean, KnowsHowSureItIs) {
  const SeedMean mean = mean_over_seeds({1.0, 2.0, 3.0, 4.0, 5.0});
  EXPECT_DOUBLE_EQ(mean.mean, 3.0);
  EXPECT_DOUBLE_EQ(*mean.standard_error, std::sqrt(2.5 / 5.0));
  EXPECT_TRUE(mean.is_more_than_chance()) << "t = 4.24 against 2.776";
  EXPECT_FALSE(mean_over_seeds({-1.0, 2.0, 3.0, -2.0, 1.0}).is_more_than_chance());
  EXPECT_FALSE(mean_over_seeds({2.0}).is_more_than_chance());
  EXPECT_FALSE(mean_over_seeds({2.0}).standard_error.has_value());
  EXPECT_EQ(mean_over_seeds({}).seeds, 0);
}

}  // namespace class_importance_test
}  // namespace nadir
