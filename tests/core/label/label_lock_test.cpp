// SPDX-License-Identifier: Apache-2.0
#include "core/label/label_lock.h"

#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>

#include "tests/support/error_text.h"
#include "tests/support/scratch_folder.h"

namespace nadir {
namespace label_lock_test {

namespace fs = std::filesystem;

LabelLock::Outcome taken(const fs::path& document, const std::string& holder) {
  auto outcome = LabelLock::take(document, holder);
  if (!outcome) throw std::runtime_error(error_text(outcome));
  return std::move(*outcome);
}

TEST(LabelLock, IsOneHoldersAtATimeAlsoWithinAProgram) {
  const ScratchFolder scratch;
  const fs::path document = scratch.path() / "labels.gpkg";
  {
    const auto first = taken(document, "ada on roof");
    ASSERT_TRUE(first.lock);
    const auto second = taken(document, "bob");
    EXPECT_FALSE(second.lock);
    EXPECT_EQ(second.holder, "ada on roof");
    EXPECT_EQ(taken(document, "eve").holder,
              "ada on roof");  // The one who asked took nothing away.
  }
  EXPECT_EQ(scratch.entries(), 0);
  EXPECT_TRUE(taken(document, "bob").lock);
}

TEST(LabelLock, IsNotHeldByAFileThatSomebodyLeft) {
  const ScratchFolder scratch;
  const fs::path document = scratch.path() / "labels.gpkg";
  scratch.file("labels.gpkg.lock", "ada, killed, with a line that is longer than the next one's\n");
  const auto mine = taken(document, "bob");
  ASSERT_TRUE(mine.lock);
  EXPECT_EQ(taken(document, "eve").holder, "bob");
}

TEST(LabelLock, OfAnotherProgramEndsWithIt) {
  const ScratchFolder scratch;
  const fs::path document = scratch.path() / "labels.gpkg";
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe(ends.data()), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    const auto lock = LabelLock::take(document, "child");
    [[maybe_unused]] const auto told = ::write(ends[1], "s", 1);
    for (;;) ::pause();
  }
  char told = 0;
  ASSERT_EQ(::read(ends[0], &told, 1), 1);
  EXPECT_EQ(taken(document, "parent").holder, "child");
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  EXPECT_TRUE(taken(document, "parent").lock);
  ::close(ends[0]);
  ::close(ends[1]);
}

TEST(LabelLock, SaysWhoHasItAndNotWhoHasLeftAFile) {
  const ScratchFolder scratch;
  const fs::path document = scratch.path() / "labels.gpkg";
  EXPECT_FALSE(LabelLock::holder(document));
  scratch.file("labels.gpkg.lock", "eve, who was killed\n");
  EXPECT_FALSE(LabelLock::holder(document));
  {
    const auto mine = taken(document, "ada");
    EXPECT_EQ(LabelLock::holder(document), "ada");
    EXPECT_EQ(LabelLock::holder(document), "ada") << "asking takes nothing away";
    EXPECT_EQ(taken(document, "bob").holder, "ada");
  }
  EXPECT_FALSE(LabelLock::holder(document));
  EXPECT_EQ(scratch.entries(), 0) << "asking leaves nothing";
}

TEST(LabelLock, IsNotHeldOnceSomebodyHasRemovedItsFile) {
  const ScratchFolder scratch;
  const fs::path document = scratch.path() / "labels.gpkg";
  const auto mine = taken(document, "ada");
  EXPECT_TRUE(mine.lock->is_held());
  fs::remove(scratch.path() / "labels.gpkg.lock");
  EXPECT_FALSE(mine.lock->is_held());
  EXPECT_TRUE(taken(document, "bob").lock);
  EXPECT_FALSE(mine.lock->is_held());
}

TEST(LabelLock, AnotherUsersFileIsInTheWayOnlyWhileThatUserHasTheLock) {
  if (::geteuid() != 0) GTEST_SKIP() << "only the administrator can be two users";
  const ScratchFolder scratch;
  fs::permissions(scratch.path(), fs::perms(0777));
  const fs::path document = scratch.path() / "labels.gpkg";
  // Takes the lock as somebody else. @returns 1: got it, 2: was told who has it.
  const auto as_nobody = [&] {
    const pid_t child = ::fork();
    if (child == 0) {
      if (::setgid(65534) != 0 || ::setuid(65534) != 0) ::_exit(99);
      const auto outcome = LabelLock::take(document, "nobody");
      ::_exit(!outcome ? 98 : outcome->lock ? 1 : outcome->holder == "root" ? 2 : 97);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return WEXITSTATUS(status);
  };
  {
    const auto mine = taken(document, "root");
    EXPECT_EQ(as_nobody(), 2);
    EXPECT_TRUE(mine.lock->is_held());
  }
  scratch.file("labels.gpkg.lock", "root, killed\n");
  EXPECT_EQ(as_nobody(), 1);
}

TEST(LabelLock, NamesAFolderThatIsNotThere) {
  const auto outcome = LabelLock::take("/nowhere/labels.gpkg", "ada");
  EXPECT_EQ(error_code(outcome), ErrorCode::kIo);
  EXPECT_THAT(error_text(outcome), testing::HasSubstr("/nowhere/labels.gpkg.lock: "));
}

TEST(LabelLock, LeavesAFileAloneThatIsNoLongerItsOwn) {
  const ScratchFolder scratch;
  const fs::path document = scratch.path() / "labels.gpkg";
  {
    const auto mine = taken(document, "ada");
    fs::remove(scratch.path() / "labels.gpkg.lock");
    scratch.file("labels.gpkg.lock", "somebody else's");
  }
  EXPECT_TRUE(fs::exists(scratch.path() / "labels.gpkg.lock"));
}

}  // namespace label_lock_test
}  // namespace nadir
