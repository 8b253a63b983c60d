// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/timeline_model.h"

#include <algorithm>

#include "core/session/session.h"
#include "widgets/panels/run_labels.h"

namespace nadir {

const TimelineRun* TimelineModel::active() const {
  return runs.empty() || !runs.back().is_active ? nullptr : &runs.back();
}

TimelineModel::Extent TimelineModel::extent() const {
  Extent extent{0.0, 0.0, 0.0};
  for (const TimelineRun& run : runs) {
    extent.from_s = std::min(extent.from_s, run.offset_s);
    extent.to_s = std::max(extent.to_s, run.offset_s + run.document->duration_s());
    if (run.is_active) extent.last_s = run.document->duration_s();
    if (run.is_live || (run.is_active && run.is_incomplete)) {
      extent.to_s = std::max(extent.to_s, run.offset_s + flight_end_s(run));
    }
  }
  if (!(extent.to_s > extent.from_s)) extent.to_s = extent.from_s + 1.0;  // one step, or none
  return extent;
}

double TimelineModel::flight_end_s(const TimelineRun& run) const {
  const bool is_begun = !run.document->time_s.empty();
  if (!is_begun || flight == nullptr || flight->description().frames.empty()) return 0.0;
  return flight->description().frames.back().time_s - run.document->start_clock_s;
}

TimelineModel timeline_model(const Session& session) {
  TimelineModel model;
  const Playback& playback = session.playback();
  model.time_s = playback.time_s;
  model.is_playing = playback.is_playing;
  model.speed = playback.speed;
  model.loop_from_s = playback.loop_from_s;
  model.loop_to_s = playback.loop_to_s;
  model.strips = session.view().layout.strips;
  model.flight = session.flight();
  const OpenRun* const active = session.active_run();
  if (active == nullptr) return model;
  if (active->document == nullptr) {
    (active->is_live ? model.coming : model.reading) = active->name;
    return model;
  }
  model.moments = active->moments;
  model.bookmarks = active->bookmarks;
  const ViewState& view = session.view();
  for (std::size_t i = 0; i < session.runs().size(); ++i) {
    const OpenRun& run = session.runs()[i];
    const bool is_active = &run == active;
    if (run.document == nullptr || (!is_active && !view.runs[i].is_shown)) continue;
    // One moment of the flight is at one place, whichever run speaks of it.
    const double offset_s = run.document->steps.empty() || active->document->steps.empty()
                                ? 0.0
                                : run.document->time_in(*active->document, 0.0);
    model.runs.push_back({static_cast<int>(i) + 1, run.name, view.runs[i].colour, is_active,
                          run.is_live, offset_s, run.document,
                          is_incomplete(*run.document, run.is_live)});
  }
  std::stable_sort(
      model.runs.begin(), model.runs.end(),
      [](const TimelineRun& a, const TimelineRun& b) { return !a.is_active && b.is_active; });
  return model;
}

}  // namespace nadir
