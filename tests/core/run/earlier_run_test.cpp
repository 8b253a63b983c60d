// SPDX-License-Identifier: Apache-2.0
#include "core/run/earlier_run.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <latch>
#include <thread>

#include "tests/core/run/recorded_run.h"
#include "tests/core/run/run_sql.h"
#include "tests/support/dead_process.h"
#include "tests/support/error_text.h"
#include "tests/support/scratch_folder.h"

namespace nadir::detail {
namespace earlier_run_test {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::StartsWith;

/// What waits beside R.nadir while a new run is written.
class EarlierRunFile : public testing::Test {
 protected:
  /// A writer under the name of the earlier run, with so many steps.
  [[nodiscard]] RunWriter writer_of(int steps) const {
    auto writer = RunWriter::create(path_, example_header()).value();
    for (int i = 0; i < steps; ++i) EXPECT_TRUE(writer.write(example_step(i)));
    return writer;
  }
  [[nodiscard]] fs::path put_aside_by(pid_t process, const std::string& number = "") const {
    return path_.string() + ".earlier-" + std::to_string(process) + number;
  }

  ScratchFolder folder_;
  fs::path path_ = folder_.path() / "R.nadir";
  fs::path own_ = put_aside_by(::getpid());
};

TEST_F(EarlierRunFile, WaitsBesideTheNewOneUntilThatIsComplete) {
  record_run(path_, 3);
  const std::string before = bytes_of(path_);
  auto writer = writer_of(1);
  EXPECT_EQ(bytes_of(own_), before);
  EXPECT_EQ(RunReader::open(path_)->step_count(), 1);
  ASSERT_TRUE(writer.finish());
  EXPECT_EQ(folder_.entries(), 1);
}

TEST_F(EarlierRunFile, GetsItsNameBackWhenTheNewOneIsDiscarded) {
  record_run(path_, 3);
  const std::string before = bytes_of(path_);
  writer_of(5).discard();
  EXPECT_EQ(bytes_of(path_), before);
  EXPECT_EQ(folder_.entries(), 1);
  fs::remove(path_);
  writer_of(5).discard();
  EXPECT_EQ(folder_.entries(), 0) << "there was none before";
}

TEST_F(EarlierRunFile, LeavesAloneWhatHasTheNameThatItWouldWaitUnder) {
  // In a container every program may have the same process id, also the one that was killed.
  record_run(own_, 7);
  const std::string last_good = bytes_of(own_);
  record_run(path_, 2);
  {
    auto writer = writer_of(1);
    EXPECT_EQ(bytes_of(own_), last_good);
    EXPECT_EQ(RunReader::open(put_aside_by(::getpid(), "-2"))->step_count(), 2);
    ASSERT_TRUE(writer.finish());
  }
  EXPECT_EQ(bytes_of(own_), last_good);
  EXPECT_EQ(folder_.entries(), 2) << "only its own is taken away";
  static_cast<void>(folder_.file(put_aside_by(::getpid(), "-2").filename().string(), "a friend's"));
  const auto writer = writer_of(1);
  EXPECT_EQ(RunReader::open(put_aside_by(::getpid(), "-3"))->step_count(), 1);
}

TEST_F(EarlierRunFile, StaysWhereTheNewOneIsStoppedAndItWasCompleteOrLonger) {
  for (const bool was_finished : {true, false}) {
    record_run(path_, 3, 0, was_finished);
    auto writer = writer_of(was_finished ? 9 : 2);
    const fs::path kept = writer.stop();
    EXPECT_EQ(kept, own_);
    EXPECT_EQ(RunReader::open(kept)->step_count(), 3);
    EXPECT_EQ(RunReader::open(path_)->step_count(), was_finished ? 9 : 2);
    EXPECT_FALSE(RunReader::open(path_)->is_complete());
    fs::remove(kept);
    fs::remove(path_);
  }
}

TEST_F(EarlierRunFile, GoesWhereTheNewOneIsStoppedAndItWasNoLongerThanThatOrDamaged) {
  record_run(path_, 3, 0, false);
  EXPECT_EQ(writer_of(3).stop(), fs::path());
  EXPECT_EQ(folder_.entries(), 1);
  const std::string whole = bytes_of(path_);
  static_cast<void>(folder_.file("R.nadir", whole.substr(0, whole.size() / 2)));
  EXPECT_EQ(writer_of(1).stop(), fs::path());
  EXPECT_EQ(folder_.entries(), 1);
  fs::remove(path_);
  EXPECT_EQ(writer_of(1).stop(), fs::path()) << "there was none";
  EXPECT_EQ(RunReader::open(path_)->step_count(), 1);
}

TEST_F(EarlierRunFile, LeavesBothToAWriterThatIsDestroyedLikeAKilledOne) {
  record_run(path_, 3);
  static_cast<void>(writer_of(1));
  EXPECT_EQ(RunReader::open(own_)->step_count(), 3);
  EXPECT_EQ(RunReader::open(path_)->step_count(), 1);
}

TEST_F(EarlierRunFile, GoesWithThoseOfKilledProgramsOnceTheNewOneIsComplete) {
  const pid_t dead = dead_process();
  record_run(path_, 1);
  for (const fs::path& other :
       {put_aside_by(dead), put_aside_by(dead, "-2"), put_aside_by(::getppid())}) {
    fs::copy_file(path_, other);
  }
  static_cast<void>(folder_.file(put_aside_by(dead).filename().string() + "-journal", "of it"));
  auto writer = writer_of(1);
  EXPECT_TRUE(fs::exists(put_aside_by(dead))) << "not before the new run is whole";
  ASSERT_TRUE(writer.finish());
  EXPECT_TRUE(fs::exists(put_aside_by(::getppid()))) << "of a living process";
  EXPECT_EQ(folder_.entries(), 2);
}

TEST_F(EarlierRunFile, OfAKilledProgramStaysWhereItMayBeAllThatIsLeft) {
  const fs::path left = put_aside_by(dead_process());
  record_run(left, 3);
  record_run(path_, 1);  // killed between putting the old run aside and beginning the new one
  EXPECT_EQ(RunReader::open(left)->step_count(), 3);
}

TEST_F(EarlierRunFile, IsNeverLostWhereSeveralWritersBeginAtOnce) {
  constexpr int kWriters = 4;
  for (int round = 0; round < 25; ++round) {
    record_run(path_, 3);
    std::latch begin(kWriters);
    std::latch tried(kWriters);
    std::atomic<int> begun = 0;
    {
      std::vector<std::jthread> threads;
      for (int i = 0; i < kWriters; ++i) {
        threads.emplace_back([&] {
          begin.arrive_and_wait();
          auto writer = RunWriter::create(path_, example_header());
          tried.arrive_and_wait();
          if (!writer) return;
          ++begun;
          writer->discard();
        });
      }
    }
    EXPECT_EQ(begun, 1) << "one writer at a time";
    int found = 0;
    for (const auto& entry : fs::directory_iterator(folder_.path())) {
      const auto run = RunReader::open(entry.path());
      if (run && run->is_complete() && run->step_count() == 3) ++found;
      fs::remove(entry.path());
    }
    EXPECT_EQ(found, 1) << "under its name, or beside it";
  }
}

TEST_F(EarlierRunFile, OfANewerVersionIsNotReplaced) {
  record_run(path_, 3);
  EXPECT_EQ(run_sql(path_, "PRAGMA user_version = 1000"), "");
  const std::string before = bytes_of(path_);
  for (const auto& code : {error_code(RunWriter::check_output(path_)),
                           error_code(RunWriter::create(path_, example_header()))}) {
    EXPECT_EQ(code, ErrorCode::kUnsupported);
  }
  EXPECT_EQ(error_text(RunWriter::check_output(path_)),
            path_.string() +
                ": will not be overwritten: it was written by a newer version of Nadir (run format "
                "1000, this one writes 1)");
  EXPECT_EQ(bytes_of(path_), before);
  EXPECT_EQ(folder_.entries(), 1);
}

TEST_F(EarlierRunFile, MayBeEmptyOrDamaged) {
  record_run(path_, 3, 50);
  const std::string whole = bytes_of(path_);
  for (const std::size_t size : {std::size_t{0}, std::size_t{72}, whole.size() / 2}) {
    static_cast<void>(folder_.file("R.nadir", whole.substr(0, size)));
    EXPECT_FALSE(RunReader::open(path_)) << "cannot be read";
    EXPECT_TRUE(RunWriter::check_output(path_)) << error_text(RunWriter::check_output(path_));
    writer_of(1).discard();
    EXPECT_EQ(fs::file_size(path_), size) << "as it was";
    record_run(path_, 1);
    EXPECT_EQ(folder_.entries(), 1);
  }
}

TEST_F(EarlierRunFile, IsOnlyAFileThatIsARun) {
  for (const fs::path& other : {folder_.file("letter.txt", "dear"), folder_.file("a", "x"),
                                folder_.file("big.txt", std::string(5000, 'x'))}) {
    EXPECT_EQ(error_text(check_run_output(other)),
              other.string() + ": will not be overwritten: it is no run file");
  }
  const fs::path link = folder_.path() / "link.nadir";
  fs::create_symlink("nowhere.nadir", link);
  EXPECT_THAT(error_text(check_run_output(link)), HasSubstr("it is no run file"));
  EXPECT_THAT(error_text(check_run_output(folder_.path())), HasSubstr("is a folder"));
  EXPECT_THAT(error_text(check_run_output(folder_.path() / "no" / "R.nadir")),
              HasSubstr("does not exist"));
  EXPECT_THAT(error_text(check_run_output("")), StartsWith("run file: its name is empty"));
  EXPECT_EQ(folder_.entries(), 4);
}

TEST_F(EarlierRunFile, IsAskedForWithoutATrace) {
  EXPECT_TRUE(RunWriter::check_output(path_));
  EXPECT_EQ(folder_.entries(), 0);
  record_run(path_, 2);
  const std::string before = bytes_of(path_);
  EXPECT_TRUE(RunWriter::check_output(path_));
  EXPECT_EQ(bytes_of(path_), before);
  EXPECT_EQ(folder_.entries(), 1);
}

}  // namespace earlier_run_test
}  // namespace nadir::detail
