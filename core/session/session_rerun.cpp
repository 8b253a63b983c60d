// SPDX-License-Identifier: Apache-2.0
// Runs while they are made.
#include <algorithm>
#include <cctype>
#include <thread>

#include "core/run/resume_point.h"
#include "core/session/session_core.h"

namespace nadir {
namespace fs = std::filesystem;

namespace {

/// "loop" of "loop-2".
std::string without_number(const std::string& name) {
  std::size_t end = name.size();
  while (end > 0 && std::isdigit(static_cast<unsigned char>(name[end - 1])) != 0) --end;
  const bool has_number = end < name.size() && end > 1 && name[end - 1] == '-';
  return has_number ? name.substr(0, end - 1) : name;
}

std::string name_of_folder(const fs::path& folder) {
  return (folder.has_filename() ? folder.filename() : folder.parent_path().filename()).string();
}

int threads_for_reruns() {
  const unsigned cores = std::thread::hardware_concurrency();
  return static_cast<int>(std::max(2U, cores)) - 1;  // one is left to the window
}

}  // namespace

Result<fs::path> Session::Implementation::name_of_next_run(const FlightDescription& flight) const {
  const OpenRun* const run = active();
  const std::string name =
      run != nullptr ? without_number(run->path.stem().string()) : name_of_folder(flight.path);
  std::vector<fs::path> folders;
  if (run != nullptr) folders.push_back(run->path.parent_path());
  folders.push_back(fs::path(absolute_path(flight.path)).parent_path());
  if (!places.data.empty()) folders.push_back(places.data / "runs");
  Error last;
  for (const fs::path& folder : folders) {
    std::error_code error;
    if (folder == places.data / "runs") fs::create_directories(folder, error);
    for (int number = run != nullptr ? 2 : 1;; ++number) {
      const fs::path path =
          folder / (number == 1 ? name + ".nadir" : fmt::format("{}-{}.nadir", name, number));
      const bool is_open =
          std::any_of(kept.view.runs.begin(), kept.view.runs.end(),
                      [&](const RunLook& look) { return look.path == path.string(); });
      if (is_open || is_being_written(path) || fs::exists(path, error)) continue;
      const auto free = RunWriter::check_output(path);
      if (free) return path;
      last = free.error();
      break;  // this folder cannot be written
    }
  }
  return tl::unexpected(last);
}

Result<void> Session::Implementation::perform(const actions::Rerun& action) {
  const OpenRun* const from = active();
  const auto recording = flight();
  if (!recording) {
    const std::string path = from != nullptr
                                 ? works[static_cast<std::size_t>(from - runs.data())].flight_path
                                 : kept.view.flight_path;
    const auto found = flights.find(path);
    if (found != flights.end() && found->second.reading) {
      return fail(ErrorCode::kInvalidOptions, "the flight is still being read");
    }
    if (from == nullptr) {
      return fail(ErrorCode::kInvalidOptions, "no flight is open: open a run or a flight first");
    }
    return fail(ErrorCode::kInvalidOptions,
                "{}: its flight is not there, so it cannot be run again", from->name);
  }
  if (!map || !map->index) {
    return fail(ErrorCode::kInvalidOptions, "{}",
                map ? "the map is still being read" : "no map is open: open one first");
  }
  const auto options = draft_options();
  if (!options) return forward_error(options);
  if (const auto valid = validate_run(*options); !valid) {
    return tl::unexpected(without_dashes(valid.error()));
  }
  RerunTask task{.flight = recording,
                 .map = map->index,
                 .map_path = map->path.string(),
                 .preset = kept.view.draft.preset,
                 .options = *options,
                 .prior = std::nullopt,
                 .parent = {},
                 .from_s = 0.0,
                 .run = {},
                 .threads = threads_for_reruns()};
  const FlightDescription& description = recording->description();
  const RunDocument* const document = active_document();
  if (action.from == RerunFrom::kCursor) {
    const auto run = need_run();
    if (!run) return forward_error(run);
    const auto index = (*run)->document->index_at(playback.time_s);
    if (*index + 1 == (*run)->document->steps.size() && (*run)->document->is_complete) {
      return fail(ErrorCode::kInvalidOptions, "nothing of the flight comes after this moment");
    }
    task.parent = (*run)->path;
    task.from_s = (*run)->document->time_s[*index];
  } else if (!description.truth && document != nullptr && !document->steps.empty()) {
    // Dead reckoning begins where the run was told that the flight begins.
    if (const auto& start = document->steps.front().odometry_in_enu) {
      task.prior = GaussianPrior{.mean_in_enu = *start};
    }
  }
  const auto path = name_of_next_run(description);
  if (!path) return forward_error(path);
  task.run = *path;
  const std::string name = path->stem().string();
  const auto read = std::find_if(flights.begin(), flights.end(), [&](const auto& flight) {
    return flight.second.recording == recording;
  });
  const std::string flight_path = read != flights.end() ? read->first : std::string();
  reruns.push_back({++last_number, name, *path, flight_path, map->path.string(),
                    Job<RerunProgress, RerunOutcome>(
                        [task = std::move(task)](const WorkContext& context, const auto& publish) {
                          return rerun(task, context, [&publish](RerunProgress progress) {
                            publish(std::make_shared<const RerunProgress>(progress));
                          });
                        })});
  open_run(path->string());
  // From here: the moment that is studied stays in sight. From the start: watch it go.
  followed_run = action.from == RerunFrom::kStart ? path->string() : std::string();
  playback.is_playing = false;
  save_now();  // so that the next start knows of it, whatever happens
  return {};
}

Result<void> Session::Implementation::perform(const actions::CancelJob& action) {
  const std::vector<JobStatus> all = jobs();
  if (all.empty()) return fail(ErrorCode::kInvalidOptions, "no work is going on");
  const int number = action.job.value_or(all.back().number);
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
  const auto reading = std::find_if(works.begin(), works.end(), is_it);
  if (reading == works.end() || !reading->reading) {
    return fail(ErrorCode::kInvalidOptions, "there is no work {}", number);
  }
  take_run_out(kept.view, runs[static_cast<std::size_t>(reading - works.begin())].path.string());
  return {};
}

void Session::Implementation::poll_reruns() {
  for (std::size_t i = 0; i < reruns.size(); ++i) {
    if (!reruns[i].job.is_done()) continue;
    RerunWork work = std::move(reruns[i]);
    reruns.erase(reruns.begin() + static_cast<std::ptrdiff_t>(i));
    end_rerun(work);
    return;  // the next one with the next frame
  }
}

void Session::Implementation::end_rerun(RerunWork& work) {
  const std::string path = work.run.string();
  const auto found = std::find_if(runs.begin(), runs.end(),
                                  [&](const OpenRun& run) { return run.path == work.run; });
  if (found != runs.end()) {
    found->is_live = false;
    works[static_cast<std::size_t>(found - runs.begin())].is_last_reading_due = true;
  }
  const Result<RerunOutcome>& outcome = *std::as_const(work.job).outcome();
  if (!outcome) {
    if (outcome.error().code == ErrorCode::kCancelled) {
      add_notice(Notice::Kind::kInfo,
                 fmt::format("{} was stopped before its first step", work.name));
    } else {
      add_notice(Notice::Kind::kError, fmt::format("{} was not made: {}", work.name,
                                                   without_dashes(outcome.error()).message));
    }
    drop_run(path);
    return;
  }
  remember(path);
  Notice notice;
  notice.text =
      outcome->was_stopped
          ? fmt::format("{} was stopped; its {} steps are kept", work.name, outcome->steps)
          : fmt::format("{} is done: {} steps", work.name, outcome->steps);
  notice.details = path;
  if (found == runs.end()) {
    notice.remedy = actions::OpenFile{path};
    notice.remedy_title = "Open it";
  }
  add_notice(std::move(notice));
}

}  // namespace nadir
