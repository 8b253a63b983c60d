// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <limits>

#include "widgets/kit/headless_ui.h"
#include "widgets/kit/number_text.h"

namespace nadir::kit {
namespace numbers_test {

/// A number with a model behind it, which follows at once or only what was committed.
class Numbers : public testing::Test {
 protected:
  Numbers() {
    options.least = 0.0;
    options.most = 10.0;
    options.unit = "m";
    options.reset = 1.0;
  }

  void take(const Edit<double>& edit) {
    if (edit.is_changed) changes.push_back(edit.value);
    if (edit.was_committed) commits.push_back(edit.value);
    if (edit.was_reset) ++resets;
    if (edit.was_committed || (follows_at_once && edit.is_changed)) value = edit.value;
  }
  auto number() {
    return [this](Ui& ui) {
      (void)ui.button("Before");
      take(ui.number_input("Noise", value, options));
      (void)ui.button("After");
    };
  }
  auto slider() {
    return [this](Ui& ui) { take(ui.slider("Noise", value, options)); };
  }

  HeadlessUi screen;
  NumberOptions options;
  double value = 5.0;
  bool follows_at_once = true;
  std::vector<double> changes, commits;
  int resets = 0;
};

TEST_F(Numbers, OfASliderFollowTheMouseAndCommitOnceWhenItIsLetGo) {
  screen.drag("Noise", 50.0, 0.0, slider());
  EXPECT_GE(changes.size(), 2U);
  ASSERT_EQ(commits.size(), 1U);
  EXPECT_GT(commits[0], 5.0);
  EXPECT_EQ(value, commits[0]);
}

TEST_F(Numbers, OfASliderRunAheadOfAModelThatTakesOnlyCommits) {
  follows_at_once = false;
  screen.drag("Noise", 50.0, 0.0, slider());
  ASSERT_EQ(commits.size(), 1U);
  EXPECT_GT(value, 5.0);
  EXPECT_EQ(screen.at("Noise").value, digits_text(value, options));
}

TEST_F(Numbers, OfASliderAreThoseUnderTheMouse) {
  screen.frame(slider());
  const Rect track = screen.at("Noise").rect;
  // The knob's middle runs between 6 px from either end.
  screen.click_at("Noise", 6.0 + 0.25 * (track.width - 12.0), track.height / 2.0, slider());
  ASSERT_EQ(commits.size(), 1U);
  EXPECT_NEAR(commits[0], 2.5, 0.05);
  screen.click_at("Noise", track.width - 1.0, 5.0, slider());
  EXPECT_EQ(value, 10.0) << "beyond the end is the end";
}

TEST_F(Numbers, OfALogarithmicSliderGrowByFactors) {
  options.least = 0.01;
  options.most = 100.0;
  options.is_logarithmic = true;
  screen.frame(slider());
  const Rect track = screen.at("Noise").rect;
  screen.click_at("Noise", track.width / 2.0, 5.0, slider());
  EXPECT_NEAR(value, 1.0, 0.1) << "the middle of 0.01 and 100";
}

TEST_F(Numbers, OfASliderAreTypedIntoItsField) {
  screen.type("Noise", "7.25", slider());
  EXPECT_EQ(value, 7.25);
  EXPECT_THAT(commits, testing::ElementsAre(7.25));
  EXPECT_EQ(screen.at("Noise/value").value, "7.25");
}

TEST_F(Numbers, AreTypedWithTheirUnitAndClamped) {
  screen.type("Noise", "3 m", number());
  EXPECT_EQ(value, 3.0);
  screen.type("Noise", "99", number());
  EXPECT_EQ(value, 10.0);
  EXPECT_THAT(commits, testing::ElementsAre(3.0, 10.0));
}

TEST_F(Numbers, ThatCannotBeReadLeaveAllAsItWas) {
  screen.type("Noise", "many", number());
  EXPECT_EQ(value, 5.0);
  EXPECT_TRUE(commits.empty());
}

TEST_F(Numbers, AreLeftByEscape) {
  screen.type("Noise", "8", number(), false);
  screen.press("Escape", number());
  screen.wait(2, number());
  EXPECT_EQ(value, 5.0);
  EXPECT_TRUE(commits.empty());
}

TEST_F(Numbers, AreCommittedByAClickElsewhere) {
  screen.type("Noise", "8", number(), false);
  screen.click("After", number());
  EXPECT_THAT(commits, testing::ElementsAre(8.0));
  screen.type("Noise", "9", number(), false);
  screen.click("Before", number());
  EXPECT_THAT(commits, testing::ElementsAre(8.0, 9.0)) << "also by what is drawn before them";
}

TEST_F(Numbers, ThatAreOpenedAndNotChangedStayExactlyAsTheyAre) {
  value = 1.0 / 3.0;
  screen.double_click("Noise", number());
  screen.press("Enter", number());
  EXPECT_EQ(value, 1.0 / 3.0) << "not 0.33";
  EXPECT_TRUE(commits.empty());
}

TEST_F(Numbers, AreDraggedSidewaysAndCommittedOnce) {
  screen.drag("Noise", 40.0, 0.0, number());
  ASSERT_EQ(commits.size(), 1U);
  EXPECT_GT(value, 5.0);
  const double up = value;
  screen.drag("Noise", -40.0, 0.0, number());
  EXPECT_NEAR(value, 5.0, 0.02) << "the way back from " << up;
}

TEST_F(Numbers, DraggedWithoutTheModelFollowingComeToTheSame) {
  screen.drag("Noise", 40.0, 0.0, number());
  const double followed = value;
  value = 5.0;
  follows_at_once = false;
  screen.drag("Noise", 40.0, 0.0, number());
  EXPECT_EQ(value, followed);
}

TEST_F(Numbers, DraggedThereAndBackCommitNothing) {
  screen.frame(number());
  screen.input().mouse_px = screen.at("Noise").rect.centre();
  screen.frame(number());
  screen.input().buttons[0] = true;
  screen.frame(number());
  *screen.input().mouse_px += Eigen::Vector2d(60.0, 0.0);
  screen.frame(number());
  EXPECT_GT(value, 5.0);
  *screen.input().mouse_px -= Eigen::Vector2d(60.0, 0.0);
  screen.frame(number());
  screen.input().buttons[0] = false;
  screen.frame(number());
  EXPECT_EQ(value, 5.0);
  EXPECT_TRUE(commits.empty());
}

TEST_F(Numbers, StepWithTheArrowKeysOnceTheyWereClicked) {
  options.step = 0.5;
  screen.press("Up", number());
  EXPECT_TRUE(commits.empty()) << "not before";
  screen.click("Noise", number());
  screen.press("Up", number());
  screen.press("Right", number());
  screen.press("Down", number());
  EXPECT_THAT(commits, testing::ElementsAre(5.5, 6.0, 5.5));
  screen.press("Shift+Left", number());
  EXPECT_EQ(value, 0.5) << "ten steps";
  screen.click("After", number());
  screen.press("Up", number());
  EXPECT_EQ(value, 0.5) << "the arrows are everybody's again";
}

TEST_F(Numbers, AreOpenedByEnterOnceTheyWereClicked) {
  screen.click("Noise", number());
  screen.press("Enter", number());
  screen.press("Ctrl+A", number());
  screen.type_here("4", number());
  screen.press("Enter", number());
  EXPECT_THAT(commits, testing::ElementsAre(4.0));
}

TEST_F(Numbers, AreResetByADoubleClickOnTheLabel) {
  screen.reset("Noise", number());
  EXPECT_EQ(value, 1.0);
  EXPECT_EQ(resets, 1);
  EXPECT_THAT(commits, testing::ElementsAre(1.0));
  screen.reset("Noise", number());
  EXPECT_EQ(resets, 1) << "nothing to reset";
  value = 3.0;
  screen.reset("Noise", slider());
  EXPECT_EQ(value, 1.0);
}

TEST_F(Numbers, TellUnitAndDefaultInTheirTooltip) {
  options.hint = {"Heading spread", ""};
  screen.hover("Noise", number());
  EXPECT_EQ(screen.tooltip(), "Heading spread · m · default 1.00");
}

TEST_F(Numbers, OfADisabledScopeCannotBeDragged) {
  const auto draw = [this](Ui& ui) {
    const auto off = ui.disabled(true, "running");
    take(ui.slider("Noise", value, options));
  };
  screen.frame(draw);
  screen.input().mouse_px = screen.at("Noise").rect.centre() + Eigen::Vector2d(40.0, 0.0);
  screen.frame(draw);
  screen.input().buttons[0] = true;
  screen.frame(draw);
  screen.input().buttons[0] = false;
  screen.frame(draw);
  EXPECT_TRUE(changes.empty());
}

TEST_F(Numbers, OfSmallSlidersAreTheSame) {
  const auto draw = [this](Ui& ui) {
    ui.next_width(100.0);
    take(ui.small_slider("Opacity", value, options));
  };
  screen.drag("Opacity", 20.0, 0.0, draw);
  EXPECT_EQ(screen.at("Opacity").rect.width, 100.0);
  ASSERT_EQ(commits.size(), 1U);
  EXPECT_NEAR(value, 5.0 + 10.0 * 20.0 / 88.0, 0.1);
  EXPECT_THAT(screen.at("Opacity").tooltip, testing::HasSubstr(digits_text(value, options)));
}

TEST_F(Numbers, OfSlidersNeedARange) {
  options.most = std::numeric_limits<double>::infinity();
  options.least = -options.most;
  EXPECT_THROW(screen.frame(slider()), std::logic_error);
}

TEST(NumberText, HasTheDigitsAndNoMinusZero) {
  NumberOptions options;
  EXPECT_EQ(digits_text(1.005, options), "1.00");
  EXPECT_EQ(digits_text(-0.001, options), "0.00");
  EXPECT_EQ(digits_text(std::nan(""), options), "–");
  options.decimals = 0;
  EXPECT_EQ(digits_text(12345.6, options), "12346");
}

TEST(NumberText, IsReadAsPeopleWriteIt) {
  NumberOptions options;
  options.unit = "m";
  options.most = 100.0;
  EXPECT_EQ(read_number(" 1.5", options), 1.5);
  EXPECT_EQ(read_number("1,5 m", options), 1.5);
  EXPECT_EQ(read_number("+2e1m ", options), 20.0);
  EXPECT_EQ(read_number("1000", options), 100.0);
  for (const char* const wrong : {"", " ", "m", "1.5 km", "nan", "inf", "1 2", "0x1", "--3"}) {
    EXPECT_EQ(read_number(wrong, options), std::nullopt) << wrong;
  }
}

TEST(NumberText, KeepsWhatItShows) {
  NumberOptions options;
  options.least = -1.0;
  EXPECT_DOUBLE_EQ(kept_digits(0.123456, options), 0.12);
  EXPECT_EQ(kept_digits(-7.0, options), -1.0);
  EXPECT_FALSE(std::signbit(kept_digits(-0.0001, options)));
  EXPECT_EQ(step_of(options), 0.01);
}

}  // namespace numbers_test
}  // namespace nadir::kit
