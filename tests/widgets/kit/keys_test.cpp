// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "widgets/kit/chord.h"
#include "widgets/kit/headless_ui.h"
#include "widgets/kit/icons.h"

namespace nadir::kit {
namespace keys_test {

TEST(Chords, AreReadAndWrittenAlike) {
  for (const char* const text :
       {"Ctrl+P", "Ctrl+Shift+P", "Space", "Left", "Page Up", "F5", "F12", "?", "[", "Ctrl++",
        "Alt+Enter", "7", "Escape", "Ctrl+Shift+Alt+Super+Z", "Delete"}) {
    const auto chord = parse_chord(text);
    ASSERT_TRUE(chord) << text;
    EXPECT_EQ(chord_text(*chord), text);
  }
  EXPECT_EQ(parse_chord("ctrl+p"), parse_chord("Ctrl+P"));
  EXPECT_EQ(parse_chord("esc"), parse_chord("Escape"));
  EXPECT_EQ(parse_chord("Ctrl+P")->key, Key::kP);
  EXPECT_TRUE(parse_chord("Ctrl+P")->modifiers.ctrl);
  EXPECT_EQ(parse_chord("?")->character, '?');
}

TEST(Chords, AreNotMadeOfNonsense) {
  for (const char* const text :
       {"", "Ctrl+", "Ctrl", "F0", "F13", "F1x", "Hyper+P", "PP", "ä", " "})
    EXPECT_FALSE(parse_chord(text)) << text;
}

/// Which of some chords a frame saw.
struct Pressed {
  std::vector<std::string> chords = {"Ctrl+P", "Ctrl+Shift+P", "P", "?",  "[",
                                     "Space",  "Left",         "+", "F5", "Ctrl++"};
  std::vector<std::string> operator()(Ui& ui) const {
    std::vector<std::string> seen;
    for (const std::string& chord : chords) {
      if (ui.is_pressed(chord)) seen.push_back(chord);
    }
    return seen;
  }
};

TEST(Keys, ArePressedOnceWithTheModifiersTheyAskFor) {
  HeadlessUi screen;
  const Pressed pressed;
  for (const std::string& chord : pressed.chords) {
    EXPECT_THAT(screen.press(chord, pressed), testing::ElementsAre(chord));
  }
  EXPECT_THAT(screen.wait(3, pressed), testing::IsEmpty());
}

TEST(Keys, ThatAreHeldRepeatOnlyWhereAskedFor) {
  HeadlessUi screen;
  int once = 0;
  int repeated = 0;
  const auto draw = [&](Ui& ui) {
    once += ui.is_pressed("Right") ? 1 : 0;
    repeated += ui.is_pressed("Right", true) ? 1 : 0;
  };
  screen.input().keys = {Key::kRight};
  screen.wait(60, draw);
  EXPECT_EQ(once, 1);
  EXPECT_GT(repeated, 5);
}

TEST(Keys, OfUnknownChordsAreNeverPressed) {
  HeadlessUi screen;
  screen.input().keys = {Key::kNone, Key::kP};
  EXPECT_FALSE(
      screen.frame([](Ui& ui) { return ui.is_pressed("Hyper+P") || ui.is_pressed(Chord{}); }));
}

TEST(Icons, AreUtf8OfTheirCodePoints) {
  EXPECT_EQ(icon_text(Icon::kPlay), "\xEF\x81\x8B");
  EXPECT_EQ(icon_text(Icon::kNone), "");
  EXPECT_EQ(icon_name(Icon::kStepForward), "step forward");
  EXPECT_EQ(icon_name(Icon::kNone), "");
}

TEST(HeadlessScreens, ThrowWithTheControlsThereAre) {
  HeadlessUi screen;
  const auto draw = [](Ui& ui) { return ui.button("Localise"); };
  try {
    (void)screen.click("Run/Localise", draw);
    FAIL();
  } catch (const std::logic_error& error) {
    EXPECT_STREQ(error.what(), "there is no control 'Run/Localise'; there are:\n  Localise");
  }
  EXPECT_THROW((void)screen.press("Hyper+P", draw), std::logic_error);
  EXPECT_TRUE(screen.click("Localise", draw)) << "and go on";
}

TEST(HeadlessScreens, JoinWhatSeveralFramesAskFor) {
  HeadlessUi screen;
  int frame = 0;
  EXPECT_THAT(screen.wait(2, [&frame](Ui&) { return std::vector<int>{frame++}; }),
              testing::ElementsAre(0, 1, 2, 3));
  EXPECT_EQ(screen.wait(2, [](Ui&) { return std::optional<int>(); }), std::nullopt);
}

TEST(Contexts, RefuseFramesWithinFramesAndSurviveThrownOnes) {
  UiContext context(ThemeName::kLight);
  (void)context.begin_frame({});
  EXPECT_THROW((void)context.begin_frame({}), std::logic_error);
  EXPECT_THROW(context.set_look(ThemeName::kDark, 1.0), std::logic_error);
  context.abandon_frame();
  context.abandon_frame();
  EXPECT_THROW(context.end_frame(), std::logic_error);
  context.begin_frame({}).text("again");
  context.end_frame();
  EXPECT_EQ(context.controls().size(), 1U);
}

TEST(Contexts, ChangeTheirLookBetweenFrames) {
  HeadlessUi screen(ThemeName::kDark, 1.0);
  const auto draw = [](Ui& ui) { (void)ui.button("Go"); };
  screen.frame(draw);
  const Rect small = screen.at("Go").rect;
  screen.context().set_look(ThemeName::kLight, 2.0);
  screen.frame(draw);
  EXPECT_NEAR(screen.at("Go").rect.width, 2.0 * small.width, 3.0);
  EXPECT_EQ(screen.context().theme_name(), ThemeName::kLight);
  screen.context().set_look(ThemeName::kLight, 17.0);
  EXPECT_EQ(screen.context().scale(), UiContext::kMostScale);
}

TEST(Contexts, LiveBesideEachOther) {
  HeadlessUi first;
  HeadlessUi second(ThemeName::kLight, 1.5);
  const auto draw = [](Ui& ui) { return ui.button("Go"); };
  EXPECT_TRUE(first.click("Go", draw));
  EXPECT_TRUE(second.click("Go", draw));
  EXPECT_TRUE(first.click("Go", draw));
}

}  // namespace keys_test
}  // namespace nadir::kit
