// SPDX-License-Identifier: Apache-2.0
#include "app/gui/frame_pace.h"

#include <algorithm>

namespace nadir {
namespace {

/// While nothing moves the window sleeps until there is input; this often it looks at files that grow.
constexpr double kLongestSleepS = 0.5;
/// While work goes on in the background: often enough for its progress, seldom enough to leave it the processor.
constexpr double kSleepWhileWorkingS = 0.05;

}  // namespace

double FramePace::sleep_s(const Doings& doings) const {
  if (!doings.is_seen) {
    return doings.is_busy || doings.is_moving ? kSleepWhileWorkingS : kLongestSleepS;
  }
  if (doings.is_moving || doings.is_input_waiting || frames_to_draw_ > 0) return 0.0;
  const double longest_s = doings.is_busy ? kSleepWhileWorkingS : kLongestSleepS;
  return std::clamp(doings.next_frame_within_s, 0.0, longest_s);
}

double interface_scale(double content_scale, double framebuffer_scale) {
  return framebuffer_scale > 0.0 ? content_scale / framebuffer_scale : content_scale;
}

}  // namespace nadir
