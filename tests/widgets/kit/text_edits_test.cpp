// SPDX-License-Identifier: Apache-2.0
// Texts as panels use them: who wants live changes takes those, who wants one undo step takes the commit.
#include <gmock/gmock.h>

#include "widgets/kit/headless_ui.h"

namespace nadir::kit {
namespace text_edits_test {

using testing::ElementsAre;
using testing::IsEmpty;

/// Two inputs and what came of them.
struct TwoTexts {
  std::string first = "loop", second = "town";
  std::vector<std::string> changes, commits;
  void operator()(Ui& ui) {
    take("First", ui.text_input("First", first), first);
    take("Second", ui.text_input("Second", second), second);
    (void)ui.button("After");
  }
  void take(const std::string& name, const TextEdit& edit, std::string& text) {
    if (edit.is_changed) changes.push_back(edit.value);
    if (!edit.was_committed) return;
    commits.push_back(name + ": " + edit.value);
    text = edit.value;
  }
};

auto drawing(TwoTexts& texts) {
  return [&texts](Ui& ui) { texts(ui); };
}

TEST(TextEdits, RunAheadOfTheModelAndCommitOnce) {
  HeadlessUi screen;
  TwoTexts texts;
  screen.click("First", drawing(texts));
  screen.press("End", drawing(texts));
  for (const char* const letter : {" ", "7"}) screen.type_here(letter, drawing(texts));
  EXPECT_THAT(texts.changes, ElementsAre("loop ", "loop 7"));
  EXPECT_THAT(texts.commits, IsEmpty());
  EXPECT_EQ(texts.first, "loop") << "nobody has taken it yet";
  EXPECT_EQ(screen.at("First").value, "loop 7");
  screen.press("Enter", drawing(texts));
  EXPECT_THAT(texts.commits, ElementsAre("First: loop 7"));
}

TEST(TextEdits, CommitNothingWhereNothingChanged) {
  HeadlessUi screen;
  TwoTexts texts;
  screen.click("First", drawing(texts));
  screen.press("Enter", drawing(texts));
  screen.click("First", drawing(texts));
  screen.click("After", drawing(texts));
  screen.type("First", "loop", drawing(texts));
  EXPECT_THAT(texts.commits, IsEmpty());
}

TEST(TextEdits, GoFromOneInputToTheNextByAClick) {
  HeadlessUi screen;
  TwoTexts texts;
  screen.type("First", "one", drawing(texts), false);
  screen.type("Second", "two", drawing(texts), false);
  screen.type("First", "three", drawing(texts));
  EXPECT_THAT(texts.commits, ElementsAre("First: one", "Second: two", "First: three"));
}

TEST(TextEdits, EscapeLeavesOnlyTheOneThatIsTyped) {
  HeadlessUi screen;
  TwoTexts texts;
  screen.type("First", "one", drawing(texts));
  screen.type("Second", "two", drawing(texts), false);
  screen.press("Escape", drawing(texts));
  screen.wait(2, drawing(texts));
  EXPECT_EQ(screen.at("First").value, "one");
  EXPECT_EQ(screen.at("Second").value, "town");
  EXPECT_THAT(texts.commits, ElementsAre("First: one"));
}

TEST(TextEdits, AreEditedWithTheUsualKeys) {
  HeadlessUi screen;
  TwoTexts texts;
  screen.click("First", drawing(texts));
  screen.press("Home", drawing(texts));
  screen.type_here("the ", drawing(texts));
  screen.press("End", drawing(texts));
  screen.press("Backspace", drawing(texts));
  EXPECT_EQ(screen.at("First").value, "the loo");
  screen.press("Home", drawing(texts));
  screen.press("Delete", drawing(texts));
  EXPECT_EQ(screen.at("First").value, "he loo");
  screen.press("Ctrl+A", drawing(texts));
  screen.type_here("ä€", drawing(texts));
  screen.press("Backspace", drawing(texts));
  EXPECT_EQ(screen.at("First").value, "ä") << "by characters, not by bytes";
}

TEST(TextEdits, UndoWhatWasTypedLast) {
  HeadlessUi screen;
  TwoTexts texts;
  screen.click("First", drawing(texts));
  screen.press("End", drawing(texts));
  screen.type_here("!", drawing(texts));
  screen.press("Ctrl+Z", drawing(texts));
  EXPECT_EQ(screen.at("First").value, "loop");
  screen.press("Ctrl+Y", drawing(texts));
  EXPECT_EQ(screen.at("First").value, "loop!");
}

TEST(TextEdits, FollowTheModelWhileNobodyTypes) {
  HeadlessUi screen;
  TwoTexts texts;
  screen.type("First", "one", drawing(texts));
  texts.first = "undone";
  screen.frame(drawing(texts));
  EXPECT_EQ(screen.at("First").value, "undone");
}

TEST(TextEdits, AreForgottenWhenTheirInputIsNotDrawnAnyMore) {
  HeadlessUi screen;
  TwoTexts texts;
  bool shows = true;
  const auto draw = [&](Ui& ui) {
    if (shows) texts(ui);
    return ui.wants_text();
  };
  (void)screen.type("First", "half a w", draw, false);
  shows = false;
  (void)screen.wait(3, draw);
  EXPECT_FALSE(screen.frame(draw)) << "keys are shortcuts again";
  EXPECT_FALSE(screen.context().is_typing());
  shows = true;
  (void)screen.wait(2, draw);
  EXPECT_EQ(screen.at("First").value, "loop");
}

TEST(TextEdits, TellTheWindowThatTheyTakeWhatIsTyped) {
  HeadlessUi screen;
  TwoTexts texts;
  screen.wait(2, drawing(texts));
  EXPECT_FALSE(screen.context().is_typing());
  screen.click("First", drawing(texts));
  EXPECT_TRUE(screen.context().is_typing());
  screen.press("Enter", drawing(texts));
  EXPECT_FALSE(screen.context().is_typing());
}

TEST(TextInputs, KeepBytesThatAreNoTextWhileSomebodyTypes) {
  HeadlessUi screen;
  std::string name = "caf\xE9";
  const auto draw = [&name](Ui& ui) { name = ui.text_input("Name", name).value; };
  screen.wait(2, draw);
  screen.click("Name", draw);
  screen.wait(2, draw);
  EXPECT_EQ(name, "caf\xE9") << "it is only looked at";
  screen.press("End", draw);
  screen.input().characters = ".nadir";
  screen.frame(draw);
  screen.input().characters.clear();
  screen.press("Enter", draw);
  EXPECT_EQ(name, "caf\xE9.nadir");
}

TEST(Texts, ShowBytesThatAreNoTextAsOneCharacterEach) {
  HeadlessUi screen;
  double shown = 0.0, expected = 0.0, without = 0.0;
  screen.wait(1, [&](Ui& ui) {
    shown = ui.text_width("caf\xE9.nadir");  // whose last letter seems to begin a longer one
    expected = ui.text_width("caf\xEF\xBF\xBD.nadir");
    without = ui.text_width("caf.nadir");
  });
  EXPECT_EQ(shown, expected);
  EXPECT_GT(shown, without);
}

TEST(SearchInputs, ShowAPlaceholderOnlyWhileTheyAreEmpty) {
  HeadlessUi screen;
  std::string found;
  const auto draw = [&found](Ui& ui) {
    TextOptions options;
    options.placeholder = "Find a layer";
    const TextEdit edit = ui.search_input("Find", found, options);
    if (edit.was_committed) found = edit.value;
  };
  screen.wait(2, draw);
  EXPECT_EQ(screen.at("Find").value, "") << "a placeholder is no value";
  screen.type("Find", "par", draw);
  EXPECT_EQ(found, "par");
  screen.press("Escape", draw);
  EXPECT_EQ(found, "par");
}

TEST(SearchInputs, GoBackToWhatTheyWereByEscape) {
  HeadlessUi screen;
  std::string found = "truth";
  std::vector<std::string> live;
  const auto draw = [&](Ui& ui) {
    const TextEdit edit = ui.search_input("Find", found);
    if (edit.was_committed) live.push_back(found = edit.value);
  };
  screen.type("Find", "par", draw, false);
  EXPECT_EQ(found, "par");
  screen.press("Escape", draw);
  screen.wait(1, draw);
  EXPECT_EQ(found, "truth");
  EXPECT_EQ(live.back(), "truth");
}

}  // namespace text_edits_test
}  // namespace nadir::kit
