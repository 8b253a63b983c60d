// SPDX-License-Identifier: Apache-2.0
#include "core/base/log.h"

#include <gmock/gmock.h>

#include <atomic>
#include <thread>

#include "tests/support/collected_log.h"

namespace nadir {
namespace log_test {

using ::testing::ElementsAre;

TEST(Log, LeadsToTheSinkInOrder) {
  const CollectedLog log;
  write_log(LogLevel::kWarning, "the first");
  write_log(LogLevel::kError, "the second");
  EXPECT_THAT(log.lines(), ElementsAre("warning: the first", "error: the second"));
}

TEST(Log, MakesOneLineOfSeveral) {
  const CollectedLog log;
  write_log(LogLevel::kError, "\n  cannot\r\n\tbe   read \n\n");
  write_log(LogLevel::kError, "");
  EXPECT_THAT(log.lines(), ElementsAre("error: cannot be read", "error: "));
}

TEST(Log, CutsWhatIsEndlessBetweenTwoLetters) {
  const CollectedLog log;
  std::string endless;
  for (int i = 0; i < 100'000; ++i) endless += "\u00fc";
  write_log(LogLevel::kWarning, "x" + endless);
  ASSERT_EQ(log.lines().size(), 1U);
  const std::string line = log.lines().front();
  EXPECT_LT(line.size(), 1'100U);
  EXPECT_THAT(line, testing::EndsWith("\u00fc ..."));
}

TEST(Log, GoesToStandardErrorWhereThereIsNoSink) {
  const LogSink before = set_log_sink(nullptr);
  testing::internal::CaptureStderr();
  write_log(LogLevel::kWarning, "no\nsink");
  write_log(LogLevel::kError, "none either");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "warning: no sink\nerror: none either\n");
  set_log_sink(before);
}

TEST(Log, GivesTheSinkBeforeBack) {
  const CollectedLog outer;
  {
    const CollectedLog inner;
    write_log(LogLevel::kWarning, "inside");
    EXPECT_THAT(inner.lines(), ElementsAre("warning: inside"));
  }
  write_log(LogLevel::kWarning, "outside");
  EXPECT_THAT(outer.lines(), ElementsAre("warning: outside"));
}

TEST(Log, LetsASinkLogAndBeReplacedMeanwhile) {
  const CollectedLog log;
  const LogSink collect = set_log_sink(nullptr);
  set_log_sink([collect](LogLevel level, const std::string& line) {
    set_log_sink(collect);
    write_log(level, "from within: " + line);
  });
  write_log(LogLevel::kError, "fell");
  EXPECT_THAT(log.lines(), ElementsAre("error: from within: fell"));
}

TEST(Log, LosesNothingOfSeveralThreads) {
  std::atomic<int> count = 0;
  const LogSink before = set_log_sink([&count](LogLevel, const std::string&) { ++count; });
  {
    std::vector<std::jthread> threads;
    for (int i = 0; i < 4; ++i) {
      threads.emplace_back([] {
        for (int k = 0; k < 500; ++k) write_log(LogLevel::kWarning, "again");
      });
    }
  }
  set_log_sink(before);
  EXPECT_EQ(count, 2000);
}

}  // namespace log_test
}  // namespace nadir
