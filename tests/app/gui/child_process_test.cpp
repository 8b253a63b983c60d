// SPDX-License-Identifier: Apache-2.0
#include "app/gui/child_process.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "tests/support/error_text.h"

namespace nadir {
namespace child_process_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// Looks until it is over; a program of these tests takes milliseconds.
int status_of(ChildProcess& process) {
  for (int i = 0; i < 5'000; ++i) {
    if (const auto status = process.poll()) return *status;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return -1;
}

Result<ChildProcess> shell(const std::string& words) {
  return ChildProcess::start("/bin/sh", {"-c", words}, {{"NADIR_SAID", "of the parent"}});
}

TEST(ChildProcess, TellsItsStatusAndWhatItSaidLineByLine) {
  auto process = shell("echo to nobody; echo first >&2; printf 'second' >&2; exit 3");
  ASSERT_TRUE(process) << error_text(process);
  EXPECT_EQ(status_of(*process), 3);
  EXPECT_THAT(process->lines(), ElementsAre("first", "second"));
  EXPECT_EQ(process->poll(), 3);  // again and again
}

TEST(ChildProcess, HasItsParentsEnvironmentAndMore) {
  auto process = shell("echo \"$NADIR_SAID\" >&2; test -n \"$PATH\"");
  ASSERT_TRUE(process) << error_text(process);
  EXPECT_EQ(status_of(*process), 0);
  EXPECT_THAT(process->lines(), ElementsAre("of the parent"));
}

TEST(ChildProcess, SaysMoreThanAPipeHolds) {
  auto process = shell("i=0; while [ $i -lt 20000 ]; do echo line$i >&2; i=$((i+1)); done");
  ASSERT_TRUE(process) << error_text(process);
  EXPECT_EQ(status_of(*process), 0);
  ASSERT_EQ(process->lines().size(), 20'000U);
  EXPECT_EQ(process->lines().back(), "line19999");
}

TEST(ChildProcess, StopsWhenItIsAskedTo) {
  auto process = shell("exec sleep 100");
  ASSERT_TRUE(process) << error_text(process);
  EXPECT_EQ(process->poll(), std::nullopt);
  process->ask_to_stop();
  EXPECT_TRUE(process->was_asked_to_stop());
  EXPECT_EQ(status_of(*process), 128 + 15);
}

TEST(ChildProcess, IsGoneWithItsObjectEvenIfItDoesNotListen) {
  const auto began = std::chrono::steady_clock::now();
  {
    auto process = shell("trap '' TERM; echo ready >&2; while :; do sleep 1; done");
    ASSERT_TRUE(process) << error_text(process);
    while (process->lines().empty()) (void)process->poll();
  }
  EXPECT_LT(std::chrono::steady_clock::now() - began, std::chrono::seconds(20));
}

TEST(ChildProcess, CannotBeAProgramThatIsNotThere) {
  const auto process = ChildProcess::start("/nowhere/nadir", {});
  ASSERT_FALSE(process);
  EXPECT_THAT(process.error().message, HasSubstr("/nowhere/nadir: cannot be started"));
}

TEST(ChildProcess, KnowsItsOwnProgram) {
  EXPECT_THAT(own_program().filename().string(), HasSubstr("test"));
}

}  // namespace child_process_test
}  // namespace nadir
