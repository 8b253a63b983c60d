// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/run_metric_rows.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <set>

#include "tests/core/session/made_run.h"

namespace nadir {
namespace run_metric_rows_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const ShownMetric& metric_of(std::string_view key) {
  const auto all = shown_metrics();
  return *std::find_if(all.begin(), all.end(),
                       [key](const ShownMetric& one) { return one.key == key; });
}

MetricRow row_with(std::vector<std::optional<double>> values) {
  MetricRow row;
  row.values = std::move(values);
  return row;
}

TEST(ShownMetrics, AreNumbersOfTheComparisonInItsUnits) {
  const std::vector<std::shared_ptr<const RunDocument>> runs = {made_document(50)};
  const RunComparison comparison = compare_runs(runs);
  for (const ShownMetric& shown : shown_metrics()) {
    const auto row = std::find_if(comparison.metrics.begin(), comparison.metrics.end(),
                                  [&](const MetricRow& one) { return one.key == shown.key; });
    ASSERT_NE(row, comparison.metrics.end()) << shown.key;
    if (shown.factor == 1.0) {
      EXPECT_EQ(row->unit, shown.unit) << shown.key;
    }
    if (shown.better != 0) {
      EXPECT_EQ(row->better, shown.better) << shown.key;
    }
  }
}

TEST(ShownMetrics, NameQuantityAndStatisticAndEachIsDifferent) {
  std::set<std::string> labels;
  for (const ShownMetric& shown : shown_metrics()) {
    EXPECT_TRUE(labels.insert(metric_label(shown)).second) << shown.key;
    EXPECT_FALSE(shown.help.empty());
  }
  EXPECT_EQ(metric_label(metric_of("estimate_orientation_median_rad")), "heading median [deg]");
  EXPECT_EQ(metric_label(metric_of("nees_mean")), "NEES mean");
  EXPECT_EQ(better_words(metric_of("coverage_95")), "nearer to 95 is better");
}

TEST(BestRuns, AreThoseNearestToWhatIsExpected) {
  const ShownMetric& nees = metric_of("nees_mean");
  EXPECT_THAT(best_runs(nees, row_with({1.0, 6.1, 128.0}), true), ElementsAre(1U))
      << "twice as wrong, not a third";
  EXPECT_THAT(best_runs(nees, row_with({1.0, 9.0, 30.0}), true), ElementsAre(0U, 1U))
      << "as wrong as each other";
  EXPECT_THAT(best_runs(nees, row_with({std::nullopt, 3.0}), true), IsEmpty()) << "alone";
  EXPECT_THAT(best_runs(nees, row_with({1.0, 3.0}), false), IsEmpty()) << "of different flights";
  const ShownMetric& coverage = metric_of("coverage_95");
  EXPECT_THAT(best_runs(coverage, row_with({0.99, 0.93}), true), ElementsAre(1U));
}

TEST(BestRuns, OfOtherNumbersAreThoseOfTheComparisonAndWhatLooksTheSame) {
  const ShownMetric& rmse = metric_of("estimate_position_rmse_m");
  MetricRow row = row_with({2.0, 1.0});
  row.best = {1};
  EXPECT_THAT(best_runs(rmse, row, true), ElementsAre(1U));
  row = row_with({0.3512, std::nullopt, 0.3488, 0.3561});
  row.best = {2};
  EXPECT_THAT(best_runs(rmse, row, true), ElementsAre(0U, 2U)) << "both are shown as 0.35";
}

}  // namespace run_metric_rows_test
}  // namespace nadir
