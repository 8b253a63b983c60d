// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

namespace nadir {

/// When what the hand does is over, so that what it does next is a step of undo of its own: notches of the wheel, presses of a
/// key that is held, and drags that follow each other quickly belong together, however long one of them rests. It has no clock
/// of its own.
class UndoPace {
 public:
  static constexpr double kTogetherS = 0.7;

  /// At the beginning of a frame. @param elapsed_s  Since the last one. @returns whether what was done before is over.
  [[nodiscard]] bool is_over(double elapsed_s) {
    if (!is_held_) since_s_ += elapsed_s;
    return since_s_ > kTogetherS;
  }
  /// At its end. @param has_asked  For anything, in this frame. @param is_held  A button, or a text that is being typed.
  void note(bool has_asked, bool is_held) {
    if (has_asked || is_held) since_s_ = 0.0;
    is_held_ = is_held;
  }

 private:
  double since_s_ = std::numeric_limits<double>::infinity();
  bool is_held_ = false;
};

}  // namespace nadir
