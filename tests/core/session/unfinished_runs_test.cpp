// SPDX-License-Identifier: Apache-2.0
#include "core/session/unfinished_runs.h"

#include <unistd.h>

#include "core/base/staged_output.h"
#include "tests/core/run/recorded_run.h"
#include "tests/support/error_text.h"
#include "tests/support/scratch_folder.h"

namespace nadir {
namespace unfinished_runs_test {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

class UnfinishedRuns : public testing::Test {
 protected:
  [[nodiscard]] std::string run(const char* name) const {
    return (scratch_.path() / name).string();
  }
  [[nodiscard]] ListedRuns listed() const { return listed_runs(config_); }
  void keep(WritingList& list, const std::vector<std::string>& runs) {
    const auto kept = list.keep(runs);
    ASSERT_TRUE(kept) << error_text(kept);
  }
  [[nodiscard]] int lists() const {
    int count = 0;
    for (const auto& entry : fs::directory_iterator(config_)) count += entry.exists() ? 1 : 0;
    return count;
  }

  ScratchFolder scratch_;
  fs::path config_ = scratch_.path() / "config";
};

TEST_F(UnfinishedRuns, AreThoseThatAreThereAndNotWhole) {
  record_run(run("cut.nadir"), 5, 0, false);
  record_run(run("whole.nadir"), 5);
  record_run(run("empty.nadir"), 0, 0, false);
  WritingList list(config_);
  keep(list, {run("cut.nadir"), run("whole.nadir"), run("empty.nadir"), run("gone.nadir")});
  EXPECT_THAT(listed().incomplete,
              UnorderedElementsAre(run("cut.nadir"), run("empty.nadir"), run("gone.nadir")));
  EXPECT_THAT(listed().unfinished, ElementsAre(run("cut.nadir")));
}

TEST_F(UnfinishedRuns, AreNotThoseThatSomebodyWritesNow) {
  auto writer = RunWriter::create(run("busy.nadir"), example_header()).value();
  ASSERT_TRUE(writer.write(example_step(0)));
  WritingList list(config_);
  keep(list, {run("busy.nadir")});
  EXPECT_THAT(listed().unfinished, IsEmpty());
  EXPECT_THAT(listed().incomplete, ElementsAre(run("busy.nadir")));
}

TEST_F(UnfinishedRuns, OfSeveralSessionsDoNotGetInEachOthersWay) {
  record_run(run("a.nadir"), 5, 0, false);
  record_run(run("b.nadir"), 5, 0, false);
  WritingList first(config_), second(config_);
  keep(first, {run("a.nadir")});
  keep(second, {run("b.nadir")});
  EXPECT_THAT(listed().unfinished, UnorderedElementsAre(run("a.nadir"), run("b.nadir")));
  keep(second, {});
  EXPECT_THAT(listed().unfinished, ElementsAre(run("a.nadir")));
  keep(first, {});
  EXPECT_EQ(lists(), 0);
  keep(first, {run("b.nadir")});
  EXPECT_THAT(listed().unfinished, ElementsAre(run("b.nadir")));
}

TEST_F(UnfinishedRuns, AreTakenOffAllListsAtOnce) {
  record_run(run("a.nadir"), 5, 0, false);
  record_run(run("b.nadir"), 5, 0, false);
  WritingList first(config_), second(config_);
  keep(first, {run("a.nadir"), run("b.nadir")});
  keep(second, {run("a.nadir")});
  take_off_lists(config_, run("a.nadir"));
  EXPECT_THAT(listed().unfinished, ElementsAre(run("b.nadir")));
  EXPECT_EQ(lists(), 1);
}

TEST_F(UnfinishedRuns, OfProgramsThatAreNoMoreGoOnceNothingIsLeftOfThem) {
  record_run(run("cut.nadir"), 5, 0, false);
  fs::create_directory(config_);
  const fs::path list = config_ / "session.toml.writing-999999999";  // no process has this number
  ASSERT_TRUE(write_text_file(list, "version = 1\nwriting = [\"" + run("cut.nadir") + "\"]\n"));
  EXPECT_THAT(listed().unfinished, ElementsAre(run("cut.nadir")));
  EXPECT_TRUE(fs::exists(list));
  fs::remove(run("cut.nadir"));
  EXPECT_THAT(listed().unfinished, IsEmpty());
  EXPECT_FALSE(fs::exists(list));
}

TEST_F(UnfinishedRuns, AreNoneWhereThereIsNoFolderOrOnlyRubbish) {
  EXPECT_THAT(listed().incomplete, IsEmpty());
  EXPECT_THAT(listed_runs({}).incomplete, IsEmpty());
  WritingList nowhere{fs::path()};
  keep(nowhere, {run("a.nadir")});
  fs::create_directory(config_);
  ASSERT_TRUE(write_text_file(config_ / "session.toml.writing-7", "writing = 3\n"));
  ASSERT_TRUE(write_text_file(config_ / "session.toml.writing-8", "version = 99\n"));
  EXPECT_THAT(listed().incomplete, IsEmpty());
  EXPECT_EQ(lists(), 2) << "what is not understood is left alone";
}

}  // namespace unfinished_runs_test
}  // namespace nadir
