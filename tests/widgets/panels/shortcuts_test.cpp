// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/shortcuts.h"

#include <gmock/gmock.h>

#include "tests/widgets/panels/asked.h"
#include "widgets/kit/headless_ui.h"
#include "widgets/panels/shortcut_sheet.h"

namespace nadir {
namespace shortcuts_test {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(CommandOf, FindsEveryShortcutOfTheTable) {
  for (const Command& command : session_commands()) {
    if (command.shortcut.empty() || command.menu == kLabelMenu) continue;
    const auto chord = kit::parse_chord(command.shortcut);
    ASSERT_TRUE(chord) << command.shortcut;
    EXPECT_EQ(command_of(*chord), &command) << command.shortcut;
  }
}

TEST(PressedCommand, IsOnLabelsOnlyWhileTheyAreDrawn) {
  for (const bool draws_labels : {false, true}) {
    kit::HeadlessUi screen;
    std::string pressed;
    screen.press("B", [&](kit::Ui& ui) {
      const Command* const command = pressed_command(ui, false, draws_labels);
      if (command != nullptr) pressed = command->text;
    });
    EXPECT_EQ(pressed, draws_labels ? "label-option tool brush" : "bookmark");
    screen.press("Ctrl+Z", [&](kit::Ui& ui) {
      const Command* const command = pressed_command(ui, false, draws_labels);
      if (command != nullptr) pressed = command->text;
    });
    EXPECT_EQ(pressed, "undo") << "what labels have no key for stays";
  }
}

TEST(PressedCommand, LeavesTheFlightWhereItIsWhileLabelsAreDrawn) {
  for (const char* const key : {"[", "]", "Space", "Left", "Up", "Home", "W", "Ctrl+Right"}) {
    for (const bool draws_labels : {false, true}) {
      kit::HeadlessUi screen;
      bool is_pressed = false;
      screen.press(key, [&](kit::Ui& ui) {
        is_pressed = is_pressed || pressed_command(ui, false, draws_labels) != nullptr;
      });
      EXPECT_EQ(is_pressed, !draws_labels) << key;
    }
  }
}

TEST(CommandOf, KnowsNoCommandForOtherKeys) {
  EXPECT_EQ(command_of({.key = kit::Key::kF12, .modifiers = {.ctrl = true, .alt = true}}), nullptr);
  EXPECT_EQ(command_of({}), nullptr);
}

TEST(RepeatsWhileHeld, IsForWhatIsDoneBySmallSteps) {
  EXPECT_TRUE(repeats_while_held({"step 1", "", "", "", true}));
  EXPECT_TRUE(repeats_while_held({"undo", "", "", "", true}));
  EXPECT_FALSE(repeats_while_held({"play toggle", "", "", "", true}));
  EXPECT_FALSE(repeats_while_held({"stepladder", "", "", "", true}));
}

/// Presses a chord over an empty window, or one with an input that takes text.
std::string pressed(const std::string& chord, bool has_overlay = false, bool types_text = false) {
  kit::HeadlessUi screen;
  std::string text, typed = "a";
  const auto draw = [&](kit::Ui& ui) {
    if (const Command* const command = pressed_command(ui, has_overlay)) text = command->text;
    if (types_text) typed = ui.text_input("Note", typed, {.takes_focus = true}).value;
  };
  screen.wait(4, draw);
  screen.press(chord, draw);
  return text;
}

TEST(PressedCommand, IsTheOneWhoseKeysWentDown) {
  EXPECT_EQ(pressed("Space"), "play toggle");
  EXPECT_EQ(pressed("Ctrl+Z"), "undo");
  EXPECT_EQ(pressed("Ctrl+P"), "show palette");
  EXPECT_EQ(pressed("?"), "show shortcuts");
  EXPECT_EQ(pressed("Ctrl+Alt+F12"), "");
}

TEST(PressedCommand, IsNoneWhileTheKeyIsTyped) {
  EXPECT_EQ(pressed("Space", false, true), "");
  EXPECT_EQ(pressed("F", false, true), "");
  EXPECT_EQ(pressed("Ctrl+Z", false, true), "");
  EXPECT_EQ(pressed("Ctrl+P", false, true), "show palette");
}

TEST(PressedCommand, LeavesTheWindowAloneWhileSomethingLiesOverIt) {
  EXPECT_EQ(pressed("Space", true), "");
  EXPECT_EQ(pressed("Ctrl+P", true), "show palette");
}

struct Sheet {
  Sheet() {
    model.is_open = true;
    model.commands = all_offered();
  }
  kit::HeadlessUi screen;
  ShortcutSheetModel model;
  ShortcutSheetState state;
  PaletteState palette;
  Actions operator()(kit::Ui& ui) { return draw_shortcut_sheet(ui, model, state, palette); }
};

TEST(ShortcutSheet, DrawsNothingWhileItIsClosed) {
  Sheet sheet;
  sheet.model.is_open = false;
  EXPECT_THAT(sheet.screen.wait(2, sheet), IsEmpty());
  EXPECT_FALSE(sheet.screen.has("Shortcuts"));
}

TEST(ShortcutSheet, FindsACommandByItsNameOrItsKey) {
  for (const char* const words : {"palette", "ctrl+p"}) {
    Sheet sheet;
    sheet.screen.wait(3, sheet);
    sheet.screen.type("Shortcuts/Search", words, sheet, false);
    EXPECT_TRUE(sheet.screen.shows("Ctrl+P")) << words;
    EXPECT_FALSE(sheet.screen.shows("Ctrl+Z")) << words;
  }
}

TEST(ShortcutSheet, HasEveryShortcut) {
  Sheet sheet;
  sheet.screen.wait(3, sheet);
  for (const OfferedCommand& offered : sheet.model.commands) {
    const Command& command = *offered.command;
    if (command.shortcut.empty()) continue;
    const std::string path = "Shortcuts/" + std::string(command.menu) + "/" + line_of(command.text);
    ASSERT_TRUE(sheet.screen.has(path)) << path;
    EXPECT_EQ(sheet.screen.at(path).value, command.shortcut);
  }
  EXPECT_TRUE(sheet.screen.shows("wheel"));
}

TEST(ShortcutSheet, TellsHowThePanelsAreUsedByTheKeyboard) {
  Sheet sheet;
  sheet.screen.type("Shortcuts/Search", "keyboard", sheet, false);
  EXPECT_EQ(sheet.screen.at("Shortcuts/Keyboard/Next, previous control").value, "Tab, Shift+Tab");
  sheet.screen.type("Shortcuts/Search", "shift+tab", sheet, false);
  EXPECT_TRUE(sheet.screen.has("Shortcuts/Keyboard/From the map into the panels"));
}

TEST(ShortcutSheet, DoesWhatIsClicked) {
  Sheet sheet;
  const std::string menu(offered_as(sheet.model.commands, "play toggle").command->menu);
  EXPECT_THAT(texts(sheet.screen.click("Shortcuts/" + menu + "/" + line_of("play toggle"), sheet)),
              ElementsAre("show none", "play toggle"));
}

TEST(ShortcutSheet, SaysThatNothingIsFound) {
  Sheet sheet;
  sheet.screen.wait(3, sheet);
  sheet.screen.type("Shortcuts/Search", "zzzqqq", sheet, false);
  EXPECT_TRUE(sheet.screen.shows("Nothing found"));
}

TEST(ShortcutSheet, ClosesByEscape) {
  Sheet sheet;
  sheet.screen.wait(3, sheet);
  EXPECT_THAT(texts(sheet.screen.press("Escape", sheet)), testing::Contains("show none"));
}

}  // namespace shortcuts_test
}  // namespace nadir
