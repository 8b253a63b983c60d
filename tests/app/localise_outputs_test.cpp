// SPDX-License-Identifier: Apache-2.0
// What `nadir localise` writes over, and what it never does.
#include <gmock/gmock.h>
#include <unistd.h>

#include <atomic>
#include <stop_token>
#include <thread>

#include "app/cli/localise_flow.h"
#include "core/base/staged_output.h"
#include "core/geo/trajectory_file.h"
#include "core/run/run_file.h"
#include "tests/app/short_flight.h"
#include "tests/core/run/recorded_run.h"
#include "tests/support/error_text.h"

namespace nadir {
namespace localise_outputs_test {

using testing::HasSubstr;
using testing::StartsWith;

namespace fs = std::filesystem;

class LocaliseOutputs : public ShortFlight {
 protected:
  /// Number of files in the folder whose names begin like this.
  static int files_named(const std::string& begin) {
    int count = 0;
    for (const auto& entry : fs::directory_iterator(scratch_->path())) {
      if (entry.path().filename().string().rfind(begin, 0) == 0) ++count;
    }
    return count;
  }
};

TEST_F(LocaliseOutputs, RefusesToOverwriteAFileThatIsNoRunBeforeItDoesAnything) {
  const auto letter = scratch_->file("letter.txt", "dear");
  expect_refused({"localise", path("no-flight"), "--map", path("no-map"), "--out", letter.string()},
                 "nadir: " + letter.string() + ": will not be overwritten: it is no run file");
  EXPECT_EQ(read_text_file(letter).value(), "dear");
}

TEST_F(LocaliseOutputs, RefusesAnOutputFolderThatIsNotThere) {
  const auto refused = run_program(localise({"--out", path("nowhere/run.nadir")}));
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.err, HasSubstr("nowhere"));
  const auto simulated = run_program(
      {"simulate", path("map"), "--route", path("route.toml"), "--out", path("nowhere/flight")});
  EXPECT_EQ(simulated.status, 1);
  EXPECT_THAT(simulated.err, HasSubstr("nowhere"));
}

TEST_F(LocaliseOutputs, FindsOutBeforeItBeginsThatATrajectoryCannotBeWritten) {
  expect_refused(
      localise({"--out", path("refused.nadir"), "--trajectory", path("nowhere/estimate.txt")}),
      "--trajectory: " + path("nowhere/estimate.txt"));
}

TEST_F(LocaliseOutputs, WritesTheEstimatesAsTumTextInMetresOfTheProjectPlane) {
  const auto localised = run_program(
      localise({"--out", path("T.nadir"), "--trajectory", path("estimate.txt"), "--frames", "12"}));
  ASSERT_EQ(localised.status, 0) << localised.err;
  const auto steps = RunReader::open(path("T.nadir")).value().steps().value();
  const auto poses = read_trajectory(path("estimate.txt")).value().poses();
  ASSERT_EQ(poses.size(), 12U);
  ASSERT_EQ(steps.size(), 12U);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Rigid2& mean = steps[i].estimate.moments.mean;
    EXPECT_EQ(poses[i].time_s, steps[i].time_s);
    EXPECT_EQ(poses[i].pose.translation_m, Eigen::Vector3d(mean.x_m, mean.y_m, 0.0));
    EXPECT_NEAR(planar(poses[i].pose).yaw_rad, mean.yaw_rad, 1e-12);
  }
  ASSERT_EQ(
      run_program({"evaluate", path("T.nadir"), "--trajectory", path("evaluated.txt")}).status, 0);
  EXPECT_EQ(read_text_file(path("evaluated.txt")).value(),
            read_text_file(path("estimate.txt")).value());
}

TEST_F(LocaliseOutputs, LeavesARunAloneThatIsBeingWritten) {
  auto writer = RunWriter::create(path("busy.nadir"), example_header()).value();
  ASSERT_TRUE(writer.write(example_step(0)).has_value());
  expect_refused(localise({"--out", path("busy.nadir")}),
                 "busy.nadir: is being written by another run");
  EXPECT_EQ(files_named("busy"), 1) << "nothing was put aside";
  ASSERT_TRUE(writer.write(example_step(1)).has_value());
  ASSERT_TRUE(writer.finish().has_value());
  const auto run = RunReader::open(path("busy.nadir")).value();
  EXPECT_TRUE(run.is_complete());
  EXPECT_EQ(run.step_count(), 2);
}

TEST_F(LocaliseOutputs, KeepsTheRunThatAnEarlierProgramOfTheSameProcessIdPutAside) {
  const std::string kept = path("same.nadir.earlier-" + std::to_string(::getpid()));
  record_run(kept, 5);
  record_run(path("same.nadir"), 2);
  ASSERT_EQ(run_program(localise({"--out", path("same.nadir"), "--frames", "3"})).status, 0);
  EXPECT_EQ(RunReader::open(kept).value().step_count(), 5);
  EXPECT_EQ(RunReader::open(path("same.nadir")).value().step_count(), 3);
  EXPECT_EQ(files_named("same.nadir"), 2);
}

TEST_F(LocaliseOutputs, RefusesATrajectoryInPlaceOfItsOwnRunHoweverItIsSpelt) {
  fs::create_directory_symlink(scratch_->path(), path("link"));
  record_run(path("taken.nadir"), 2);
  const std::string before = read_text_file(path("taken.nadir")).value();
  for (const char* out : {"refused.nadir", "taken.nadir"}) {
    for (const char* folder : {"", "./", "link/", "nowhere/../"}) {
      expect_refused(
          localise({"--out", path(out), "--trajectory", path(folder + std::string(out))}),
          "is the run file of --out", 2);
    }
  }
  EXPECT_EQ(read_text_file(path("taken.nadir")).value(), before);
}

TEST_F(LocaliseOutputs, RefusesATrajectoryInPlaceOfWhatItReads) {
  scratch_->file("quick.toml", "preset = \"thesis\"\n");
  for (const auto& [file, what] :
       {std::pair("flight/truth.txt", "is the truth of the flight"),
        std::pair("flight/./truth.txt", "is the truth of the flight"),
        std::pair("flight/odometry.txt", "is the odometry of the flight"),
        std::pair("flight/flight.toml", "is a file of the flight"),
        std::pair("map/../map/map.toml", "is a file of the map")}) {
    const std::string before = read_text_file(path(file)).value();
    expect_refused(localise({"--out", path("refused.nadir"), "--trajectory", path(file)}),
                   "--trajectory: " + path(file) + " " + what);
    EXPECT_EQ(read_text_file(path(file)).value(), before);
  }
  expect_refused(localise({"--recipe", path("quick.toml"), "--trajectory", path("./quick.toml")}),
                 "is the recipe to read", 2);
}

TEST_F(LocaliseOutputs, ReplacesARunThatIsEmptyOrDamaged) {
  record_run(path("whole.nadir"), 2);
  const std::string whole = read_text_file(path("whole.nadir")).value();
  for (const std::string& bytes : {std::string(), whole.substr(0, whole.size() / 2)}) {
    scratch_->file("broken.nadir", bytes);
    const auto run = run_program(localise({"--out", path("broken.nadir"), "--frames", "3"}));
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(RunReader::open(path("broken.nadir")).value().step_count(), 3);
    EXPECT_EQ(files_named("broken"), 1);
  }
}

TEST_F(LocaliseOutputs, RefusesToOverwriteARunOfANewerVersion) {
  record_run(path("newer.nadir"), 2);
  std::string bytes = read_text_file(path("newer.nadir")).value();
  bytes.at(63) = 9;  // Where SQLite keeps PRAGMA user_version.
  scratch_->file("newer.nadir", bytes);
  expect_refused(localise({"--out", path("newer.nadir")}),
                 "newer.nadir: will not be overwritten: it was written by a newer version");
  EXPECT_EQ(read_text_file(path("newer.nadir")).value(), bytes);
}

/// Localises into this file until its first steps are there, as Ctrl+C would stop it.
class StoppedRun : public LocaliseOutputs {
 protected:
  static Error stopped(const std::string& out) {
    cli::LocaliseTask task;
    task.flight = path("flight");
    task.map = path("map");
    task.run = out;
    task.is_quiet = true;
    // Steps of 0.1 s, so that the stop comes long before the end.
    EXPECT_TRUE(set_option(task.request.options, "particles", "200000").has_value());
    std::stop_source stop;
    std::atomic<bool> is_done = false;
    std::jthread watcher([&] {
      while (!is_done) {
        const auto run = RunReader::open(out);
        if (run && run->header().flight != example_header().flight && run->step_count() > 0) {
          stop.request_stop();
        }
        std::this_thread::yield();
      }
    });
    std::ostringstream words;
    const auto result = cli::localise_and_evaluate(task, stop.get_token(), words);
    is_done = true;
    EXPECT_FALSE(result);
    return result ? Error{} : result.error();
  }
};

TEST_F(StoppedRun, KeepsItsStepsAndTheCompleteRunThatWasThereBefore) {
  record_run(path("stopped.nadir"), 3);
  const Error error = stopped(path("stopped.nadir"));
  EXPECT_EQ(error.code, ErrorCode::kCancelled);
  const std::string kept = path("stopped.nadir.earlier-" + std::to_string(::getpid()));
  EXPECT_THAT(error.message, StartsWith("stopped after "));
  EXPECT_THAT(error.message, HasSubstr(" steps; they are in " + path("stopped.nadir") +
                                       ", and the run that was there before is in " + kept));
  const auto before = RunReader::open(kept).value();
  EXPECT_TRUE(before.is_complete());
  EXPECT_EQ(before.step_count(), 3);
  const auto now = RunReader::open(path("stopped.nadir")).value();
  EXPECT_FALSE(now.is_complete());
  EXPECT_GT(now.step_count(), 0);
}

TEST_F(StoppedRun, SaysNothingOfARunBeforeWhereThereWasNone) {
  const Error error = stopped(path("alone.nadir"));
  EXPECT_EQ(error.code, ErrorCode::kCancelled);
  EXPECT_TRUE(error.message.ends_with(" steps; they are in " + path("alone.nadir")))
      << error.message;
  EXPECT_EQ(files_named("alone"), 1);
}

}  // namespace localise_outputs_test
}  // namespace nadir
