// SPDX-License-Identifier: Apache-2.0
// Time: where the cursor is, and how it moves.
#include <algorithm>
#include <cmath>

#include "core/session/run_comparison.h"
#include "core/session/session_core.h"

namespace nadir {
namespace {

Result<void> no_such_moment(const std::string& what) {
  return fail(ErrorCode::kInvalidOptions, "{}", what);
}

}  // namespace

void Session::Implementation::seek(double time_s) {
  const RunDocument* const run = active_document();
  const double end_s = run != nullptr ? run->duration_s() : time_s;
  const double to_s = std::clamp(time_s, 0.0, std::max(end_s, 0.0));
  if (to_s != playback.time_s) direction = to_s > playback.time_s ? 1 : -1;
  playback.time_s = to_s;
  stop_following();
}

void Session::Implementation::stop_following() {
  followed_run.clear();
  if (coming) coming->is_followed = false;
}

Result<void> Session::Implementation::perform(const actions::Seek& action) {
  if (!std::isfinite(action.time_s)) {
    return fail(ErrorCode::kInvalidOptions, "the time is not a number");
  }
  const OpenRun* const run = active();
  if (run == nullptr) return fail(ErrorCode::kInvalidOptions, "no run is open: open one first");
  if (run->document) {
    seek(action.time_s);
  } else {  // as soon as it is read
    wanted_time_s = std::max(0.0, action.time_s);
    stop_following();
  }
  return {};
}

Result<void> Session::Implementation::perform(const actions::GoToMoment& action) {
  return perform(actions::Seek{action.time_s});
}

Result<void> Session::Implementation::perform(const actions::StepBy& action) {
  const auto run = need_run();
  if (!run) return forward_error(run);
  const RunDocument& document = *(*run)->document;
  const auto now = static_cast<std::int64_t>(document.index_at(playback.time_s).value_or(0));
  const auto last = static_cast<std::int64_t>(document.time_s.size()) - 1;
  const std::int64_t to = std::clamp<std::int64_t>(now + action.steps, 0, last);
  seek(document.time_s[static_cast<std::size_t>(to)]);
  return {};
}

Result<void> Session::Implementation::perform(const actions::GoTo& action) {
  const auto needed = need_run();
  if (!needed) return forward_error(needed);
  const OpenRun& run = **needed;
  const double now_s = playback.time_s;
  const auto to_moment = [this](const WorstMoment* moment, const char* otherwise) {
    if (moment == nullptr) return no_such_moment(otherwise);
    seek(moment->time_s);
    return Result<void>();
  };
  const auto to_bookmark = [&](std::optional<std::size_t> index, const char* otherwise) {
    if (!index) return no_such_moment(otherwise);
    seek(run.bookmarks[*index].time_s);
    return Result<void>();
  };
  switch (action.moment) {
    case Moment::kStart:
      seek(playback.loop_from_s.value_or(0.0));
      return {};
    case Moment::kEnd:
      seek(playback.loop_to_s.value_or(run.document->duration_s()));
      if (run.is_live) followed_run = run.path.string();
      return {};
    case Moment::kWorst:
      return to_moment(most_severe(run.moments), "nothing of this run stands out");
    case Moment::kNextWorst:
      return to_moment(next_moment(run.moments, now_s), "no worst moment comes after this one");
    case Moment::kPreviousWorst:
      return to_moment(previous_moment(run.moments, now_s), "no worst moment lies before this one");
    case Moment::kNextBookmark:
      return to_bookmark(next_bookmark(run.bookmarks, now_s),
                         "no bookmark comes after this moment");
    case Moment::kPreviousBookmark:
      return to_bookmark(previous_bookmark(run.bookmarks, now_s),
                         "no bookmark lies before this moment");
  }
  return {};
}

Result<void> Session::Implementation::perform(const actions::Play& action) {
  const bool is_wanted = switched(playback.is_playing, action.to);
  if (is_wanted) {
    const auto run = need_run();
    if (!run) return forward_error(run);
    // At the end, again from the beginning.
    const double end_s = playback.loop_to_s.value_or((*run)->document->duration_s());
    if (playback.time_s >= end_s) playback.time_s = playback.loop_from_s.value_or(0.0);
    stop_following();
    direction = 1;
  }
  playback.is_playing = is_wanted;
  return {};
}

Result<void> Session::Implementation::perform(const actions::SetSpeed& action) {
  if (!(action.speed >= kLeastSpeed && action.speed <= kMostSpeed)) {
    return fail(ErrorCode::kInvalidOptions, "a speed of {:g} is not in [{:g}, {:g}]", action.speed,
                double{kLeastSpeed}, double{kMostSpeed});
  }
  playback.speed = action.speed;
  return {};
}

Result<void> Session::Implementation::perform(const actions::SetLoop& action) {
  if (!action.from_s && !action.to_s) {
    playback.loop_from_s.reset();
    playback.loop_to_s.reset();
    return {};
  }
  const auto run = need_run();
  if (!run) return forward_error(run);
  if (!action.from_s || !action.to_s) {
    return fail(ErrorCode::kInvalidOptions, "a range has a beginning and an end");
  }
  const double end_s = (*run)->document->duration_s();
  const double from_s = std::clamp(*action.from_s, 0.0, end_s);
  const double to_s = std::clamp(*action.to_s, 0.0, end_s);
  if (!(from_s < to_s)) {
    return fail(ErrorCode::kInvalidOptions, "from {:g} s to {:g} s there is nothing of this run",
                *action.from_s, *action.to_s);
  }
  playback.loop_from_s = from_s;
  playback.loop_to_s = to_s;
  return {};
}

Result<void> Session::Implementation::perform(const actions::GoToDivergence& action) {
  const auto needed = need_run();
  if (!needed) return forward_error(needed);
  const auto index = run_of(action.run);
  if (!index) return forward_error(index);
  const OpenRun& other = runs[*index];
  if (&other == *needed) {
    return fail(ErrorCode::kInvalidOptions, "{} is the active run itself", other.name);
  }
  if (!other.document) {
    return fail(ErrorCode::kInvalidOptions, "{} is still being read", other.name);
  }
  if (!are_of_same_flight((*needed)->document->header, other.document->header)) {
    return fail(ErrorCode::kInvalidOptions, "{} and {} are of different flights", (*needed)->name,
                other.name);
  }
  const auto parting = first_divergence(*(*needed)->document, *other.document);
  if (!parting) {
    return fail(ErrorCode::kInvalidOptions, "{} and {} never part: they are nowhere {}",
                (*needed)->name, other.name, divergence_words());
  }
  seek(parting->time_s);
  add_notice(Notice::Kind::kInfo,
             fmt::format("{} and {} part here, {}: parted is {}", (*needed)->name, other.name,
                         parting->words, divergence_words()));
  return {};
}

void Session::Implementation::settle_time() {
  const OpenRun* const run = active();
  const std::string path = run != nullptr ? run->path.string() : std::string();
  if (wanted_time_s) {
    playback.time_s = *wanted_time_s;
    timed_path = path;
    timed_run.reset();
    wanted_time_s.reset();
  }
  if (run == nullptr) {
    playback.is_playing = false;
    stop_following();
    return;
  }
  if (!run->document) return;
  const RunDocument& now = *run->document;
  if (path != timed_path && timed_run) {
    if (are_of_same_flight(timed_run->header, now.header)) {
      const double shift_s = timed_run->start_clock_s - now.start_clock_s;
      playback.time_s += shift_s;
      if (playback.loop_from_s) *playback.loop_from_s += shift_s;
      if (playback.loop_to_s) *playback.loop_to_s += shift_s;
    } else {
      playback.time_s = 0.0;
      playback.loop_from_s.reset();
      playback.loop_to_s.reset();
      playback.is_playing = false;
    }
  }
  if (path != timed_path || !timed_run || timed_run->start_clock_s != now.start_clock_s) {
    timed_run = TimedRun{now.header, now.start_clock_s};
  }
  timed_path = path;
  const double end_s = now.duration_s();
  if (followed_run == path) playback.time_s = end_s;
  // What is being written may still come to where the cursor waits.
  if (!run->is_live) playback.time_s = std::min(playback.time_s, end_s);
  playback.time_s = std::max(playback.time_s, 0.0);
  if (playback.loop_from_s && (*playback.loop_from_s < 0.0 || *playback.loop_from_s >= end_s)) {
    playback.loop_from_s.reset();
    playback.loop_to_s.reset();
  }
  if (playback.loop_to_s && !run->is_live) {
    playback.loop_to_s = std::min(*playback.loop_to_s, end_s);
  }
}

void Session::Implementation::move_on(double elapsed_s) {
  const RunDocument* const run = active_document();
  if (!playback.is_playing || run == nullptr || !(elapsed_s > 0.0)) return;
  const double to_s = playback.time_s + elapsed_s * playback.speed;
  direction = 1;
  if (playback.loop_from_s && playback.loop_to_s) {
    const double from_s = *playback.loop_from_s, length_s = *playback.loop_to_s - from_s;
    // A cursor outside the range comes into it.
    playback.time_s = to_s >= from_s && to_s < from_s + length_s
                          ? to_s
                          : from_s + std::fmod(std::max(0.0, to_s - from_s), length_s);
    return;
  }
  playback.time_s = std::min(to_s, run->duration_s());
  const OpenRun* const open = active();
  if (to_s >= run->duration_s() && !open->is_live) playback.is_playing = false;
}

}  // namespace nadir
