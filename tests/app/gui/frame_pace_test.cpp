// SPDX-License-Identifier: Apache-2.0
#include "app/gui/frame_pace.h"

#include <gtest/gtest.h>

namespace nadir {
namespace frame_pace_test {

/// A pace that has drawn all frames that a new window needs.
FramePace settled() {
  FramePace pace;
  for (int i = 0; i < 10; ++i) pace.draw();
  return pace;
}

TEST(FramePace, RestsWhileNothingMoves) {
  const FramePace pace = settled();
  EXPECT_DOUBLE_EQ(pace.sleep_s({}), 0.5);
  FramePace::Doings blinking;
  blinking.next_frame_within_s = 0.2;
  EXPECT_DOUBLE_EQ(pace.sleep_s(blinking), 0.2);
}

TEST(FramePace, DrawsAtOnceWhatMovesAndCalmlyWhatWorks) {
  const FramePace pace = settled();
  FramePace::Doings doings;
  doings.is_busy = true;
  EXPECT_DOUBLE_EQ(pace.sleep_s(doings), 0.05);
  doings.is_moving = true;
  EXPECT_EQ(pace.sleep_s(doings), 0.0);
}

TEST(FramePace, DrawsAFewFramesAfterEachInput) {
  FramePace pace = settled();
  // A wheel that turns on and on: each notch is followed by as many frames as the first one.
  for (int notch = 0; notch < 4; ++notch) {
    pace.hear();
    pace.draw();
  }
  int frames = 0;
  while (pace.sleep_s({}) == 0.0 && frames < 100) {
    pace.draw();
    ++frames;
  }
  EXPECT_EQ(frames, 2) << "three with that of the last notch";
  FramePace::Doings more;
  more.is_input_waiting = true;
  EXPECT_EQ(pace.sleep_s(more), 0.0);
}

TEST(FramePace, OfAMinimisedWindowGoesOnWithWorkButNeverSpins) {
  FramePace pace;
  pace.hear();
  FramePace::Doings unseen;
  unseen.is_seen = false;
  EXPECT_DOUBLE_EQ(pace.sleep_s(unseen), 0.5);
  unseen.is_moving = unseen.is_busy = unseen.is_input_waiting = true;
  EXPECT_DOUBLE_EQ(pace.sleep_s(unseen), 0.05);
}

TEST(InterfaceScale, IsNotAppliedTwice) {
  EXPECT_DOUBLE_EQ(interface_scale(2.0, 1.0), 2.0) << "a window of as many pixels as the screen";
  EXPECT_DOUBLE_EQ(interface_scale(2.0, 2.0), 1.0) << "the frame buffer is twice as fine already";
  EXPECT_DOUBLE_EQ(interface_scale(1.5, 0.0), 1.5) << "not known while it is minimised";
}

}  // namespace frame_pace_test
}  // namespace nadir
