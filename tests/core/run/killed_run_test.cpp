// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <sqlite3.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <filesystem>
#include <functional>

#include "core/run/run_file.h"
#include "tests/core/run/recorded_run.h"
#include "tests/support/error_text.h"
#include "tests/support/scratch_folder.h"

namespace nadir {
namespace killed_run_test {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr int kParticles = 400;

/// Runs `work` in a child process; its exit status, or minus the signal that ended it.
int in_child(const std::function<int()>& work) {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(work());
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFSIGNALED(status) ? -WTERMSIG(status) : WEXITSTATUS(status);
}

/// Starts a child that writes steps without end, and kills it once it has reported `steps` of them
/// and `spins` more turns of a loop have passed, so that the kill falls on different moments of a
/// step.
void write_until_killed(const fs::path& path, int steps, int spins) {
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    auto writer = RunWriter::create(path, example_header());
    for (int i = 0; writer; ++i) {
      if (!writer->write(example_step(i, kParticles)) || ::write(ends[1], "s", 1) != 1) ::_exit(1);
    }
    ::_exit(1);
  }
  ::close(ends[1]);
  char report = 0;
  int reported = 0;
  while (reported < steps && ::read(ends[0], &report, 1) == 1) ++reported;
  for (std::atomic<int> turns = 0; turns < spins; ++turns) {
  }
  ::kill(child, SIGKILL);
  int status = 0;
  ::waitpid(child, &status, 0);
  ::close(ends[0]);
  ASSERT_EQ(reported, steps);
  ASSERT_TRUE(WIFSIGNALED(status));
}

TEST(KilledRun, IsReadableUpToItsLastStepWheneverTheKillFalls) {
  const ScratchFolder folder;
  for (int round = 0; round < 24; ++round) {
    const fs::path path = folder.path() / ("R" + std::to_string(round) + ".nadir");
    const int reported = 1 + round % 7;
    write_until_killed(path, reported, round * 10'000);
    const auto run = RunReader::open(path);
    ASSERT_TRUE(run) << error_text(run);
    EXPECT_FALSE(run->is_complete());
    const auto steps = run->steps();
    ASSERT_TRUE(steps) << error_text(steps);
    ASSERT_GE(steps->size(), static_cast<std::size_t>(reported)) << "every reported step is there";
    EXPECT_EQ(run->step_count(), static_cast<int>(steps->size()));
    for (const RunStep& step : *steps) {
      const auto whole = run->step(step.step);
      ASSERT_TRUE(whole) << error_text(whole);
      ASSERT_TRUE(whole->particles && whole->topview) << "no step is there in part";
      EXPECT_EQ(whole->particles->size(), static_cast<std::size_t>(kParticles));
      EXPECT_EQ(whole->estimate.moments.mean, example_step(step.step).estimate.moments.mean);
    }
  }
}

/// Kills a writer in the middle of a step, when parts of it lie in the file already and the journal
/// with the way back lies beside it: what a kill in the worst moment leaves.
void leave_half_a_step(const fs::path& path) {
  record_run(path, 3, kParticles, false);
  const int status = in_child([&] {
    sqlite3* database = nullptr;
    sqlite3_open(path.c_str(), &database);
    sqlite3_exec(database,
                 "PRAGMA cache_size = 1; PRAGMA synchronous = OFF; BEGIN;"
                 "UPDATE step SET estimate_x_m = -1; UPDATE about SET value = 'torn';"
                 "UPDATE particles SET data = zeroblob(200000);",
                 nullptr, nullptr, nullptr);
    ::raise(SIGKILL);
    return 0;
  });
  ASSERT_EQ(status, -SIGKILL);
  ASSERT_TRUE(fs::exists(path.string() + "-journal"));
}

/// 0 if the run holds its three whole steps and nothing of the torn one.
int check_three_steps(const fs::path& path) {
  const auto run = RunReader::open(path);
  if (!run) return 10;
  if (run->header().flight != "loop" || run->step_count() != 3) return 11;
  const auto steps = run->steps();
  if (!steps || steps->size() != 3) return 12;
  for (int i = 0; i < 3; ++i) {
    const auto step = run->step(i);
    if (!step || !step->particles || step->particles->size() != kParticles) return 13;
    if (step->estimate.moments.mean != example_step(i).estimate.moments.mean) return 14;
  }
  return 0;
}

TEST(KilledRun, HalfAStepIsTakenBackFromTheFile) {
  const ScratchFolder folder;
  const fs::path path = folder.path() / "R.nadir";
  leave_half_a_step(path);
  EXPECT_EQ(check_three_steps(path), 0);
  EXPECT_FALSE(fs::exists(path.string() + "-journal")) << "done once and for all";
  EXPECT_EQ(check_three_steps(path), 0);
}

TEST(KilledRun, HalfAStepIsTakenBackUnderAnOpenReader) {
  const ScratchFolder folder;
  const fs::path path = folder.path() / "R.nadir";
  record_run(path, 1, kParticles, false);
  const auto early = RunReader::open(path);
  ASSERT_TRUE(early);
  ASSERT_EQ(in_child([&] {
              sqlite3* database = nullptr;
              sqlite3_open(path.c_str(), &database);
              sqlite3_exec(database,
                           "PRAGMA cache_size = 1; BEGIN; UPDATE particles SET data = "
                           "zeroblob(300000); UPDATE step SET time_s = -1;",
                           nullptr, nullptr, nullptr);
              ::raise(SIGKILL);
              return 0;
            }),
            -SIGKILL);
  ASSERT_TRUE(fs::exists(path.string() + "-journal"));
  const auto steps = early->steps();
  ASSERT_TRUE(steps) << error_text(steps);
  EXPECT_EQ(steps->at(0).time_s, 0.0);
}

TEST(KilledRun, IsReadableInAFolderThatMayNotBeWritten) {
  const ScratchFolder folder;
  const fs::path kept = folder.path() / "archive";
  fs::create_directory(kept);
  leave_half_a_step(kept / "R.nadir");
  fs::permissions(folder.path(), fs::perms::all);
  fs::permissions(kept / "R.nadir", fs::perms(0444));
  fs::permissions(kept / "R.nadir-journal", fs::perms(0444));
  fs::permissions(kept, fs::perms(0555));
  const int outcome = in_child([&] {
    // Root may write anywhere, so it becomes nobody for this.
    if (::geteuid() == 0 && (::setgid(65534) != 0 || ::setuid(65534) != 0)) return 99;
    if (::access(kept.c_str(), W_OK) == 0) return 98;
    return check_three_steps(kept / "R.nadir");
  });
  EXPECT_EQ(outcome, 0);
  EXPECT_TRUE(fs::exists(kept / "R.nadir-journal")) << "the original is as it was";
  fs::permissions(kept, fs::perms(0755));
}

TEST(KilledRun, AFinishedRunIsReadableInAFolderThatMayNotBeWritten) {
  const ScratchFolder folder;
  const fs::path kept = folder.path() / "archive";
  fs::create_directory(kept);
  record_run(kept / "R.nadir", 3, kParticles);
  fs::permissions(folder.path(), fs::perms::all);
  fs::permissions(kept / "R.nadir", fs::perms(0444));
  fs::permissions(kept, fs::perms(0555));
  EXPECT_EQ(in_child([&] {
              if (::geteuid() == 0 && (::setgid(65534) != 0 || ::setuid(65534) != 0)) return 99;
              return check_three_steps(kept / "R.nadir");
            }),
            0);
  fs::permissions(kept, fs::perms(0755));
}

TEST(KilledRun, CanBeReplacedByANewOne) {
  const ScratchFolder folder;
  const fs::path path = folder.path() / "R.nadir";
  leave_half_a_step(path);
  record_run(path, 3, kParticles);
  EXPECT_EQ(check_three_steps(path), 0) << "the old journal does not reach into the new run";
}

TEST(KilledRun, IsWholeAgainWhenTheOneThatReplacedItIsDiscarded) {
  const ScratchFolder folder;
  const fs::path path = folder.path() / "R.nadir";
  leave_half_a_step(path);
  auto writer = RunWriter::create(path, {}).value();
  ASSERT_TRUE(writer.write(example_step(0)));
  writer.discard();
  EXPECT_EQ(check_three_steps(path), 0);
  EXPECT_EQ(folder.entries(), 1);
}

TEST(KilledRun, IsWholeWhereItStaysBesideAShorterOneThatWasStopped) {
  const ScratchFolder folder;
  const fs::path path = folder.path() / "R.nadir";
  leave_half_a_step(path);
  auto writer = RunWriter::create(path, {}).value();
  ASSERT_TRUE(writer.write(example_step(0)));
  EXPECT_EQ(check_three_steps(writer.stop()), 0);
  EXPECT_EQ(RunReader::open(path)->step_count(), 1);
  EXPECT_EQ(folder.entries(), 2) << "no journal is left";
}

TEST(RunWriter, RefusesAFileThatAnotherWriterIsAtWorkOn) {
  const ScratchFolder folder;
  const fs::path path = folder.path() / "R.nadir";
  {
    auto writer = RunWriter::create(path, example_header()).value();
    ASSERT_TRUE(writer.write(example_step(0)));
    EXPECT_THAT(error_text(RunWriter::create(path, {})),
                HasSubstr("R.nadir: is being written by another run"));
    EXPECT_EQ(in_child([&] { return RunWriter::create(path, {}) ? 1 : 0; }), 0);
    EXPECT_THAT(error_text(RunWriter::check_output(path)),
                HasSubstr("R.nadir: is being written by another run"));
    EXPECT_EQ(folder.entries(), 1) << "nothing was put aside";
    EXPECT_EQ(RunReader::open(path)->step_count(), 1) << "readers are welcome";
    ASSERT_TRUE(writer.write(example_step(1))) << "and the first one goes on";
    EXPECT_EQ(RunReader::open(path)->step_count(), 2);
  }
  EXPECT_TRUE(RunWriter::create(path, example_header())) << "it is done now";
}

TEST(RunWriter, RefusesAFolderThatMayNotBeWritten) {
  const ScratchFolder folder;
  const fs::path kept = folder.path() / "archive";
  fs::create_directory(kept);
  fs::permissions(folder.path(), fs::perms::all);
  fs::permissions(kept, fs::perms(0555));
  EXPECT_EQ(in_child([&] {
              if (::geteuid() == 0 && (::setgid(65534) != 0 || ::setuid(65534) != 0)) return 99;
              const auto writer = RunWriter::create(kept / "R.nadir", {});
              if (writer) return 1;
              return writer.error().message.find("is not writable") == std::string::npos ? 2 : 0;
            }),
            0);
  fs::permissions(kept, fs::perms(0755));
}

}  // namespace killed_run_test
}  // namespace nadir
