// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "core/label/label_raster.h"
#include "core/label/label_store.h"
#include "tests/core/label/drawn_labels.h"
#include "tests/support/error_text.h"
#include "tests/support/scratch_folder.h"

namespace nadir {
namespace label_fuzz_test {

/// Draws again what an edit has changed, as a window does.
void redraw(Raster<ClassId>& labels, const LabelEdit& edit, const LabelDocument& document) {
  const CellRect changed =
      changed_cells(edit, document.grid(), document.grid()).cut_to(document.grid().whole());
  const auto part = rasterise(document, document.grid(), changed);
  for (int row = 0; row < part.height(); ++row) {
    const auto from = part.row(row);
    const auto to = labels.row(row + static_cast<int>(changed.top));
    std::copy(from.begin(), from.end(), to.begin() + changed.left);
  }
}

class RandomGestures : public testing::TestWithParam<std::uint64_t> {};

TEST_P(RandomGestures, UndoAndRedoGiveTheRasterOfTheDocumentAtEveryMoment) {
  const ScratchFolder scratch;
  const auto path = scratch.path() / "labels.gpkg";
  const std::uint64_t seed = GetParam();
  std::optional<LabelStore> store;
  {
    auto made = LabelStore::create(path, test_plane(), test_grid(120, 90), "ada");
    ASSERT_TRUE(made) << error_text(made);
    store.emplace(std::move(*made));
  }
  Raster<ClassId> labels = rasterise(store->document());
  for (std::uint32_t step = 0; step < 250; ++step) {
    const auto words = random_words({seed, 0, step, 9, 0});
    const std::uint32_t what = words[0] % 10;
    Result<LabelEdit> edit = LabelEdit{};
    if (what < 6) {
      edit = random_edit(store->document(), seed, step);
      const auto done = store->commit(*edit);
      ASSERT_TRUE(done) << error_text(done);
    } else if (what < 8 && store->undo_step()) {
      edit = store->undo();
    } else if (what == 8 && store->redo_step()) {
      edit = store->redo();
    } else if (what == 9 && words[1] % 8 == 0) {
      const LabelDocument before = store->document();
      store.reset();
      auto opened = LabelStore::open(path, "ada");
      ASSERT_TRUE(opened) << error_text(opened);
      store.emplace(std::move(*opened));
      ASSERT_TRUE(store->document() == before);
    }
    ASSERT_TRUE(edit) << error_text(edit);
    redraw(labels, *edit, store->document());
    ASSERT_EQ(labels, rasterise(store->document())) << "step " << step;
  }
  const LabelDocument last = store->document();
  int steps = 0;
  for (; store->undo_step(); ++steps) ASSERT_TRUE(store->undo());
  EXPECT_TRUE(store->document().objects().empty());
  EXPECT_TRUE(store->document().paint().empty());
  EXPECT_EQ(rasterise(store->document()), Raster<ClassId>(120, 90, kUnclassified));
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomGestures, testing::Values(51, 52, 53, 54));

}  // namespace label_fuzz_test
}  // namespace nadir
