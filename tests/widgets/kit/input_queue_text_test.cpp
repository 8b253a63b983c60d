// SPDX-License-Identifier: Apache-2.0
// Text that waits between keys and buttons.
#include <gmock/gmock.h>

#include "tests/widgets/kit/queued_frames.h"

namespace nadir::kit {
namespace input_queue_text_test {

using testing::IsEmpty;

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

}  // namespace input_queue_text_test
}  // namespace nadir::kit
