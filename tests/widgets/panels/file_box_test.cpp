// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/file_box.h"

#include <gmock/gmock.h>

#include "tests/support/scratch_folder.h"
#include "tests/widgets/panels/box_on_disk.h"

namespace nadir {
namespace file_box_test {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

TEST(OpenBox, BeginsWhereSomethingWasOpenedLastAndTakesTypingAtOnce) {
  BoxToOpen box;
  box.wait();
  EXPECT_EQ(folder_of_box(box), "/data/flights");
  EXPECT_TRUE(box.screen.has("Open/Names/loop-2.nadir")) << box.screen.words();
  box.type_here("2");
  EXPECT_EQ(box.state.files.typed, "2");
  EXPECT_TRUE(box.screen.has("Open/Names/loop-2.nadir"));
  EXPECT_FALSE(box.screen.has("Open/Names/loop-10.nadir"));
}

TEST(OpenBox, BeginsWhereItWasLeftUnlessSomethingWasOpenedElsewhereSince) {
  BoxToOpen box;
  box.wait();
  box.press("Backspace");
  const auto again = [&box] {
    box.model.use = FileBoxModel::Use::kClosed;
    box.wait();
    box.model.use = FileBoxModel::Use::kOpen;
    box.wait();
    return folder_of_box(box);
  };
  EXPECT_EQ(again(), "/data");
  box.model.first_folder = "/data/flights/2018";  // of what was dropped on the window, say
  EXPECT_EQ(again(), "/data/flights/2018");
}

TEST(OpenBox, ShowsNameKindAndDate) {
  BoxToOpen box;
  box.wait();
  const auto cell = [&](const std::string& path) {
    return box.screen.at("Open/Names/" + path).value;
  };
  EXPECT_THAT(cell("town/Name"), HasSubstr("town"));
  const std::vector<std::pair<std::string, std::string>> kinds = {
      {"town", "map"}, {"loop", "flight"}, {"wide.toml", "recipe"}};
  for (const auto& [name, kind] : kinds) EXPECT_EQ(cell(name + "/Kind"), kind);
  EXPECT_THAT(cell("town/Changed"), StartsWith("2020-09-"));
}

TEST(OpenBox, OpensTheFirstThatFitsOnEnter) {
  BoxToOpen box;
  EXPECT_THAT(box.type("Open/##Name", "loop-1"),
              ElementsAre("show none", "open /data/flights/loop-10.nadir"));
}

TEST(OpenBox, OpensAMapOrAFlightAsAWhole) {
  BoxToOpen box;
  EXPECT_THAT(box.double_click("Open/Names/town"), Contains("open /data/flights/town"));
}

TEST(OpenBox, GoesIntoAFolderByADoubleClickAndTypesOn) {
  BoxToOpen box;
  EXPECT_THAT(box.double_click("Open/Names/2018"), IsEmpty());
  EXPECT_EQ(folder_of_box(box), "/data/flights/2018");
  box.wait();
  box.type_here("old");
  EXPECT_EQ(box.state.files.typed, "old");
  EXPECT_THAT(box.press("Enter"), ElementsAre("show none", "open /data/flights/2018/old.nadir"));
}

TEST(OpenBox, IsGoneThroughByArrowsAndEnter) {
  BoxToOpen box;
  box.wait();
  box.press("Down");
  EXPECT_EQ(box.state.files.chosen, "2018");
  EXPECT_TRUE(box.screen.at("Open/Names/2018").is_selected);
  EXPECT_THAT(box.press("Enter"), IsEmpty());
  EXPECT_EQ(folder_of_box(box), "/data/flights/2018");
  box.wait();
  box.press("Down");
  EXPECT_THAT(box.press("Enter"), ElementsAre("show none", "open /data/flights/2018/old.nadir"));
}

TEST(OpenBox, GoesUpByBackspaceWhereNothingIsTypedAndByAltUp) {
  BoxToOpen box;
  box.wait();
  box.press("Backspace");
  EXPECT_EQ(folder_of_box(box), "/data");
  EXPECT_EQ(box.state.files.chosen, "flights") << "whence it came";
  box.wait();
  box.press("Alt+Up");
  EXPECT_EQ(folder_of_box(box), "/");
  box.wait();
  box.press("Backspace");
  EXPECT_EQ(folder_of_box(box), "/") << "there is nothing above";
  BoxToOpen typed;
  typed.wait();
  typed.type_here("l");
  typed.press("Backspace");
  EXPECT_EQ(folder_of_box(typed), "/data/flights") << "it took a letter away";
}

TEST(OpenBox, GoesUpByItsButtonAndAlongItsWay) {
  BoxToOpen box;
  box.click("Open/Way/Folder up");
  EXPECT_EQ(folder_of_box(box), "/data");
  box.wait();
  box.click("Open/Way//##/");
  EXPECT_EQ(folder_of_box(box), "/");
  box.wait();
  EXPECT_FALSE(box.screen.at("Open/Way/Folder up").is_enabled);
}

TEST(OpenBox, TakesAPathAndCompletesIt) {
  BoxToOpen box;
  box.type("Open/##Name", "/data/f", false);
  EXPECT_TRUE(box.screen.has("Open/Names/flights"));
  box.press("Tab");
  box.wait();
  EXPECT_EQ(box.state.files.typed, "/data/flights/");
  box.type_here("loop-");
  EXPECT_EQ(box.state.files.typed, "/data/flights/loop-") << "typing goes on at the end";
  box.type_here("10.nadir");
  EXPECT_THAT(box.press("Enter"), ElementsAre("show none", "open /data/flights/loop-10.nadir"));
}

TEST(OpenBox, GoesToAFolderWhosePathIsTyped) {
  BoxToOpen box;
  EXPECT_THAT(box.type("Open/##Name", "/data/maps/"), IsEmpty());
  EXPECT_EQ(folder_of_box(box), "/data/maps");
  EXPECT_EQ(box.state.files.typed, "");
}

TEST(OpenBox, SaysInPlaceWhyAFolderCannotBeShown) {
  BoxToOpen box;
  box.type("Open/##Name", "/nowhere/at all/", false);
  EXPECT_TRUE(box.screen.shows("/nowhere/at all: does not exist")) << box.screen.words();
  EXPECT_FALSE(box.screen.at("Open/Open##take").is_enabled);
}

TEST(OpenBox, SaysThatNothingFitsAndShowsAllOnDemand) {
  BoxToOpen box;
  box.type("Open/##Name", "notes", false);
  EXPECT_TRUE(box.screen.shows("Nothing here that can be opened")) << box.screen.words();
  box.click("Open/All files");
  box.wait();
  EXPECT_TRUE(box.screen.has("Open/Names/notes.txt"));
}

TEST(OpenBox, GoesToPlacesAndToTheFolderOfARecentFile) {
  BoxToOpen box;
  box.click("Open/Places/maps##/data/maps");
  EXPECT_EQ(folder_of_box(box), "/data/maps");
  box.wait();
  box.click("Open/Places/Recent/old##/data/flights/2018/old.nadir");
  EXPECT_EQ(folder_of_box(box), "/data/flights/2018");
  EXPECT_EQ(box.state.files.chosen, "old.nadir");
  EXPECT_THAT(box.double_click("Open/Places/Recent/old##/data/flights/2018/old.nadir"),
              Contains("open /data/flights/2018/old.nadir"));
}

TEST(OpenBox, OrdersByAClickOnAHeading) {
  BoxToOpen box;
  box.wait();
  EXPECT_LT(box.screen.at("Open/Names/loop-2.nadir").rect.top,
            box.screen.at("Open/Names/wide.toml").rect.top);
  box.click("Open/Names/Changed");
  box.wait();
  EXPECT_GT(box.screen.at("Open/Names/loop-2.nadir").rect.top,
            box.screen.at("Open/Names/wide.toml").rect.top);
}

TEST(OpenBox, ClosesByEscapeAndByItsButtonAndKeepsItsFolder) {
  BoxToOpen box;
  box.click("Open/Way/Folder up");
  EXPECT_THAT(box.click("Open/Cancel"), ElementsAre("show none"));
  box.wait();
  EXPECT_THAT(box.press("Escape"), Contains("show none"));
  box.model.use = FileBoxModel::Use::kClosed;
  box.wait(2);
  EXPECT_FALSE(box.screen.has("Open"));
  box.model.use = FileBoxModel::Use::kOpen;
  box.wait();
  EXPECT_EQ(folder_of_box(box), "/data");
  EXPECT_EQ(box.state.files.typed, "");
}

TEST(OpenBox, Of20000NamesDrawsThoseInSightAndKeepsTheChosenOneThere) {
  BoxToOpen box;
  auto many = std::make_shared<FolderListing>();
  many->folder = "/data/flights";
  for (int i = 0; i < 20'000; ++i) {
    FolderEntry entry;
    entry.name = fmt::format("{:05}-{}.nadir", i, std::string(100, 'x'));
    entry.kind = FileKind::kRun;
    many->entries.push_back(entry);
  }
  box.model.disk.folders["/data/flights"] = many;
  box.wait();
  EXPECT_LT(box.screen.controls().size(), 300U);
  for (int i = 0; i < 60; ++i) box.press("Down");
  box.wait();
  ASSERT_EQ(box.state.files.chosen, many->entries[59].name);
  const kit::Control& row = box.screen.at("Open/Names/" + many->entries[59].name);
  const kit::Rect table = box.screen.at("Open/Names").rect;
  EXPECT_GE(row.rect.top, table.top);
  EXPECT_LE(row.rect.bottom(), table.bottom() + 1.0);
  EXPECT_TRUE(box.fits("Open"));
}

TEST(OpenBox, FitsIntoASmallWindow) {
  BoxToOpen box;
  box.screen.input().size_px = {700.0, 480.0};
  box.wait(5);
  EXPECT_TRUE(box.fits());
  EXPECT_TRUE(box.screen.at("Open/Open##take").is_visible);
  EXPECT_LE(box.screen.at("Open/Open##take").rect.bottom(), 480.0);
}

TEST(FileBoxModel, FollowsTheSessionsOverlay) {
  const ScratchFolder folder;
  Session session({folder.path() / "config", folder.path() / "data", {}});
  FolderReader reader;
  FileBoxState state;
  EXPECT_EQ(file_box_model(session, state, reader).use, FileBoxModel::Use::kClosed);
  ASSERT_TRUE(session.apply(actions::ShowOverlay{Overlay::kOpen}));
  EXPECT_EQ(file_box_model(session, state, reader).use, FileBoxModel::Use::kOpen);
  ASSERT_TRUE(session.apply(actions::ShowOverlay{Overlay::kSaveRecipe}));
  const FileBoxModel model = file_box_model(session, state, reader);
  EXPECT_EQ(model.use, FileBoxModel::Use::kSaveRecipe);
  EXPECT_EQ(model.proposed_name, "recipe.toml");
}

}  // namespace file_box_test
}  // namespace nadir
