// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>

#include "core/label/label_store.h"
#include "tests/core/label/drawn_labels.h"
#include "tests/core/label/other_program.h"
#include "tests/support/error_text.h"
#include "tests/support/scratch_folder.h"

namespace nadir {
namespace killed_label_store_test {

namespace fs = std::filesystem;

constexpr std::uint64_t kSeed = 41;

/// Goes on with the work, one gesture after the other, without end; reports each that is finished.
[[noreturn]] void work_for_ever(const fs::path& path, int reports) {
  auto store = LabelStore::open(path, "ada");
  while (store && store->why_read_only().empty()) {
    const auto step =
        static_cast<std::uint32_t>(store->undo_step() ? store->undo_step()->number : 0);
    // Every seventh gesture is undone and done again, which is two more that are finished.
    if (!store->commit(random_edit(store->document(), kSeed, step)) ||
        ::write(reports, "s", 1) != 1)
      break;
    if (step % 7 == 6 && (!store->undo() || !store->redo())) break;
  }
  ::_exit(1);
}

/// Kills a child at work after it has finished some gestures and a loop has turned some times. @returns how many it said.
int work_until_killed(const fs::path& path, int least, int spins) {
  std::array<int, 2> ends{};
  EXPECT_EQ(::pipe(ends.data()), 0);
  const pid_t child = ::fork();
  if (child == 0) work_for_ever(path, ends[1]);
  ::close(ends[1]);
  char report = 0;
  int finished = 0;
  while (finished < least && ::read(ends[0], &report, 1) == 1) ++finished;
  for (std::atomic<int> turns = 0; turns < spins; ++turns) {
  }
  ::kill(child, SIGKILL);
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_TRUE(WIFSIGNALED(status));
  while (::read(ends[0], &report, 1) == 1) ++finished;  // What it said before it died.
  ::close(ends[0]);
  return finished;
}

TEST(KilledLabelStore, LosesAtMostTheGestureInProgress) {
  const ScratchFolder scratch;
  const fs::path path = scratch.path() / "labels.gpkg";
  { ASSERT_TRUE(LabelStore::create(path, test_plane(), test_grid(40, 30), "ada")); }
  LabelDocument expected = test_document();
  std::int64_t known = 0;
  int in_progress = 0;
  for (std::uint32_t kill = 0; kill < 100; ++kill) {
    const auto words = random_words({kSeed, 0, kill, 1, 0});
    const int finished = work_until_killed(path, static_cast<int>(words[0] % 8),
                                           static_cast<int>(words[1] % 60'000));
    auto store = LabelStore::open(path, "ada");
    ASSERT_TRUE(store) << error_text(store);
    ASSERT_TRUE(store->why_read_only().empty()) << store->why_read_only();
    ASSERT_TRUE(store->notices().empty());
    const auto last = store->history(known + 1, 1'000'000);
    ASSERT_TRUE(last);
    const auto count = static_cast<int>(last->size());
    ASSERT_GE(count, finished);
    ASSERT_LE(count, finished + 1);  // The one in progress may have been finished but not said.
    in_progress += count - finished;
    for (int i = 0; i < count; ++i) {
      expected.apply(random_edit(expected, kSeed, static_cast<std::uint32_t>(known++)));
    }
    // It may have been killed between undoing the last gesture and doing it again.
    if (store->redo_step()) {
      ASSERT_EQ(store->redo_step()->number, known);
      ASSERT_TRUE(store->redo());
    }
    ASSERT_TRUE(store->document() == expected) << "kill " << kill;
  }
  EXPECT_GT(known, 100);
  RecordProperty("gestures", static_cast<int>(known));
  RecordProperty("finished_but_unsaid", in_progress);
  auto store = LabelStore::open(path, "ada");
  while (store->undo_step()) ASSERT_TRUE(store->undo());
  EXPECT_TRUE(store->document() == test_document());
  EXPECT_EQ(OtherProgram(path).value("PRAGMA integrity_check"), "ok");
}

TEST(KilledLabelStore, IsReadWithItsLastEditsFromAFolderThatCannotBeWritten) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
  const ScratchFolder scratch;
  const fs::path path = scratch.path() / "labels.gpkg";
  { ASSERT_TRUE(LabelStore::create(path, test_plane(), test_grid(40, 30), "ada")); }
  ASSERT_GE(work_until_killed(path, 20, 0), 20);
  ASSERT_GT(fs::file_size(scratch.path() / "labels.gpkg-wal"), 0U);
  fs::remove(scratch.path() / "labels.gpkg-shm");
  fs::permissions(scratch.path(), fs::perms::owner_read | fs::perms::owner_exec);
  const auto store = LabelStore::open(path, "ada");
  fs::permissions(scratch.path(), fs::perms::owner_all);
  ASSERT_TRUE(store) << error_text(store);
  EXPECT_FALSE(store->why_read_only().empty());
  EXPECT_GE(store->undo_step()->number, 20);
}

}  // namespace killed_label_store_test
}  // namespace nadir
