// SPDX-License-Identifier: Apache-2.0
// The file box where a recipe is saved.
#include <gmock/gmock.h>

#include "tests/widgets/panels/box_on_disk.h"

namespace nadir {
namespace save_box_test {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(SaveBox, ProposesANameAndWritesItOnEnter) {
  BoxToSave box;
  box.wait();
  EXPECT_EQ(box.screen.at("Save recipe/##Name").value, "loop-options.toml");
  EXPECT_THAT(box.press("Enter"),
              ElementsAre("show none", "save-preset /data/flights/loop-options.toml"));
}

TEST(SaveBox, GivesAnEndingAndReplacesWhatIsProposedByWhatIsTyped) {
  BoxToSave box;
  box.wait();
  box.type_here("mine");
  EXPECT_EQ(box.state.files.typed, "mine");
  EXPECT_THAT(box.press("Enter"), ElementsAre("show none", "save-preset /data/flights/mine.toml"));
}

TEST(SaveBox, WarnsBeforeItReplacesAndAsksForEnterTwice) {
  BoxToSave box;
  box.type("Save recipe/##Name", "wide.toml", false);
  EXPECT_TRUE(box.screen.shows("is there already and would be replaced")) << box.screen.words();
  EXPECT_TRUE(box.screen.has("Save recipe/Replace##take"));
  EXPECT_THAT(box.press("Enter"), IsEmpty());
  box.wait();
  EXPECT_TRUE(box.screen.shows("Enter once more replaces")) << box.screen.words();
  EXPECT_THAT(box.press("Enter"), ElementsAre("show none", "save-preset /data/flights/wide.toml"));
}

TEST(SaveBox, ReplacesByItsButton) {
  BoxToSave box;
  box.type("Save recipe/##Name", "wide", false);
  EXPECT_THAT(box.click("Save recipe/Replace##take"),
              ElementsAre("show none", "save-preset /data/flights/wide.toml"));
}

TEST(SaveBox, TakesTheNameOfAFileThatIsDoubleClickedAndGoesIntoFolders) {
  BoxToSave box;
  EXPECT_THAT(box.double_click("Save recipe/Names/wide.toml"), IsEmpty());
  EXPECT_EQ(box.state.files.typed, "wide.toml");
  box.wait();
  box.double_click("Save recipe/Names/2018");
  EXPECT_EQ(folder_of_box(box), "/data/flights/2018");
  EXPECT_EQ(box.state.files.typed, "wide.toml") << "the name stays";
}

TEST(SavePlace, SaysWhatIsInTheWay) {
  const MadeFolders disk;
  FileBrowserModel model;
  FileBrowserState state;
  state.folder = "/data/flights";
  constexpr std::array<std::string_view, 2> kEndings = {".toml", ".nadir"};
  const auto place = [&](const std::string& typed) {
    state.typed = typed;
    disk.show(state, model);
    return save_place(model, state, kEndings);
  };
  EXPECT_EQ(place("").why_not, "type a name first");
  EXPECT_EQ(place(" . ").why_not, "type a name first");
  EXPECT_EQ(place("new").file, "/data/flights/new.toml");
  EXPECT_FALSE(place("new").replaces);
  EXPECT_EQ(place("new.nadir").file, "/data/flights/new.nadir");
  EXPECT_TRUE(place("loop-2.nadir").replaces);
  EXPECT_EQ(place("../maps/new").file, "/data/maps/new.toml");
  EXPECT_EQ(place("/nowhere/new").why_not, "/nowhere: does not exist");
  state.typed = "2018";
  disk.show(state, model);
  EXPECT_TRUE(save_place(model, state, {}).replaces) << "a folder may replace a folder";
  state.typed = "notes.txt";
  EXPECT_EQ(save_place(model, state, {}).why_not, "notes.txt is a file");
}

}  // namespace save_box_test
}  // namespace nadir
