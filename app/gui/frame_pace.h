// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

namespace nadir {

/// When the window on the desktop draws its next frame: at once while something moves and for a few frames after input, which
/// open and settle what it asked for; calmly while work goes on; else when there is input. It has no clock of its own.
class FramePace {
 public:
  struct Doings {
    bool is_moving = false;  ///< The very next frame shows something else.
    bool is_busy = false;    ///< Work goes on, whose progress shows.
    bool is_input_waiting = false;
    bool is_seen = true;  ///< False: minimised. Nothing is drawn then, but work has to go on.
    double next_frame_within_s =
        std::numeric_limits<double>::infinity();  ///< Of what blinks or appears late.
  };

  /// How long to wait for input at most, in seconds; 0: not at all.
  [[nodiscard]] double sleep_s(const Doings& doings) const;
  /// Something came from outside: input, a file that was dropped, another size.
  void hear() { frames_to_draw_ = kFramesAfterInput; }
  /// A frame was drawn.
  void draw() { frames_to_draw_ -= frames_to_draw_ > 0 ? 1 : 0; }

 private:
  static constexpr int kFramesAfterInput = 3;
  int frames_to_draw_ = kFramesAfterInput;
};

/// The interface's own scale on a screen. @param content_scale  That the screen asks for. @param framebuffer_scale  Pixels of
/// the frame buffer for one that the interface counts: so much larger all of it is drawn already.
[[nodiscard]] double interface_scale(double content_scale, double framebuffer_scale);

}  // namespace nadir
