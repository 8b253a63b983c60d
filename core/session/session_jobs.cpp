// SPDX-License-Identifier: Apache-2.0
// Work that goes on: what there is of it, how far it is, and how it is stopped.
#include <algorithm>

#include "core/session/session_core.h"

namespace nadir {

std::vector<JobStatus> Session::Implementation::jobs() const {
  std::vector<JobStatus> list;
  const auto add = [&list](int number, std::string title, const JobProgress& progress,
                           bool will_be_shown, bool is_stopping) {
    list.push_back({number, std::move(title), progress.fraction, progress.activity,
                    progress.remaining_s(), will_be_shown, is_stopping});
  };
  for (std::size_t i = 0; i < works.size(); ++i) {
    if (works[i].reading && !runs[i].document) {
      add(works[i].number, "reading " + runs[i].name, works[i].reading->progress(), false, false);
    }
  }
  for (const RerunWork& work : reruns) {
    const OpenRun* const run = active();
    const bool is_waited_for = run != nullptr && run->path == work.run && !run->document;
    add(work.number, (work.is_cancelled ? "stopping " : "localising ") + work.name,
        work.job.progress(), is_waited_for, work.is_cancelled);
  }
  if (labels && labels->opening) {
    add(labels->number,
        "opening the labels of " + std::filesystem::path(labels->path).filename().string(),
        labels->opening->progress(), false, false);
  }
  for (const SmallWork& work : small_works) {
    add(work.number, work.title, work.job.progress(), false, work.is_cancelled);
  }
  for (const EffectWork& work : effect_works) {
    JobProgress progress{work.fraction, work.activity, 0.0};
    progress.elapsed_s =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - work.began).count();
    add(work.number, work.title, progress, work.opens_result && active() == nullptr,
        work.is_cancelled);
  }
  std::sort(list.begin(), list.end(),
            [](const JobStatus& a, const JobStatus& b) { return a.number < b.number; });
  return list;
}

bool Session::Implementation::is_busy() const {
  const bool is_reading =
      map_reading.has_value() ||
      std::any_of(works.begin(), works.end(),
                  [](const RunWork& work) {
                    return work.reading ||
                           (work.live && work.live->stage == LiveRun::Stage::kEnded);
                  }) ||
      std::any_of(flights.begin(), flights.end(),
                  [](const auto& flight) { return flight.second.reading.has_value(); });
  const bool is_decoding = std::any_of(runs.begin(), runs.end(), [](const OpenRun& run) {
    return run.cache && !run.cache->is_cursor_ready();
  });
  const bool is_labelling = labels && (labels->opening || !labels->is_counted);
  return playback.is_playing || is_labelling || is_reading || is_decoding || !reruns.empty() ||
         !small_works.empty() || !effect_works.empty();
}

Result<void> Session::Implementation::perform(const actions::CancelJob& action) {
  const std::vector<JobStatus> all = jobs();
  if (all.empty()) return fail(ErrorCode::kInvalidOptions, "no work is going on");
  // Asked for twice, two works stop, although the first of them is still there.
  const auto going_on =
      std::find_if(all.rbegin(), all.rend(), [](const JobStatus& job) { return !job.is_stopping; });
  const int newest = going_on == all.rend() ? all.back().number : going_on->number;
  const int number = action.job.value_or(newest);
  const auto is_it = [number](const auto& work) { return work.number == number; };
  if (const auto work = std::find_if(reruns.begin(), reruns.end(), is_it); work != reruns.end()) {
    work->is_cancelled = true;
    work->job.request_stop();
    return {};
  }
  const auto small = std::find_if(small_works.begin(), small_works.end(), is_it);
  if (small != small_works.end()) {
    small->is_cancelled = true;
    small->job.request_stop();
    return {};
  }
  const auto effect = std::find_if(effect_works.begin(), effect_works.end(), is_it);
  if (effect != effect_works.end()) {
    if (!effect->is_cancelled) cancelled_effects.push_back(number);
    effect->is_cancelled = true;
    effect->activity = "stopping";
    return {};
  }
  if (labels && labels->opening && labels->number == number) {
    return perform(actions::CloseLabels{});
  }
  const auto reading = std::find_if(works.begin(), works.end(), is_it);
  if (reading == works.end() || !reading->reading) {
    return fail(ErrorCode::kInvalidOptions, "there is no work {}", number);
  }
  take_run_out(kept.view, runs[static_cast<std::size_t>(reading - works.begin())].path.string());
  return {};
}

}  // namespace nadir
