// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "core/session/step_cache.h"

namespace nadir::detail {

/// How useless something is to one that looks at `here`: how many items away it is, and three times that where it lies
/// behind one that plays. 0 at `here`; rises to both sides.
struct CursorDistance {
  std::size_t here = 0;
  bool is_forward = true;
  bool is_playing = false;

  [[nodiscard]] std::size_t operator()(std::size_t index) const {
    const bool is_behind = is_forward ? index < here : index > here;
    const std::size_t away = index < here ? here - index : index - here;
    return is_playing && is_behind ? 3 * away : away;
  }
};

/// A step that may be looked at soon.
struct NearbyStep {
  std::size_t index = 0;
  bool is_with_camera =
      false;  ///< Near enough for its camera frame, which is larger and slower, too.
};

/// The steps that are worth decoding before anybody asks, by rising distance, what is ahead first; without the cursor's own.
/// Playing: 240 ahead (frames: 30) and 20 behind (1); at rest 90 on either side (4).
/// @param count  Of steps.
[[nodiscard]] std::vector<NearbyStep> steps_nearby(const Cursor& cursor, std::size_t count);

}  // namespace nadir::detail
