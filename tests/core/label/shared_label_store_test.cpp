// SPDX-License-Identifier: Apache-2.0
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

#include "tests/core/label/label_file.h"

namespace nadir {
namespace shared_label_store_test {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::IsEmpty;

/// Who may write into a document, and what the others get.
class SharedLabelStoreTest : public LabelFile {};

TEST_F(SharedLabelStoreTest, ASecondProgramReadsAndSaysWhoHasIt) {
  LabelStore first = made();
  work(first, 34, 0, 10);
  {
    LabelStore second = opened();
    EXPECT_THAT(second.why_read_only(), HasSubstr("is open for ada on "));
    EXPECT_THAT(second.why_read_only(), HasSubstr(fmt::format("(process {})", ::getpid())));
    EXPECT_TRUE(second.document() == first.document());
    EXPECT_EQ(error_text(second.commit(random_edit(second.document(), 34, 99))),
              second.why_read_only());
    EXPECT_FALSE(second.undo());
  }
  work(first, 34, 10, 5);  // The second one's leaving has taken nothing away.
  const LabelStore third = opened();
  EXPECT_THAT(third.why_read_only(), HasSubstr("ada"));
}

TEST_F(SharedLabelStoreTest, IsFreeAgainWhenItsHolderHasClosedIt) {
  static_cast<void>(made());
  EXPECT_FALSE(fs::exists(scratch_.path() / "labels.gpkg.lock"));
  EXPECT_THAT(opened().why_read_only(), IsEmpty());
}

TEST_F(SharedLabelStoreTest, TheLockOfAKilledProgramIsGone) {
  static_cast<void>(made());
  const pid_t child = ::fork();
  if (child == 0) {
    auto store = LabelStore::open(path_, "eve");
    ::kill(::getpid(), SIGKILL);
  }
  ::waitpid(child, nullptr, 0);
  EXPECT_TRUE(fs::exists(scratch_.path() / "labels.gpkg.lock"));
  EXPECT_THAT(opened().why_read_only(), IsEmpty());
}

TEST_F(SharedLabelStoreTest, OpensForReadingWhereItCannotBeWritten) {
  std::optional<LabelDocument> last;
  {
    LabelStore store = made();
    work(store, 35, 0, 10);
    last = store.document();
  }
  {
    const LabelStore asked = opened(LabelAccess::kRead);
    EXPECT_THAT(asked.why_read_only(), HasSubstr("was opened for reading"));
    EXPECT_FALSE(fs::exists(scratch_.path() / "labels.gpkg.lock"));
  }
  if (::geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
  fs::permissions(path_, fs::perms::owner_read);
  fs::permissions(scratch_.path(), fs::perms::owner_read | fs::perms::owner_exec);
  const LabelStore store = opened();
  EXPECT_THAT(store.why_read_only(), HasSubstr("cannot be written, so it was opened for reading"));
  EXPECT_TRUE(store.document() == *last);
  fs::permissions(scratch_.path(), fs::perms::owner_all);
}

}  // namespace shared_label_store_test
}  // namespace nadir
