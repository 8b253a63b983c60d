// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "core/label/label_store.h"
#include "tests/core/label/drawn_labels.h"
#include "tests/core/label/other_program.h"
#include "tests/support/error_text.h"
#include "tests/support/scratch_folder.h"

namespace nadir {
namespace damaged_label_store_test {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr std::size_t kPageBytes = 4096;

std::string bytes_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// A closed document of some hundred objects and some paint.
LabelDocument make(const fs::path& path) {
  auto store = LabelStore::create(path, test_plane(), test_grid(2000, 2000), "ada");
  EXPECT_TRUE(store) << error_text(store);
  LabelEdit edit{"Draw", {}, {}, {}};
  for (int i = 0; i < 300; ++i) {
    const double x = i % 20 * 40.0;
    const double y = i / 20 * 40.0;
    edit.objects.push_back(added(i % 2 == 0
                                     ? area(kRoad, {box(x, y, x + 30, y + 20)}, i + 1)
                                     : outline(kBuilding, {box(x, y, x + 9, y + 9)}, 0.3, i + 1)));
  }
  EXPECT_TRUE(store->commit(edit));
  EXPECT_TRUE(store->commit(painting(store->document(), {0, 0, 900, 700}, kTerrain)));
  return store->document();
}

/// Number of the page that begins a table.
std::size_t root_of(const fs::path& path, const std::string& table) {
  return static_cast<std::size_t>(std::stoul(
      OtherProgram(path).value("SELECT rootpage FROM sqlite_schema WHERE name = '" + table + "'")));
}

/// Every object that is there is as it was drawn.
void expect_only_truth(const LabelDocument& found, const LabelDocument& truth) {
  for (const auto& [id, placed] : found.objects()) {
    const auto expected = truth.object(id);
    ASSERT_NE(expected, nullptr) << id;
    EXPECT_EQ(*placed.object, *expected);
  }
  for (const auto& [address, tile] : found.paint()) EXPECT_EQ(*tile, *truth.tile(address));
}

TEST(DamagedLabelStore, OpensWhatIsLeftForReadingAndSaysSo) {
  const ScratchFolder scratch;
  const fs::path path = scratch.path() / "labels.gpkg";
  const LabelDocument truth = make(path);
  const std::string whole = bytes_of(path);
  int opened = 0;
  int damaged = 0;
  for (std::size_t page = 1; page < whole.size() / kPageBytes; ++page) {
    std::string bytes = whole;
    std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(page * kPageBytes), kPageBytes, '\xA5');
    const fs::path copy = scratch.file("page.gpkg", bytes);
    const auto store = LabelStore::open(copy, "ada");
    if (!store) continue;  // One of the few pages without which nothing is known.
    ++opened;
    expect_only_truth(store->document(), truth);
    if (store->document() == truth && store->why_read_only().empty())
      continue;  // A page of the history, or of an index.
    ++damaged;
    EXPECT_THAT(store->why_read_only(), HasSubstr("is damaged, so what could be read"));
    EXPECT_THAT(store->notices().back(), HasSubstr("is damaged"));
    EXPECT_GT(store->document().objects().size() + store->document().paint().size(), 100U);
  }
  const auto pages = static_cast<int>(whole.size() / kPageBytes);
  EXPECT_GT(opened, pages * 2 / 3);
  EXPECT_GT(damaged, 0);
}

TEST(DamagedLabelStore, FindsObjectsInTheirLayersWhereNadirsOwnTableIsLost) {
  const ScratchFolder scratch;
  const fs::path path = scratch.path() / "labels.gpkg";
  const LabelDocument truth = make(path);
  std::string bytes = bytes_of(path);
  const std::size_t root = root_of(path, "nadir_object");
  std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>((root - 1) * kPageBytes), kPageBytes,
              '\xA5');
  const auto store = LabelStore::open(scratch.file("lost.gpkg", bytes), "ada");
  ASSERT_TRUE(store) << error_text(store);
  EXPECT_EQ(store->document().objects().size(), truth.objects().size());
  expect_only_truth(store->document(), truth);
  EXPECT_FALSE(store->why_read_only().empty());
}

TEST(DamagedLabelStore, CanBeCopiedIntoASoundOne) {
  const ScratchFolder scratch;
  const fs::path path = scratch.path() / "labels.gpkg";
  const LabelDocument truth = make(path);
  std::string bytes = bytes_of(path);
  const std::size_t root = root_of(path, "area");
  std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>((root - 1) * kPageBytes), kPageBytes,
              '\xA5');
  const auto store = LabelStore::open(scratch.file("lost.gpkg", bytes), "ada");
  ASSERT_TRUE(store) << error_text(store);
  const fs::path saved = scratch.path() / "saved.gpkg";
  {
    auto copy = LabelStore::create(saved, store->document(), "ada");
    ASSERT_TRUE(copy) << error_text(copy);
  }
  const auto back = LabelStore::open(saved, "ada");
  ASSERT_TRUE(back);
  EXPECT_TRUE(back->document() == truth);
  EXPECT_THAT(back->why_read_only(), IsEmpty());
}

TEST(DamagedLabelStore, CutOffIsRefusedOrRead) {
  const ScratchFolder scratch;
  const fs::path path = scratch.path() / "labels.gpkg";
  const LabelDocument truth = make(path);
  const std::string whole = bytes_of(path);
  for (std::size_t length = 0; length < whole.size(); length += 3 * kPageBytes + 100) {
    const auto store = LabelStore::open(scratch.file("cut.gpkg", whole.substr(0, length)), "ada");
    if (store) {
      expect_only_truth(store->document(), truth);
      EXPECT_FALSE(store->why_read_only().empty()) << length;
    } else {
      EXPECT_EQ(error_code(store), ErrorCode::kMalformed) << error_text(store);
      EXPECT_THAT(error_text(store), HasSubstr("cut.gpkg"));
    }
  }
}

TEST(DamagedLabelStore, PaintWithFlippedBitsIsLeftOutAndTold) {
  const ScratchFolder scratch;
  const fs::path path = scratch.path() / "labels.gpkg";
  make(path);
  OtherProgram(path).run(
      "UPDATE nadir_tile SET data = x'28B52FFD' WHERE tile_column = 1 AND tile_row = 0");
  const auto store = LabelStore::open(path, "ada");
  ASSERT_TRUE(store) << error_text(store);
  EXPECT_EQ(store->document().tile({1, 0}), nullptr);
  EXPECT_THAT(store->notices(),
              testing::ElementsAre("the paint of tile 1, 0 is damaged", store->why_read_only()));
  EXPECT_THAT(store->why_read_only(), HasSubstr("is damaged"));
}

}  // namespace damaged_label_store_test
}  // namespace nadir
