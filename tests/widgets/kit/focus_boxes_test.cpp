// SPDX-License-Identifier: Apache-2.0
// The keyboard in menus, in boxes over the window, and from region to region.
#include <gmock/gmock.h>

#include "tests/widgets/kit/keyed_window.h"

namespace nadir::kit {
namespace focus_boxes_test {

using testing::ElementsAre;
using testing::IsEmpty;

const std::vector<std::string> kItems = {"one", "two", "three"};

/// A bar with two menus, one of which has another in it.
struct Menus : KeyedWindow {
  std::vector<std::string> chosen;
  Menus() {
    content = [this](Ui& ui) {
      const auto item = [&](const std::string& name, const std::string& because = {}) {
        if (ui.menu_item(name, {.disabled_because = because})) chosen.push_back(name);
      };
      {
        const auto bar = ui.menu_bar();
        if (const auto menu = ui.menu("File")) {
          item("New", "not now");
          item("Open");
          if (const auto inner = ui.menu("Recent")) {
            item("Loop");
            item("Town");
          }
        }
        if (const auto menu = ui.menu("Edit")) {
          item("Undo");
          item("Redo");
        }
      }
      (void)ui.button("After");
    };
  }
};

TEST(FocusedMenus, OpenWalkAndChooseByKeys) {
  Menus menus;
  menus.press("Shift+Tab");
  EXPECT_EQ(focused(menus.screen), "File");
  menus.press("Right");
  EXPECT_EQ(focused(menus.screen), "Edit");
  menus.press("Down");
  EXPECT_EQ(focused(menus.screen), "Edit/Undo");
  menus.press_all({"Down", "Enter"});
  EXPECT_THAT(menus.chosen, ElementsAre("Redo"));
  EXPECT_EQ(focused(menus.screen), "Edit");
  menus.press_all({"Enter", "Left"});
  EXPECT_EQ(focused(menus.screen), "File/Open") << "what cannot be chosen is passed over";
  menus.press_all({"Down", "Right"});
  EXPECT_EQ(focused(menus.screen), "File/Recent/Loop");
  menus.press("Left");
  EXPECT_EQ(focused(menus.screen), "File/Recent");
  menus.press_all({"Enter", "Down", "Enter"});
  EXPECT_THAT(menus.chosen, ElementsAre("Redo", "Town"));
  menus.press_all({"Enter", "Escape"});
  EXPECT_EQ(focused(menus.screen), "File");
  menus.press("Tab");
  EXPECT_EQ(focused(menus.screen), "After");
  EXPECT_THAT(menus.shortcuts, IsEmpty());
}

TEST(FocusedMenus, OfControlsOpenByShiftF10) {
  std::vector<std::string> chosen;
  KeyedWindow window;
  window.content = [&](Ui& ui) {
    for (const std::string& name : kItems) {
      (void)ui.button(name);
      if (const auto menu = ui.context_menu("menu of " + name)) {
        if (ui.menu_item("Raise")) chosen.push_back(name);
      }
    }
  };
  window.press_all({"Shift+Tab", "Tab", "Shift+F10"});
  EXPECT_EQ(focused(window.screen), "menu of two/Raise");
  window.press("Enter");
  EXPECT_THAT(chosen, ElementsAre("two"));
  EXPECT_EQ(focused(window.screen), "two");
}

TEST(FocusedBoxes, KeepTheKeyboardAndGiveItBack) {
  bool is_open = false;
  std::vector<std::string> done;
  KeyedWindow window;
  window.content = [&](Ui& ui) {
    (void)ui.button("Before");
    if (ui.button("Open")) is_open = true;
    if (!is_open) return;
    const auto box = ui.overlay("Box");
    (void)ui.text_input("Name", "text", {.takes_focus = true});
    if (ui.button("Do")) done.emplace_back("Do");
    if (ui.button("Cancel") || box.wants_close()) is_open = false;
  };
  window.press_all({"Shift+Tab", "Tab", "Enter"});
  ASSERT_TRUE(is_open);
  EXPECT_EQ(focused(window.screen), "Box/Name");
  window.press("Tab");
  EXPECT_EQ(focused(window.screen), "Box/Do");
  window.press("Enter");
  EXPECT_THAT(done, ElementsAre("Do"));
  window.press_all({"Tab", "Tab"});
  EXPECT_EQ(focused(window.screen), "Box/Name") << "round within the box";
  window.press_all({"Shift+Tab", "Space"});
  EXPECT_FALSE(is_open);
  EXPECT_EQ(focused(window.screen), "Open");
  window.press("Enter");
  window.press_all({"Tab", "Escape"});
  EXPECT_FALSE(is_open) << "Escape closes the box first";
  EXPECT_EQ(focused(window.screen), "Open");
}

TEST(FocusedBoxes, AreWalkedByTabAloneHoweverTheyOpened) {
  bool is_open = false;
  KeyedWindow window;
  window.content = [&](Ui& ui) {
    if (ui.button("Open")) is_open = true;
    if (!is_open) return;
    const auto box = ui.overlay("Box");
    (void)ui.button("Do");
    (void)ui.button("Cancel");
  };
  window.screen.click("Open", window);
  EXPECT_EQ(focused(window.screen), "");
  window.press("Tab");
  EXPECT_EQ(focused(window.screen), "Box/Do");
  EXPECT_THAT(window.shortcuts, IsEmpty());
}

TEST(FocusedBoxes, AreBegunAtTheirFirstControlWhereverTheMouseWas) {
  bool is_open = false;
  KeyedWindow window;
  window.content = [&](Ui& ui) {
    for (const std::string& item : kItems) (void)ui.button(item);
    if (ui.button("Open")) is_open = true;
    if (!is_open) return;
    const auto box = ui.overlay("Box");
    for (const std::string& item : kItems) (void)ui.button(item);
    if (box.wants_close()) is_open = false;
  };
  window.screen.click("Open", window);
  window.press("Tab");
  EXPECT_EQ(focused(window.screen), "Box/one");
  window.press_all({"Tab", "Escape"});
  ASSERT_FALSE(is_open);
  window.press_all({"Shift+Tab", "Shift+Tab"});
  EXPECT_EQ(focused(window.screen), "three") << "and below it goes on where it was";
}

TEST(FocusedBoxes, ThatTakeThePlaceOfOthersTakeTheKeyboard) {
  std::string open;
  KeyedWindow window;
  window.content = [&](Ui& ui) {
    if (ui.button("Open")) open = "First";
    if (open.empty()) return;
    const auto box = ui.overlay(open);
    if (ui.button("Do")) open = open == "First" ? "Second" : "First";
    if (box.wants_close()) open.clear();
  };
  window.press_all({"Shift+Tab", "Enter"});
  EXPECT_EQ(focused(window.screen), "First/Do");
  window.press("Enter");
  EXPECT_EQ(focused(window.screen), "Second/Do");
  window.press("Enter");
  EXPECT_EQ(focused(window.screen), "First/Do");
  window.press("Escape");
  EXPECT_EQ(focused(window.screen), "Open");
}

TEST(FocusedRegions, AreGoneThroughByCtrlTab) {
  KeyedWindow window;
  window.screen.leave_out_region();
  window.content = [](Ui& ui) {
    double left = 0.0;
    for (const char* const name : {"Left", "Middle", "Right"}) {
      const auto region = ui.region(name, {left, 0.0, 300.0, 400.0});
      for (const std::string& item : kItems) (void)ui.button(item);
      left += 300.0;
    }
  };
  window.press("Ctrl+Tab");
  EXPECT_EQ(focused(window.screen), "Left/one");
  window.press_all({"Tab", "Ctrl+Tab"});
  EXPECT_EQ(focused(window.screen), "Middle/one");
  window.press_all({"Ctrl+Tab", "Ctrl+Tab"});
  EXPECT_EQ(focused(window.screen), "Left/one");
  window.press("Ctrl+Shift+Tab");
  EXPECT_EQ(focused(window.screen), "Right/one");
}

}  // namespace focus_boxes_test
}  // namespace nadir::kit
