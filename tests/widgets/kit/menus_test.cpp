// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "widgets/kit/headless_ui.h"

namespace nadir::kit {
namespace menus_test {

/// A menu bar in a region; what was chosen comes back.
std::vector<std::string> draw_menus(Ui& ui) {
  std::vector<std::string> chosen;
  const auto region = ui.region("Menu", {0.0, 0.0, 600.0, 40.0});
  const auto bar = ui.menu_bar();
  if (const auto file = ui.menu("File")) {
    if (ui.menu_item("Open…", {"Ctrl+O", Icon::kFolder})) chosen.emplace_back("open");
    if (ui.menu_item("Save", {"Ctrl+S", Icon::kNone, false, "No run is open"}))
      chosen.emplace_back("save");
    ui.menu_line();
    if (const auto recent = ui.menu("Recent")) {
      if (ui.menu_item("loop 7")) chosen.emplace_back("loop 7");
    }
  }
  if (const auto view = ui.menu("View")) {
    if (ui.menu_item("North up", {"N", Icon::kNone, true, "", "The map's north is up"}))
      chosen.emplace_back("north");
  }
  return chosen;
}

TEST(Menus, OpenOnTheWayToAnItem) {
  HeadlessUi screen;
  EXPECT_THAT(screen.click("Menu/File/Open…", draw_menus), testing::ElementsAre("open"));
  screen.wait(2, draw_menus);
  EXPECT_FALSE(screen.has("Menu/File/Open…")) << "closed by the choice";
  EXPECT_EQ(screen.at("Menu/File").value, "closed");
}

TEST(Menus, OpenWithinMenus) {
  HeadlessUi screen;
  EXPECT_THAT(screen.click("Menu/File/Recent/loop 7", draw_menus), testing::ElementsAre("loop 7"));
}

TEST(Menus, FollowTheMouseOnceOneIsOpen) {
  HeadlessUi screen;
  (void)screen.click("Menu/File", draw_menus);
  (void)screen.wait(2, draw_menus);
  EXPECT_TRUE(screen.has("Menu/File/Save"));
  screen.input().mouse_px = screen.at("Menu/View").rect.centre();
  (void)screen.wait(3, draw_menus);
  EXPECT_TRUE(screen.has("Menu/View/North up"));
  EXPECT_FALSE(screen.has("Menu/File/Save"));
  EXPECT_TRUE(screen.at("Menu/View/North up").is_selected);
  (void)screen.press("Escape", draw_menus);
  (void)screen.wait(2, draw_menus);
  EXPECT_FALSE(screen.has("Menu/View/North up"));
}

TEST(Menus, DoNotOpenByHoveringAlone) {
  HeadlessUi screen;
  (void)screen.hover("Menu/File", draw_menus);
  EXPECT_FALSE(screen.has("Menu/File/Save"));
}

TEST(Menus, SayWhyAnItemCannotBeChosen) {
  HeadlessUi screen;
  (void)screen.click("Menu/File", draw_menus);
  (void)screen.wait(2, draw_menus);
  EXPECT_FALSE(screen.at("Menu/File/Save").is_enabled);
  EXPECT_EQ(screen.at("Menu/File/Save").tooltip, "No run is open");
  EXPECT_EQ(screen.at("Menu/File/Open…").value, "Ctrl+O");
  EXPECT_THROW((void)screen.click("Menu/File/Save", draw_menus), std::logic_error);
}

TEST(Menus, KeepKeysForThemselvesWhileTheyAreOpen) {
  HeadlessUi screen;
  bool was_pressed = false;
  const auto draw = [&was_pressed](Ui& ui) {
    was_pressed = was_pressed || ui.is_pressed("Escape") || ui.is_pressed("N");
    (void)draw_menus(ui);
  };
  screen.click("Menu/File", draw);
  screen.press("N", draw);
  screen.press("Escape", draw);
  EXPECT_FALSE(was_pressed);
  screen.wait(1, draw);
  screen.press("N", draw);
  EXPECT_TRUE(was_pressed);
}

TEST(ContextMenus, OpenAtTheRightButtonOnTheLastControl) {
  HeadlessUi screen;
  int copies = 0;
  const auto draw = [&copies](Ui& ui) {
    (void)ui.list_row("alpha");
    if (const auto menu = ui.context_menu("Row menu")) {
      if (ui.menu_item("Copy")) ++copies;
    }
    (void)ui.list_row("beta");
  };
  screen.right_click("beta", draw);
  screen.wait(2, draw);
  EXPECT_FALSE(screen.has("Row menu/Copy"));
  screen.right_click("alpha", draw);
  screen.wait(2, draw);
  screen.click("Row menu/Copy", draw);
  EXPECT_EQ(copies, 1);
}

TEST(ContextMenus, DoNotOpenAtTheEndOfADrag) {
  HeadlessUi screen;
  const auto draw = [](Ui& ui) {
    (void)ui.area("map", {400.0, 300.0});
    if (const auto menu = ui.context_menu("Map menu")) (void)ui.menu_item("Copy");
  };
  screen.drag("map", 60.0, 0.0, draw, MouseButton::kRight);
  screen.wait(2, draw);
  EXPECT_FALSE(screen.has("Map menu/Copy"));
  screen.right_click("map", draw);
  screen.wait(2, draw);
  EXPECT_TRUE(screen.has("Map menu/Copy"));
}

TEST(ButtonMenus, OpenUnderTheirButton) {
  HeadlessUi screen;
  const auto draw = [](Ui& ui) {
    bool was_chosen = false;
    if (const auto menu = ui.button_menu("Strips", Icon::kMore, {"Choose strips", ""}))
      was_chosen = ui.menu_item("Error");
    return was_chosen;
  };
  EXPECT_TRUE(screen.click("Strips/Error", draw));
  EXPECT_EQ(screen.at("Strips").kind, ControlKind::kMenu);
}

TEST(Notices, StandAboveEachOtherAndAskForWhatWasClicked) {
  HeadlessUi screen;
  const std::vector<Notice> notices = {
      {"a", Level::kGood, "The figure was written.", "", "Open the folder"},
      {"b", Level::kBad, "maps/town.png: the file is cut short.", "libpng: read error"}};
  const auto draw = [&notices](Ui& ui) { return ui.notices(notices, ui.screen()); };
  (void)screen.wait(3, draw);
  EXPECT_LT(screen.at("Notices/a").rect.bottom(), screen.at("Notices/b").rect.top);
  EXPECT_NEAR(screen.at("Notices/b").rect.bottom(), 800.0 - 12.0, 1.0);
  const auto dismissed = screen.click("Notices/a/Dismiss", draw);
  ASSERT_TRUE(dismissed);
  EXPECT_EQ(dismissed->id, "a");
  EXPECT_EQ(dismissed->kind, NoticeWish::Kind::kDismiss);
  EXPECT_EQ(screen.click("Notices/a/Open the folder", draw)->kind, NoticeWish::Kind::kAction);
  EXPECT_EQ(screen.click("Notices/b/Copy", draw)->kind, NoticeWish::Kind::kCopy);
  EXPECT_FALSE(screen.shows("libpng"));
  (void)screen.click("Notices/b/Details", draw);
  (void)screen.wait(2, draw);
  EXPECT_TRUE(screen.shows("libpng: read error"));
}

TEST(ContextMenus, OpenOnAnotherPartOfTheRowToo) {
  HeadlessUi screen;
  int chosen = 0;
  const auto draw = [&](Ui& ui) {
    (void)ui.icon_button("Part", Icon::kEye, {"Part of the row", ""});
    ui.opens_context_menu("row");
    ui.same_line();
    ui.text("Title");
    if (const auto menu = ui.context_menu("row")) chosen += ui.menu_item("Raise") ? 1 : 0;
  };
  for (const char* const part : {"Part", "Title"}) {
    screen.right_click(part, draw);
    screen.click("row/Raise", draw);
  }
  EXPECT_EQ(chosen, 2);
  screen.press("Shift+Tab", draw);
  screen.press("Shift+F10", draw);
  screen.wait(2, draw);
  EXPECT_TRUE(screen.has("row/Raise"));
}

}  // namespace menus_test
}  // namespace nadir::kit
