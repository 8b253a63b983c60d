// SPDX-License-Identifier: Apache-2.0
#include "widgets/kit/input_queue.h"

#include <gmock/gmock.h>

#include "tests/widgets/kit/queued_frames.h"

namespace nadir::kit {
namespace input_queue_test {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(InputQueues, AreEmptyAtFirst) {
  InputQueue queue;
  EXPECT_FALSE(queue.is_waiting());
  const FrameInput frame = queue.next(false);
  EXPECT_THAT(frame.keys, IsEmpty());
  EXPECT_FALSE(frame.mouse_px);
  EXPECT_EQ(frame.wheel, Eigen::Vector2d(0.0, 0.0));
}

TEST(InputQueues, SpreadATapOverTwoFrames) {
  const Frames frames = frames_of(Hand().tap(Key::kRight));
  ASSERT_EQ(frames.size(), 2U);
  EXPECT_TRUE(is_held(frames[0], Key::kRight));
  EXPECT_FALSE(is_held(frames[1], Key::kRight));
}

TEST(InputQueues, LoseNoneOfManyTaps) {
  Hand hand;
  for (int i = 0; i < 10; ++i) hand.tap(Key::kRightBracket);
  const Frames frames = frames_of(hand);
  EXPECT_EQ(presses_of(frames, Key::kRightBracket).size(), 10U);
  EXPECT_EQ(frames.size(), 20U) << "and no longer than that";
}

TEST(InputQueues, KeepAKeyDownUntilItComesUp) {
  InputQueue queue;
  queue.add(Hand().down(Key::kUp).events);
  for (int i = 0; i < 5; ++i) EXPECT_TRUE(is_held(queue.next(false), Key::kUp));
  queue.add(Hand().up(Key::kUp).events);
  EXPECT_FALSE(is_held(queue.next(false), Key::kUp));
}

TEST(InputQueues, PressDifferentKeysInTheirOrder) {
  const Frames frames = frames_of(Hand().tap(Key::kDown).tap(Key::kDown).tap(Key::kEnter));
  const auto down = presses_of(frames, Key::kDown);
  const auto enter = presses_of(frames, Key::kEnter);
  ASSERT_EQ(down.size(), 2U);
  ASSERT_EQ(enter.size(), 1U);
  EXPECT_LT(down[1], enter[0]);
}

TEST(InputQueues, ClickWhereTheMouseWas) {
  const Frames frames = frames_of(Hand().move(10, 20).press().move(50, 60).release().move(90, 90));
  const auto down = changes_of(frames, 0, true);
  const auto up = changes_of(frames, 0, false);
  ASSERT_EQ(down.size(), 1U);
  ASSERT_EQ(up.size(), 1U);
  EXPECT_EQ(frames[down[0]].mouse_px, Eigen::Vector2d(10, 20));
  EXPECT_EQ(frames[up[0]].mouse_px, Eigen::Vector2d(50, 60));
  EXPECT_EQ(frames.back().mouse_px, Eigen::Vector2d(90, 90));
}

TEST(InputQueues, ShowWhatLiesUnderTheMouseBeforeItIsPressedAndDragged) {
  const Frames frames = frames_of(Hand().move(10, 20).press().move(50, 60).release());
  const auto down = changes_of(frames, 0, true);
  const auto up = changes_of(frames, 0, false);
  ASSERT_EQ(down.size() + up.size(), 2U);
  EXPECT_EQ(frames[down[0] - 1].mouse_px, Eigen::Vector2d(10, 20)) << "hovered first";
  EXPECT_EQ(frames[up[0] - 1].mouse_px, Eigen::Vector2d(50, 60));
  EXPECT_TRUE(frames[up[0] - 1].buttons[0]) << "dragged there while it was held";
}

TEST(InputQueues, MakeTwoPressesOfADoubleClick) {
  const Frames frames = frames_of(Hand().move(5, 5).click().click());
  EXPECT_EQ(changes_of(frames, 0, true).size(), 2U);
  EXPECT_EQ(changes_of(frames, 0, false).size(), 2U);
}

TEST(InputQueues, KnowButtonsApart) {
  const Frames frames = frames_of(Hand().press(1).press(2).release(1).release(2));
  EXPECT_THAT(changes_of(frames, 1, true), ElementsAre(0U));
  EXPECT_THAT(changes_of(frames, 2, true), ElementsAre(1U));
  EXPECT_THAT(frames_of(Hand().click(5))[0].buttons, testing::Each(false)) << "no such button";
}

TEST(InputQueues, HoldModifiersForWhatTheyWereHeldFor) {
  for (const bool is_ctrl_first_up : {true, false}) {
    Hand hand;
    hand.key(Hand::kCtrl, true).down(Key::kP);
    if (is_ctrl_first_up) {
      hand.key(Hand::kCtrl, false).up(Key::kP);
    } else {
      hand.up(Key::kP).key(Hand::kCtrl, false);
    }
    const Frames frames = frames_of(hand);
    const auto presses = presses_of(frames, Key::kP);
    ASSERT_EQ(presses.size(), 1U);
    EXPECT_TRUE(frames[presses[0]].modifiers.ctrl);
    EXPECT_FALSE(frames.back().modifiers.ctrl);
  }
}

TEST(InputQueues, DoNotGiveAModifierToWhatWasPressedBeforeIt) {
  const Frames frames = frames_of(Hand().down(Key::kP).key(Hand::kCtrl, true).up(Key::kP));
  EXPECT_FALSE(frames[presses_of(frames, Key::kP)[0]].modifiers.ctrl);
}

TEST(InputQueues, HoldAModifierForAClickAndForTheWheel) {
  const Frames click =
      frames_of(Hand().key(Hand::kCtrl, true).click().key(Hand::kCtrl, false).click());
  const auto presses = changes_of(click, 0, true);
  ASSERT_EQ(presses.size(), 2U);
  EXPECT_TRUE(click[presses[0]].modifiers.ctrl);
  EXPECT_FALSE(click[presses[1]].modifiers.ctrl);
  const Frames wheel = frames_of(Hand().key(Hand::kShift, true).wheel(1).key(Hand::kShift, false));
  EXPECT_EQ(wheel[0].wheel.y(), 1.0);
  EXPECT_TRUE(wheel[0].modifiers.shift);
}

TEST(InputQueues, CountModifiersOfBothHands) {
  InputQueue queue;
  queue.add(Hand().key(Hand::kShift, true).key(Hand::kRightShift, true).events);
  EXPECT_TRUE(queue.next(false).modifiers.shift);
  queue.add(Hand().key(Hand::kShift, false).events);
  EXPECT_TRUE(queue.next(false).modifiers.shift);
  queue.add(Hand().key(Hand::kRightShift, false).events);
  EXPECT_FALSE(queue.next(false).modifiers.shift);
}

TEST(InputQueues, AddUpTheWheel) {
  const Frames frames = frames_of(Hand().wheel(1).wheel(1).wheel(0.5));
  ASSERT_EQ(frames.size(), 1U);
  EXPECT_EQ(frames[0].wheel.y(), 2.5);
  InputQueue queue;
  queue.add(Hand().wheel(1).events);
  EXPECT_EQ(queue.next(false).wheel.y(), 1.0);
  EXPECT_EQ(queue.next(false).wheel.y(), 0.0) << "once";
}

TEST(InputQueues, TurnTheWheelWhereTheMouseWas) {
  const Frames far = frames_of(Hand().move(10, 10).wheel(1).move(200, 10).wheel(1));
  std::map<double, double> notches;
  for (const FrameInput& frame : far) notches[frame.mouse_px->x()] += frame.wheel.y();
  EXPECT_EQ(notches[10.0], 1.0);
  EXPECT_EQ(notches[200.0], 1.0);
  InputQueue queue;
  queue.add(Hand().move(10, 10).events);
  (void)queue.next(false);
  queue.add(Hand().wheel(1).move(11, 10).wheel(1).move(12, 11).wheel(1).events);
  EXPECT_EQ(queue.next(false).wheel.y(), 3.0) << "a trembling hand does not slow it down";
}

TEST(InputQueues, DoNotFallBehindAHandThatScrollsAndMoves) {
  Hand hand;
  for (int i = 0; i < 1000; ++i) hand.move(20.0 * (i % 50), 10).wheel(1);
  const Frames frames = frames_of(hand);
  EXPECT_LT(frames.size(), 200U);
  double notches = 0.0;
  for (const FrameInput& frame : frames) notches += frame.wheel.y();
  EXPECT_EQ(notches, 1000.0);
}

TEST(InputQueues, MoveTheMouseToWhereItIs) {
  Hand hand;
  for (int i = 0; i < 1000; ++i) hand.move(i, 2.0 * i);
  const Frames frames = frames_of(hand);
  ASSERT_EQ(frames.size(), 1U);
  EXPECT_EQ(frames[0].mouse_px, Eigen::Vector2d(999, 1998));
}

TEST(InputQueues, ForgetAMouseThatLeavesUnlessItHoldsSomething) {
  EXPECT_FALSE(frames_of(Hand().move(5, 5).leave()).back().mouse_px);
  const Frames frames = frames_of(Hand().move(5, 5).press().leave().move(-40, 5).release());
  EXPECT_EQ(frames.back().mouse_px, Eigen::Vector2d(-40, 5)) << "dragged out";
  EXPECT_EQ(frames_of(Hand().leave().move(7, 8)).back().mouse_px, Eigen::Vector2d(7, 8));
}

}  // namespace input_queue_test
}  // namespace nadir::kit
