// SPDX-License-Identifier: Apache-2.0
// Which chords a frame sees pressed, while nothing, a text, a number, a menu or an overlay has the keyboard.
#include <gmock/gmock.h>

#include <set>

#include "widgets/kit/chord.h"
#include "widgets/kit/headless_ui.h"

namespace nadir::kit {
namespace chords_test {

using testing::ElementsAre;
using testing::IsEmpty;

/// Every key that has a name or a sign.
std::vector<Key> all_keys() {
  std::vector<Key> keys;
  for (int code = 1; code < 340; ++code) {
    const auto key = static_cast<Key>(code);
    const std::string text = chord_text({key});
    if (const auto parsed = parse_chord(text); parsed && parsed->key == key) keys.push_back(key);
  }
  return keys;
}

TEST(ChordTexts, AreDifferentForAllKeys) {
  std::set<std::string> texts;
  for (const Key key : all_keys()) EXPECT_TRUE(texts.insert(chord_text({key})).second);
  EXPECT_GE(texts.size(), 26U + 10U + 12U + 14U) << "letters, digits, function keys, named keys";
}

TEST(ChordTexts, AreReadBackWithAllModifiers) {
  for (const Key key : all_keys()) {
    for (int mask = 0; mask < 16; ++mask) {
      Chord chord{key};
      chord.modifiers = {(mask & 1) != 0, (mask & 2) != 0, (mask & 4) != 0, (mask & 8) != 0};
      const auto parsed = parse_chord(chord_text(chord));
      ASSERT_TRUE(parsed) << chord_text(chord);
      EXPECT_EQ(*parsed, chord) << chord_text(chord);
    }
  }
}

TEST(ChordTexts, AreReadInAnyCaseAndOrder) {
  EXPECT_EQ(parse_chord("SHIFT+CTRL+p"), parse_chord("Ctrl+Shift+P"));
  EXPECT_EQ(parse_chord("page up"), parse_chord("Page Up"));
  EXPECT_EQ(parse_chord("f12")->key, Key::kF12);
}

/// Presses every key with every modifier; which of the chords were seen.
std::vector<std::string> seen_of(HeadlessUi& screen, const std::vector<std::string>& chords) {
  std::vector<std::string> all;
  const auto draw = [&chords](Ui& ui) {
    std::vector<std::string> seen;
    for (const std::string& chord : chords) {
      if (ui.is_pressed(chord)) seen.push_back(chord);
    }
    return seen;
  };
  for (const std::string& chord : chords) {
    for (const std::string& seen : screen.press(chord, draw)) all.push_back(chord + ": " + seen);
  }
  return all;
}

TEST(PressedChords, AreThoseOfExactlyTheirModifiers) {
  HeadlessUi screen;
  EXPECT_THAT(seen_of(screen, {"P", "Shift+P", "Ctrl+P", "Ctrl+Shift+P", "Alt+P", "Ctrl+Alt+P"}),
              ElementsAre("P: P", "Shift+P: Shift+P", "Ctrl+P: Ctrl+P",
                          "Ctrl+Shift+P: Ctrl+Shift+P", "Alt+P: Alt+P", "Ctrl+Alt+P: Ctrl+Alt+P"));
}

TEST(PressedChords, OfSignsCountWhateverKeyTypesThem) {
  HeadlessUi screen;
  bool was_seen = false;
  const auto draw = [&was_seen](Ui& ui) { was_seen = was_seen || ui.is_pressed("["); };
  screen.input().keys = {Key::k8};  // as in Germany, with the right Alt
  screen.input().modifiers.alt = true;
  screen.input().characters = "[";
  screen.frame(draw);
  EXPECT_TRUE(was_seen);
  was_seen = false;
  screen.input().modifiers = {};
  screen.input().keys = {Key::kLeftBracket};
  screen.frame(draw);
  EXPECT_FALSE(was_seen) << "the key that has it in America may type something else";
}

TEST(PressedChords, RepeatAfterAWhileWhereTheyAreHeld) {
  HeadlessUi screen;
  std::vector<int> frames;
  int frame = 0;
  const auto draw = [&](Ui& ui) {
    if (ui.is_pressed("Right", true)) frames.push_back(frame);
    ++frame;
  };
  screen.input().keys = {Key::kRight};
  for (int i = 0; i < 60; ++i) screen.frame(draw);
  ASSERT_GT(frames.size(), 3U);
  EXPECT_EQ(frames[0], 0);
  EXPECT_GT(frames[1], 10) << "not at once";
  for (std::size_t i = 2; i < frames.size(); ++i) EXPECT_LT(frames[i] - frames[i - 1], 8);
}

TEST(PressedChords, AreSeenByEverybodyWhoAsks) {
  HeadlessUi screen;
  EXPECT_TRUE(
      screen.press("F5", [](Ui& ui) { return ui.is_pressed("F5") && ui.is_pressed("F5"); }));
}

/// A text input that has the keyboard, and which chords go past it.
class Typing : public testing::TestWithParam<bool> {
 protected:
  std::vector<std::string> past_it(const std::vector<std::string>& chords) {
    std::vector<std::string> seen;
    std::string text = "loop";
    const auto draw = [&](Ui& ui) {
      for (const std::string& chord : chords) {
        if (ui.is_pressed(chord)) seen.push_back(chord);
      }
      TextOptions options;
      options.is_multiline = GetParam();
      (void)ui.text_input("Name", text, options);
    };
    HeadlessUi screen;
    screen.click("Name", draw);
    for (const std::string& chord : chords) {
      screen.press(chord, draw);
      EXPECT_TRUE(screen.frame([&](Ui& ui) {
        draw(ui);
        return ui.wants_text();
      })) << chord
          << " ended it";
    }
    return seen;
  }
};

TEST_P(Typing, KeepsWhatIsTextAndLetsTheRestPass) {
  EXPECT_THAT(past_it({"G", "1", "Space", "Shift+G", "["}), IsEmpty());
  EXPECT_THAT(past_it({"Ctrl+A", "Ctrl+C", "Ctrl+X", "Ctrl+V", "Ctrl+Z", "Ctrl+Left", "Home", "End",
                       "Backspace", "Delete", "Left", "Right"}),
              IsEmpty());
  EXPECT_THAT(past_it({"Ctrl+P", "Ctrl+S", "F5", "Alt+F"}),
              ElementsAre("Ctrl+P", "Ctrl+S", "F5", "Alt+F"));
}

INSTANTIATE_TEST_SUITE_P(InTexts, Typing, testing::Bool());

TEST(PressedChords, OfArrowsBelongToANumberThatWasClicked) {
  HeadlessUi screen;
  std::vector<std::string> seen;
  const auto draw = [&seen](Ui& ui) {
    for (const char* const chord : {"Right", "Up", "Space", "G"}) {
      if (ui.is_pressed(chord)) seen.emplace_back(chord);
    }
    (void)ui.number_input("Noise", 5.0, {});
    (void)ui.button("After");
  };
  screen.press("Right", draw);
  screen.click("Noise", draw);
  for (const char* const chord : {"Right", "Up", "Space", "G"}) screen.press(chord, draw);
  screen.click("After", draw);
  screen.press("Up", draw);
  EXPECT_THAT(seen, ElementsAre("Right", "Space", "G", "Up"));
}

TEST(PressedChords, BelongToAnOpenMenu) {
  HeadlessUi screen;
  std::vector<std::string> seen;
  const auto draw = [&seen](Ui& ui) {
    for (const char* const chord : {"Escape", "F5", "Ctrl+P"}) {
      if (ui.is_pressed(chord)) seen.emplace_back(chord);
    }
    if (const auto menu = ui.button_menu("More", Icon::kMore, {"More", ""}))
      (void)ui.menu_item("One");
  };
  screen.click("More", draw);
  screen.wait(2, draw);
  screen.press("F5", draw);
  screen.press("Ctrl+P", draw);
  EXPECT_THAT(seen, IsEmpty());
  screen.press("Escape", draw);
  screen.wait(2, draw);
  EXPECT_FALSE(screen.has("More/One"));
  EXPECT_THAT(seen, IsEmpty()) << "Escape closed the menu, nothing else";
  screen.press("Escape", draw);
  EXPECT_THAT(seen, ElementsAre("Escape"));
}

TEST(Modifiers, AreToldAsTheyAreHeld) {
  HeadlessUi screen;
  screen.input().modifiers = {true, false, true, false};
  screen.frame([](Ui& ui) {
    EXPECT_TRUE(ui.modifiers().ctrl);
    EXPECT_FALSE(ui.modifiers().shift);
    EXPECT_TRUE(ui.modifiers().alt);
  });
}

TEST(Holding, LastsFromAPressUntilEverythingIsLetGo) {
  HeadlessUi screen;
  std::string text;
  const auto draw = [&text](Ui& ui) {
    (void)ui.area("map", {100.0, 100.0});
    text = ui.text_input("Name", text).value;
    (void)ui.button("After");
    return ui.is_holding();
  };
  screen.wait(2, draw);
  EXPECT_FALSE(screen.frame(draw));
  screen.input().mouse_px = screen.at("map").rect.centre();
  screen.input().buttons[2] = true;
  EXPECT_TRUE(screen.frame(draw));
  screen.input().buttons[2] = false;
  screen.frame(draw);
  EXPECT_FALSE(screen.frame(draw));
  (void)screen.click("Name", draw);
  EXPECT_TRUE(screen.frame(draw)) << "a text is being typed";
  (void)screen.press("Enter", draw);
  EXPECT_FALSE(screen.frame(draw));
}

}  // namespace chords_test
}  // namespace nadir::kit
