// SPDX-License-Identifier: Apache-2.0
// What others do to the files of a document that is open: replace, move and remove them.
#include <fcntl.h>
#include <stdio.h>  // NOLINT(modernize-deprecated-headers): renameat2 is not in cstdio.
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>

#include "core/label/label_sync.h"
#include "tests/core/label/label_file.h"

namespace nadir {
namespace lost_label_store_test {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::IsEmpty;

/// A document at work in a folder of its own, "town".
class LostLabelStoreTest : public testing::Test {
 protected:
  LostLabelStoreTest() {
    fs::create_directory(town_);
    make(path_);
  }
  static void make(const fs::path& path) {
    const auto made = LabelStore::create(path, test_plane(), test_grid(40, 30), "ada");
    if (!made) throw std::runtime_error(error_text(made));
  }
  [[nodiscard]] static LabelStore opened(const fs::path& path, const std::string& who = "ada") {
    auto store = LabelStore::open(path, who);
    if (!store) throw std::runtime_error(error_text(store));
    return std::move(*store);
  }
  static void work(LabelStore& store, std::uint32_t first, std::uint32_t steps) {
    for (std::uint32_t step = first; step < first + steps; ++step) {
      const auto done = store.commit(random_edit(store.document(), 51, step));
      ASSERT_TRUE(done) << error_text(done);
    }
  }
  /// The next gesture is refused, in a sentence that names the file; what was drawn is still there and can be saved.
  void expect_refuses_and_keeps(LabelStore& store, const std::string& why) {
    const LabelDocument before = store.document();
    const auto refused = store.commit(random_edit(before, 51, 1000));
    EXPECT_THAT(error_text(refused), HasSubstr(path_.string() + ": another program has " + why));
    EXPECT_EQ(store.why_read_only(), error_text(refused));
    EXPECT_TRUE(store.has_lost_its_file());
    EXPECT_TRUE(store.document() == before);
    EXPECT_FALSE(store.undo_step());
    EXPECT_EQ(error_text(store.undo()), store.why_read_only());
    EXPECT_EQ(error_text(store.history(1, 10)), store.why_read_only());
    EXPECT_EQ(error_text(store.flush()), store.why_read_only());
    EXPECT_TRUE(store.take_foreign_changes()->empty());
    const fs::path copy = scratch_.path() / "copy.gpkg";
    { ASSERT_TRUE(LabelStore::create(copy, store.document(), "ada")); }
    EXPECT_TRUE(opened(copy).document() == before);
  }

  ScratchFolder scratch_;
  fs::path town_ = scratch_.path() / "town";
  fs::path path_ = town_ / "labels.gpkg";
};

std::string bytes_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST_F(LostLabelStoreTest, AnotherFileRenamedOverItGetsNothing) {
  for (const std::uint32_t steps : {0U, 5U}) {  // Also before the first write.
    fs::remove(scratch_.path() / "copy.gpkg");
    LabelStore store = opened(path_);
    work(store, 0, steps);
    const fs::path other = scratch_.path() / "other.gpkg";
    make(other);
    const std::string others = bytes_of(other);
    fs::rename(other, path_);
    expect_refuses_and_keeps(store, "replaced it");
    EXPECT_TRUE(store.close());
    EXPECT_EQ(bytes_of(path_), others);
    EXPECT_TRUE(opened(path_).document() == test_document());
  }
}

TEST_F(LostLabelStoreTest, DeletedItStaysInMemory) {
  LabelStore store = opened(path_);
  work(store, 0, 5);
  fs::remove(path_);
  expect_refuses_and_keeps(store, "deleted or moved it");
  // Saved where it was, it is whole: what lay beside the old one has nothing to do with it.
  { ASSERT_TRUE(LabelStore::create(path_, store.document(), "ada")); }
  EXPECT_TRUE(opened(path_).document() == store.document());
}

TEST_F(LostLabelStoreTest, MovedAwayTheFileHasAllThatWasDrawn) {
  LabelStore store = opened(path_);
  work(store, 0, 5);
  const fs::path elsewhere = scratch_.path() / "elsewhere.gpkg";
  fs::rename(path_, elsewhere);
  expect_refuses_and_keeps(store, "deleted or moved it");
  EXPECT_TRUE(opened(elsewhere).document() == store.document());
  EXPECT_EQ(opened(elsewhere).undo_step()->number, 5);
}

TEST_F(LostLabelStoreTest, InAFolderThatWasRenamedTheFileHasAllThatWasDrawn) {
  LabelStore store = opened(path_);
  work(store, 0, 5);
  fs::rename(town_, scratch_.path() / "city");
  expect_refuses_and_keeps(store, "deleted or moved it");
  EXPECT_TRUE(opened(scratch_.path() / "city" / "labels.gpkg").document() == store.document());
}

TEST_F(LostLabelStoreTest, OfAFolderThatWasExchangedNeitherFileIsTouched) {
  std::optional<LabelStore> store = opened(path_);
  work(*store, 0, 5);
  const fs::path fresh = scratch_.path() / "fresh";
  fs::create_directory(fresh);
  make(fresh / "labels.gpkg");
  ASSERT_EQ(::renameat2(AT_FDCWD, fresh.c_str(), AT_FDCWD, town_.c_str(), RENAME_EXCHANGE), 0);
  fs::remove_all(fresh);
  // Bob works on the new one before Ada's program looks again, and has his changes beside it.
  LabelStore bobs = opened(path_, "bob");
  ASSERT_THAT(bobs.why_read_only(), IsEmpty());
  work(bobs, 0, 3);
  expect_refuses_and_keeps(*store, "replaced it");
  store.reset();
  EXPECT_GT(fs::file_size(path_.string() + "-wal"), 0U);
  EXPECT_TRUE(fs::exists(path_.string() + ".lock"));
  work(bobs, 3, 3);
  const LabelDocument last = bobs.document();
  EXPECT_TRUE(bobs.close());
  EXPECT_TRUE(opened(path_).document() == last);
  EXPECT_EQ(OtherProgram(path_).value("PRAGMA integrity_check"), "ok");
}

TEST_F(LostLabelStoreTest, IsNoticedByLookingToo) {
  LabelStore store = opened(path_);
  work(store, 0, 5);
  const LabelDocument before = store.document();
  fs::remove(path_);
  EXPECT_THAT(error_text(store.take_foreign_changes()), HasSubstr("deleted or moved it"));
  EXPECT_TRUE(store.has_lost_its_file());
  EXPECT_TRUE(store.document() == before);
}

TEST_F(LostLabelStoreTest, IsNoticedByClosing) {
  LabelStore store = opened(path_);
  work(store, 0, 5);
  fs::remove(path_);
  EXPECT_THAT(error_text(store.close()), HasSubstr("deleted or moved it"));
}

TEST_F(LostLabelStoreTest, ASyncLeavesAnotherFileOfTheNameAlone) {
  const NamedFile mine(path_);
  const fs::path other = scratch_.path() / "other.gpkg";
  make(other);
  fs::rename(other, path_);
  // What another program has not carried over yet, and more than this one would leave.
  const OtherProgram program(path_);
  program.run("PRAGMA journal_mode = WAL; PRAGMA wal_autocheckpoint = 0");
  program.run("INSERT INTO nadir_value VALUES ('large', zeroblob(12000000))");
  const auto changes = fs::file_size(path_.string() + "-wal");
  const auto size = fs::file_size(path_);
  LabelSync sync(mine);
  sync.note_commit();
  EXPECT_THAT(error_text(sync.flush()), HasSubstr("is not the file any more that was opened"));
  EXPECT_EQ(fs::file_size(path_.string() + "-wal"), changes);
  EXPECT_EQ(fs::file_size(path_), size);
}

TEST_F(LostLabelStoreTest, ALockThatSomebodyRemovedIsTakenAgain) {
  LabelStore store = opened(path_);
  work(store, 0, 2);
  fs::remove(path_.string() + ".lock");
  work(store, 2, 2);
  EXPECT_TRUE(fs::exists(path_.string() + ".lock"));
  EXPECT_THAT(opened(path_, "bob").why_read_only(), HasSubstr("is open for ada"));
}

TEST_F(LostLabelStoreTest, WhoGotTheLockThatWasRemovedKeepsIt) {
  LabelStore store = opened(path_);
  work(store, 0, 2);
  fs::remove(path_.string() + ".lock");
  LabelStore bobs = opened(path_, "bob");
  ASSERT_THAT(bobs.why_read_only(), IsEmpty());
  work(bobs, 2, 2);
  EXPECT_THAT(error_text(store.commit(random_edit(store.document(), 51, 9))),
              HasSubstr("is open for bob"));
  EXPECT_FALSE(store.has_lost_its_file());
  { const LabelStore gone = std::move(store); }
  work(bobs, 4, 2);
  const LabelDocument last = bobs.document();
  ASSERT_TRUE(bobs.close());
  EXPECT_TRUE(opened(path_).document() == last);
}

TEST_F(LostLabelStoreTest, WhatAnotherNadirHasWrittenIsFollowedWithItsPaintAndSteps) {
  LabelStore store = opened(path_);
  ASSERT_TRUE(store.commit(painting(store.document(), {0, 0, 20, 20}, kRoad)));
  const LabelEdit mine = painting(store.document(), {5, 5, 9, 9}, kCurb);
  fs::remove(path_.string() + ".lock");
  std::optional<LabelDocument> theirs;
  {
    LabelStore bobs = opened(path_, "bob");
    ASSERT_TRUE(bobs.commit(painting(bobs.document(), {10, 10, 30, 30}, kTerrain)));
    theirs = bobs.document();
  }
  EXPECT_THAT(error_text(store.commit(mine)), HasSubstr("take its changes over first"));
  const auto followed = store.take_foreign_changes();
  ASSERT_TRUE(followed) << error_text(followed);
  EXPECT_EQ(followed->tiles.size(), 1U);
  EXPECT_TRUE(store.document() == *theirs);
  EXPECT_EQ(store.undo_step()->author, "bob");
  ASSERT_TRUE(store.commit(painting(store.document(), {5, 5, 9, 9}, kCurb)));
  EXPECT_EQ(store.document().paint_at(25, 25), kTerrain);
  EXPECT_EQ(store.history(1, 10)->size(), 3U);
}

/// A child draws; between two gestures somebody removes what lies beside the document; then the child is killed.
TEST_F(LostLabelStoreTest, AFileOfChangesThatSomebodyRemovedIsMadeAgain) {
  std::array<int, 2> there{};
  std::array<int, 2> back{};
  ASSERT_EQ(::pipe(there.data()) + ::pipe(back.data()), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    LabelStore store = opened(path_);
    char word = 0;
    for (std::uint32_t step = 0;; ++step) {
      if (!store.commit(random_edit(store.document(), 51, step))) ::_exit(1);
      if (::write(back[1], "s", 1) != 1 || ::read(there[0], &word, 1) != 1) ::_exit(1);
    }
  }
  char word = 0;
  for (const char* const ending : {"", "-wal", "", "-shm", "-wal", ""}) {
    ASSERT_EQ(::read(back[0], &word, 1), 1);
    if (*ending != 0) {
      EXPECT_TRUE(fs::remove(path_.string() + ending)) << ending;
    }
    ASSERT_EQ(::write(there[1], "g", 1), 1);
  }
  ASSERT_EQ(::read(back[0], &word, 1), 1);
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  for (const int end : {there[0], there[1], back[0], back[1]}) ::close(end);
  LabelDocument expected = test_document();
  for (std::uint32_t step = 0; step < 7; ++step) expected.apply(random_edit(expected, 51, step));
  const LabelStore store = opened(path_);
  EXPECT_TRUE(store.document() == expected);
  EXPECT_EQ(store.undo_step()->number, 7);
}

TEST_F(LostLabelStoreTest, ALinkAndItsFileAreOneDocument) {
  const fs::path link = scratch_.path() / "link.gpkg";
  fs::create_symlink(path_, link);
  LabelStore store = opened(link);
  work(store, 0, 5);
  EXPECT_TRUE(fs::exists(path_.string() + "-wal"));
  EXPECT_TRUE(fs::exists(path_.string() + ".lock"));
  EXPECT_THAT(opened(path_, "bob").why_read_only(), HasSubstr("is open for ada"));
  EXPECT_THAT(*LabelStore::writer(path_), HasSubstr("ada"));
  EXPECT_THAT(*LabelStore::writer(link), HasSubstr("ada"));
  const LabelDocument last = store.document();
  ASSERT_TRUE(store.close());
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_TRUE(opened(path_).document() == last);
}

TEST_F(LostLabelStoreTest, ALinkThatLeadsElsewhereNowIsAnotherFile) {
  const fs::path link = town_ / "link.gpkg";
  fs::create_symlink(path_, link);
  LabelStore store = opened(link);
  work(store, 0, 5);
  make(scratch_.path() / "other.gpkg");
  fs::remove(link);
  fs::create_symlink(scratch_.path() / "other.gpkg", link);
  EXPECT_THAT(error_text(store.commit(random_edit(store.document(), 51, 9))),
              HasSubstr("link.gpkg: another program has replaced it"));
  EXPECT_TRUE(opened(path_).document() == store.document());
}

}  // namespace lost_label_store_test
}  // namespace nadir
