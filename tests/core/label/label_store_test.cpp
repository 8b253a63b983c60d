// SPDX-License-Identifier: Apache-2.0
#include "core/label/label_store.h"

#include <gmock/gmock.h>
#include <sys/resource.h>

#include <csignal>

#include "core/label/label_raster.h"
#include "tests/core/label/label_file.h"

namespace nadir {
namespace label_store_test {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::IsEmpty;

/// Cells of a quarter of a metre.
class LabelStoreTest : public LabelFile {
 protected:
  [[nodiscard]] LabelStore made() const { return LabelFile::made(test_grid(40, 30, 0.25)); }
};

TEST_F(LabelStoreTest, KeepsPlaneAndGridToTheLastBit) {
  const auto plane = *ProjectPlane::create({48.98772123456789, -8.1 / 3.0});
  const LabelGrid grid{0.1 + 0.2, {-1.0 / 3.0, 1e5 / 7.0}, 123, 456};
  ASSERT_TRUE(LabelStore::create(path_, plane, grid, "ada"));
  const LabelStore store = opened();
  EXPECT_TRUE(store.document().plane() == plane);
  EXPECT_EQ(store.document().grid(), grid);
  EXPECT_FALSE(store.undo_step());
  EXPECT_THAT(store.why_read_only(), IsEmpty());
}

TEST_F(LabelStoreTest, HoldsWhatWasCommittedWhenItIsOpenedAgain) {
  std::optional<LabelDocument> last;
  {
    LabelStore store = made();
    work(store, 31, 0, 150);
    last = store.document();
  }
  const LabelStore store = opened();
  EXPECT_TRUE(store.document() == *last);
  EXPECT_EQ(store.document().next_id(), last->next_id());
  EXPECT_EQ(rasterise(store.document()), rasterise(*last));
  EXPECT_THAT(store.notices(), IsEmpty());
}

TEST_F(LabelStoreTest, UndoSurvivesClosingAndOpeningInOneOrder) {
  std::vector<LabelDocument> before;
  std::optional<LabelDocument> last;
  {
    LabelStore store = made();
    before = work(store, 32, 0, 60);
    last = store.document();
  }
  for (int step = 59; step >= 0; --step) {  // Opened again for every single one.
    LabelStore store = opened();
    ASSERT_EQ(store.undo_step()->title, fmt::format("Step {}", step));
    EXPECT_EQ(store.undo_step()->author, "ada");
    ASSERT_TRUE(store.undo());
    ASSERT_TRUE(store.document() == before[static_cast<std::size_t>(step)]) << step;
  }
  LabelStore store = opened();
  EXPECT_FALSE(store.undo_step());
  EXPECT_EQ(error_text(store.undo()), "there is nothing to undo");
  while (store.redo_step()) ASSERT_TRUE(store.redo());
  EXPECT_TRUE(store.document() == *last);
  EXPECT_EQ(error_text(store.redo()), "there is nothing to do again");
}

TEST_F(LabelStoreTest, SaysWhatUndoHasChanged) {
  LabelStore store = made();
  ASSERT_TRUE(store.commit(adding({area(kRoad, {box(0, 0, 2, 2)})}, "Draw road")));
  const auto edit = store.undo();
  ASSERT_TRUE(edit);
  EXPECT_EQ(edit->title, "Draw road");
  ASSERT_EQ(edit->objects.size(), 1U);
  EXPECT_NE(edit->objects.front().before, nullptr);
  EXPECT_EQ(edit->objects.front().after, nullptr);
  EXPECT_EQ(store.redo_step()->title, "Draw road");
}

TEST_F(LabelStoreTest, AnEditAfterUndoHidesButKeepsWhatWasUndone) {
  LabelStore store = made();
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

TEST_F(LabelStoreTest, GoesToAnyStepOfAnyBranch) {
  LabelStore store = made();
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

TEST_F(LabelStoreTest, TheWayBetweenStepsLeadsACopyThereAndChangesNothing) {
  LabelStore store = made();
  const LabelDocument blank = store.document();
  work(store, 40, 0, 5);
  const LabelDocument fifth = store.document();
  for (int i = 0; i < 3; ++i) ASSERT_TRUE(store.undo());
  const LabelDocument second = store.document();
  work(store, 40, 50, 2);
  const LabelDocument seventh = store.document();
  const auto led = [&](LabelDocument document, std::int64_t from, std::int64_t to) {
    const auto way = store.way(document, from, to);
    EXPECT_TRUE(way) << error_text(way);
    for (const LabelEdit& edit : *way) document.apply(edit);
    return document;
  };
  EXPECT_TRUE(led(seventh, 7, 5) == fifth);
  EXPECT_TRUE(led(fifth, 5, 2) == second);
  EXPECT_TRUE(led(second, 2, 7) == seventh);
  EXPECT_TRUE(led(seventh, 7, 0) == blank);
  EXPECT_TRUE(led(seventh, 7, 7) == seventh);
  EXPECT_TRUE(store.document() == seventh);
  EXPECT_EQ(store.undo_step()->number, 7);
  for (const auto& [from, to] : {std::pair{7, 8}, {-1, 7}, {9, 7}}) {
    const auto way = store.way(seventh, from, to);
    ASSERT_FALSE(way);
    EXPECT_EQ(way.error().code, ErrorCode::kInvalidOptions);
  }
  EXPECT_FALSE(store.way(second, 7, 5)) << "it is not the document of that step";
}

TEST_F(LabelStoreTest, ClosedItIsOneFileAndOpeningItChangesNothing) {
  {
    LabelStore store = made();
    work(store, 33, 0, 5);
    EXPECT_GT(scratch_.entries(), 1);
    EXPECT_TRUE(store.close());
  }
  EXPECT_EQ(scratch_.entries(), 1);
  const auto bytes = [&] {
    std::ifstream file(path_, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(file), {});
  };
  const std::string before = bytes();
  EXPECT_EQ(before[18], 1);  // No WAL.
  { const LabelStore store = opened(); }
  EXPECT_EQ(bytes(), before);
}

TEST_F(LabelStoreTest, AStrokeTakesTwoKilobytesOfHistoryAtMost) {
  LabelStore store = made();
  for (int stroke = 0; stroke < 40; ++stroke) {
    // A brush of 12 cells through two tiles or three.
    const std::int64_t left = stroke * 17 % 300;
    LabelEdit edit = painting(store.document(), {left, stroke * 11, left + 400, stroke * 11 + 12},
                              stroke % 2 == 0 ? kRoad : kTerrain);
    ASSERT_TRUE(store.commit(edit));
  }
  const OtherProgram other(path_);
  EXPECT_LT(std::stoi(other.value("SELECT sum(length(delta)) / 40 FROM nadir_tile_change")), 2000);
}

TEST_F(LabelStoreTest, CarriesLargeChangesOverWhileItIsOpen) {
  LabelStore store = made();
  const OtherProgram other(path_);
  const auto pages_in_file = [&] { return fs::file_size(path_) / 4096; };
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

TEST_F(LabelStoreTest, RefusesWhatDoesNotFitAndChangesNothing) {
  LabelStore store = made();
  ASSERT_TRUE(store.commit(adding({area(kRoad, {box(0, 0, 2, 2)})})));
  const LabelDocument before = store.document();
  EXPECT_FALSE(store.commit(adding({area(kRoad, {box(0, 0, 2, 2)})})));
  EXPECT_FALSE(store.commit(adding({area(kRoad, {ring({{0, 0}, {1, 1}})}, 2)})));
  EXPECT_TRUE(store.document() == before);
  EXPECT_EQ(store.history(1, 10)->size(), 1U);
  EXPECT_TRUE(store.commit(LabelEdit{}));  // Nothing is no step.
  EXPECT_EQ(store.history(1, 10)->size(), 1U);
}

TEST_F(LabelStoreTest, IsNotMadeOverAnother) {
  scratch_.file("labels.gpkg", "precious");
  EXPECT_THAT(error_text(LabelStore::create(path_, test_plane(), test_grid(4, 4), "ada")),
              HasSubstr("is there already"));
  EXPECT_THAT(error_text(LabelStore::create(scratch_.path() / "no" / "labels.gpkg", test_plane(),
                                            test_grid(4, 4), "ada")),
              HasSubstr("no"));
  EXPECT_FALSE(
      LabelStore::create(scratch_.path() / "b.gpkg", test_plane(), test_grid(0, 4), "ada"));
}

TEST_F(LabelStoreTest, SaysWhatAFileIsThatIsNone) {
  EXPECT_EQ(error_code(LabelStore::open(scratch_.path() / "none.gpkg", "ada")),
            ErrorCode::kNotFound);
  const fs::path text = scratch_.file("text.gpkg", std::string(4096, 'x'));
  EXPECT_EQ(error_text(LabelStore::open(text, "ada")),
            text.string() + ": is no labelling document");
  const fs::path empty = scratch_.file("empty.gpkg", "");
  EXPECT_EQ(error_text(LabelStore::open(empty, "ada")),
            empty.string() + ": is no labelling document");
  const fs::path other = scratch_.path() / "other.gpkg";
  OtherProgram(other).run("CREATE TABLE gpkg_contents (a)");
  EXPECT_EQ(error_text(LabelStore::open(other, "ada")),
            other.string() + ": is no labelling document");
}

TEST_F(LabelStoreTest, OfANewerVersionIsLeftAlone) {
  static_cast<void>(made());
  run_elsewhere("UPDATE nadir_about SET value = '2' WHERE key = 'format'");
  const auto store = LabelStore::open(path_, "ada");
  EXPECT_EQ(error_code(store), ErrorCode::kUnsupported);
  EXPECT_THAT(error_text(store), HasSubstr("is of label format 2, this program knows 1"));
}

TEST_F(LabelStoreTest, AFullDiskChangesNothing) {
  std::optional<LabelDocument> before;
  {
    LabelStore store = made();
    work(store, 36, 0, 10);
    before = store.document();
    // No file may grow: what a full disk says, but by another signal.
    std::signal(SIGXFSZ, SIG_IGN);
    rlimit usual{};
    ::getrlimit(RLIMIT_FSIZE, &usual);
    rlimit full = usual;
    full.rlim_cur = fs::file_size(scratch_.path() / "labels.gpkg-wal");
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
  EXPECT_TRUE(opened().document() == *before);
}

}  // namespace label_store_test
}  // namespace nadir
