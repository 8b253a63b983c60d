// SPDX-License-Identifier: Apache-2.0
// The keyboard goes from control to control, and every control can be used by it alone.
#include <gmock/gmock.h>

#include <algorithm>

#include "tests/widgets/kit/keyed_window.h"
#include "widgets/kit/ui_look.h"

namespace nadir::kit {
namespace focus_test {

using testing::ElementsAre;
using testing::IsEmpty;

/// One of each, and what was asked of them. The window has shortcuts of its own.
struct Panel {
  HeadlessUi screen;
  bool is_on = false, is_seen = false;
  double share = 0.5, count = 10.0;
  std::string name = "loop";
  std::vector<std::string> done, shortcuts;
  NumberOptions of_share = {.least = 0.0, .most = 1.0, .reset = 0.5};
  NumberOptions of_count = {.least = 0.0, .most = 100.0, .decimals = 0, .reset = 10.0};

  void operator()(Ui& ui) {
    for (const char* const chord : {"Space", "Enter", "Left", "Right", "Up", "Down", "Home", "[",
                                    "7", "-", "G", "Tab", "Escape", "Delete", "Ctrl+Left"}) {
      if (ui.is_pressed(chord, true)) shortcuts.emplace_back(chord);
    }
    if (ui.button("Go")) done.emplace_back("Go");
    if (ui.icon_button("Close", Icon::kClose, {"Close it", ""})) done.emplace_back("Close");
    if (const auto on = ui.checkbox("Check", is_on)) is_on = *on;
    if (const auto seen = ui.eye("Eye", is_seen)) is_seen = *seen;
    if (ui.link("Link")) done.emplace_back("Link");
    {
      const auto pale = ui.disabled(true, "never");
      if (ui.button("Pale")) done.emplace_back("Pale");
    }
    (void)ui.area("Area", {100.0, 40.0});
    if (const auto edit = ui.slider("Share", share, of_share); edit.is_changed) share = edit.value;
    if (const auto edit = ui.number_input("Count", count, of_count); edit.was_committed)
      count = edit.value;
    if (const auto edit = ui.text_input("Name", name); edit.was_committed) name = edit.value;
    if (const auto part = ui.section("Part")) (void)ui.button("Inside");
  }
  void press(const std::string& chord) { screen.press(chord, *this); }
  /// Goes on until that has the keyboard; fails where it never has.
  void walk_to(const std::string& path) {
    if (focused(screen).empty()) press("Shift+Tab");
    for (int i = 0; i < 40 && focused(screen) != path; ++i) press("Tab");
    ASSERT_EQ(focused(screen), path);
  }
};

TEST(Focus, IsNowhereUntilShiftTab) {
  Panel panel;
  for (const char* const chord : {"Tab", "Space", "Right", "["}) panel.press(chord);
  EXPECT_EQ(focused(panel.screen), "");
  EXPECT_THAT(panel.shortcuts, ElementsAre("Tab", "Space", "Right", "["));
  panel.press("Shift+Tab");
  EXPECT_EQ(focused(panel.screen), "Go");
}

TEST(Focus, GoesThroughAllThatCanBeUsedAndRoundAgain) {
  Panel panel;
  panel.press("Shift+Tab");
  std::vector<std::string> way;
  for (int i = 0; i < 11; ++i) {
    way.push_back(focused(panel.screen));
    panel.press("Tab");
  }
  EXPECT_THAT(way, ElementsAre("Go", "Close", "Check", "Eye", "Link", "Share", "Share/value",
                               "Count", "Name", "Part", "Part/Inside"));
  EXPECT_EQ(focused(panel.screen), "Go");
  std::reverse(way.begin(), way.end());
  std::vector<std::string> back;
  for (int i = 0; i < 11; ++i) {
    panel.press("Shift+Tab");
    back.push_back(focused(panel.screen));
  }
  EXPECT_EQ(back, way);
  EXPECT_THAT(panel.shortcuts, IsEmpty()) << "Tab is none while it walks";
  EXPECT_THAT(panel.done, IsEmpty());
}

TEST(Focus, PressesWithSpaceAndEnterOnceAndKeepsThemFromTheWindow) {
  for (const char* const key : {"Space", "Enter"}) {
    Panel panel;
    for (const char* const path : {"Go", "Close", "Check", "Eye", "Link", "Part"}) {
      panel.walk_to(path);
      panel.press(key);
    }
    EXPECT_THAT(panel.done, ElementsAre("Go", "Close", "Link")) << key;
    EXPECT_TRUE(panel.is_on);
    EXPECT_TRUE(panel.is_seen);
    EXPECT_EQ(panel.screen.at("Part").value, "closed");
    EXPECT_THAT(panel.shortcuts, IsEmpty()) << key;
  }
}

TEST(Focus, LeavesAllOtherShortcutsToTheWindow) {
  Panel panel;
  panel.walk_to("Go");
  for (const char* const chord : {"Left", "Right", "Up", "Home", "[", "7", "-", "G", "Ctrl+Left"})
    panel.press(chord);
  EXPECT_THAT(panel.shortcuts,
              ElementsAre("Left", "Right", "Up", "Home", "[", "7", "-", "G", "Ctrl+Left"));
}

TEST(Focus, GoesBackToTheWindowByEscapeOrTheMouse) {
  Panel panel;
  panel.walk_to("Close");
  panel.press("Escape");
  EXPECT_EQ(focused(panel.screen), "");
  EXPECT_THAT(panel.shortcuts, IsEmpty()) << "that Escape did no more than this";
  panel.press("Space");
  panel.press("Escape");
  EXPECT_THAT(panel.shortcuts, ElementsAre("Space", "Escape"));
  EXPECT_THAT(panel.done, IsEmpty());
  panel.press("Shift+Tab");
  EXPECT_EQ(focused(panel.screen), "Close") << "it goes on where it was";
  panel.screen.click("Check", panel);
  EXPECT_EQ(focused(panel.screen), "");
  panel.press("Space");
  EXPECT_TRUE(panel.is_on) << "the mouse did that; Space is the window's again";
  EXPECT_THAT(panel.shortcuts, ElementsAre("Space", "Escape", "Space"));
  panel.press("Shift+Tab");
  EXPECT_EQ(focused(panel.screen), "Check") << "and to what the mouse used last";
}

TEST(Focus, MovesSlidersByArrowsAndResetsThemByDelete) {
  Panel panel;
  panel.walk_to("Share");
  panel.press("Right");
  panel.press("Up");
  EXPECT_NEAR(panel.share, 0.54, 1e-9);
  panel.press("Shift+Left");
  EXPECT_NEAR(panel.share, 0.34, 1e-9);
  for (int i = 0; i < 4; ++i) panel.press("Shift+Right");
  EXPECT_EQ(panel.share, 1.0) << "not beyond its end";
  panel.press("Delete");
  EXPECT_EQ(panel.share, 0.5);
  EXPECT_THAT(panel.shortcuts, IsEmpty());
}

TEST(Focus, StepsNumbersAndTypesIntoThem) {
  Panel panel;
  panel.walk_to("Count");
  panel.press("Up");
  panel.press("Left");
  panel.press("Shift+Right");
  EXPECT_EQ(panel.count, 20.0);
  panel.press("7");
  panel.press("3");
  EXPECT_EQ(panel.screen.at("Count").value, "20") << "what is typed is not taken yet";
  panel.press("Enter");
  EXPECT_EQ(panel.count, 73.0);
  EXPECT_EQ(focused(panel.screen), "Count");
  panel.press("Delete");
  EXPECT_EQ(panel.count, 10.0);
  panel.press("Enter");
  panel.screen.type_here("42", panel);
  panel.press("Tab");
  EXPECT_EQ(panel.count, 42.0) << "Tab takes it, as a click elsewhere does";
  EXPECT_EQ(focused(panel.screen), "Name");
  EXPECT_THAT(panel.shortcuts, IsEmpty());
}

TEST(Focus, TypesIntoTextsAndLeavesThemByTab) {
  Panel panel;
  panel.walk_to("Name");
  panel.screen.type_here("7 laps [G]", panel);
  EXPECT_THAT(panel.shortcuts, IsEmpty()) << "no shortcut is in a text";
  EXPECT_EQ(panel.name, "loop");
  panel.press("Tab");
  EXPECT_EQ(panel.name, "7 laps [G]");
  EXPECT_EQ(focused(panel.screen), "Part");
  panel.press("Shift+Tab");
  panel.screen.type_here("other", panel);
  panel.press("Escape");
  EXPECT_EQ(panel.name, "7 laps [G]");
  EXPECT_EQ(focused(panel.screen), "Name") << "Escape ends the typing first";
  panel.press("Enter");
  panel.screen.type_here("other", panel);
  panel.press("Enter");
  EXPECT_EQ(panel.name, "other");
  EXPECT_THAT(panel.shortcuts, IsEmpty());
}

TEST(Focus, GoesOnBesideWhatIsGone) {
  HeadlessUi screen;
  bool has_second = true;
  const auto draw = [&](Ui& ui) {
    (void)ui.button("First");
    if (has_second && ui.button("Second")) has_second = false;
    (void)ui.button("Third");
    return ui.is_pressed("Space");
  };
  screen.press("Shift+Tab", draw);
  screen.press("Tab", draw);
  EXPECT_FALSE(screen.press("Space", draw));
  ASSERT_FALSE(has_second);
  EXPECT_TRUE(screen.press("Space", draw)) << "nothing has the keyboard";
  screen.press("Tab", draw);
  EXPECT_EQ(focused(screen), "Third");
}

TEST(Focus, ExplainsWhatItComesToAsTheMouseDoes) {
  Panel panel;
  panel.walk_to("Close");
  panel.screen.input().delta_s = 0.5;
  panel.screen.frame(panel);
  panel.screen.frame(panel);
  EXPECT_EQ(panel.screen.tooltip(), "Close it");
}

TEST(Focus, BringsIntoSightWhatItComesTo) {
  HeadlessUi screen(ThemeName::kDark, 1.0, {300.0, 200.0});
  const auto draw = [](Ui& ui) {
    for (int i = 0; i < 40; ++i) (void)ui.button(std::to_string(i));
  };
  screen.press("Shift+Tab", draw);
  for (int i = 0; i < 25; ++i) screen.press("Tab", draw);
  screen.wait(2, draw);
  ASSERT_EQ(focused(screen), "25");
  EXPECT_GE(screen.at("25").rect.top, 0.0);
  EXPECT_LE(screen.at("25").rect.bottom(), 200.0);
}

TEST(FocusFrames, StandOutFromAllGroundsInBothThemes) {
  for (const ThemeName name : {ThemeName::kLight, ThemeName::kDark}) {
    const Theme& the_theme = theme(name);
    // The frame has the accent's colour, and a line of the page's within it.
    for (const Rgba ground : {the_theme.page, the_theme.window}) {
      EXPECT_GE(contrast(the_theme.accent, ground), 3.0);
    }
    const Look look = look_of(the_theme);
    const auto channel = [](std::uint32_t colour, unsigned shift) {
      return static_cast<std::uint8_t>((colour >> shift) & 0xFFU);
    };
    for (const std::uint32_t ground : {look.raised, look.hovered, look.held, look.panel}) {
      const Rgba colour{channel(ground, 0), channel(ground, 8), channel(ground, 16)};
      EXPECT_GE(contrast(the_theme.accent, colour), 3.0);
    }
  }
}

}  // namespace focus_test
}  // namespace nadir::kit
