// SPDX-License-Identifier: Apache-2.0
#include "core/session/folder_listing.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "core/session/folder_reader.h"
#include "tests/support/error_text.h"
#include "tests/support/scratch_folder.h"

namespace nadir {
namespace folder_listing_test {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

std::vector<std::string> names_of(const FolderListing& listing) {
  std::vector<std::string> names;
  for (const FolderEntry& entry : listing.entries) names.push_back(entry.name);
  return names;
}

/// Looks until a reader has an answer for the folder.
void wait_for(FolderReader& reader, const fs::path& folder) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  do {
    reader.look(folder);
    std::this_thread::yield();
    ASSERT_LT(std::chrono::steady_clock::now(), end) << "it takes for ever";
  } while (reader.is_reading());
}

TEST(FolderListing, HasFoldersFirstAndNumbersByTheirValue) {
  const ScratchFolder scratch;
  for (const char* name : {"loop-10.nadir", "Loop-2.nadir", "loop-1.nadir", "loop-02b.txt"})
    scratch.file(name, "x");
  fs::create_directory(scratch.path() / "zoo");
  fs::create_directory(scratch.path() / "alp");
  const auto listing = list_folder(scratch.path(), {});
  ASSERT_TRUE(listing) << error_text(listing);
  EXPECT_THAT(names_of(*listing), ElementsAre("alp", "zoo", "loop-1.nadir", "Loop-2.nadir",
                                              "loop-02b.txt", "loop-10.nadir"));
  EXPECT_EQ(listing->folder, scratch.path());
  EXPECT_FALSE(listing->is_cut_short);
}

TEST(FolderListing, KnowsKindSizeAndTimeOfEachName) {
  const ScratchFolder scratch;
  const fs::path run = scratch.file("loop.nadir", "12345");
  scratch.file("town/map.toml", "");
  fs::last_write_time(run, fs::file_time_type::clock::now() - std::chrono::hours(2));
  const auto listing = list_folder(scratch.path(), {});
  ASSERT_TRUE(listing) << error_text(listing);
  const FolderEntry* const file = listing->find("loop.nadir");
  const FolderEntry* const map = listing->find("town");
  ASSERT_NE(file, nullptr);
  ASSERT_NE(map, nullptr);
  EXPECT_EQ(file->kind, FileKind::kRun);
  EXPECT_FALSE(file->is_folder);
  EXPECT_EQ(file->bytes, 5U);
  EXPECT_NEAR(map->changed_s - file->changed_s, 7200.0, 60.0);
  EXPECT_EQ(map->kind, FileKind::kMap);
  EXPECT_TRUE(map->is_folder);
  EXPECT_EQ(listing->find("none"), nullptr);
}

TEST(FolderListing, LeavesOutLinksThatLeadNowhereAndFollowsTheOthers) {
  const ScratchFolder scratch;
  scratch.file("maps/town/map.toml", "");
  fs::create_symlink(scratch.path() / "gone", scratch.path() / "broken");
  fs::create_directory_symlink(scratch.path() / "maps" / "town", scratch.path() / "link");
  const auto listing = list_folder(scratch.path(), {});
  ASSERT_TRUE(listing) << error_text(listing);
  EXPECT_THAT(names_of(*listing), ElementsAre("link", "maps"));
  EXPECT_EQ(listing->find("link")->kind, FileKind::kMap);
}

TEST(FolderListing, SaysWhyAFolderCannotBeShown) {
  const ScratchFolder scratch;
  EXPECT_EQ(error_text(list_folder(scratch.path() / "none", {})),
            (scratch.path() / "none").string() + ": does not exist");
  EXPECT_THAT(error_text(list_folder(scratch.file("a.txt", ""), {})),
              HasSubstr("a.txt: is not a folder"));
  if (::geteuid() == 0) return;  // who may do everything is refused nothing
  const fs::path closed = scratch.path() / "closed";
  fs::create_directory(closed);
  fs::permissions(closed, fs::perms::none);
  EXPECT_THAT(error_text(list_folder(closed, {})), HasSubstr("Permission denied"));
  fs::permissions(closed, fs::perms::owner_all);
}

TEST(FolderListing, EndsSoonWhenItIsStopped) {
  const ScratchFolder scratch;
  scratch.file("a", "");
  std::stop_source stop;
  stop.request_stop();
  WorkContext context;
  context.stop = stop.get_token();
  const auto listing = list_folder(scratch.path(), context);
  ASSERT_FALSE(listing);
  EXPECT_EQ(error_code(listing), ErrorCode::kCancelled);
}

TEST(StandsBefore, OrdersByWhatIsAskedForAndThenByName) {
  std::vector<FolderEntry> entries;
  const auto add = [&entries](const char* name, FileKind kind, double changed_s) {
    FolderEntry entry;
    entry.name = name;
    entry.kind = kind;
    entry.is_folder = kind == FileKind::kFolder;
    entry.changed_s = changed_s;
    entries.push_back(entry);
  };
  add("a", FileKind::kFigure, 1.0);
  add("b", FileKind::kRun, 3.0);
  add("c", FileKind::kRun, 2.0);
  add("d", FileKind::kFolder, 0.0);
  const auto in_order = [&entries](FileOrder order) {
    std::sort(entries.begin(), entries.end(), [order](const FolderEntry& a, const FolderEntry& b) {
      return stands_before(a, b, order);
    });
    std::string names;
    for (const FolderEntry& entry : entries) names += entry.name;
    return names;
  };
  EXPECT_EQ(in_order(FileOrder::kName), "dabc");
  EXPECT_EQ(in_order(FileOrder::kKind), "dbca");
  EXPECT_EQ(in_order(FileOrder::kChanged), "dbca") << "the newest first";
}

TEST(StandsBefore, IsAStrictOrderOfNamesThatDifferInLittle) {
  const std::vector<std::string> names = {"a1", "a01", "A1", "a", "a10", "a2", "", "1", "01", "b"};
  for (const std::string& left : names) {
    for (const std::string& right : names) {
      FolderEntry a, b;
      a.name = left;
      b.name = right;
      const bool is_before = stands_before(a, b, FileOrder::kName);
      const bool is_after = stands_before(b, a, FileOrder::kName);
      EXPECT_EQ(left == right, !is_before && !is_after) << left << " " << right;
      EXPECT_FALSE(is_before && is_after) << left << " " << right;
    }
  }
}

TEST(FolderReader, ListsOneFolderAfterAnother) {
  const ScratchFolder scratch;
  scratch.file("one/a.nadir", "");
  scratch.file("two/b.nadir", "");
  FolderReader reader;
  reader.look({});
  EXPECT_FALSE(reader.is_reading());
  wait_for(reader, scratch.path() / "one");
  ASSERT_NE(reader.listing(), nullptr);
  EXPECT_THAT(names_of(*reader.listing()), ElementsAre("a.nadir"));
  const auto before = reader.listing();
  reader.look(scratch.path() / "one");
  EXPECT_EQ(reader.listing(), before) << "the same again costs nothing";
  wait_for(reader, scratch.path() / "two");
  ASSERT_NE(reader.listing(), nullptr);
  EXPECT_THAT(names_of(*reader.listing()), ElementsAre("b.nadir"));
}

TEST(FolderReader, NeverShowsTheNamesOfAnotherFolder) {
  const ScratchFolder scratch;
  scratch.file("one/a", "");
  scratch.file("two/b", "");
  FolderReader reader;
  for (int i = 0; i < 50; ++i) {
    const fs::path folder = scratch.path() / (i % 2 == 0 ? "one" : "two");
    reader.look(folder);
    if (reader.listing()) {
      EXPECT_EQ(reader.listing()->folder, folder);
    }
  }
  wait_for(reader, scratch.path() / "two");
  EXPECT_THAT(names_of(*reader.listing()), ElementsAre("b"));
}

TEST(FolderReader, TellsAFaultUntilAnotherFolderIsAskedFor) {
  const ScratchFolder scratch;
  FolderReader reader;
  wait_for(reader, scratch.path() / "none");
  EXPECT_EQ(reader.listing(), nullptr);
  EXPECT_THAT(reader.fault(), HasSubstr("none: does not exist"));
  wait_for(reader, scratch.path());
  EXPECT_EQ(reader.fault(), "");
  EXPECT_NE(reader.listing(), nullptr);
  reader.look({});
  EXPECT_EQ(reader.listing(), nullptr) << "a box that is closed shows nothing old when it opens";
}

}  // namespace folder_listing_test
}  // namespace nadir
