// SPDX-License-Identifier: Apache-2.0
// Decoded steps: how much memory they get, and which are wanted.
#include <algorithm>

#include "core/session/session_core.h"

namespace nadir {

void Session::Implementation::share_memory() {
  const auto count = static_cast<std::size_t>(std::count_if(
      runs.begin(), runs.end(), [](const OpenRun& run) { return run.cache != nullptr; }));
  if (count == 0) return;
  const std::size_t bytes = (static_cast<std::size_t>(kept.memory_megabytes) << 20U) / count;
  for (OpenRun& run : runs) {
    if (run.cache) run.cache->set_budget_bytes(bytes);
  }
}

void Session::Implementation::request_steps() {
  const RunDocument* const here = active_document();
  if (here == nullptr) return;
  const WindowLayout& layout = kept.view.layout;
  const bool shows_camera =
      !layout.is_map_only &&
      (layout.shows(Panel::kCamera) || layout.shows(Panel::kMoment) || layout.shows(Panel::kScene));
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (!runs[i].cache || !kept.view.runs.at(i).is_shown) continue;
    const RunDocument& there = *runs[i].document;
    // Of one that will be shown from its end on, that is what will be seen.
    const bool begins_at_end = coming && coming->is_followed && runs[i].path == coming->path;
    const auto index =
        there.index_at(begins_at_end ? there.duration_s() : here->time_in(there, playback.time_s));
    if (!index) continue;
    const bool is_active = static_cast<int>(i) + 1 == kept.view.active_run;
    runs[i].cache->request({*index, direction, playback.is_playing, is_active && shows_camera});
  }
}

}  // namespace nadir
