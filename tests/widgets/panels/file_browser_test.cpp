// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/file_browser.h"

#include <gmock/gmock.h>

#include <chrono>
#include <thread>

#include "tests/support/scratch_folder.h"
#include "tests/widgets/panels/made_folders.h"

namespace nadir {
namespace file_browser_test {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

struct Browser {
  MadeFolders disk;
  FileBrowserModel model;
  FileBrowserState state;
  Browser() { state.folder = "/data/flights"; }
  std::vector<std::string> shown(const FileFilter& filter = {}) {
    disk.show(state, model);
    std::vector<std::string> names;
    for (const FolderEntry* entry : shown_entries(model, state, filter))
      names.push_back(entry->name);
    return names;
  }
};

TEST(ShownEntries, AreWhatCanBeOpenedOrGoneInto) {
  Browser browser;
  EXPECT_THAT(browser.shown(),
              ElementsAre("2018", "loop", "town", "loop-2.nadir", "loop-10.nadir", "wide.toml"));
  browser.state.shows_all = true;
  EXPECT_THAT(browser.shown(), testing::IsSupersetOf({"notes.txt", ".hidden.nadir"}));
}

TEST(ShownEntries, HaveTheWordsThatAreTyped) {
  Browser browser;
  browser.state.typed = "LOOP nad";
  EXPECT_THAT(browser.shown(), ElementsAre("loop-2.nadir", "loop-10.nadir"));
  browser.state.typed = "zzz";
  EXPECT_THAT(browser.shown(), IsEmpty());
}

TEST(ShownEntries, OfAPathBeginWithItsLastPart) {
  Browser browser;
  browser.state.typed = "../maps/c";
  EXPECT_THAT(browser.shown(), ElementsAre("country"));
  browser.state.typed = "../maps/x";
  EXPECT_THAT(browser.shown(), IsEmpty());
  browser.state.typed = "/data/flights/loop-";
  EXPECT_THAT(browser.shown(), ElementsAre("loop-2.nadir", "loop-10.nadir"));
}

TEST(ShownEntries, ForSavingAreFoldersAndFilesOfTheSameEnding) {
  Browser browser;
  browser.state.typed = "anything";
  constexpr std::array<std::string_view, 1> kEndings = {".toml"};
  EXPECT_THAT(browser.shown({true, kEndings}), ElementsAre("2018", "wide.toml"));
}

TEST(ShownEntries, AreOrderedAsAskedForWithFoldersOnTop) {
  Browser browser;
  browser.state.order = FileOrder::kChanged;
  EXPECT_THAT(browser.shown(),
              ElementsAre("town", "loop", "2018", "wide.toml", "loop-10.nadir", "loop-2.nadir"));
  browser.state.is_reversed = true;
  EXPECT_THAT(browser.shown(),
              ElementsAre("2018", "loop", "town", "loop-2.nadir", "loop-10.nadir", "wide.toml"));
}

TEST(FirstFolder, IsThatOfWhatWasOpenedLast) {
  const std::vector<std::string> recents = {"/data/flights/a.nadir", "/b/c"};
  EXPECT_EQ(first_folder(recents, "/home/ada"), "/data/flights");
  EXPECT_EQ(first_folder({}, "/home/ada"), "/home/ada");
  EXPECT_EQ(first_folder({}, ""), "/");
  EXPECT_EQ(first_folder({}, "/home/ada", "/work"), "/work") << "where it was started";
  EXPECT_EQ(first_folder(recents, "/home/ada", "/work"), "/data/flights");
}

TEST(GoInto, ForgetsWhatWasTypedAndGoesOnTyping) {
  FileBrowserState state;
  state.typed = "loop";
  state.chosen = "loop";
  go_into(state, "/data");
  EXPECT_EQ(state.folder, "/data");
  EXPECT_EQ(state.typed, "");
  EXPECT_EQ(state.chosen, "");
  EXPECT_TRUE(state.goes_on_typing);
}

TEST(WhenText, IsADayAndATime) {
  EXPECT_THAT(when_text(1.6e9), testing::MatchesRegex("2020-09-1[234] [0-2][0-9]:[0-5][0-9]"));
  EXPECT_NE(when_text(1.6e9), when_text(1.6e9 + 86'400.0));
  EXPECT_EQ(when_text(1.6e9).substr(10), when_text(1.6e9 + 86'400.0).substr(10));
}

TEST(FileBrowserModel, HasHomeTheDiskAndEveryFolderOfTheRecentOnesOnce) {
  const std::vector<std::string> recents = {"/data/flights/a.nadir", "/data/flights/b.nadir",
                                            "/data/maps/town"};
  FolderReader reader;
  const FileBrowserModel model = file_browser_model(recents, {}, reader);
  std::vector<std::string> folders;
  for (const FilePlace& place : model.places) folders.push_back(place.folder);
  EXPECT_THAT(folders, testing::IsSupersetOf({"/", "/data/flights", "/data/maps"}));
  EXPECT_EQ(std::count(folders.begin(), folders.end(), "/data/flights"), 1);
  ASSERT_EQ(model.recents.size(), 3U);
  EXPECT_EQ(model.recents[2].title, "town");
  EXPECT_EQ(model.recents[2].folder, "/data/maps");
  EXPECT_EQ(model.recents[2].name, "town");
  EXPECT_EQ(model.recents[2].detail, "data/maps") << "files of one name are told apart";
  EXPECT_EQ(model.recents[0].detail, "data/flights");
  const auto maps = std::find_if(model.places.begin(), model.places.end(),
                                 [](const auto& place) { return place.folder == "/data/maps"; });
  ASSERT_NE(maps, model.places.end());
  EXPECT_EQ(maps->detail, "data");
}

TEST(FileBrowserModel, ShowsTheFolderOfATypedPathWithoutWaitingForTheDisk) {
  const ScratchFolder scratch;
  scratch.file("inner/a.nadir", "");
  FolderReader reader;
  FileBrowserState state;
  state.folder = scratch.path().string();
  state.typed = "inner/";
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  FileBrowserModel model = file_browser_model({}, state, reader);
  while (!model.listing && std::chrono::steady_clock::now() < end) {
    std::this_thread::yield();
    model = file_browser_model({}, state, reader);
  }
  ASSERT_NE(model.listing, nullptr);
  EXPECT_NE(model.listing->find("a.nadir"), nullptr);
  EXPECT_EQ(state.folder, scratch.path().string()) << "until Enter it is only looked at";
}

}  // namespace file_browser_test
}  // namespace nadir
