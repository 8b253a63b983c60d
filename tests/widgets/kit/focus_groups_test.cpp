// SPDX-License-Identifier: Apache-2.0
// The keyboard among things of which one is chosen, in rows and on handles, and in inputs.
#include <gmock/gmock.h>

#include "tests/widgets/kit/keyed_window.h"

namespace nadir::kit {
namespace focus_groups_test {

using testing::ElementsAre;
using testing::IsEmpty;

const std::vector<std::string> kItems = {"one", "two", "three"};

TEST(FocusedChoices, AreOneStopAndChosenByArrows) {
  std::size_t pose = 1, way = 0, tab = 2;
  KeyedWindow window;
  window.content = [&](Ui& ui) {
    if (const auto chosen = ui.tabs("Tabs", kItems, tab)) tab = *chosen;
    if (const auto chosen = ui.choice("Pose", kItems, pose)) pose = *chosen;
    if (const auto chosen = ui.radio("Way", kItems, way)) way = *chosen;
    (void)ui.button("After");
  };
  window.press("Shift+Tab");
  EXPECT_EQ(focused(window.screen), "Tabs/three") << "what is chosen stands for all";
  window.press("Left");
  EXPECT_EQ(tab, 1U);
  window.press("Tab");
  EXPECT_EQ(focused(window.screen), "Pose/two");
  window.press_all({"Right", "Right", "Right"});
  EXPECT_EQ(pose, 2U);
  EXPECT_EQ(focused(window.screen), "Pose/three");
  window.press("Home");
  EXPECT_EQ(pose, 0U);
  window.press("Tab");
  EXPECT_EQ(focused(window.screen), "Way/one");
  window.press("Down");
  EXPECT_EQ(way, 1U);
  EXPECT_THAT(window.shortcuts, IsEmpty());
  window.press("Tab");
  EXPECT_EQ(focused(window.screen), "After");
  window.press("Shift+Tab");
  EXPECT_EQ(focused(window.screen), "Way/two");
  window.press("Shift+Tab");
  window.press("Up");
  EXPECT_THAT(window.shortcuts, ElementsAre("Up")) << "beside each other they need none of those";
}

TEST(FocusedRows, AreGoneThroughByArrowsWithWhatLiesOnThem) {
  std::vector<std::string> clicked;
  KeyedWindow window;
  window.content = [&](Ui& ui) {
    for (const std::string& item : kItems) {
      if (ui.list_row(item, {.is_selected = item == "two"})) clicked.push_back(item);
      ui.same_line();
      ui.right_align(ui.px(28.0));
      (void)ui.eye("eye of " + item, true);
    }
  };
  window.press("Shift+Tab");
  EXPECT_EQ(focused(window.screen), "eye of one");
  window.press("Tab");
  EXPECT_EQ(focused(window.screen), "two") << "what is chosen stands for all rows";
  window.press("Down");
  window.press("Enter");
  window.press_all({"Home", "Space"});
  EXPECT_THAT(clicked, ElementsAre("three", "one"));
  window.press("Tab");
  EXPECT_EQ(focused(window.screen), "eye of one");
  window.press_all({"Tab", "Tab", "Tab"});
  EXPECT_EQ(focused(window.screen), "eye of three");
  EXPECT_THAT(window.shortcuts, IsEmpty());
  window.press("Right");
  EXPECT_THAT(window.shortcuts, ElementsAre("Right"));
}

TEST(FocusedRows, OfLongTablesComeIntoSight) {
  std::size_t chosen = 0;
  KeyedWindow window;
  window.content = [&](Ui& ui) {
    const std::vector<Column> columns = {{.title = "Name"}};
    const auto table = ui.table("Names", columns, {.height = 200.0});
    if (!table) return;
    ui.clipped_table_rows(500, [&](std::size_t i) {
      if (ui.row(std::to_string(i), i == chosen)) chosen = i;
      ui.cell(std::to_string(i));
    });
  };
  window.press("Shift+Tab");
  for (int i = 0; i < 60; ++i) window.press("Down");
  window.press("Enter");
  EXPECT_EQ(chosen, 60U);
  for (int i = 0; i < 30; ++i) window.press("Up");
  window.press("Enter");
  EXPECT_EQ(chosen, 30U);
}

TEST(FocusedLists, OpenAndCloseByKeys) {
  std::size_t chosen = 1;
  KeyedWindow window;
  window.content = [&](Ui& ui) {
    if (const auto picked = ui.combo("Preset", kItems, chosen)) chosen = *picked;
    (void)ui.button("After");
  };
  for (const char* const opens : {"Enter", "Space", "Down"}) {
    chosen = 1;
    window.press(focused(window.screen).empty() ? "Shift+Tab" : "Home");
    window.press(opens);
    EXPECT_EQ(focused(window.screen), "Preset/two") << opens;
    window.press_all({"Down", "Enter"});
    EXPECT_EQ(chosen, 2U);
    EXPECT_EQ(focused(window.screen), "Preset") << "it is where it was";
  }
  window.press_all({"Enter", "Up", "Escape"});
  EXPECT_EQ(chosen, 2U);
  EXPECT_EQ(focused(window.screen), "Preset");
  window.shortcuts.clear();
  window.press("Tab");
  EXPECT_EQ(focused(window.screen), "After");
  EXPECT_THAT(window.shortcuts, IsEmpty());
}

TEST(FocusedHandles, MoveTheWayTheArrowsPoint) {
  double left = 200.0, right = 300.0, below = 150.0;
  std::size_t place = 1;
  KeyedWindow window;
  window.screen.leave_out_region();
  window.content = [&](Ui& ui) {
    {
      const auto region = ui.region("List", {0.0, 0.0, 100.0, 100.0});
      if (const auto edit = ui.grip("Grip", place, 3, 28.0); edit.was_committed) place = edit.value;
    }
    left =
        ui.splitter("Left", {200.0, 0.0, 6.0, 400.0}, Axis::kHorizontal, left, 100.0, 400.0).value;
    right =
        ui.splitter("Right", {700.0, 0.0, 6.0, 400.0}, Axis::kHorizontal, right, 100.0, 400.0, true)
            .value;
    below =
        ui.splitter("Below", {0.0, 500.0, 900.0, 6.0}, Axis::kVertical, below, 100.0, 160.0, true)
            .value;
  };
  window.press_all({"Shift+Tab", "Down", "Down"});
  EXPECT_EQ(place, 2U) << "not beyond the end";
  window.press("Up");
  EXPECT_EQ(place, 1U);
  window.press_all({"Tab", "Right"});
  EXPECT_EQ(left, 216.0);
  window.press_all({"Tab", "Right"});
  EXPECT_EQ(right, 284.0);
  window.press_all({"Tab", "Up"});
  EXPECT_EQ(below, 160.0);
  EXPECT_THAT(window.shortcuts, ElementsAre()) << "a handle keeps its arrows";
}

TEST(FocusedInputs, ThatCompleteByTabAreLeftByShiftTab) {
  int completions = 0;
  KeyedWindow window;
  window.content = [&](Ui& ui) {
    (void)ui.button("Before");
    const auto edit = ui.text_input("Name", "fl", {.takes_focus = true, .takes_tab = true});
    completions += edit.wants_completion ? 1 : 0;
    (void)ui.button("After");
  };
  window.screen.wait(3, window);
  window.press("Tab");
  EXPECT_EQ(completions, 1);
  EXPECT_EQ(focused(window.screen), "");
  window.press("Shift+Tab");
  EXPECT_EQ(focused(window.screen), "Before");
  EXPECT_EQ(completions, 1);
}

TEST(FocusedLines, AreTypedIntoAndLeftByTab) {
  std::string note = "first";
  KeyedWindow window;
  window.content = [&](Ui& ui) {
    if (const auto edit = ui.text_input("Note", note, {.is_multiline = true}); edit.was_committed)
      note = edit.value;
    (void)ui.button("After");
  };
  window.press_all({"Shift+Tab", "End"});
  window.screen.type_here(" lap", window);
  window.press("Tab");
  EXPECT_EQ(note, "first lap");
  EXPECT_EQ(focused(window.screen), "After");
  EXPECT_THAT(window.shortcuts, IsEmpty());
}

}  // namespace focus_groups_test
}  // namespace nadir::kit
