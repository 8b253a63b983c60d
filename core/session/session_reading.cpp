// SPDX-License-Identifier: Apache-2.0
// Runs on their way from the disk. All reading is done by jobs; this takes over what they have read.
#include <algorithm>
#include <set>
#include <system_error>
#include <utility>

#include "core/session/session_core.h"

namespace nadir {
namespace fs = std::filesystem;

namespace {

constexpr double kLeastBetweenReadingsS = 0.25;
constexpr double kBetweenLooksS = 1.0;  // at a run that another program may be writing

/// The file's name, with its folder or a number where another open run is called so.
std::string name_of_run(const fs::path& path, const std::set<std::string>& taken) {
  std::string stem = path.stem().string();
  if (!taken.contains(stem)) return stem;
  std::string with_folder = stem + " (" + path.parent_path().filename().string() + ")";
  if (!taken.contains(with_folder)) return with_folder;
  for (int number = 2;; ++number) {
    std::string numbered = fmt::format("{} ({})", stem, number);
    if (!taken.contains(numbered)) return numbered;
  }
}

}  // namespace

FileState file_state(const fs::path& path) {
  std::error_code error;
  FileState state;
  state.bytes = fs::file_size(path, error);
  state.written = fs::last_write_time(path, error);
  return state;
}

bool Session::Implementation::is_being_written(const fs::path& run) const {
  return std::any_of(reruns.begin(), reruns.end(),
                     [&](const RerunWork& work) { return work.run == run; });
}

void Session::Implementation::reconcile() {
  const ViewState& view = kept.view;
  const bool are_the_same =
      std::equal(runs.begin(), runs.end(), view.runs.begin(), view.runs.end(),
                 [](const OpenRun& run, const RunLook& look) { return run.path == look.path; });
  if (!are_the_same) reconcile_runs();
  std::erase_if(map_wishes, [&view](const auto& wish) {
    return std::none_of(view.runs.begin(), view.runs.end(),
                        [&wish](const RunLook& look) { return look.path == wish.first; });
  });
  for (OpenRun& run : runs) {
    const auto marked = kept.bookmarks.find(run.path.string());
    if (marked != kept.bookmarks.end()) run.bookmarks = marked->second;
  }
  share_memory();
  reconcile_map();
  if (!view.flight_path.empty()) begin_flight(view.flight_path);
  settle_time();
}

void Session::Implementation::reconcile_runs() {
  const ViewState& view = kept.view;
  std::vector<OpenRun> next_runs;
  std::vector<RunWork> next_works;
  std::set<std::string> names;
  for (const RunLook& look : view.runs) {
    const auto found = std::find_if(runs.begin(), runs.end(), [&](const OpenRun& run) {
      return run.path.string() == look.path;
    });
    if (found != runs.end()) {
      const auto index = static_cast<std::size_t>(found - runs.begin());
      next_runs.push_back(std::move(*found));
      next_works.push_back(std::move(works[index]));
      runs.erase(found);
      works.erase(works.begin() + static_cast<std::ptrdiff_t>(index));
    } else {
      OpenRun run;
      run.path = look.path;
      RunWork& work = next_works.emplace_back();
      work.number = ++last_number;
      const auto writer = std::find_if(reruns.begin(), reruns.end(), [&](const RerunWork& rerun) {
        return rerun.run == run.path;
      });
      if (writer != reruns.end()) {  // what it is made from is known before its first step
        run.is_live = true;
        work.flight_path = writer->flight_path;
        work.map_path = writer->map_path;
      }
      next_runs.push_back(std::move(run));
    }
    OpenRun& run = next_runs.back();
    run.name = name_of_run(run.path, names);
    names.insert(run.name);
  }
  for (RunWork& work : works) let_go(work.reading);
  for (OpenRun& run : runs) {  // its thread may be in the middle of a step
    if (!run.cache) continue;
    std::optional<Job<int, int>> closing(
        std::in_place,
        [cache = std::move(run.cache)](const auto& /*context*/, const auto& /*publish*/) mutable {
          cache.reset();
          return Result<int>(0);
        });
    let_go(closing);
  }
  runs = std::move(next_runs);
  works = std::move(next_works);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (!runs[i].document && !works[i].reading && !runs[i].is_live) begin_reading(i);
  }
}

void Session::Implementation::begin_reading(std::size_t run) {
  const auto earlier = runs[run].document;
  works[run].since_reading_s = 0.0;
  works[run].is_last_reading = std::exchange(works[run].is_last_reading_due, false);
  works[run].file = file_state(runs[run].path);
  works[run].since_look_s = 0.0;
  works[run].reading.emplace(
      [earlier, path = runs[run].path](const WorkContext& context,
                                       const auto& /*publish*/) -> Result<ReadRun> {
        auto document =
            earlier ? RunDocument::grown(earlier, context) : RunDocument::load(path, context);
        if (!document) return forward_error(document);
        ReadRun read{std::move(*document), {}, std::nullopt};
        if (earlier) return read;
        auto bookmarks = read_bookmarks(path);
        if (bookmarks) {
          read.bookmarks = std::move(*bookmarks);
        } else {
          read.bookmarks_fault = bookmarks.error();
        }
        return read;
      });
}

void Session::Implementation::take_run(std::size_t index) {
  RunWork& work = works[index];
  OpenRun& run = runs[index];
  Result<ReadRun> read = std::move(*work.reading->outcome());
  work.reading.reset();
  const bool is_at_its_end = std::exchange(work.is_last_reading, false);
  if (is_at_its_end) run.is_live = false;
  if (!read) {
    if (run.document) {  // it was readable before; what is there of it stays
      add_notice(Notice::Kind::kWarning, read.error().message);
      let_go_of_follow(index);
      return;
    }
    add_notice(Notice::Kind::kError, read.error().message);
    drop_run(run.path.string());
    return;
  }
  if (run.is_live && !run.document) work.held_view = hold_view_for(run.path.string());
  const auto before = std::exchange(run.document, std::move(read->document));
  run.moments = run.document->worst_moments;
  const std::string path = run.path.string();
  if (before) {
    if (run.cache) run.cache->set_document(run.document);
    if (!(before->header == run.document->header)) {  // another run has taken its name
      timed_run.reset();
      find_inputs(index);
    }
    settle_time();
    let_go_of_follow(index);
    if (is_at_its_end && work.held_view) {
      let_go_of_view_unseen(*std::exchange(work.held_view, std::nullopt));
    }
    return;
  }
  if (run.document->steps.empty() && !run.is_live) {
    add_notice(Notice::Kind::kError, fmt::format("{}: holds no steps", path));
    drop_run(path);
    return;
  }
  run.cache = std::make_shared<StepCache>(run.document);
  share_memory();
  if (read->bookmarks_fault) {
    add_notice(Notice::Kind::kWarning, read->bookmarks_fault->message);
  } else {
    run.bookmarks = read->bookmarks;
    const auto known = kept.bookmarks.find(path);
    if (known == kept.bookmarks.end()) {
      kept.bookmarks.emplace(path, std::move(read->bookmarks));
    } else {  // it was open before
      const Bookmarks expected = std::exchange(known->second, std::move(read->bookmarks));
      take_foreign({path, expected, run.bookmarks}, kept);
    }
  }
  if (!run.is_live) remember(path);
  find_inputs(index);
  let_go_of_follow(index);
}

void Session::Implementation::let_go_of_follow(std::size_t index) {
  if (runs[index].is_live || followed_run != runs[index].path) return;
  followed_run.clear();
  const RunDocument* const seen = active_document();
  const auto back_to_clock_s = std::exchange(works[index].back_to_clock_s, std::nullopt);
  if (!back_to_clock_s || seen == nullptr || seen != runs[index].document.get()) return;
  playback.time_s = std::clamp(*back_to_clock_s - seen->start_clock_s, 0.0, seen->duration_s());
}

void Session::Implementation::drop_run(const std::string& path) {
  std::erase(recents, path);
  if (followed_run == path) followed_run.clear();
  if (coming_run == path) coming_run.clear();
  std::optional<HeldView> held;  // for a run that leaves nothing: then all is as it was
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (runs[i].path == path) held = works[i].held_view;
  }
  amend([&path](KeptState& state) {
    take_run_out(state.view, path);
    state.bookmarks.erase(path);
  });
  if (held) let_go_of_view(*held);
  reconcile();
}

void Session::Implementation::poll_reading(double elapsed_s) {
  for (std::size_t i = 0; i < runs.size(); ++i) {
    works[i].since_reading_s += elapsed_s;
    works[i].since_look_s += elapsed_s;
    if (works[i].reading && works[i].reading->is_done()) {
      take_run(i);
      break;  // the list may be another one now; the rest comes with the next frame
    }
  }
  take_map();
  take_flights();
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (works[i].reading) continue;
    if (works[i].is_last_reading_due) begin_reading(i);
    if (!runs[i].is_live) look_at_file(i);
    if (!runs[i].is_live || works[i].reading || works[i].since_reading_s < kLeastBetweenReadingsS)
      continue;
    const auto writer = std::find_if(reruns.begin(), reruns.end(), [&](const RerunWork& work) {
      return work.run == runs[i].path;
    });
    if (writer == reruns.end()) continue;
    const auto progress = writer->job.latest();
    const std::size_t known = runs[i].document ? runs[i].document->steps.size() : 0;
    if (progress && static_cast<std::size_t>(progress->steps) > known) begin_reading(i);
  }
}

void Session::Implementation::look_at_file(std::size_t index) {
  RunWork& work = works[index];
  const std::shared_ptr<const RunDocument> document = runs[index].document;
  if (!document || work.reading) return;
  const bool may_grow = !document->is_complete && work.since_look_s >= kBetweenLooksS;
  if (!may_grow && !work.is_opened_again) return;
  work.since_look_s = 0.0;
  if (!(file_state(runs[index].path) == work.file)) begin_reading(index);
  if (!std::exchange(work.is_opened_again, false)) return;
  // What was not there, or could not be read, may be whole now.
  const auto flight = flights.find(work.flight_path);
  const bool has_failed = flight != flights.end() && flight->second.has_failed;
  if (has_failed) flight->second.has_failed = false;
  if (has_failed || work.flight_path.empty() || work.map_path.empty()) find_inputs(index);
}

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
    const bool begins_at_end = runs[i].path == coming_run && runs[i].path == followed_run;
    const auto index =
        there.index_at(begins_at_end ? there.duration_s() : here->time_in(there, playback.time_s));
    if (!index) continue;
    const bool is_active = static_cast<int>(i) + 1 == kept.view.active_run;
    runs[i].cache->request({*index, direction, playback.is_playing, is_active && shows_camera});
  }
}

}  // namespace nadir
