// SPDX-License-Identifier: Apache-2.0
#include "core/eval/report.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>
#include <vector>

namespace nadir {
namespace report_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using Json = nlohmann::ordered_json;

RunEvaluation judged_run(bool with_truth = true) {
  std::vector<EvaluatedStep> steps;
  for (int i = 0; i < 60; ++i) {
    EvaluatedStep step{.time_s = 0.3 * i,
                       .estimate_in_enu = {i + 0.1, 0.2 / 3.0, 0.01},
                       .odometry_in_enu = Rigid2{i * 1.25, 0.4, -0.05},
                       .update_ms = 7.25};
    if (with_truth) step.truth_in_enu = Rigid2{1.0 * i, 0, 0};
    step.covariance = Eigen::Vector3d(0.04, 0.04, 1e-3).asDiagonal();
    steps.push_back(step);
  }
  RunEvaluation evaluation = evaluate_steps(steps).value();
  evaluation.run = "R.nadir";
  evaluation.flight = "loop";
  evaluation.map = "town, old";
  evaluation.preset = "default";
  evaluation.seed = 18446744073709551615ULL;
  return evaluation;
}

std::vector<std::string> keys_of(const Json& object) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : object.items()) keys.push_back(key);
  return keys;
}

std::vector<std::string> first(std::vector<std::string> all, std::size_t count) {
  all.resize(count);
  return all;
}

TEST(JsonReport, BeginsWithThePromisedKeysInTheirOrder) {
  const Json report = Json::parse(report_as_json(std::vector{judged_run()}));
  EXPECT_THAT(keys_of(report), ElementsAre("runs"));
  const Json run = report["runs"][0];
  EXPECT_THAT(first(keys_of(run), 14),
              ElementsAre("flight", "map", "preset", "seed", "steps", "matched_pairs", "alignment",
                          "estimate", "odometry", "nees_mean", "coverage_95", "converged_after_s",
                          "converged_after_m", "update_rate_hz"));
  for (const char* which : {"estimate", "odometry"}) {
    EXPECT_THAT(first(keys_of(run[which]), 12),
                ElementsAre("position_mse_m2", "position_rmse_m", "position_mean_m",
                            "position_median_m", "position_p90_m", "position_max_m",
                            "orientation_mse_rad2", "orientation_median_rad", "orientation_p90_rad",
                            "recall_1m", "recall_3m", "recall_5m"));
  }
}

TEST(JsonReport, NumbersComeBackToTheLastBit) {
  const RunEvaluation evaluation = judged_run();
  const Json run = Json::parse(report_as_json(std::vector{evaluation}))["runs"][0];
  EXPECT_EQ(run["seed"].get<std::uint64_t>(), evaluation.seed);
  EXPECT_EQ(run["estimate"]["position_rmse_m"].get<double>(),
            evaluation.estimate->position_m.root_mean_square);
  EXPECT_EQ(run["odometry"]["position_p90_m"].get<double>(), evaluation.odometry->position_m.p90);
  EXPECT_EQ(run["nees_mean"].get<double>(), *evaluation.consistency.nees_mean);
  EXPECT_EQ(report_as_json(std::vector{evaluation}), report_as_json(std::vector{judged_run()}));
}

TEST(JsonReport, DoesNotTellWhereOrHowFastItWasComputed) {
  RunEvaluation other = judged_run();
  other.run = "/elsewhere/other.nadir";
  other.computing_ms_mean = 99.0;
  EXPECT_EQ(report_as_json(std::vector{other}), report_as_json(std::vector{judged_run()}));
}

TEST(JsonReport, UnknownValuesAreNullAndNeverLeftOut) {
  const Json known = Json::parse(report_as_json(std::vector{judged_run()}))["runs"][0];
  const Json unknown = Json::parse(report_as_json(std::vector{judged_run(false)}))["runs"][0];
  EXPECT_EQ(keys_of(known), keys_of(unknown));
  EXPECT_EQ(keys_of(known["estimate"]), keys_of(unknown["estimate"]));
  for (const auto& [key, value] : unknown["odometry"].items()) EXPECT_TRUE(value.is_null()) << key;
  for (const char* key :
       {"nees_mean", "coverage_95", "converged_after_s", "converged_after_m", "distance_m"}) {
    EXPECT_TRUE(unknown[key].is_null()) << key;
  }
}

TEST(JsonReport, SurvivesNumbersAndNamesThatJsonCannotHold) {
  RunEvaluation evaluation = judged_run();
  evaluation.estimate->position_m.mean = std::nan("");
  evaluation.flight = "flight\xff\"\n";
  const Json run = Json::parse(report_as_json(std::vector{evaluation}))["runs"][0];
  EXPECT_TRUE(run["estimate"]["position_mean_m"].is_null());
  EXPECT_THAT(run["flight"].get<std::string>(), HasSubstr("flight"));
}

TEST(JsonReport, SaysHowItWasAligned) {
  RunEvaluation evaluation = judged_run();
  evaluation.alignment = Alignment::kSim2;
  evaluation.odometry_alignment = {.scale = 0.8, .rigid = {1, 2, 0.5}};
  const Json run = Json::parse(report_as_json(std::vector{evaluation}))["runs"][0];
  EXPECT_EQ(run["alignment"], "sim2");
  EXPECT_EQ(run["odometry_alignment"]["scale"], 0.8);
}

TEST(CsvReport, HasAHeaderAndOneLineARunOfAsManyCells) {
  const auto text = report_as_csv(std::vector{judged_run(), judged_run(false)});
  std::istringstream lines(text);
  std::string header, known, unknown;
  std::getline(lines, header);
  std::getline(lines, known);
  std::getline(lines, unknown);
  const auto commas = [](const std::string& line) {
    return std::count(line.begin(), line.end(), ',');
  };
  EXPECT_THAT(
      header,
      HasSubstr(
          "seed,steps,matched_pairs,dropped_steps,is_complete,alignment,estimate_position_mse_m2"));
  EXPECT_THAT(header, HasSubstr("odometry_recall_5m"));
  EXPECT_EQ(commas(known), commas(header) + 1) << "one comma is inside the quoted name of the map";
  EXPECT_EQ(commas(unknown), commas(header) + 1);
  EXPECT_THAT(
      known,
      HasSubstr("R.nadir,loop,\"town, old\",default,18446744073709551615,60,60,0,true,none,"));
  EXPECT_THAT(unknown, HasSubstr(",,,,,")) << "unknown cells are empty";
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 3);
}

TEST(CsvReport, QuotesQuotes) {
  RunEvaluation evaluation = judged_run();
  evaluation.flight = "the \"long\" one";
  EXPECT_THAT(report_as_csv(std::vector{evaluation}), HasSubstr("\"the \"\"long\"\" one\""));
}

TEST(TextReport, AlignsDecimalPointsAndHeadings) {
  std::istringstream lines(report_as_text(std::vector{judged_run()}));
  std::vector<std::size_t> points;
  std::string line;
  while (std::getline(lines, line)) {
    if (line.find(" RMSE ") == std::string::npos) continue;
    std::vector<std::size_t> found;
    for (std::size_t at = 0; (at = line.find('.', at)) != std::string::npos; ++at)
      found.push_back(at);
    if (points.empty()) points = found;
    EXPECT_EQ(found, points) << line;
    EXPECT_LE(line.size(), 100U);
  }
  EXPECT_EQ(points.size(), 3U) << "odometry, estimate and ratio";
}

TEST(TextReport, SaysAlignmentPairsAndRatio) {
  const std::string text = report_as_text(std::vector{judged_run()});
  EXPECT_THAT(text, HasSubstr("alignment      none"));
  EXPECT_THAT(text, HasSubstr("60: 60 matched pairs, 0 dropped"));
  EXPECT_THAT(text, HasSubstr("drift over 10 m"));
  EXPECT_THAT(text, HasSubstr("converged      after 0.0 s"));
  EXPECT_THAT(text, Not(HasSubstr("nan")));
  const double ratio =
      judged_run().estimate->position_m.mean / judged_run().odometry->position_m.mean;
  EXPECT_THAT(text, HasSubstr(fmt::format("{:.3f}", ratio)));
}

TEST(TextReport, SaysWhenThereIsNoTruthAndWhenTheRunWasStopped) {
  RunEvaluation evaluation = judged_run(false);
  evaluation.is_complete = false;
  const std::string text = report_as_text(std::vector{evaluation});
  EXPECT_THAT(text, HasSubstr("stopped before its end"));
  EXPECT_THAT(text, HasSubstr("The truth is not known"));
}

TEST(EveryReport, TellsHowManyStepsAreBehindTheConsistency) {
  RunEvaluation evaluation = judged_run();
  evaluation.consistency.nees_steps = 41;
  evaluation.consistency.excluded_steps = 19;
  const Json run = Json::parse(report_as_json(std::vector{evaluation}))["runs"][0];
  EXPECT_EQ(run["nees_steps"], 41);
  EXPECT_EQ(run["nees_excluded_steps"], 19);
  EXPECT_EQ(run["coverage_steps"], 60);
  const std::string csv = report_as_csv(std::vector{evaluation});
  EXPECT_THAT(csv, HasSubstr(",nees_steps,nees_excluded_steps,coverage_steps\n"));
  EXPECT_THAT(csv, testing::EndsWith(",41,19,60\n"));
  const std::string text = report_as_text(std::vector{evaluation});
  EXPECT_THAT(text, HasSubstr("19 steps with a singular or unknown covariance"));
  EXPECT_THAT(text, HasSubstr("of 60 steps with the truth inside the 95 % ellipse"));
  EXPECT_THAT(report_as_text(std::vector{judged_run()}), Not(HasSubstr("singular")));
}

TEST(TextReport, WarnsThatAnAlignedErrorIsNotTheUsers) {
  RunEvaluation evaluation = judged_run();
  evaluation.alignment = Alignment::kSe2;
  EXPECT_THAT(report_as_text(std::vector{evaluation}),
              HasSubstr("se2 (least squares on all pairs"));
}

/// Localised over the whole map, with truth from a later step on: nothing says where the odometry began.
TEST(TextReport, HasTheErrorsOfARunWhoseOdometryIsNotInThePlane) {
  RunEvaluation evaluation = judged_run();
  evaluation.odometry.reset();
  const std::string text = report_as_text(std::vector{evaluation});
  EXPECT_THAT(text, Not(HasSubstr("truth is not known")));
  std::istringstream lines(text);
  std::string line, found;
  while (std::getline(lines, line)) {
    if (line.find("position maximum") != std::string::npos) found = line;
  }
  std::istringstream words(found);
  std::vector<std::string> cells{std::istream_iterator<std::string>(words), {}};
  EXPECT_THAT(cells, ElementsAre("position", "maximum", "m", "-", "0.120", "-"));
  EXPECT_THAT(text, HasSubstr("drift over 10 m"));
  EXPECT_THAT(text, HasSubstr("converged      after 0.0 s"));
}

}  // namespace report_test
}  // namespace nadir
