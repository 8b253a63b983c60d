// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <sqlite3.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/staged_output.h"
#include "tests/app/program.h"
#include "tests/core/run/recorded_run.h"
#include "tests/support/scratch_folder.h"

namespace nadir {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class EvaluateCommand : public testing::Test {
 protected:
  [[nodiscard]] std::string path(const std::string& name) const {
    return (scratch_.path() / name).string();
  }
  /// A run of so many steps of example_step(); 0.35 m off the truth, odometry worse and worse.
  [[nodiscard]] std::string run(const std::string& name,
                                int steps = 40,
                                bool is_finished = true) const {
    record_run(path(name), steps, 0, is_finished);
    return path(name);
  }
  [[nodiscard]] static nlohmann::json runs_of(const ProgramOutput& output) {
    EXPECT_EQ(output.status, 0) << output.err;
    return nlohmann::json::parse(output.out)["runs"];
  }

  ScratchFolder scratch_;
};

TEST_F(EvaluateCommand, PrintsATableOfErrorsForPeople) {
  const auto shown = run_program({"evaluate", run("R.nadir")});
  EXPECT_EQ(shown.status, 0);
  EXPECT_EQ(shown.err, "");
  EXPECT_THAT(shown.out, AllOf(HasSubstr("R.nadir\n"), HasSubstr("proving-ground"),
                               HasSubstr("40: 40 matched pairs, 0 dropped"),
                               HasSubstr("alignment      none"), HasSubstr("position RMSE")));
}

TEST_F(EvaluateCommand, PrintsJsonWithTheErrorsOfTheRun) {
  const auto json = runs_of(run_program({"evaluate", run("R.nadir"), "--json"}));
  ASSERT_EQ(json.size(), 1U);
  EXPECT_NEAR(json[0]["estimate"]["position_rmse_m"], std::hypot(0.1, 1.0 / 3.0), 1e-9);
  EXPECT_NEAR(json[0]["estimate"]["orientation_median_rad"], 0.01, 1e-9);
  EXPECT_NEAR(json[0]["odometry"]["position_max_m"], 39.0 * std::hypot(0.02, 0.01), 1e-9);
  EXPECT_EQ(json[0]["coverage_steps"], 40);
  EXPECT_EQ(json[0]["is_complete"], true);
}

TEST_F(EvaluateCommand, PrintsOneLineOfCsvARun) {
  const auto shown = run_program({"evaluate", run("a.nadir"), run("b.nadir", 20), "--csv"});
  EXPECT_EQ(shown.status, 0);
  EXPECT_EQ(std::count(shown.out.begin(), shown.out.end(), '\n'), 3);
  EXPECT_THAT(shown.out, AllOf(HasSubstr("run,flight,map"), HasSubstr("a.nadir,loop,proving-"),
                               HasSubstr("b.nadir,loop,proving-")));
}

TEST_F(EvaluateCommand, JudgesSeveralRunsInTheOrderGiven) {
  const std::string first = run("a.nadir", 30);
  const auto json = runs_of(run_program({"evaluate", run("b.nadir", 12), first, "--json"}));
  ASSERT_EQ(json.size(), 2U);
  EXPECT_EQ(json[0]["steps"], 12);
  EXPECT_EQ(json[1]["steps"], 30);
}

TEST_F(EvaluateCommand, AlignsOnlyWhereItIsAskedTo) {
  const std::string recorded = run("R.nadir");
  const auto se2 = runs_of(run_program({"evaluate", recorded, "--align", "se2", "--json"}))[0];
  EXPECT_EQ(se2["alignment"], "se2");
  EXPECT_LT(se2["estimate"]["position_rmse_m"], 1e-6) << "its error is a constant shift";
  EXPECT_NEAR(se2["estimate_alignment"]["x_m"].get<double>(), -0.1, 0.1);
  const auto sim2 = runs_of(run_program({"evaluate", recorded, "--align", "sim2", "--json"}))[0];
  EXPECT_LT(sim2["odometry_alignment"]["scale"], 1.0) << "odometry measured 2 % too much";
  const auto text = run_program({"evaluate", recorded, "--align", "se2"});
  EXPECT_THAT(text.out, HasSubstr("least squares on all pairs"));
}

TEST_F(EvaluateCommand, SaysThatARunWasStopped) {
  const std::string stopped = run("S.nadir", 7, false);
  const auto shown = run_program({"evaluate", stopped});
  EXPECT_EQ(shown.status, 0);
  EXPECT_EQ(shown.err, stopped + ": was stopped before its end; these are its first 7 steps\n");
  EXPECT_THAT(shown.out, HasSubstr("(stopped before its end)"));
  EXPECT_EQ(run_program({"evaluate", stopped, "--quiet"}).err, "");
  EXPECT_EQ(runs_of(run_program({"evaluate", stopped, "--json"}))[0]["is_complete"], false);
}

TEST_F(EvaluateCommand, WritesToAFileWhereItIsAskedTo) {
  const std::string recorded = run("R.nadir");
  const auto shown = run_program({"evaluate", recorded, "--json", "--out", path("r.json")});
  EXPECT_EQ(shown.status, 0);
  EXPECT_EQ(shown.out, "");
  EXPECT_EQ(read_text_file(path("r.json")).value(),
            run_program({"evaluate", recorded, "--json"}).out);
  const auto refused = run_program({"evaluate", recorded, "--out", path("no/r.json")});
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.err, HasSubstr("no/r.json"));
}

TEST_F(EvaluateCommand, RefusesARunOfANewerVersion) {
  const std::string newer = run("N.nadir");
  sqlite3* database = nullptr;
  sqlite3_open(newer.c_str(), &database);
  sqlite3_exec(database, "PRAGMA user_version = 1000", nullptr, nullptr, nullptr);
  sqlite3_close(database);
  const auto refused = run_program({"evaluate", newer, "--json"});
  EXPECT_EQ(refused.status, 1);
  EXPECT_EQ(refused.out, "");
  EXPECT_THAT(refused.err, HasSubstr("N.nadir: was written by a newer version of Nadir"));
}

TEST_F(EvaluateCommand, PrintsNothingWhereOneOfSeveralRunsIsBad) {
  const std::string good = run("R.nadir");
  for (const std::string& bad : {path("missing.nadir"), scratch_.file("x.txt", "dear").string()}) {
    const auto refused = run_program({"evaluate", good, bad, "--csv"});
    EXPECT_EQ(refused.status, 1);
    EXPECT_EQ(refused.out, "");
    EXPECT_THAT(refused.err, HasSubstr(bad));
    EXPECT_EQ(std::count(refused.err.begin(), refused.err.end(), '\n'), 1) << refused.err;
  }
}

TEST_F(EvaluateCommand, CannotAlignARunOfOneStep) {
  const auto refused = run_program({"evaluate", run("one.nadir", 1), "--align", "se2"});
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.err, HasSubstr("one.nadir"));
}

TEST_F(EvaluateCommand, ExitsWithTwoWhereItIsMisused) {
  const std::string recorded = run("R.nadir");
  EXPECT_EQ(run_program({"evaluate"}).status, 2);
  EXPECT_EQ(run_program({"evaluate", recorded, "--align", "se3"}).status, 2);
  EXPECT_EQ(run_program({"evaluate", recorded, "--json", "--csv"}).status, 2);
  EXPECT_EQ(run_program({"evaluate", recorded, "--jsn"}).status, 2);
  EXPECT_EQ(run_program({"evaluate", "--help"}).status, 0);
}

}  // namespace
}  // namespace nadir
