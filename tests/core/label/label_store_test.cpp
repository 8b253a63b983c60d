// SPDX-License-Identifier: Apache-2.0
#include "core/label/label_store.h"

#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

#include "core/label/label_raster.h"
#include "tests/core/label/drawn_labels.h"
#include "tests/core/label/other_program.h"
#include "tests/support/error_text.h"
#include "tests/support/scratch_folder.h"

namespace nadir {
namespace label_store_test {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::IsEmpty;

LabelStore made(const fs::path& path) {
  auto store = LabelStore::create(path, test_plane(), test_grid(40, 30, 0.25), "ada");
  if (!store) throw std::runtime_error(error_text(store));
  return std::move(*store);
}

LabelStore opened(const fs::path& path, LabelAccess access = LabelAccess::kWriteWhereFree) {
  auto store = LabelStore::open(path, "bob", access);
  if (!store) throw std::runtime_error(error_text(store));
  return std::move(*store);
}

/// Commits what somebody might do, and says what the document was before each step.
std::vector<LabelDocument> work(LabelStore& store,
                                std::uint64_t seed,
                                std::uint32_t first,
                                std::uint32_t steps) {
  std::vector<LabelDocument> before;
  for (std::uint32_t step = first; step < first + steps; ++step) {
    before.push_back(store.document());
    const auto done = store.commit(random_edit(store.document(), seed, step));
    EXPECT_TRUE(done) << error_text(done);
  }
  return before;
}

TEST(LabelStore, KeepsPlaneAndGridToTheLastBit) {
  const ScratchFolder scratch;
  const fs::path path = scratch.path() / "labels.gpkg";
  const auto plane = *ProjectPlane::create({48.98772123456789, -8.1 / 3.0});
  const LabelGrid grid{0.1 + 0.2, {-1.0 / 3.0, 1e5 / 7.0}, 123, 456};
  ASSERT_TRUE(LabelStore::create(path, plane, grid, "ada"));
  const LabelStore store = opened(path);
  EXPECT_TRUE(store.document().plane() == plane);
  EXPECT_EQ(store.document().grid(), grid);
  EXPECT_FALSE(store.undo_step());
  EXPECT_THAT(store.why_read_only(), IsEmpty());
}

TEST(LabelStore, HoldsWhatWasCommittedWhenItIsOpenedAgain) {
  const ScratchFolder scratch;
  const fs::path path = scratch.path() / "labels.gpkg";
  std::optional<LabelDocument> last;
  {
    LabelStore store = made(path);
    work(store, 31, 0, 150);
    last = store.document();
  }
  const LabelStore store = opened(path);
  EXPECT_TRUE(store.document() == *last);
  EXPECT_EQ(store.document().next_id(), last->next_id());
  EXPECT_EQ(rasterise(store.document()), rasterise(*last));
  EXPECT_THAT(store.notices(), IsEmpty());
}

TEST(LabelStore, UndoSurvivesClosingAndOpeningInOneOrder) {
  const ScratchFolder scratch;
  const fs::path path = scratch.path() / "labels.gpkg";
  std::vector<LabelDocument> before;
  std::optional<LabelDocument> last;
  {
    LabelStore store = made(path);
    before = work(store, 32, 0, 60);
    last = store.document();
  }
  for (int step = 59; step >= 0; --step) {  // Opened again for every single one.
    LabelStore store = opened(path);
    ASSERT_EQ(store.undo_step()->title, fmt::format("Step {}", step));
    EXPECT_EQ(store.undo_step()->author, "ada");
    ASSERT_TRUE(store.undo());
    ASSERT_TRUE(store.document() == before[static_cast<std::size_t>(step)]) << step;
  }
  LabelStore store = opened(path);
  EXPECT_FALSE(store.undo_step());
  EXPECT_EQ(error_text(store.undo()), "there is nothing to undo");
  while (store.redo_step()) ASSERT_TRUE(store.redo());
  EXPECT_TRUE(store.document() == *last);
  EXPECT_EQ(error_text(store.redo()), "there is nothing to do again");
}

TEST(LabelStore, SaysWhatUndoHasChanged) {
  const ScratchFolder scratch;
  LabelStore store = made(scratch.path() / "labels.gpkg");
  ASSERT_TRUE(store.commit(adding({area(kRoad, {box(0, 0, 2, 2)})}, "Draw road")));
  const auto edit = store.undo();
  ASSERT_TRUE(edit);
  EXPECT_EQ(edit->title, "Draw road");
  ASSERT_EQ(edit->objects.size(), 1U);
  EXPECT_NE(edit->objects.front().before, nullptr);
  EXPECT_EQ(edit->objects.front().after, nullptr);
  EXPECT_EQ(store.redo_step()->title, "Draw road");
}

TEST(LabelStore, AnEditAfterUndoHidesButKeepsWhatWasUndone) {
  const ScratchFolder scratch;
  LabelStore store = made(scratch.path() / "labels.gpkg");
  ASSERT_TRUE(store.commit(adding({area(kRoad, {box(0, 0, 2, 2)}, 1)}, "First")));
  ASSERT_TRUE(store.commit(adding({area(kRoad, {box(4, 0, 6, 2)}, 2)}, "Second")));
  ASSERT_TRUE(store.undo());
  ASSERT_TRUE(store.commit(adding({area(kTerrain, {box(8, 0, 9, 2)}, 3)}, "Third")));
  EXPECT_FALSE(store.redo_step());
  ASSERT_TRUE(store.undo());
  EXPECT_EQ(store.redo_step()->title, "Third");
  const auto history = store.history(1, 10);
  ASSERT_TRUE(history);
  ASSERT_EQ(history->size(), 3U);
  EXPECT_EQ((*history)[1].title, "Second");
  EXPECT_EQ((*history)[1].parent, 1);
  EXPECT_EQ((*history)[2].parent, 1);
  EXPECT_EQ((*history)[2].time.size(), std::string("2026-05-01T12:00:00Z").size());
}

TEST(LabelStore, GoesToAnyStepOfAnyBranch) {
  const ScratchFolder scratch;
  LabelStore store = made(scratch.path() / "labels.gpkg");
  std::vector<LabelDocument> at{store.document()};  // By the number of the step.
  const auto commit = [&] {
    work(store, 39, static_cast<std::uint32_t>(at.size()), 1);
    at.push_back(store.document());
  };
  for (int i = 0; i < 6; ++i) commit();
  for (int i = 0; i < 4; ++i) ASSERT_TRUE(store.undo());
  for (int i = 0; i < 5; ++i) commit();  // From step 2, as steps 7 to 11.
  ASSERT_TRUE(store.undo());
  for (const std::size_t step : {6U, 11U, 0U, 4U, 9U, 9U, 2U, 1U, 7U}) {
    const LabelDocument before = store.document();
    const auto edit = store.go_to(static_cast<std::int64_t>(step));
    ASSERT_TRUE(edit) << error_text(edit);
    EXPECT_TRUE(store.document() == at[step]) << step;
    EXPECT_EQ(edit->empty(), before == at[step]);
  }
  EXPECT_THAT(error_text(store.go_to(12)), HasSubstr("its history has no step 12"));
  EXPECT_TRUE(store.document() == at[7]);
}

TEST(LabelStore, ClosedItIsOneFileAndOpeningItChangesNothing) {
  const ScratchFolder scratch;
  const fs::path path = scratch.path() / "labels.gpkg";
  {
    LabelStore store = made(path);
    work(store, 33, 0, 5);
    EXPECT_GT(scratch.entries(), 1);
    EXPECT_TRUE(store.close());
  }
  EXPECT_EQ(scratch.entries(), 1);
  const auto bytes = [&] {
    std::ifstream file(path, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(file), {});
  };
  const std::string before = bytes();
  EXPECT_EQ(before[18], 1);  // No WAL.
  { const LabelStore store = opened(path); }
  EXPECT_EQ(bytes(), before);
}

TEST(LabelStore, AStrokeTakesTwoKilobytesOfHistoryAtMost) {
  const ScratchFolder scratch;
  const fs::path path = scratch.path() / "labels.gpkg";
  LabelStore store = made(path);
  for (int stroke = 0; stroke < 40; ++stroke) {
    // A brush of 12 cells through two tiles or three.
    const std::int64_t left = stroke * 17 % 300;
    LabelEdit edit = painting(store.document(), {left, stroke * 11, left + 400, stroke * 11 + 12},
                              stroke % 2 == 0 ? kRoad : kTerrain);
    ASSERT_TRUE(store.commit(edit));
  }
  const OtherProgram other(path);
  EXPECT_LT(std::stoi(other.value("SELECT sum(length(delta)) / 40 FROM nadir_tile_change")), 2000);
}

TEST(LabelStore, CarriesLargeChangesOverWhileItIsOpen) {
  const ScratchFolder scratch;
  const fs::path path = scratch.path() / "labels.gpkg";
  LabelStore store = made(path);
  const OtherProgram other(path);
  const auto pages_in_file = [&] { return fs::file_size(path) / 4096; };
  const auto small = pages_in_file();
  std::uint32_t step = 0;
  // Notes that do not get shorter by packing, so that few edits make much.
  for (int edit = 0; edit < 12; ++edit) {
    std::string note;
    while (note.size() < 400'000) {
      for (const std::uint32_t word : random_words({38, 0, step++, 0, 0}))
        note += std::to_string(word);
    }
    LabelObject object = area(kRoad, {box(0, 0, 2, 2)}, store.document().next_id());
    object.note = note;
    ASSERT_TRUE(store.commit(adding({object})));
  }
  const auto brought = store.flush();
  ASSERT_TRUE(brought) << error_text(brought);
  EXPECT_GT(pages_in_file(), small + 1000);
  EXPECT_TRUE(store.take_foreign_changes()->empty());
  ASSERT_TRUE(store.undo());  // Carrying over is no change by another program.
  EXPECT_EQ(store.document().objects().size(), 11U);
}

TEST(LabelStore, RefusesWhatDoesNotFitAndChangesNothing) {
  const ScratchFolder scratch;
  LabelStore store = made(scratch.path() / "labels.gpkg");
  ASSERT_TRUE(store.commit(adding({area(kRoad, {box(0, 0, 2, 2)})})));
  const LabelDocument before = store.document();
  EXPECT_FALSE(store.commit(adding({area(kRoad, {box(0, 0, 2, 2)})})));
  EXPECT_FALSE(store.commit(adding({area(kRoad, {ring({{0, 0}, {1, 1}})}, 2)})));
  EXPECT_TRUE(store.document() == before);
  EXPECT_EQ(store.history(1, 10)->size(), 1U);
  EXPECT_TRUE(store.commit(LabelEdit{}));  // Nothing is no step.
  EXPECT_EQ(store.history(1, 10)->size(), 1U);
}

TEST(LabelStore, IsNotMadeOverAnother) {
  const ScratchFolder scratch;
  const fs::path path = scratch.file("labels.gpkg", "precious");
  EXPECT_THAT(error_text(LabelStore::create(path, test_plane(), test_grid(4, 4), "ada")),
              HasSubstr("is there already"));
  EXPECT_THAT(error_text(LabelStore::create(scratch.path() / "no" / "labels.gpkg", test_plane(),
                                            test_grid(4, 4), "ada")),
              HasSubstr("no"));
  EXPECT_FALSE(LabelStore::create(scratch.path() / "b.gpkg", test_plane(), test_grid(0, 4), "ada"));
}

TEST(LabelStore, SaysWhatAFileIsThatIsNone) {
  const ScratchFolder scratch;
  EXPECT_EQ(error_code(LabelStore::open(scratch.path() / "none.gpkg", "ada")),
            ErrorCode::kNotFound);
  const fs::path text = scratch.file("text.gpkg", std::string(4096, 'x'));
  EXPECT_EQ(error_text(LabelStore::open(text, "ada")),
            text.string() + ": is no labelling document");
  const fs::path empty = scratch.file("empty.gpkg", "");
  EXPECT_EQ(error_text(LabelStore::open(empty, "ada")),
            empty.string() + ": is no labelling document");
  const fs::path other = scratch.path() / "other.gpkg";
  OtherProgram(other).run("CREATE TABLE gpkg_contents (a)");
  EXPECT_EQ(error_text(LabelStore::open(other, "ada")),
            other.string() + ": is no labelling document");
}

TEST(LabelStore, OfANewerVersionIsLeftAlone) {
  const ScratchFolder scratch;
  const fs::path path = scratch.path() / "labels.gpkg";
  { made(path); }
  OtherProgram(path).run("UPDATE nadir_about SET value = '2' WHERE key = 'format'");
  const auto store = LabelStore::open(path, "ada");
  EXPECT_EQ(error_code(store), ErrorCode::kUnsupported);
  EXPECT_THAT(error_text(store), HasSubstr("is of label format 2, this program knows 1"));
}

TEST(LabelStore, ASecondProgramReadsAndSaysWhoHasIt) {
  const ScratchFolder scratch;
  const fs::path path = scratch.path() / "labels.gpkg";
  LabelStore first = made(path);
  work(first, 34, 0, 10);
  {
    LabelStore second = opened(path);
    EXPECT_THAT(second.why_read_only(), HasSubstr("is open for ada on "));
    EXPECT_THAT(second.why_read_only(), HasSubstr(fmt::format("(process {})", ::getpid())));
    EXPECT_TRUE(second.document() == first.document());
    EXPECT_EQ(error_text(second.commit(random_edit(second.document(), 34, 99))),
              second.why_read_only());
    EXPECT_FALSE(second.undo());
  }
  work(first, 34, 10, 5);  // The second one's leaving has taken nothing away.
  const LabelStore third = opened(path);
  EXPECT_THAT(third.why_read_only(), HasSubstr("ada"));
}

TEST(LabelStore, IsFreeAgainWhenItsHolderHasClosedIt) {
  const ScratchFolder scratch;
  const fs::path path = scratch.path() / "labels.gpkg";
  { made(path); }
  EXPECT_FALSE(fs::exists(scratch.path() / "labels.gpkg.lock"));
  EXPECT_THAT(opened(path).why_read_only(), IsEmpty());
}

TEST(LabelStore, TheLockOfAKilledProgramIsGone) {
  const ScratchFolder scratch;
  const fs::path path = scratch.path() / "labels.gpkg";
  { made(path); }
  const pid_t child = ::fork();
  if (child == 0) {
    auto store = LabelStore::open(path, "eve");
    ::kill(::getpid(), SIGKILL);
  }
  ::waitpid(child, nullptr, 0);
  EXPECT_TRUE(fs::exists(scratch.path() / "labels.gpkg.lock"));
  EXPECT_THAT(opened(path).why_read_only(), IsEmpty());
}

TEST(LabelStore, OpensForReadingWhereItCannotBeWritten) {
  const ScratchFolder scratch;
  const fs::path path = scratch.path() / "labels.gpkg";
  std::optional<LabelDocument> last;
  {
    LabelStore store = made(path);
    work(store, 35, 0, 10);
    last = store.document();
  }
  {
    const LabelStore asked = opened(path, LabelAccess::kRead);
    EXPECT_THAT(asked.why_read_only(), HasSubstr("was opened for reading"));
    EXPECT_FALSE(fs::exists(scratch.path() / "labels.gpkg.lock"));
  }
  if (::geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
  fs::permissions(path, fs::perms::owner_read);
  fs::permissions(scratch.path(), fs::perms::owner_read | fs::perms::owner_exec);
  const LabelStore store = opened(path);
  EXPECT_THAT(store.why_read_only(), HasSubstr("cannot be written, so it was opened for reading"));
  EXPECT_TRUE(store.document() == *last);
  fs::permissions(scratch.path(), fs::perms::owner_all);
}

TEST(LabelStore, AFullDiskChangesNothing) {
  const ScratchFolder scratch;
  const fs::path path = scratch.path() / "labels.gpkg";
  std::optional<LabelDocument> before;
  {
    LabelStore store = made(path);
    work(store, 36, 0, 10);
    before = store.document();
    // No file may grow: what a full disk says, but by another signal.
    std::signal(SIGXFSZ, SIG_IGN);
    rlimit usual{};
    ::getrlimit(RLIMIT_FSIZE, &usual);
    rlimit full = usual;
    full.rlim_cur = fs::file_size(scratch.path() / "labels.gpkg-wal");
    ::setrlimit(RLIMIT_FSIZE, &full);
    const auto refused =
        store.commit(adding({area(kRoad, {box(0, 0, 2, 2)}, store.document().next_id())}));
    const auto undone = store.undo();
    ::setrlimit(RLIMIT_FSIZE, &usual);
    EXPECT_EQ(error_code(refused), ErrorCode::kIo);
    EXPECT_FALSE(undone);
    EXPECT_TRUE(store.document() == *before);
    const auto done =
        store.commit(adding({area(kRoad, {box(0, 0, 2, 2)}, store.document().next_id())}));
    EXPECT_TRUE(done) << error_text(done);
    ASSERT_TRUE(store.undo());
  }
  EXPECT_TRUE(opened(path).document() == *before);
}

}  // namespace label_store_test
}  // namespace nadir
