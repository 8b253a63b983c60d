// SPDX-License-Identifier: Apache-2.0
// What boxes of files and fields of numbers need of inputs: typing that goes on, and what is not taken.
#include <gmock/gmock.h>

#include "widgets/kit/headless_ui.h"
#include "widgets/kit/number_text.h"

namespace nadir::kit {
namespace typing_on_test {

/// A field whose caller changes its text while it is typed into.
struct GoingOn {
  HeadlessUi screen;
  std::string text;
  bool replaces = false;  ///< In the next frame.
  int completions = 0, backs = 0, entered = 0;
  void operator()(Ui& ui) {
    const bool now = std::exchange(replaces, false);
    const TextEdit edit =
        ui.text_input("Name", text, {.takes_focus = true, .takes_focus_now = now});
    text = edit.value;
    completions += edit.wants_completion ? 1 : 0;
    backs += edit.went_back ? 1 : 0;
    entered += edit.was_entered ? 1 : 0;
  }
};

TEST(TypingOn, GoesOnAtTheEndOfATextThatTookThePlaceOfWhatWasTyped) {
  GoingOn field;
  field.screen.wait(3, field);
  field.screen.type_here("fl", field);
  field.text = "flights/";
  field.replaces = true;
  field.screen.wait(2, field);
  EXPECT_EQ(field.text, "flights/");
  field.screen.type_here("a", field);
  EXPECT_EQ(field.text, "flights/a");
}

TEST(TypingOn, GoesOnAfterEnterWhereTheCallerWantsIt) {
  GoingOn field;
  field.screen.wait(3, field);
  field.screen.type_here("one", field);
  field.screen.press("Enter", field);
  EXPECT_EQ(field.entered, 1);
  field.screen.type_here("lost", field);
  EXPECT_EQ(field.text, "one") << "the keyboard is elsewhere";
  field.text.clear();
  field.replaces = true;
  field.screen.wait(2, field);
  field.screen.type_here("two", field);
  EXPECT_EQ(field.text, "two");
}

TEST(TypingOn, TellsOfTabAndOfBackspaceInAnEmptyField) {
  GoingOn field;
  field.screen.wait(3, field);
  field.screen.type_here("a", field);
  field.screen.press("Tab", field);
  EXPECT_EQ(field.completions, 1);
  EXPECT_EQ(field.text, "a") << "Tab types nothing";
  field.screen.press("Backspace", field);
  EXPECT_EQ(field.backs, 0) << "it took the letter";
  EXPECT_EQ(field.text, "");
  field.screen.press("Backspace", field);
  EXPECT_EQ(field.backs, 1);
}

/// A number that refuses, and somebody who keeps what it refused.
struct Refusing {
  HeadlessUi screen;
  NumberOptions options;
  double value = 5.0;
  std::vector<double> commits;
  bool is_slider = false;
  Refusing() {
    options.least = 1.0;
    options.most = 10.0;
    options.unit = "m";
    options.refuses = true;
  }
  void operator()(Ui& ui) {
    const auto edit =
        is_slider ? ui.slider("Range", value, options) : ui.number_input("Range", value, options);
    if (!edit.refused.empty()) {
      options.refused = edit.refused;
    } else if (edit.was_ended || edit.was_committed) {
      options.refused.clear();
    }
    if (edit.was_committed) {
      commits.push_back(edit.value);
      value = edit.value;
    }
    (void)ui.button("After");
  }
};

TEST(RefusingNumbers, KeepWhatWasTypedUntilItIsCorrected) {
  Refusing number;
  for (const char* const wrong : {"0.5", "99", "many", "1 2"}) {
    number.screen.type("Range", wrong, number);
    EXPECT_EQ(number.options.refused, wrong);
    number.screen.wait(2, number);
    EXPECT_EQ(number.screen.at("Range").value, wrong);
  }
  EXPECT_THAT(number.commits, testing::IsEmpty());
  number.screen.type("Range", "7", number);
  EXPECT_THAT(number.commits, testing::ElementsAre(7.0));
  EXPECT_EQ(number.options.refused, "");
}

TEST(RefusingNumbers, AreGoodAgainWhereTheOldValueIsTyped) {
  Refusing number;
  number.screen.type("Range", "99", number);
  number.screen.type("Range", "5", number);
  EXPECT_THAT(number.commits, testing::IsEmpty()) << "it is no change";
  EXPECT_EQ(number.options.refused, "");
}

TEST(RefusingNumbers, KeepWhatWasLeftByAClickElsewhere) {
  Refusing number;
  number.screen.type("Range", "99", number, false);
  number.screen.click("After", number);
  number.screen.wait(2, number);
  EXPECT_EQ(number.options.refused, "99");
  EXPECT_THAT(number.commits, testing::IsEmpty());
}

TEST(RefusingNumbers, OfSlidersRefuseInTheirField) {
  Refusing number;
  number.is_slider = true;
  number.screen.type("Range/value", "99", number);
  EXPECT_EQ(number.options.refused, "99");
  number.screen.drag("Range", 30.0, 0.0, number);
  EXPECT_EQ(number.options.refused, "") << "dragged to something that can be";
  EXPECT_EQ(number.commits.size(), 1U);
}

TEST(ReadNumberWithin, IsNothingOutOfRange) {
  NumberOptions options;
  options.least = 1.0;
  options.most = 10.0;
  options.unit = "m";
  EXPECT_EQ(read_number_within("1", options), 1.0);
  EXPECT_EQ(read_number_within("10 m", options), 10.0);
  EXPECT_EQ(read_number_within("2,5", options), 2.5);
  EXPECT_FALSE(read_number_within("0.99", options));
  EXPECT_FALSE(read_number_within("10.01", options));
  EXPECT_FALSE(read_number_within("ten", options));
}

TEST(KeepRowInSight, ScrollsATableThatIsGoneThroughByKeys) {
  std::size_t wanted = 0;
  const auto draw = [&wanted](Ui& ui) {
    const std::vector<Column> columns = {{.title = "Name"}};
    const auto table = ui.table("Names", columns, {.height = 200.0});
    if (!table) return;
    ui.clipped_table_rows(500, [&](std::size_t i) {
      (void)ui.row(std::to_string(i), i == wanted);
      ui.cell(std::to_string(i));
    });
    ui.keep_row_in_sight(wanted);
  };
  HeadlessUi screen;
  for (const std::size_t row : {0U, 3U, 20U, 499U, 250U, 0U}) {
    wanted = row;
    screen.wait(3, draw);
    const Rect table = screen.at("Names").rect;
    const Rect shown = screen.at("Names/" + std::to_string(row)).rect;
    EXPECT_GE(shown.top, table.top + 20.0) << row << " is not below the heading";
    EXPECT_LE(shown.bottom(), table.bottom() + 1.0) << row;
  }
}

}  // namespace typing_on_test
}  // namespace nadir::kit
