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
  reconcile_labels();
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
        work.live = LiveRun{.origin = writer->origin};
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
  if (auto& live = works[run].live; live && live->stage == LiveRun::Stage::kEnded) {
    live->stage = LiveRun::Stage::kReadToItsEnd;
  }
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
  std::optional<LiveRun> ended;
  if (work.live && work.live->stage == LiveRun::Stage::kReadToItsEnd) {
    ended = std::exchange(work.live, std::nullopt);
    run.is_live = false;
  }
  if (!read) {
    if (run.document) {  // it was readable before; what is there of it stays
      add_notice(Notice::Kind::kWarning, read.error().message);
      if (ended) end_following(index, *ended);
      return;
    }
    add_notice(Notice::Kind::kError, read.error().message);
    drop_run(run.path.string());
    return;
  }
  if (work.live && !run.document) work.live->held_view = hold_view_for(run.path.string());
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
    if (ended) end_following(index, *ended);
    if (ended && ended->held_view) let_go_of_view_unseen(*ended->held_view);
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
  if (ended) end_following(index, *ended);
}

void Session::Implementation::end_following(std::size_t index, const LiveRun& ended) {
  const fs::path& path = runs[index].path;
  if (coming && coming->path == path) coming->is_followed = false;  // it will be seen whole
  if (followed_run != path) return;
  followed_run.clear();
  const RunDocument* const seen = active_document();
  const auto back_s = ended.origin.studied_clock_s;
  if (!back_s || seen == nullptr || seen != runs[index].document.get()) return;
  playback.time_s = std::clamp(*back_s - seen->start_clock_s, 0.0, seen->duration_s());
}

void Session::Implementation::drop_run(const std::string& path) {
  std::erase(recents, path);
  if (followed_run == path) followed_run.clear();
  if (coming && coming->path == path) coming.reset();
  std::optional<HeldView> held;  // for a run that leaves nothing: then all is as it was
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (runs[i].path == path && works[i].live) held = works[i].live->held_view;
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
    if (works[i].live && works[i].live->stage == LiveRun::Stage::kEnded) begin_reading(i);
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

}  // namespace nadir
