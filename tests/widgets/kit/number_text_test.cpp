// SPDX-License-Identifier: Apache-2.0
#include "widgets/kit/number_text.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "widgets/kit/headless_ui.h"

namespace nadir::kit {
namespace number_text_test {

NumberOptions metres(double least, double most) {
  NumberOptions options;
  options.least = least;
  options.most = most;
  options.unit = "m";
  return options;
}

TEST(NumberComplaints, AreMadeOfWhatIsNoNumber) {
  const NumberOptions options = metres(0.0, 10.0);
  for (const char* const text : {"many", "1.5 km", "1 2", "0x1", "nan", "inf", "1e999", "--1"})
    EXPECT_EQ(number_complaint(text, options), "not a number in m") << text;
  EXPECT_EQ(number_complaint("many", {}), "not a number");
}

TEST(NumberComplaints, AreMadeOfWhatIsOutOfRange) {
  const NumberOptions options = metres(-1.0, 10.0);
  EXPECT_EQ(number_complaint("10.01", options), "at most 10.00 m");
  EXPECT_EQ(number_complaint("-2", options), "at least -1.00 m");
  EXPECT_EQ(number_complaint("10", options), "");
  EXPECT_EQ(number_complaint("-1,0 m", options), "");
  EXPECT_EQ(number_complaint("1e300", {}), "") << "there is no range";
}

TEST(NumberComplaints, WaitForSomethingToBeTyped) {
  for (const char* const text : {"", " ", "-", "+", ".", "-."})
    EXPECT_EQ(number_complaint(text, metres(5.0, 10.0)), "") << text;
}

TEST(NumberComplaints, AreMadeExactlyWhereReadingChangesOrRefuses) {
  const NumberOptions options = metres(0.0, 10.0);
  for (const char* const text : {"0", "10", "3.3333", "9.999 m", "+4"}) {
    EXPECT_EQ(number_complaint(text, options), "") << text;
    EXPECT_TRUE(read_number(text, options)) << text;
  }
  for (const char* const text : {"11", "-0.5", "1e9"}) {
    EXPECT_NE(number_complaint(text, options), "") << text;
    EXPECT_TRUE(read_number(text, options)) << "clamped: " << text;
  }
}

TEST(NumberTexts, AreReadBack) {
  for (int decimals = 0; decimals <= 6; ++decimals) {
    NumberOptions options;
    options.decimals = decimals;
    options.unit = "deg";
    for (const double value : {0.0, 1.0, -1.0, 0.5, 1234.5678, -0.001, 99999.0}) {
      const std::string text = digits_text(value, options);
      const auto read = read_number(text + " deg", options);
      ASSERT_TRUE(read) << text;
      EXPECT_NEAR(*read, value, 0.5 * std::pow(10.0, -decimals) + 1e-12);
      EXPECT_EQ(digits_text(*read, options), text) << "what is shown is what is kept";
    }
  }
}

TEST(NumberTexts, RoundToWhatTheyShowAndStayInRange) {
  const NumberOptions options = metres(0.0, 10.0);
  for (const double value : {-5.0, 0.0, 0.004, 0.006, 3.14159, 9.999, 12.0}) {
    const double kept = kept_digits(value, options);
    EXPECT_GE(kept, 0.0);
    EXPECT_LE(kept, 10.0);
    EXPECT_EQ(kept, kept_digits(kept, options)) << "once is enough";
    EXPECT_NEAR(kept, std::clamp(value, 0.0, 10.0), 0.005 + 1e-12);
  }
  NumberOptions whole;
  whole.decimals = 0;
  EXPECT_EQ(kept_digits(2.5000001, whole), 3.0);
}

TEST(NumberHints, TellUnitAndDefault) {
  NumberOptions options = metres(0.0, 10.0);
  options.hint.text = "Spread";
  EXPECT_EQ(number_hint(options).unit, "m");
  EXPECT_EQ(number_hint(options).source, "");
  options.reset = 1.5;
  EXPECT_EQ(number_hint(options).source, "default 1.50");
  options.hint.source = "of the motion model";
  EXPECT_EQ(number_hint(options).source, "of the motion model, default 1.50");
}

/// A number field with somebody behind it who takes what is committed.
struct NumberField {
  NumberOptions options = metres(0.0, 10.0);
  double value = 5.0;
  std::vector<double> commits;
  void operator()(Ui& ui) {
    const auto edit = ui.number_input("Noise", value, options);
    if (edit.was_committed) {
      commits.push_back(edit.value);
      value = edit.value;
    }
    (void)ui.button("After");
  }
};

TEST(NumberFields, TakeTheNearestOfWhatIsOutOfRange) {
  HeadlessUi screen;
  NumberField field;
  const auto draw = [&field](Ui& ui) { field(ui); };
  screen.type("Noise", "99", draw);
  screen.type("Noise", "-3", draw);
  EXPECT_THAT(field.commits, testing::ElementsAre(10.0, 0.0));
}

TEST(NumberFields, KeepMoreDigitsThanTheyShowIfTheyAreTyped) {
  HeadlessUi screen;
  NumberField field;
  const auto draw = [&field](Ui& ui) { field(ui); };
  screen.type("Noise", "3.14159", draw);
  EXPECT_EQ(field.value, 3.14159);
  screen.wait(1, draw);
  EXPECT_EQ(screen.at("Noise").value, "3.14");
}

TEST(NumberFields, AreDraggedFinerWithAltAndCoarserWithShift) {
  const auto dragged = [](Modifiers modifiers) {
    HeadlessUi screen;
    NumberField field;
    field.options = {};
    field.options.step = 0.1;
    field.options.decimals = 3;
    field.value = 100.0;
    screen.drag(
        "Noise", 20.0, 0.0, [&field](Ui& ui) { field(ui); }, MouseButton::kLeft, modifiers);
    return field.value - 100.0;
  };
  const double usual = dragged({});
  EXPECT_GT(usual, 0.0);
  EXPECT_NEAR(dragged({false, true}), 10.0 * usual, 0.05 * usual);
  EXPECT_NEAR(dragged({false, false, true}), 0.1 * usual, 0.05 * usual);
}

TEST(NumberFields, DoNotLeaveTheirRangeByArrowKeys) {
  HeadlessUi screen;
  NumberField field;
  field.options.step = 4.0;
  const auto draw = [&field](Ui& ui) { field(ui); };
  screen.click("Noise", draw);
  screen.press("Up", draw);
  screen.press("Up", draw);
  screen.press("Up", draw);
  EXPECT_EQ(field.value, 10.0);
  EXPECT_THAT(field.commits, testing::ElementsAre(9.0, 10.0)) << "the last changed nothing";
}

TEST(NumberFields, OfOneScreenAreTypedOneAfterTheOther) {
  HeadlessUi screen;
  NumberField first;
  double second = 1.0;
  const auto draw = [&](Ui& ui) {
    {
      const auto scope = ui.scope("First");
      first(ui);
    }
    const auto scope = ui.scope("Second");
    const auto edit = ui.number_input("Noise", second, {});
    if (edit.was_committed) second = edit.value;
  };
  screen.type("First/Noise", "2", draw, false);
  screen.type("Second/Noise", "3", draw);
  EXPECT_EQ(first.value, 2.0) << "committed by the click on the other";
  EXPECT_EQ(second, 3.0);
}

TEST(NumberFields, ShowWhatIsNoNumberAsADash) {
  HeadlessUi screen;
  NumberField field;
  field.value = std::numeric_limits<double>::quiet_NaN();
  const auto draw = [&field](Ui& ui) { field(ui); };
  screen.wait(2, draw);
  EXPECT_EQ(screen.at("Noise").value, "–");
  screen.type("Noise", "4", draw);
  EXPECT_EQ(field.value, 4.0);
}

}  // namespace number_text_test
}  // namespace nadir::kit
