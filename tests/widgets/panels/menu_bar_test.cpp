// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/menu_bar.h"

#include <gmock/gmock.h>

#include "tests/support/scratch_folder.h"
#include "tests/widgets/panels/asked.h"
#include "widgets/kit/headless_ui.h"

namespace nadir {
namespace menu_bar_test {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

struct Menus {
  explicit Menus(double width = 1280.0) : screen(ThemeName::kDark, 1.0, {width, 800.0}) {
    model.commands = all_offered();
  }
  kit::HeadlessUi screen;
  MenuBarModel model;
  PaletteState palette;
  Actions operator()(kit::Ui& ui) { return draw_menu_bar(ui, model, palette); }
  /// Where the line of a command is; its menu is opened first.
  std::string open(std::string_view text) {
    const Command& command = *offered_as(model.commands, text).command;
    screen.click("Menu/" + std::string(command.menu), *this);
    for (const kit::Control& control : screen.controls()) {
      if (control.kind == kit::ControlKind::kMenuItem &&
          control.label.rfind(std::string(command.title), 0) == 0) {
        return control.path;
      }
    }
    return "no line for " + std::string(text);
  }
};

TEST(MenuBar, HasTheSixMenusFromTheLeft) {
  Menus menus;
  menus.screen.wait(2, menus);
  double left = 0.0;
  for (const char* const name : {"File", "Edit", "View", "Go", "Run", "Help"}) {
    const kit::Control& menu = menus.screen.at(std::string("Menu/") + name);
    EXPECT_GE(menu.rect.left, left) << name;
    left = menu.rect.right();
  }
}

TEST(MenuBar, EveryCommandIsInItsMenuOrInOneBelowIt) {
  std::map<std::string, std::vector<std::string>> lines_of;  // by the menu that is opened last
  const Menus all;
  for (const OfferedCommand& offered : all.model.commands) {
    const std::string menu = "Menu/" + std::string(offered.command->menu);
    const std::string group = menu_group_of(*offered.command, all.model.commands);
    const std::string opened = group.empty() ? menu : menu + "/" + group;
    lines_of[opened].push_back(opened + "/" + menu_title_of(*offered.command, all.model));
  }
  EXPECT_TRUE(lines_of.count("Menu/View/Layers"));
  for (const auto& [opened, lines] : lines_of) {
    Menus menus;
    menus.screen.click(opened, menus);
    menus.screen.wait(2, menus);
    for (const std::string& line : lines) EXPECT_TRUE(menus.screen.has(line)) << line;
  }
}

TEST(MenuBar, EveryMenuFitsIntoTheWindow) {
  for (const char* const name : {"File", "Edit", "View", "Go", "Run", "Help"}) {
    Menus menus;
    menus.screen.click(std::string("Menu/") + name, menus);
    menus.screen.wait(2, menus);
    for (const kit::Control& control : menus.screen.controls()) {
      EXPECT_LE(control.rect.bottom(), 800.0) << control.path;
    }
  }
}

TEST(MenuBar, DoesWhatIsChosen) {
  Menus menus;
  const std::string path = menus.open("open-demo");
  EXPECT_THAT(texts(menus.screen.click(path, menus)), ElementsAre("open-demo"));
}

TEST(MenuBar, AsksForArgumentsInThePaletteAndForFilesInTheirBoxes) {
  const std::vector<std::array<std::string, 2>> known = {
      {"seek", "show palette"},  {"open", "show open"},
      {"export", "show export"}, {"export-table", "show export"},
      {"report", "show export"}, {"save-preset", "show save-recipe"}};
  for (const auto& [command, shown] : known) {
    Menus menus;
    const std::string path = menus.open(command);
    EXPECT_THAT(texts(menus.screen.click(path, menus)), ElementsAre(shown)) << command;
    const bool is_of_a_file_box = command == "open" || command == "save-preset";
    EXPECT_EQ(menus.palette.begun, is_of_a_file_box ? "" : command);
  }
}

TEST(MenuBar, ShowsShortcutsAndReasons) {
  Menus menus;
  offered_as(menus.model.commands, "undo").why_not = "nothing to undo";
  const std::string path = menus.open("undo");
  const kit::Control& line = menus.screen.at(path);
  EXPECT_FALSE(line.is_enabled);
  EXPECT_EQ(line.value, "Ctrl+Z");
  EXPECT_THAT(line.tooltip, HasSubstr("nothing to undo"));
}

TEST(MenuBar, SaysWhatUndoTakesBack) {
  Menus menus;
  menus.model.undo_title = "Hide particles";
  const std::string path = menus.open("undo");
  EXPECT_TRUE(menus.screen.shows(": Hide particles")) << menus.screen.words();
  EXPECT_THAT(texts(menus.screen.click(path, menus)), ElementsAre("undo"));
}

TEST(MenuBar, ChecksWhatIsOn) {
  Menus menus;
  offered_as(menus.model.commands, "map-only toggle").is_on = true;
  const std::string path = menus.open("map-only toggle");
  EXPECT_TRUE(menus.screen.at(path).is_selected);
}

TEST(MenuBar, OpensARecentFile) {
  Menus menus;
  menus.model.recents = {"/flights/one.nadir", "/flights/two.nadir"};
  EXPECT_THAT(
      texts(menus.screen.click(
          "Menu/File/Open recent/" + std::string("/flights/two.nadir##/flights/two.nadir"), menus)),
      ElementsAre("open /flights/two.nadir"));
}

TEST(MenuBar, SaysThatThereAreNoRecentFiles) {
  Menus menus;
  menus.screen.click("Menu/File", menus);
  menus.screen.hover("Menu/File/Open recent", menus);
  ASSERT_TRUE(menus.screen.has("Menu/File/Open recent/Nothing yet")) << menus.screen.words();
  EXPECT_FALSE(menus.screen.at("Menu/File/Open recent/Nothing yet").is_enabled);
}

TEST(MenuBar, SaysWhatIsOpen) {
  Menus menus;
  menus.model.open_names = {"proving-ground", "loop medium 7", "default"};
  menus.screen.wait(2, menus);
  EXPECT_TRUE(menus.screen.shows("proving-ground  ›  loop medium 7  ›  default"))
      << menus.screen.words();
}

TEST(MenuBar, ShortensLongNamesRatherThanRunIntoItsNeighbours) {
  for (const double width : {960.0, 1280.0}) {
    Menus menus(width);
    menus.model.open_names = {std::string(200, 'm'), std::string(200, 'r'), std::string(200, 'p')};
    menus.screen.wait(2, menus);
    const double left = menus.screen.at("Menu/Help").rect.right();
    for (const kit::Control& control : menus.screen.controls()) {
      if (control.kind != kit::ControlKind::kText) continue;
      EXPECT_GT(control.rect.left, left) << control.label;
      EXPECT_LT(control.rect.right(), width - 100.0) << control.label;
    }
  }
}

TEST(MenuBar, OpensThePaletteByItsButton) {
  Menus menus;
  EXPECT_THAT(texts(menus.screen.click("Menu/Ctrl+P##palette", menus)),
              ElementsAre("show palette"));
}

TEST(MenuBarModel, OfASessionWithNothingOpenHasNoNames) {
  const ScratchFolder folder;
  const Session session({folder.path() / "config", folder.path() / "data", {}});
  const MenuBarModel model = menu_bar_model(session);
  EXPECT_THAT(model.open_names, IsEmpty());
  EXPECT_EQ(model.undo_title, "");
  EXPECT_THAT(model.recents, IsEmpty());
}

}  // namespace menu_bar_test
}  // namespace nadir
