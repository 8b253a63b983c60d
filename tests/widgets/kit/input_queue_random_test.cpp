// SPDX-License-Identifier: Apache-2.0
// Hands that do anything: nothing is lost, and nothing hidden by what follows.
#include <gmock/gmock.h>

#include <map>
#include <random>

#include "tests/widgets/kit/queued_frames.h"

namespace nadir::kit {
namespace input_queue_random_test {

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

}  // namespace input_queue_random_test
}  // namespace nadir::kit
