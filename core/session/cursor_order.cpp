// SPDX-License-Identifier: Apache-2.0
#include "core/session/cursor_order.h"

namespace nadir::detail {

std::vector<NearbyStep> steps_nearby(const Cursor& cursor, std::size_t count) {
  constexpr std::size_t kPlaying = 240, kAtRest = 90;
  constexpr std::size_t kFramesPlaying = 30, kFramesAtRest = 4;
  if (cursor.index >= count) return {};
  const std::size_t reach = cursor.is_playing ? kPlaying : kAtRest;
  const std::size_t camera_reach = cursor.is_playing ? kFramesPlaying : kFramesAtRest;
  const std::size_t behind_every = cursor.is_playing ? 3 : 1;  // as CursorDistance weighs it
  const std::size_t behind_reach = cursor.is_playing ? kPlaying / 12 : kAtRest;
  const std::size_t earlier = cursor.index;
  const std::size_t later = count - 1 - cursor.index;
  const bool is_forward = cursor.direction >= 0;
  std::vector<NearbyStep> steps;
  const auto add = [&](std::size_t offset, bool is_later, bool is_with_camera) {
    if (offset > (is_later ? later : earlier)) return;
    steps.push_back({is_later ? cursor.index + offset : cursor.index - offset, is_with_camera});
  };
  for (std::size_t distance = 1; distance <= reach; ++distance) {
    add(distance, is_forward, distance <= camera_reach);
    const std::size_t behind = distance / behind_every;
    if (distance % behind_every == 0 && behind <= behind_reach) {
      add(behind, !is_forward, cursor.is_playing ? behind <= 1 : behind <= camera_reach);
    }
  }
  return steps;
}

}  // namespace nadir::detail
