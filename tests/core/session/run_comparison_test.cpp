// SPDX-License-Identifier: Apache-2.0
#include "core/session/run_comparison.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>
#include <sstream>

#include "core/eval/report.h"
#include "core/run/run_options.h"
#include "tests/core/session/made_run.h"

namespace nadir {
namespace run_comparison_test {

using ::testing::ElementsAre;
using ::testing::Eq;
using ::testing::IsEmpty;

using Document = std::shared_ptr<const RunDocument>;
using Values = std::vector<std::optional<std::string>>;

Document with_header(const std::function<void(RunHeader&)>& change) {
  RunDocument run = made_run(50);
  change(run.header);
  return RunDocument::from_steps(std::move(run));
}

const SettingDifference* setting(const RunComparison& comparison, const std::string& name) {
  for (const SettingDifference& row : comparison.settings) {
    if (row.name == name) return &row;
  }
  return nullptr;
}

const MetricRow& metric(const RunComparison& comparison, const std::string& key) {
  for (const MetricRow& row : comparison.metrics) {
    if (row.key == key) return row;
  }
  throw std::runtime_error("no metric " + key);
}

std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> parts;
  std::stringstream stream(line);
  for (std::string part; std::getline(stream, part, ',');) parts.push_back(part);
  return parts;
}

TEST(RunComparison, OfEqualRunsFindsNoDifference) {
  const std::vector<Document> runs = {made_document(50), made_document(50)};
  const RunComparison comparison = compare_runs(runs);
  EXPECT_TRUE(comparison.is_same_flight);
  EXPECT_TRUE(comparison.is_same_map);
  EXPECT_THAT(comparison.settings, IsEmpty());
  EXPECT_THAT(comparison.divergence, ElementsAre(Eq(std::nullopt), Eq(std::nullopt)));
  for (const MetricRow& row : comparison.metrics) {
    EXPECT_EQ(row.values[0], row.values[1]) << row.key;
    if (row.better == 0 || !row.values[0]) {
      EXPECT_THAT(row.best, IsEmpty()) << row.key;
    } else {
      EXPECT_THAT(row.best, ElementsAre(0U, 1U)) << row.key << ": none is better than the other";
    }
  }
}

TEST(RunComparison, OfNoRunAndOfOneRunHasNothingToCompare) {
  EXPECT_THAT(compare_runs({}).names, IsEmpty());
  const std::vector<Document> runs = {made_document(50)};
  const RunComparison comparison = compare_runs(runs);
  EXPECT_THAT(comparison.names, ElementsAre("made"));
  EXPECT_THAT(comparison.settings, IsEmpty());
  EXPECT_EQ(metric(comparison, "steps").values, std::vector{std::optional(50.0)});
}

TEST(RunComparison, TellsTheSettingsThatDifferWithTheirUnits) {
  const std::vector<Document> runs = {
      with_header([](RunHeader& header) {
        header.options = {{"particles", "5000"},
                          {"max-range", "20"},
                          {"blur-yaw", "0"},
                          {"seed", "1"},
                          {"of-another-version", "x"}};
      }),
      with_header([](RunHeader& header) {
        header.preset = "thesis";
        header.seed = 7;
        header.options = {
            {"particles", "10000"}, {"max-range", "25"}, {"blur-yaw", "0"}, {"seed", "7"}};
      })};
  const RunComparison comparison = compare_runs(runs);
  ASSERT_NE(setting(comparison, "preset"), nullptr);
  EXPECT_EQ(setting(comparison, "preset")->values, (Values{"default", "thesis"}));
  EXPECT_EQ(setting(comparison, "seed")->values, (Values{"1", "7"}));
  const SettingDifference* const range = setting(comparison, "max-range");
  ASSERT_NE(range, nullptr);
  EXPECT_EQ(range->unit, "m");
  EXPECT_FALSE(range->help.empty());
  EXPECT_EQ(range->values, (Values{"20", "25"}));
  EXPECT_EQ(setting(comparison, "of-another-version")->values, (Values{"x", std::nullopt}));
  EXPECT_EQ(comparison.settings.size(), 5U) << "nothing that is the same, and the seed once";
}

TEST(RunComparison, ListsOptionsAsTheFieldListDoes) {
  RunHeader all;
  std::vector<std::string> expected;
  for (const OptionText& option : option_texts(RunOptions{})) {
    all.options[option.name] = option.value;
    if (option.name != "seed") expected.push_back(option.name);
  }
  const std::vector<Document> runs = {
      with_header([&](RunHeader& header) { header.options = all.options; }),
      with_header([](RunHeader& /*header*/) {})};
  std::vector<std::string> names;
  for (const SettingDifference& row : compare_runs(runs).settings) names.push_back(row.name);
  EXPECT_EQ(names, expected);
}

TEST(RunComparison, TellsOptionsApartThatHaveNoEffect) {
  const auto with_options = [](std::map<std::string, std::string> options) {
    return with_header([&](RunHeader& header) { header.options = std::move(options); });
  };
  const std::vector<Document> scaled = {
      with_options({{"motion", "scaled"}, {"translation-noise", "0.3"}, {"along-noise", "0.1"}}),
      with_options({{"motion", "scaled"}, {"translation-noise", "0.5"}, {"along-noise", "0.2"}})};
  const RunComparison comparison = compare_runs(scaled);
  EXPECT_EQ(setting(comparison, "translation-noise"), nullptr);
  ASSERT_NE(setting(comparison, "along-noise"), nullptr);
  EXPECT_TRUE(setting(comparison, "along-noise")->has_effect());
  ASSERT_EQ(comparison.idle_settings.size(), 1U);
  EXPECT_EQ(comparison.idle_settings[0].name, "translation-noise");
  EXPECT_EQ(comparison.idle_settings[0].values, (Values{"0.3", "0.5"}));
  EXPECT_THAT(comparison.idle_settings[0].no_effect,
              ElementsAre("motion = scaled", "motion = scaled"));
  // Where one of them uses it, it takes part in what tells them apart.
  const std::vector<Document> mixed = {
      scaled[0], with_options({{"motion", "thesis"}, {"translation-noise", "0.5"}})};
  const RunComparison other = compare_runs(mixed);
  EXPECT_THAT(other.idle_settings, IsEmpty());
  ASSERT_NE(setting(other, "translation-noise"), nullptr);
  EXPECT_THAT(setting(other, "translation-noise")->no_effect, ElementsAre("motion = scaled", ""));
}

TEST(RunComparison, KnowsFlightsAndMapsByTheirHashes) {
  RunHeader a;
  a.flight = "loop";
  a.flight_hash = "1";
  RunHeader b = a;
  b.flight = "renamed";
  EXPECT_TRUE(are_of_same_flight(a, b));
  b.flight_hash = "2";
  b.flight = "loop";
  EXPECT_FALSE(are_of_same_flight(a, b));
  b.flight_hash.clear();
  EXPECT_TRUE(are_of_same_flight(a, b)) << "by name where a hash is missing";
  b.map = "town";
  EXPECT_FALSE(are_on_same_map(a, b));

  const std::vector<Document> runs = {
      made_document(50), with_header([](RunHeader& header) { header.map_hash = "a2"; })};
  const RunComparison comparison = compare_runs(runs);
  EXPECT_TRUE(comparison.is_same_flight);
  EXPECT_FALSE(comparison.is_same_map);
  EXPECT_EQ(setting(comparison, "map")->values, (Values{"town (a1)", "town (a2)"}));
}

TEST(RunComparison, GivesEveryNumberOfTheReport) {
  const std::vector<Document> runs = {made_document(300, [](RunStep& step) {
    step.odometry_in_enu = Rigid2{0.5 * step.step, 0.003 * step.step, 0.001};
    step.estimate.moments.mean.yaw_rad = 0.01 * std::sin(step.step);
  })};
  const RunComparison comparison = compare_runs(runs);
  const std::string report = report_as_csv(std::vector{runs[0]->evaluation});
  std::stringstream stream(report);
  std::string keys, values;
  std::getline(stream, keys);
  std::getline(stream, values);
  const std::vector<std::string> names = cells(keys);
  const std::vector<std::string> texts = cells(values);
  const std::set<std::string> not_numbers = {"run",  "flight",      "map",      "preset",
                                             "seed", "is_complete", "alignment"};
  std::size_t row = 0;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (not_numbers.count(names[i]) > 0) continue;
    ASSERT_LT(row, comparison.metrics.size());
    const MetricRow& metric = comparison.metrics[row++];
    EXPECT_EQ(metric.key, names[i]) << "in the same order";
    ASSERT_EQ(metric.values[0].has_value(), !texts[i].empty()) << metric.key;
    if (texts[i].empty()) continue;
    double factor = 1.0;
    if (metric.unit.rfind("deg", 0) == 0) factor = 180.0 / std::numbers::pi;
    if (metric.unit == "deg^2") factor *= factor;
    EXPECT_NEAR(*metric.values[0], factor * std::stod(texts[i]),
                1e-9 * std::abs(factor * std::stod(texts[i])))
        << metric.key;
    EXPECT_FALSE(metric.label.empty());
  }
  EXPECT_EQ(row, comparison.metrics.size());
}

TEST(RunComparison, MarksTheBestOfRunsThatCompete) {
  const auto off = [](double error_m) {
    return made_document(300, [=](RunStep& step) { set_error_m(step, error_m); });
  };
  const std::vector<Document> runs = {off(0.4), off(0.2), off(0.3)};
  const RunComparison comparison = compare_runs(runs);
  EXPECT_THAT(metric(comparison, "estimate_position_rmse_m").best, ElementsAre(1U));
  EXPECT_THAT(metric(comparison, "estimate_recall_1m").best, ElementsAre(0U, 1U, 2U));
  EXPECT_THAT(metric(comparison, "duration_s").best, IsEmpty()) << "longer is not better";
  EXPECT_EQ(metric(comparison, "odometry_position_rmse_m").values[0], std::nullopt);

  const std::vector<Document> two = {off(1.5), off(0.2)};
  EXPECT_THAT(metric(compare_runs(two), "estimate_recall_1m").best, ElementsAre(1U))
      << "higher is better";
  const std::vector<Document> tied = {off(1.5), off(0.2), off(0.2), off(0.3)};
  EXPECT_THAT(metric(compare_runs(tied), "estimate_position_rmse_m").best, ElementsAre(1U, 2U))
      << "all that share it";
  RunDocument elsewhere = made_run(300);
  elsewhere.header.flight_hash = "f2";
  const std::vector<Document> strangers = {off(0.4), RunDocument::from_steps(elsewhere)};
  EXPECT_THAT(metric(compare_runs(strangers), "estimate_position_rmse_m").best, IsEmpty());
}

}  // namespace run_comparison_test
}  // namespace nadir
