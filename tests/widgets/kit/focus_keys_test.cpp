// SPDX-License-Identifier: Apache-2.0
// Which keys a control keeps from the window, and for how long.
#include <gmock/gmock.h>

#include "tests/widgets/kit/keyed_window.h"

namespace nadir::kit {
namespace focus_keys_test {

using testing::ElementsAre;
using testing::IsEmpty;

/// A number, a slider and a field, with a palette that Ctrl+P opens over them.
struct Options {
  HeadlessUi screen;
  double count = 10.0, share = 0.5;
  bool has_count = true, is_off = false, has_palette = false;
  std::size_t highlighted = 0;
  std::string typed, name = "loop";
  std::vector<std::string> shortcuts, late;
  NumberOptions of_count = {.least = 0.0, .most = 100.0, .decimals = 0, .reset = 50.0};
  NumberOptions of_share = {.least = 0.0, .most = 1.0, .reset = 0.1};

  void operator()(Ui& ui) {
    if (ui.is_pressed("Ctrl+P")) has_palette = true;
    for (const char* const chord : {"Left", "Ctrl+Left", "Ctrl+Right", "Alt+Up", "Ctrl+Delete",
                                    "Delete", "Shift+Left", "Enter", "Escape", "Space", "7"}) {
      if (ui.is_pressed(chord)) shortcuts.emplace_back(chord);
    }
    (void)ui.button("Before");
    {
      const auto pale = ui.disabled(is_off, "not now");
      if (has_count) {
        if (const auto edit = ui.number_input("Count", count, of_count); edit.was_committed)
          count = edit.value;
      }
      if (const auto edit = ui.slider("Share", share, of_share); edit.is_changed)
        share = edit.value;
    }
    if (const auto edit = ui.text_input("Name", name); edit.was_committed) name = edit.value;
    if (has_palette) draw_palette(ui);
    // What lies right of a column asks after it.
    if (ui.is_pressed("Escape")) late.emplace_back("Escape");
  }
  void draw_palette(Ui& ui) {
    const auto box = ui.overlay("Palette");
    typed = ui.search_input("Command", typed, {.takes_focus = true}).value;
    if (ui.is_pressed("Down")) ++highlighted;
    if (box.wants_close()) has_palette = false;
  }
  void press(const std::string& chord) { screen.press(chord, *this); }
};

TEST(NumberKeys, AreNotTheNumbersUnderAPaletteThatOpens) {
  Options options;
  options.screen.click("Count", options);
  options.press("Ctrl+P");
  options.screen.wait(2, options);
  options.press("Down");
  EXPECT_EQ(options.highlighted, 1U);
  options.screen.type_here("seek 7", options);
  options.press("Left");
  options.press("Delete");
  EXPECT_EQ(options.typed, "seek ");
  EXPECT_EQ(options.count, 10.0);
  options.press("Escape");
  EXPECT_FALSE(options.has_palette);
  options.press("Up");
  EXPECT_EQ(options.count, 10.0);
}

TEST(NumberKeys, AreTheWindowsOnceTheNumberIsGoneOrCannotBeChanged) {
  for (const bool is_gone : {true, false}) {
    Options options;
    options.screen.click("Count", options);
    (is_gone ? options.has_count : options.is_off) = !is_gone;
    options.screen.wait(1, options);
    for (const char* const chord : {"Left", "Enter", "7", "Escape"}) options.press(chord);
    EXPECT_THAT(options.shortcuts, ElementsAre("Left", "Enter", "7", "Escape"));
    options.has_count = true;
    options.is_off = false;
    options.press("Left");
    EXPECT_EQ(options.count, 10.0) << "it does not get them back by itself";
  }
}

TEST(NumberKeys, AreTheWindowsAfterAClickOfAnyButtonElsewhere) {
  for (const MouseButton button : {MouseButton::kLeft, MouseButton::kRight}) {
    Options options;
    options.screen.click("Count", options);
    options.screen.click_at("Before", 400.0, 5.0, options, button);
    options.press("Left");
    EXPECT_EQ(options.count, 10.0);
    EXPECT_THAT(options.shortcuts, ElementsAre("Left"));
  }
  Options options;
  options.screen.type("Count", "12", options, false);
  options.screen.click_at("Before", 400.0, 5.0, options);
  options.press("Left");
  EXPECT_EQ(options.count, 12.0) << "what was typed is taken, and that was all";
  EXPECT_THAT(options.shortcuts, ElementsAre("Left"));
}

TEST(ControlKeys, AreNoneWithCtrlOrAlt) {
  const auto chords = {"Ctrl+Left", "Ctrl+Right", "Alt+Up", "Ctrl+Delete"};
  for (const char* const path : {"Count", "Share"}) {
    Options options;
    options.press("Shift+Tab");
    for (int i = 0; i < 3 && focused(options.screen) != path; ++i) options.press("Tab");
    ASSERT_EQ(focused(options.screen), path);
    for (const char* const chord : chords) options.press(chord);
    EXPECT_THAT(options.shortcuts, ElementsAre("Ctrl+Left", "Ctrl+Right", "Alt+Up", "Ctrl+Delete"))
        << path;
    EXPECT_EQ(options.count, 10.0);
    EXPECT_EQ(options.share, 0.5);
  }
  Options clicked;
  clicked.screen.click("Count", clicked);
  for (const char* const chord : chords) clicked.press(chord);
  EXPECT_THAT(clicked.shortcuts, ElementsAre("Ctrl+Left", "Ctrl+Right", "Alt+Up", "Ctrl+Delete"));
  EXPECT_EQ(clicked.count, 10.0);
  clicked.shortcuts.clear();
  clicked.press("Delete");
  EXPECT_EQ(clicked.count, 50.0);
  EXPECT_THAT(clicked.shortcuts, IsEmpty()) << "alone it resets the number and nothing else";
}

TEST(ControlKeys, LeaveShiftWithArrowsToTheWindowAmongTabs) {
  KeyedWindow window;
  std::vector<std::string> shortcuts;
  window.content = [&](Ui& ui) {
    if (ui.is_pressed("Shift+Left")) shortcuts.emplace_back("Shift+Left");
    (void)ui.tabs("Tabs", std::vector<std::string>{"one", "two"}, 0);
  };
  window.press_all({"Shift+Tab", "Shift+Left", "Left"});
  EXPECT_THAT(shortcuts, ElementsAre("Shift+Left"));
  EXPECT_THAT(window.shortcuts, IsEmpty());
}

TEST(ControlKeys, OfSpaceBeginToTypeANumber) {
  Options options;
  options.press("Shift+Tab");
  options.press("Tab");
  ASSERT_EQ(focused(options.screen), "Count");
  options.press("Space");
  options.screen.type_here("42", options);
  options.press("Enter");
  EXPECT_EQ(options.count, 42.0);
  options.press("Space");
  options.press("Tab");
  EXPECT_EQ(focused(options.screen), "Share");
  EXPECT_THAT(options.shortcuts, IsEmpty());
}

TEST(Escape, EndsTypingOrSteppingAndNothingElse) {
  Options options;
  options.screen.click("Name", options);
  options.screen.type_here("town", options);
  options.press("Escape");
  EXPECT_EQ(options.name, "loop");
  EXPECT_THAT(options.late, IsEmpty()) << "also for those that ask after the field was drawn";
  options.screen.click("Count", options);
  options.press("Escape");
  EXPECT_THAT(options.late, IsEmpty());
  EXPECT_THAT(options.shortcuts, IsEmpty());
  options.press("Escape");
  EXPECT_THAT(options.late, ElementsAre("Escape"));
}

TEST(Escape, GivesTheKeyboardBackFromWhatIsGone) {
  Options options;
  options.press("Shift+Tab");
  options.press("Tab");
  ASSERT_EQ(focused(options.screen), "Count");
  options.is_off = true;
  options.screen.wait(2, options);
  EXPECT_EQ(focused(options.screen), "");
  options.is_off = false;
  options.screen.wait(2, options);
  EXPECT_EQ(focused(options.screen), "") << "it does not come back by itself";
  options.press("Escape");
  EXPECT_THAT(options.shortcuts, IsEmpty());
  options.press("Tab");
  EXPECT_EQ(focused(options.screen), "") << "Tab is the window's again";
}

TEST(FocusTooltips, GoAwayAfterAWhile) {
  KeyedWindow window;
  window.content = [](Ui& ui) { (void)ui.icon_button("Close", Icon::kClose, {"Close it", ""}); };
  window.press("Shift+Tab");
  const auto wait_for_s = [&window](int seconds) {
    for (int i = 0; i < 4 * seconds; ++i) {
      window.screen.input().delta_s = 0.25;
      window.screen.frame(window);
    }
  };
  wait_for_s(1);
  EXPECT_EQ(window.screen.tooltip(), "Close it");
  EXPECT_LE(window.screen.context().next_frame_within_s(), 4.0) << "also where nothing else moves";
  wait_for_s(4);
  EXPECT_EQ(window.screen.tooltip(), "") << "it would be in the way of what lies below";
}

}  // namespace focus_keys_test
}  // namespace nadir::kit
