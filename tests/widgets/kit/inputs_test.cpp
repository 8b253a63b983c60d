// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "widgets/kit/headless_ui.h"

namespace nadir::kit {
namespace inputs_test {

class Inputs : public testing::Test {
 protected:
  void take(const TextEdit& edit) {
    if (edit.is_changed) changes.push_back(edit.value);
    if (edit.was_committed) commits.push_back(edit.value);
    if (edit.was_entered) ++entered;
    if (edit.was_cancelled) ++cancelled;
    if (edit.was_committed) text = edit.value;
  }
  auto input() {
    return [this](Ui& ui) {
      (void)ui.button("Before");
      take(ui.text_input("Name", text, options));
      (void)ui.button("After");
      wants_text = ui.wants_text();
      escaped = ui.is_pressed("Escape");
      letter = letter || ui.is_pressed("G");
      saved = saved || ui.is_pressed("Ctrl+S");
      undone = undone || ui.is_pressed("Ctrl+Z");
      went_down = went_down || ui.is_pressed("Down");
    };
  }

  HeadlessUi screen;
  TextOptions options;
  std::string text = "loop";
  std::vector<std::string> changes, commits;
  int entered = 0, cancelled = 0;
  bool wants_text = false, escaped = false, letter = false, saved = false, undone = false,
       went_down = false;
};

TEST_F(Inputs, TakeTextAndCommitItWithEnter) {
  screen.type("Name", "grüner Kreis", input());
  EXPECT_THAT(commits, testing::ElementsAre("grüner Kreis"));
  EXPECT_EQ(entered, 1);
  EXPECT_FALSE(changes.empty());
  screen.wait(1, input());
  EXPECT_EQ(screen.at("Name").value, "grüner Kreis");
}

TEST_F(Inputs, AreEmptiedToo) {
  options.placeholder = "a name";
  screen.type("Name", "", input());
  EXPECT_THAT(commits, testing::ElementsAre(""));
}

TEST_F(Inputs, WaitWhereThereIsNoRoomForThem) {
  options.takes_focus = true;
  text.clear();
  double above = 2000.0;  // so that it lies out of sight
  const auto draw = [&](Ui& ui) {
    ui.space(above);
    const auto area = ui.scroll_area("Area", 60.0);
    take(ui.text_input("Name", text, options));
  };
  screen.wait(4, draw);
  EXPECT_TRUE(commits.empty());
  above = 0.0;
  screen.wait(3, draw);
  screen.type_here("loop", draw);
  screen.press("Enter", draw);
  EXPECT_THAT(commits, testing::ElementsAre("loop"));
}

TEST_F(Inputs, CommitWhenTheMouseClicksElsewhere) {
  screen.type("Name", "a", input(), false);
  screen.click("After", input());
  screen.type("Name", "b", input(), false);
  screen.click("Before", input());
  EXPECT_THAT(commits, testing::ElementsAre("a", "b"));
  EXPECT_EQ(entered, 0);
}

TEST_F(Inputs, ForgetWhatWasTypedWithEscape) {
  screen.type("Name", "other", input(), false);
  screen.press("Escape", input());
  EXPECT_EQ(cancelled, 1);
  EXPECT_TRUE(commits.empty());
  screen.wait(1, input());
  EXPECT_EQ(screen.at("Name").value, "loop");
}

TEST_F(Inputs, KeepLettersFromBeingShortcuts) {
  screen.click("Name", input());
  EXPECT_TRUE(wants_text);
  screen.press("G", input());
  EXPECT_FALSE(letter);
  screen.press("Ctrl+Z", input());
  EXPECT_FALSE(undone) << "that is the text's own";
  screen.press("Ctrl+S", input());
  EXPECT_TRUE(saved) << "that is no text";
  screen.press("Down", input());
  EXPECT_TRUE(went_down) << "a list below it may be walked through";
  screen.press("Enter", input());
  screen.press("G", input());
  EXPECT_TRUE(letter);
}

TEST_F(Inputs, TakeTheKeyboardWhenTheyAppearAndOnlyThen) {
  options.takes_focus = true;
  screen.wait(3, input());
  EXPECT_TRUE(wants_text);
  screen.type_here("x", input());
  screen.press("Enter", input());
  EXPECT_THAT(commits, testing::ElementsAre("x")) << "what was in it is selected";
  screen.wait(3, input());
  EXPECT_FALSE(wants_text);
}

TEST_F(Inputs, OfSeveralLinesCommitWhenTheyAreLeft) {
  options.is_multiline = true;
  screen.click("Name", input());
  screen.press("Ctrl+A", input());
  screen.type_here("one", input());
  screen.press("Enter", input());
  screen.type_here("two", input());
  EXPECT_TRUE(commits.empty());
  screen.click("After", input());
  EXPECT_THAT(commits, testing::ElementsAre("one\ntwo"));
}

TEST_F(Inputs, OfSearchesAreLiveAndCanBeCleared) {
  std::string found;
  const auto draw = [&](Ui& ui) {
    const TextEdit edit = ui.search_input("Find", found, {"Find a layer"});
    if (edit.was_committed) found = edit.value;
  };
  screen.type("Find", "par", draw, false);
  EXPECT_EQ(found, "par") << "before Enter";
  screen.wait(1, draw);
  screen.click("Find/Clear", draw);
  screen.wait(1, draw);
  EXPECT_EQ(found, "");
  EXPECT_FALSE(screen.has("Find/Clear"));
}

TEST_F(Inputs, CopyAndPasteThroughTheClipboard) {
  screen.context().set_clipboard("33.45 N");
  screen.click("Name", input());
  screen.press("Ctrl+A", input());
  screen.press("Ctrl+V", input());
  screen.press("Enter", input());
  EXPECT_THAT(commits, testing::ElementsAre("33.45 N"));
  screen.click("Name", input());
  screen.press("Ctrl+A", input());
  screen.press("Ctrl+C", input());
  EXPECT_EQ(screen.context().clipboard(), "33.45 N");
}

TEST_F(Inputs, OfADisabledScopeTakeNothing) {
  const auto draw = [this](Ui& ui) {
    const auto off = ui.disabled(true, "running");
    take(ui.text_input("Name", text));
    wants_text = ui.wants_text();
  };
  screen.frame(draw);
  EXPECT_THROW(screen.type("Name", "x", draw), std::logic_error);
  EXPECT_FALSE(wants_text);
}

TEST(Progress, ShowsShareAndWordsAndCanBeCancelled) {
  HeadlessUi screen;
  const auto draw = [](Ui& ui) { return ui.progress("Localising", 0.439, "12 s left"); };
  EXPECT_TRUE(screen.click("Localising/Cancel", draw));
  EXPECT_EQ(screen.at("Localising").value, "43 %, 12 s left");
}

TEST(Progress, WithoutAShareMovesUnlessMotionIsReduced) {
  HeadlessUi screen;
  const auto draw = [](Ui& ui) { (void)ui.progress("Reading", std::nan(""), "", false); };
  screen.frame(draw);
  EXPECT_FALSE(screen.has("Reading/Cancel"));
  EXPECT_GT(screen.context().next_frame_within_s(), 1e6);
  screen.context().set_motion_reduced(false);
  screen.frame(draw);
  EXPECT_LT(screen.context().next_frame_within_s(), 0.1);
}

TEST(Grips, MoveTheirRowByWholeRows) {
  HeadlessUi screen;
  std::vector<std::size_t> live;
  std::vector<std::size_t> commits;
  const auto draw = [&](Ui& ui) {
    const auto edit = ui.grip("Move", 1, 4, 28.0);
    if (edit.is_changed) live.push_back(edit.value);
    if (edit.was_committed) commits.push_back(edit.value);
  };
  screen.drag("Move", 0.0, 60.0, draw);
  EXPECT_THAT(live, testing::ElementsAre(2, 3));
  EXPECT_THAT(commits, testing::ElementsAre(3));
  screen.drag("Move", 0.0, -500.0, draw);
  EXPECT_THAT(commits, testing::ElementsAre(3, 0)) << "not above the first";
  screen.drag("Move", 0.0, 3.0, draw);
  EXPECT_EQ(commits.size(), 2U);
}

}  // namespace inputs_test
}  // namespace nadir::kit
