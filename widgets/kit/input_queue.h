// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <vector>

#include "widgets/gl/window_event.h"
#include "widgets/kit/frame_input.h"

namespace nadir::kit {

/// Spreads what a hand did over frames. A frame knows how things stand, not what happened: a key that went down and up while
/// a slow frame was drawn would never have been pressed. So no frame is told two doings of which the second would hide the
/// first: what comes next then waits, in its order, for the next frame, which should follow at once.
///
/// - A key or button changes at most once a frame, and one of them at most is pressed in it.
/// - The mouse stands still while a button changes, so that a press happens where it was made, and over what was seen there.
/// - Modifiers change before or after what they are held for.
/// - Text stays between the keys and buttons that it was typed between. What follows a shortcut or a click waits a frame, for
///   that may have opened something that takes it. Letters that go into a text are no keys: however many of them came, they
///   are typed in one frame.
///
/// Movements and notches of the wheel add up while they wait, so that what waits is bounded by how fast a hand presses.
class InputQueue {
 public:
  void add(const std::vector<WindowEvent>& events);

  /// As much as one frame may be told. @param is_typing  A text takes what is typed.
  [[nodiscard]] FrameInput next(bool is_typing);

  /// Something waits for another frame.
  [[nodiscard]] bool is_waiting() const { return !waiting_.empty(); }

 private:
  /// What has been told to the frame that next() makes.
  struct Told;
  [[nodiscard]] bool fits(const WindowEvent& event, const Told& told, bool is_typing) const;
  [[nodiscard]] bool fits_key(const WindowEvent& event, const Told& told, bool is_typing) const;
  void tell(const WindowEvent& event, Told& told, bool is_typing);
  void tell_key(const WindowEvent& event, Told& told, bool is_typing);
  [[nodiscard]] bool is_letter(const WindowEvent& event, bool is_typing) const;
  void merge(const WindowEvent& event);

  std::deque<WindowEvent> waiting_;
  FrameInput frame_;                      ///< How things stand.
  std::vector<int> modifiers_;            ///< Held down.
  int last_pressed_ = 0;                  ///< Key; 0: it was a button.
  int frames_since_press_ = kManyFrames;  ///< And since a button came up.
  static constexpr int kManyFrames = 1000;
};

}  // namespace nadir::kit
