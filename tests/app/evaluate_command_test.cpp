// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <sqlite3.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/cli/trajectory_output.h"
#include "core/base/staged_output.h"
#include "core/geo/trajectory_file.h"
#include "tests/app/program.h"
#include "tests/core/run/recorded_run.h"
#include "tests/support/scratch_folder.h"

namespace nadir {
namespace evaluate_command_test {

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

TEST_F(EvaluateCommand, WritesTheEstimatesOfARunAsTumText) {
  const std::string recorded = run("R.nadir", 5);
  const auto shown =
      run_program({"evaluate", recorded, "--trajectory", path("estimate.txt"), "--align", "se2"});
  ASSERT_EQ(shown.status, 0) << shown.err;
  EXPECT_THAT(shown.out, HasSubstr("position RMSE"));
  const auto poses = read_trajectory(path("estimate.txt")).value().poses();
  ASSERT_EQ(poses.size(), 5U);
  for (int i = 0; i < 5; ++i) {
    const auto& pose = poses[static_cast<std::size_t>(i)];
    EXPECT_EQ(pose.time_s, example_step(i).time_s);
    EXPECT_EQ(pose.pose.translation_m, Eigen::Vector3d(500.0 + i + 0.1, 200.0 - 1.0 / 3.0, 0.0))
        << "as estimated, though the table is of aligned poses";
    EXPECT_NEAR(planar(pose.pose).yaw_rad, 0.01, 1e-12);
  }
}

TEST_F(EvaluateCommand, HeadsATrajectoryWithItsFrameAndWhereThatLies) {
  ASSERT_EQ(run_program({"evaluate", run("R.nadir", 2), "--trajectory", path("t.txt")}).status, 0);
  EXPECT_THAT(read_text_file(path("t.txt")).value(),
              AllOf(testing::StartsWith("# estimated trajectory of flight loop, written by Nadir "),
                    HasSubstr("# frame enu: x east and y north in metres"),
                    HasSubstr("latitude 47.12345678901234"), HasSubstr("# times in seconds"),
                    HasSubstr("# time_s x y z qx qy qz qw\n0 ")));
}

TEST_F(EvaluateCommand, WritesATrajectoryWholeOrNotAtAll) {
  const std::string recorded = run("R.nadir", 3);
  const auto refused =
      run_program({"evaluate", recorded, "--trajectory", path("nowhere/t.txt"), "--json"});
  EXPECT_EQ(refused.status, 1);
  EXPECT_EQ(refused.out, "");
  EXPECT_THAT(refused.err, HasSubstr("--trajectory: " + path("nowhere/t.txt")));
  EXPECT_EQ(scratch_.entries(), 1);
}

TEST_F(EvaluateCommand, SaysThatARunKnewNoTruth) {
  auto writer = RunWriter::create(path("blind.nadir"), example_header()).value();
  for (int i = 0; i < 3; ++i) {
    RunStep step = example_step(i);
    step.truth_in_enu.reset();
    ASSERT_TRUE(writer.write(step).has_value());
  }
  ASSERT_TRUE(writer.finish().has_value());
  const auto shown = run_program({"evaluate", path("blind.nadir"), "--json"});
  EXPECT_EQ(runs_of(shown)[0]["steps"], 3);
  EXPECT_TRUE(runs_of(shown)[0]["estimate"]["position_rmse_m"].is_null());
  EXPECT_EQ(shown.err,
            path("blind.nadir") + ": its flight knew no truth, so its errors are unknown\n");
  const auto aligned = run_program({"evaluate", path("blind.nadir"), "--align", "se2"});
  EXPECT_EQ(aligned.status, 1);
  EXPECT_THAT(aligned.err, HasSubstr("blind.nadir: "));
}

TEST_F(EvaluateCommand, FailsWithARunWithoutSteps) {
  const std::string empty = run("E.nadir", 0, false);
  for (const std::vector<std::string>& more :
       {std::vector<std::string>{}, {"--json"}, {"--trajectory", path("t.txt")}}) {
    std::vector<std::string> arguments = {"evaluate", empty};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const auto refused = run_program(arguments);
    EXPECT_EQ(refused.status, 1);
    EXPECT_EQ(refused.out, "");
    EXPECT_EQ(refused.err, "nadir: " + empty + ": holds no steps, so there is nothing to judge\n");
  }
}

TEST_F(EvaluateCommand, FailsWithAFolder) {
  const auto refused = run_program({"evaluate", scratch_.path().string()});
  EXPECT_EQ(refused.status, 1);
  EXPECT_EQ(refused.err, "nadir: " + scratch_.path().string() + ": is a folder, not a run file\n");
}

TEST_F(EvaluateCommand, DoesNotWriteOverWhatItReads) {
  const std::string recorded = run("R.nadir");
  for (const char* flag : {"--out", "--trajectory"}) {
    const auto refused = run_program({"evaluate", recorded, flag, recorded});
    EXPECT_EQ(refused.status, 2);
    EXPECT_THAT(refused.err, HasSubstr(std::string(flag) + ": " + recorded + " is a run to read"));
  }
  const auto respelt = run_program({"evaluate", recorded, "--trajectory", path("./R.nadir")});
  EXPECT_EQ(respelt.status, 2);
  EXPECT_THAT(respelt.err, HasSubstr("is a run to read"));
  for (const char* name : {"both.txt", "./both.txt", "nowhere/../both.txt"}) {
    const auto twice =
        run_program({"evaluate", recorded, "--out", path("both.txt"), "--trajectory", path(name)});
    EXPECT_EQ(twice.status, 2) << name;
    EXPECT_THAT(twice.err, HasSubstr("is the file of --out"));
  }
  EXPECT_EQ(scratch_.entries(), 1);
}

TEST_F(EvaluateCommand, KnowsAFileByAnyOfItsNames) {
  using cli::names_same_file;
  EXPECT_TRUE(names_same_file("to-be-made.nadir", "./to-be-made.nadir"));
  EXPECT_TRUE(
      names_same_file("to-be-made.nadir", std::filesystem::current_path() / "to-be-made.nadir"));
  EXPECT_FALSE(names_same_file("to-be-made.nadir", "to-be-made.txt"));
  EXPECT_FALSE(names_same_file("", "")) << "no file at all";
  EXPECT_FALSE(names_same_file("", std::filesystem::current_path()));
  std::filesystem::create_directory_symlink(scratch_.path(), path("link"));
  EXPECT_TRUE(names_same_file(path("link/new.nadir"), path("new.nadir")));
  const std::string recorded = run("R.nadir", 1);
  std::filesystem::create_symlink("R.nadir", path("L.nadir"));
  EXPECT_TRUE(names_same_file(recorded, path("L.nadir")));
}

TEST_F(EvaluateCommand, WritesTheTrajectoryOfOneRunOnly) {
  const auto refused = run_program(
      {"evaluate", run("a.nadir"), run("b.nadir"), "--trajectory", path("estimate.txt")});
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.err, HasSubstr("--trajectory: is for one run, and 2 are given"));
}

TEST_F(EvaluateCommand, ExitsWithTwoWhereItIsMisused) {
  const std::string recorded = run("R.nadir");
  EXPECT_EQ(run_program({"evaluate"}).status, 2);
  EXPECT_EQ(run_program({"evaluate", recorded, "--align", "se3"}).status, 1)
      << "a value, not a word";
  EXPECT_EQ(run_program({"evaluate", recorded, "--json", "--csv"}).status, 2);
  EXPECT_EQ(run_program({"evaluate", recorded, "--jsn"}).status, 2);
  EXPECT_EQ(run_program({"evaluate", "--help"}).status, 0);
}

}  // namespace evaluate_command_test
}  // namespace nadir
