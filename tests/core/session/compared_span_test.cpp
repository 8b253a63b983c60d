// SPDX-License-Identifier: Apache-2.0
#include "core/session/compared_span.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <functional>
#include <stdexcept>

#include "core/session/run_comparison.h"
#include "tests/core/session/made_run.h"

namespace nadir {
namespace compared_span_test {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

using Document = std::shared_ptr<const RunDocument>;

/// Steps [first, end) of a flight with ten a second; errors of 0.2 m before step 100 and of 8 m from there on.
Document part(int first,
              int end,
              bool is_complete,
              const std::function<void(RunStep& step)>& change = {}) {
  RunDocument run =
      made_run(end, [](RunStep& step) { set_error_m(step, step.step < 100 ? 0.2 : 8.0); });
  run.steps.erase(run.steps.begin(), run.steps.begin() + first);
  if (change) std::for_each(run.steps.begin(), run.steps.end(), change);
  run.is_complete = is_complete;
  return RunDocument::from_steps(std::move(run));
}

const MetricRow& metric(const RunComparison& comparison, const std::string& key) {
  for (const MetricRow& row : comparison.metrics) {
    if (row.key == key) return row;
  }
  throw std::runtime_error("no metric " + key);
}

TEST(ComparedSpan, OfWholeRunsIsAllOfThem) {
  const std::vector<Document> runs = {part(0, 200, true), part(0, 200, true)};
  const ComparedSpan span = compared_span(runs);
  EXPECT_TRUE(span.is_shared);
  EXPECT_EQ(span.from_s, 0.0);
  EXPECT_NEAR(span.to_s, 19.9, 1e-9);
  EXPECT_THAT(span.is_whole, ElementsAre(true, true));
  EXPECT_EQ(span.begins_last, std::nullopt);
  EXPECT_EQ(span.ends_first, std::nullopt);
}

TEST(ComparedSpan, OfNoRunAndOfOneRunIsWhatThereIs) {
  EXPECT_THAT(compared_span({}).is_whole, IsEmpty());
  const std::vector<Document> one = {part(0, 50, false)};
  EXPECT_NEAR(compared_span(one).to_s, 4.9, 1e-9);
  EXPECT_THAT(compared_span(one).is_whole, ElementsAre(true));
  const std::vector<Document> begun = {made_document(0), part(0, 50, true)};
  EXPECT_TRUE(compared_span(begun).is_shared) << "a run without steps is in nobody's way";
  EXPECT_NEAR(compared_span(begun).to_s, 4.9, 1e-9);
}

TEST(ComparedSpan, EndsWhereARunWasStopped) {
  const std::vector<Document> runs = {part(0, 200, true), part(0, 80, false)};
  const ComparedSpan span = compared_span(runs);
  EXPECT_NEAR(span.to_s, 7.9, 1e-9);
  EXPECT_THAT(span.is_whole, ElementsAre(false, true));
  EXPECT_EQ(span.ends_first, 1U);
  EXPECT_EQ(span.begins_last, std::nullopt);
}

TEST(ComparedSpan, BeginsWhereTheLastOneBegins) {
  const std::vector<Document> runs = {part(0, 200, true), part(60, 200, true)};
  const ComparedSpan span = compared_span(runs);
  EXPECT_NEAR(span.from_s, 6.0, 1e-9);
  EXPECT_NEAR(span.to_s, 19.9, 1e-9);
  EXPECT_EQ(span.begins_last, 1U);
  EXPECT_EQ(span.ends_first, std::nullopt);
  // Told in the time of the first run: here the one that begins later.
  const std::vector<Document> turned = {runs[1], runs[0]};
  EXPECT_NEAR(compared_span(turned).from_s, 0.0, 1e-9);
  EXPECT_NEAR(compared_span(turned).to_s, 13.9, 1e-9);
  EXPECT_EQ(compared_span(turned).begins_last, 0U);
}

TEST(ComparedSpan, OfRunsThatMissEachOtherIsNone) {
  const std::vector<Document> runs = {part(0, 50, false), part(60, 120, true)};
  EXPECT_FALSE(compared_span(runs).is_shared);
  const RunComparison comparison = compare_runs(runs);
  EXPECT_FALSE(comparison.do_compete());
  EXPECT_EQ(metric(comparison, "steps").values, (std::vector<std::optional<double>>{50.0, 60.0}));
  for (const MetricRow& row : comparison.metrics) EXPECT_TRUE(row.best.empty()) << row.key;
}

TEST(ComparedSpan, OfDifferentFlightsIsNone) {
  RunDocument other = made_run(50);
  other.header.flight_hash = "f2";
  const std::vector<Document> runs = {part(0, 200, true), RunDocument::from_steps(other)};
  EXPECT_FALSE(compared_span(runs).is_shared) << "their clocks say nothing of each other";
  EXPECT_EQ(metric(compare_runs(runs), "steps").values,
            (std::vector<std::optional<double>>{200.0, 50.0}));
}

TEST(ComparedSpan, LeavesRunsOfDifferentRatesWholeThatReachTheEnd) {
  RunDocument slow = made_run(200);
  std::erase_if(slow.steps, [](const RunStep& step) { return step.step % 7 != 0; });  // to 19.6 s
  const std::vector<Document> runs = {part(0, 200, true), RunDocument::from_steps(slow)};
  const ComparedSpan span = compared_span(runs);
  EXPECT_THAT(span.is_whole, ElementsAre(true, true));
  EXPECT_NEAR(span.to_s, 19.9, 1e-9);
  // One that was stopped there is not known to have gone on.
  slow.is_complete = false;
  const std::vector<Document> stopped = {runs[0], RunDocument::from_steps(slow)};
  EXPECT_THAT(compared_span(stopped).is_whole, ElementsAre(true, true)) << "half a period: 19.95 s";
  slow.steps.pop_back();  // 18.9 s
  const std::vector<Document> earlier = {runs[0], RunDocument::from_steps(slow)};
  EXPECT_THAT(compared_span(earlier).is_whole, ElementsAre(false, true));
  EXPECT_NEAR(compared_span(earlier).to_s, 19.2, 1e-9);
}

/// The trap: a run that stopped before the flight became hard has less error than a whole one, and is no better.
TEST(ComparedSpan, MakesAStoppedRunAsGoodAsTheSameRunThatWentOn) {
  const std::vector<Document> runs = {part(0, 200, true), part(0, 80, false)};
  ASSERT_GT(runs[0]->evaluation.estimate->position_m.root_mean_square, 5.0);
  const RunComparison comparison = compare_runs(runs);
  EXPECT_TRUE(comparison.do_compete());
  for (const MetricRow& row : comparison.metrics) {
    EXPECT_EQ(row.values[0], row.values[1]) << row.key;
    EXPECT_NE(row.best.size(), 1U) << row.key << ": none is better than the other";
  }
  EXPECT_NEAR(*metric(comparison, "estimate_position_rmse_m").values[0], 0.2, 1e-9);
}

TEST(ComparedSpan, ComparesARunFromAMomentOnOverTheRestOfTheFlight) {
  const auto better = [](RunStep& step) { set_error_m(step, 3.0); };
  const std::vector<Document> runs = {part(0, 200, true), part(120, 200, true, better)};
  const RunComparison comparison = compare_runs(runs);
  const MetricRow& rmse = metric(comparison, "estimate_position_rmse_m");
  EXPECT_NEAR(*rmse.values[0], 8.0, 1e-9) << "without the good beginning";
  EXPECT_NEAR(*rmse.values[1], 3.0, 1e-9);
  EXPECT_EQ(rmse.best, (std::vector<std::size_t>{1U}));
  EXPECT_EQ(metric(comparison, "steps").values, (std::vector<std::optional<double>>{80.0, 80.0}));
}

TEST(ComparedSpan, OfARunThatJitteredIsNotAStepLonger) {
  const auto jitter = [](RunStep& step) { step.time_s += step.step % 2 == 0 ? 0.0 : -0.02; };
  const std::vector<Document> runs = {part(0, 200, true, jitter), part(0, 81, false, jitter)};
  const RunComparison comparison = compare_runs(runs);
  EXPECT_EQ(metric(comparison, "steps").values, (std::vector<std::optional<double>>{81.0, 81.0}));
}

}  // namespace compared_span_test
}  // namespace nadir
