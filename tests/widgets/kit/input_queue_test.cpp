// SPDX-License-Identifier: Apache-2.0
#include "widgets/kit/input_queue.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <map>
#include <random>

#include "tests/widgets/kit/hand_events.h"
#include "widgets/kit/ui_context.h"

namespace nadir::kit {
namespace input_queue_test {

using testing::ElementsAre;
using testing::IsEmpty;
using Frames = std::vector<FrameInput>;

/// The frames that all of it takes, which came before the first of them was drawn.
Frames frames_of(const Hand& hand, bool is_typing = false) {
  InputQueue queue;
  queue.add(hand.events);
  Frames frames;
  do {
    frames.push_back(queue.next(is_typing));
  } while (queue.is_waiting() && frames.size() < 100'000);
  return frames;
}

bool is_held(const FrameInput& frame, Key key) {
  return std::find(frame.keys.begin(), frame.keys.end(), key) != frame.keys.end();
}

/// Frames in which the key went down, as Dear ImGui sees it.
std::vector<std::size_t> presses_of(const Frames& frames, Key key) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (is_held(frames[i], key) && (i == 0 || !is_held(frames[i - 1], key))) found.push_back(i);
  }
  return found;
}

/// Frames in which the button went down (or came up).
std::vector<std::size_t> changes_of(const Frames& frames, std::size_t button, bool to_down) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const bool was_down = i > 0 && frames[i - 1].buttons.at(button);
    if (frames[i].buttons.at(button) == to_down && was_down != to_down) found.push_back(i);
  }
  return found;
}

std::string text_of(const Frames& frames) {
  std::string all;
  for (const FrameInput& frame : frames) all += frame.characters;
  return all;
}

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

TEST(InputQueues, TypeAWholeSentenceInOneFrame) {
  const std::string sentence = "error surface around the estimate at 12 s";
  const Frames frames = frames_of(Hand().type(sentence), true);
  ASSERT_EQ(frames.size(), 1U);
  EXPECT_EQ(frames[0].characters, sentence);
  EXPECT_THAT(frames[0].keys, IsEmpty()) << "letters of a text are no keys";
}

TEST(InputQueues, KeepTheOrderOfTextAndTheKeysThatEditIt) {
  const Frames frames = frames_of(Hand().type("ab").tap(Key::kBackspace).type("c"), true);
  const auto presses = presses_of(frames, Key::kBackspace);
  ASSERT_EQ(presses.size(), 1U);
  std::string before, after;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    // Dear ImGui takes the characters of a frame before its keys.
    (i <= presses[0] ? before : after) += frames[i].characters;
  }
  EXPECT_EQ(before, "ab");
  EXPECT_EQ(after, "c");
}

TEST(InputQueues, TypeNothingIntoWhatWasClickedAwayFrom) {
  const Frames frames = frames_of(Hand().move(5, 5).type("ab").click().type("c"), true);
  const auto down = changes_of(frames, 0, true);
  ASSERT_EQ(down.size(), 1U);
  EXPECT_EQ(frames[down[0]].characters, "");
  EXPECT_EQ(text_of({frames.begin(), frames.begin() + static_cast<long>(down[0])}), "ab");
  EXPECT_EQ(text_of(frames), "abc");
}

TEST(InputQueues, GiveWhatAShortcutOpensAFrameBeforeText) {
  InputQueue queue;
  queue.add(Hand().chord(Key::kP).type("open").events);
  const FrameInput first = queue.next(false);
  EXPECT_TRUE(is_held(first, Key::kP));
  EXPECT_TRUE(first.modifiers.ctrl);
  const FrameInput second = queue.next(false);
  EXPECT_EQ(second.characters, "") << "here the palette comes and takes the keyboard";
  const FrameInput third = queue.next(true);
  EXPECT_EQ(third.characters, "open");
  EXPECT_FALSE(queue.is_waiting());
}

TEST(InputQueues, DoNotKeepLettersBackWhereNothingOpened) {
  const Frames frames = frames_of(Hand().chord(Key::kP).type("m"));
  EXPECT_EQ(presses_of(frames, Key::kM).size(), 1U);
  EXPECT_EQ(text_of(frames), "m");
  EXPECT_LE(frames.size(), 4U);
}

TEST(InputQueues, TellSignsOfChordsOneAFrame) {
  const Frames frames = frames_of(Hand().type("[[]"));
  EXPECT_EQ(text_of(frames), "[[]");
  for (const FrameInput& frame : frames) EXPECT_LE(frame.characters.size(), 1U);
}

TEST(InputQueues, TakeWhatAHeldKeyRepeatsForOneOutsideOfTexts) {
  Hand hand;
  hand.down(Key::kLeftBracket);
  for (int i = 0; i < 30; ++i) hand.character('[');
  EXPECT_EQ(text_of(frames_of(hand)), "[") << "a slow frame does not fall behind for good";
  EXPECT_EQ(text_of(frames_of(hand, true)), std::string(30, '['));
}

TEST(InputQueues, TypeWithTheRightAltWhatStandsThere) {
  const Frames frames = frames_of(Hand()
                                      .key(Hand::kRightAlt, true)
                                      .down(Key::k8)
                                      .character('[')
                                      .up(Key::k8)
                                      .key(Hand::kRightAlt, false));
  EXPECT_EQ(text_of(frames), "[");
  EXPECT_EQ(presses_of(frames, Key::k8).size(), 1U);
}

TEST(InputQueues, WriteCharactersAsUtf8) {
  const Frames frames =
      frames_of(Hand().character('a').character(0xE4).character(0x20AC).character(0x1F6F0), true);
  EXPECT_EQ(text_of(frames), "aä€🛰");
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

/// A hand that does anything, the same each time. Keys come up only after they went down.
Hand busy_hand(std::mt19937& random, int count) {
  const std::vector<Key> keys = {Key::kRight, Key::kEnter, Key::kF, Key::kM, Key::k1};
  std::map<int, bool> is_down;
  Hand hand;
  const auto roll = [&random](unsigned sides) { return static_cast<int>(random() % sides); };
  for (int i = 0; i < count; ++i) {
    switch (roll(6)) {
      case 0:
        hand.move(roll(500), roll(500));
        break;
      case 1:
        hand.wheel(roll(2) == 0 ? 1.0 : -1.0);
        break;
      case 2: {
        const int button = roll(3);
        bool& state = is_down[button];
        state ? hand.release(button) : hand.press(button);
        state = !state;
        break;
      }
      case 3: {
        const int modifier = Hand::kShift + roll(4);
        bool& state = is_down[modifier];
        hand.key(modifier, !state);
        state = !state;
        break;
      }
      default: {
        const int code = static_cast<int>(keys[static_cast<std::size_t>(roll(5))]);
        bool& state = is_down[code];
        hand.key(code, !state);
        if (!state && code < 128) hand.character(code);
        state = !state;
      }
    }
  }
  return hand;
}

TEST(InputQueues, LoseNothingWhateverAHandDoes) {
  std::mt19937 random(7);
  for (int round = 0; round < 200; ++round) {
    const Hand hand = busy_hand(random, 120);
    const Frames frames = frames_of(hand);
    std::map<int, std::size_t> key_presses;
    std::array<std::size_t, 3> presses = {}, releases = {};
    std::string text;
    double notches = 0.0;
    for (const WindowEvent& event : hand.events) {
      if (event.kind == WindowEvent::Kind::kKey && event.is_down) ++key_presses[event.code];
      if (event.kind == WindowEvent::Kind::kButton)
        ++(event.is_down ? presses : releases).at(static_cast<std::size_t>(event.code));
      if (event.kind == WindowEvent::Kind::kCharacter) text += static_cast<char>(event.code);
      if (event.kind == WindowEvent::Kind::kWheel) notches += event.at.y();
    }
    for (const auto& [code, count] : key_presses) {
      if (code < Hand::kShift) {
        EXPECT_EQ(presses_of(frames, static_cast<Key>(code)).size(), count) << round;
      }
    }
    for (std::size_t button = 0; button < 3; ++button) {
      EXPECT_EQ(changes_of(frames, button, true).size(), presses.at(button));
      EXPECT_EQ(changes_of(frames, button, false).size(), releases.at(button));
    }
    EXPECT_EQ(text_of(frames), text);
    double turned = 0.0;
    for (const FrameInput& frame : frames) turned += frame.wheel.y();
    EXPECT_EQ(turned, notches);
    EXPECT_LE(frames.size(), 2 * hand.events.size()) << "what waits is told soon";
  }
}

TEST(InputQueues, PressAtMostOneThingAFrame) {
  std::mt19937 random(11);
  for (int round = 0; round < 50; ++round) {
    const Frames frames = frames_of(busy_hand(random, 200));
    for (std::size_t i = 1; i < frames.size(); ++i) {
      int pressed = 0;
      for (const Key key : frames[i].keys) pressed += is_held(frames[i - 1], key) ? 0 : 1;
      for (std::size_t button = 0; button < 3; ++button) {
        pressed += frames[i].buttons.at(button) && !frames[i - 1].buttons.at(button) ? 1 : 0;
      }
      EXPECT_LE(pressed, 1);
    }
  }
}

/// A window whose frames are so slow that all of a gesture came before the next one.
class SlowWindow {
 public:
  template <class Draw>
  void play(const Hand& hand, const Draw& draw) {
    queue_.add(hand.events);
    for (int i = 0; i < 2 || queue_.is_waiting(); ++i) {
      const FrameInput input = queue_.next(context.is_typing());
      Ui& ui = context.begin_frame(input);
      {
        const auto region = ui.region("", ui.screen());
        draw(ui);
      }
      context.end_frame();
    }
  }
  [[nodiscard]] Rect rect_of(const std::string& path) const {
    for (const Control& control : context.controls()) {
      if (control.path == path) return control.rect;
    }
    return {};
  }
  UiContext context;

 private:
  InputQueue queue_;
};

TEST(SlowWindows, ClickWhatIsPressedAndLetGoBetweenTwoFrames) {
  SlowWindow window;
  int clicks = 0, picked = 0;
  const auto draw = [&](Ui& ui) {
    clicks += ui.button("Go") ? 1 : 0;
    picked += ui.list_row("row").was_double_clicked ? 1 : 0;
  };
  window.play({}, draw);
  const Eigen::Vector2d go = window.rect_of("Go").centre();
  const Eigen::Vector2d row = window.rect_of("row").centre();
  window.play(Hand().move(go.x(), go.y()).click().click().click(), draw);
  EXPECT_EQ(clicks, 3);
  window.play(Hand().move(row.x(), row.y()).click().click(), draw);
  EXPECT_EQ(picked, 1);
}

TEST(SlowWindows, DragASliderToWhereItWasLetGo) {
  SlowWindow window;
  double value = 5.0;
  NumberOptions options;
  options.least = 0.0;
  options.most = 10.0;
  const auto draw = [&](Ui& ui) {
    const auto edit = ui.slider("Noise", value, options);
    if (edit.is_changed || edit.was_committed) value = edit.value;
  };
  window.play({}, draw);
  const Rect track = window.rect_of("Noise");
  window.play(Hand()
                  .move(track.centre().x(), track.centre().y())
                  .press()
                  .move(track.right() + 50.0, track.centre().y())
                  .release()
                  .move(0, 0),
              draw);
  EXPECT_EQ(value, 10.0);
}

TEST(SlowWindows, TypeIntoWhatAShortcutOpens) {
  SlowWindow window;
  bool is_open = false;
  std::string typed, entered;
  const auto draw = [&](Ui& ui) {
    if (!is_open) {
      if (ui.is_pressed("Ctrl+P")) is_open = true;
      return;
    }
    TextOptions options;
    options.takes_focus = true;
    const TextEdit edit = ui.text_input("Command", typed, options);
    typed = edit.value;
    if (edit.was_entered) entered = edit.value;
  };
  window.play(Hand().chord(Key::kP).type("open the demo").tap(Key::kEnter), draw);
  EXPECT_EQ(entered, "open the demo");
}

TEST(SlowWindows, TypeIntoANumberThatWasDoubleClicked) {
  SlowWindow window;
  double value = 5.0;
  const auto draw = [&](Ui& ui) {
    const auto edit = ui.number_input("Noise", value, {});
    if (edit.was_committed) value = edit.value;
  };
  window.play({}, draw);
  const Eigen::Vector2d at = window.rect_of("Noise").centre();
  window.play(Hand().move(at.x(), at.y()).click().click().type("12").tap(Key::kEnter), draw);
  EXPECT_EQ(value, 12.0);
}

}  // namespace input_queue_test
}  // namespace nadir::kit
