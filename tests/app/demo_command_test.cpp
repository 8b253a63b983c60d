// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <iostream>

#include "tests/app/program.h"
#include "tests/support/scratch_folder.h"

namespace nadir {
namespace demo_command_test {

namespace fs = std::filesystem;

/// Works in a folder for as long as it lives.
class WorkingFolder {
 public:
  explicit WorkingFolder(const fs::path& folder) { fs::current_path(folder); }
  ~WorkingFolder() { fs::current_path(before_); }
  WorkingFolder(const WorkingFolder&) = delete;
  WorkingFolder& operator=(const WorkingFolder&) = delete;

 private:
  fs::path before_ = fs::current_path();
};

TEST(DemoCommand, BlamesTheBundledMapAndNotItsFolderWhereThatMapIsMissing) {
  const ScratchFolder scratch;
  fs::create_directories(scratch.path() / "maps" / "proving-ground");  // a shell of the bundled map
  const WorkingFolder here(scratch.path());
  const auto refused = run_program({"demo", "--out", "target"});
  EXPECT_EQ(refused.status, 1);
  EXPECT_EQ(refused.err,
            "nadir: maps/proving-ground: the bundled map is missing from this installation of "
            "Nadir\n");
  EXPECT_FALSE(fs::exists("target"));
}

TEST(DemoCommand, FailsWhereItsFolderIsAFile) {
  const ScratchFolder scratch;
  const std::string letter = scratch.file("letter.txt", "dear").string();
  const auto refused = run_program({"demo", "--out", letter});
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.err, testing::StartsWith("nadir: " + letter));
  EXPECT_EQ(scratch.entries(), 1);
}

TEST(DemoCommand, FailsWithASeedThatIsNoNumber) {
  const auto refused = run_program({"demo", "--seed", "lucky"});
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.err, testing::StartsWith("nadir demo: --seed: 'lucky' is not a whole"));
}

/// Runs the demo with a Ctrl+C that waits for it, and ends the process with its exit status; 99 where it leaves a piece
/// of work behind.
[[noreturn]] void interrupted_demo(const fs::path& folder) {
  sigset_t interrupt;
  sigemptyset(&interrupt);
  sigaddset(&interrupt, SIGINT);
  pthread_sigmask(SIG_BLOCK, &interrupt, nullptr);
  ::kill(::getpid(), SIGINT);
  const auto stopped = run_program({"demo", "--out", folder.string(), "--quiet"});
  std::cerr << stopped.err;
  bool is_clean = !fs::exists(folder / "flight") && !fs::exists(folder / "run.nadir");
  for (const auto& entry : fs::directory_iterator(folder)) {
    is_clean = is_clean && entry.path().string().find(".partial-") == std::string::npos;
  }
  std::_Exit(is_clean ? stopped.status : 99);
}

TEST(DemoCommandDeathTest, IsStoppedByCtrlCFromItsFirstFileOnAndLeavesNothingHalfDone) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";  // a process of its own, with one thread
  const ScratchFolder scratch;
  EXPECT_EXIT(interrupted_demo(scratch.path() / "demo"), testing::ExitedWithCode(1), "was stopped");
}

}  // namespace demo_command_test
}  // namespace nadir
