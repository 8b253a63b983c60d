// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "tests/widgets/kit/hand_events.h"
#include "widgets/kit/frame_input.h"
#include "widgets/kit/input_queue.h"

namespace nadir::kit {

using Frames = std::vector<FrameInput>;

/// The frames that all of it takes, which came before the first of them was drawn.
[[nodiscard]] inline Frames frames_of(const Hand& hand, bool is_typing = false) {
  InputQueue queue;
  queue.add(hand.events);
  Frames frames;
  do {
    frames.push_back(queue.next(is_typing));
  } while (queue.is_waiting() && frames.size() < 100'000);
  return frames;
}

[[nodiscard]] inline bool is_held(const FrameInput& frame, Key key) {
  return std::find(frame.keys.begin(), frame.keys.end(), key) != frame.keys.end();
}

/// Frames in which the key went down, as Dear ImGui sees it.
[[nodiscard]] inline std::vector<std::size_t> presses_of(const Frames& frames, Key key) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (is_held(frames[i], key) && (i == 0 || !is_held(frames[i - 1], key))) found.push_back(i);
  }
  return found;
}

/// Frames in which the button went down (or came up).
[[nodiscard]] inline std::vector<std::size_t> changes_of(const Frames& frames,
                                                         std::size_t button,
                                                         bool to_down) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const bool was_down = i > 0 && frames[i - 1].buttons.at(button);
    if (frames[i].buttons.at(button) == to_down && was_down != to_down) found.push_back(i);
  }
  return found;
}

[[nodiscard]] inline std::string text_of(const Frames& frames) {
  std::string all;
  for (const FrameInput& frame : frames) all += frame.characters;
  return all;
}

}  // namespace nadir::kit
