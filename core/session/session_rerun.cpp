// SPDX-License-Identifier: Apache-2.0
// Runs while they are made.
#include <algorithm>
#include <cctype>
#include <optional>
#include <string_view>
#include <system_error>
#include <thread>

#include "core/run/run_prior.h"
#include "core/session/session_core.h"

namespace nadir {
namespace fs = std::filesystem;

namespace {

/// "loop" of "loop-2"; nothing where no number that this program gives stands behind a name.
std::optional<std::string> before_number(const std::string& name) {
  std::size_t end = name.size();
  while (end > 0 && std::isdigit(static_cast<unsigned char>(name[end - 1])) != 0) --end;
  const std::string_view number = std::string_view(name).substr(end);
  const bool is_given = !number.empty() && number.front() != '0' && number != "1";
  if (!is_given || end < 2 || name[end - 1] != '-') return std::nullopt;
  return name.substr(0, end - 1);
}

std::string name_of_folder(const fs::path& folder) {
  return (folder.has_filename() ? folder.filename() : folder.parent_path().filename()).string();
}

int threads_for_reruns() {
  const unsigned cores = std::thread::hardware_concurrency();
  return static_cast<int>(std::max(2U, cores)) - 1;  // one is left to the window
}

}  // namespace

std::string Session::Implementation::name_without_number(const OpenRun& run) const {
  std::string stem = run.path.stem().string();
  const auto base = before_number(stem);
  if (!base) return stem;
  // The number is ours where there is the run that it was counted from; "drive-12" may be somebody's own name.
  const auto is_base = [&base](const fs::path& path) {
    const std::string name = path.stem().string();
    return name == *base || before_number(name) == base;
  };
  std::error_code error;
  const bool is_counted = fs::exists(run.path.parent_path() / (*base + ".nadir"), error) ||
                          (run.document && !run.document->header.parent_run.empty() &&
                           is_base(run.document->header.parent_run)) ||
                          std::any_of(runs.begin(), runs.end(), [&](const OpenRun& other) {
                            return other.path != run.path && other.path.stem().string() == *base;
                          });
  return is_counted ? *base : stem;
}

Result<fs::path> Session::Implementation::name_of_next_run(const FlightDescription& flight,
                                                           const OpenRun* run) const {
  const std::string name = run != nullptr ? name_without_number(*run) : name_of_folder(flight.path);
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

const OpenRun* Session::Implementation::run_to_rerun(RerunFrom from) const {
  switch (from) {
    case RerunFrom::kFlight:
      return nullptr;
    case RerunFrom::kCursor:
      return active();
    case RerunFrom::kStart:
      break;
  }
  return run_to_repeat();
}

Result<std::string> Session::Implementation::flight_to_localise(const OpenRun* run) const {
  const std::string& path = run != nullptr
                                ? works[static_cast<std::size_t>(run - runs.data())].flight_path
                                : kept.view.flight_path;
  if (flight_of(path) != nullptr) return path;
  const auto found = flights.find(path);
  if (found != flights.end() && found->second.reading) {
    return fail(ErrorCode::kInvalidOptions, "the flight is still being read");
  }
  if (run != nullptr && !run->document && !run->is_live) {
    return fail(ErrorCode::kInvalidOptions, "{} is still being read", run->name);
  }
  if (run != nullptr) {
    return fail(ErrorCode::kInvalidOptions,
                "{}: its flight is not there, so it cannot be run again", run->name);
  }
  return fail(ErrorCode::kInvalidOptions, "no flight is open: open {} first",
              runs.empty() ? "a run or a flight" : "one");
}

Result<std::optional<Prior>> Session::Implementation::prior_of(const OpenRun& run) const {
  if (run.document) return recorded_prior(run.path, run.document->header);
  if (const LiveRun* const made = live(run)) return made->origin.prior;
  return fail(ErrorCode::kInvalidOptions, "{} is still being read", run.name);
}

Result<void> Session::Implementation::set_start(RerunTask& task,
                                                RerunFrom from,
                                                const OpenRun* run) const {
  if (from == RerunFrom::kCursor) {
    const auto needed = need_run();
    if (!needed) return forward_error(needed);
    const RunDocument& document = *(*needed)->document;
    const auto index = document.index_at(playback.time_s);
    if (*index + 1 == document.steps.size() && document.is_complete) {
      return fail(ErrorCode::kInvalidOptions, "nothing of the flight comes after this moment");
    }
    task.parent = (*needed)->path;
    task.from_s = document.time_s[*index];
    return {};
  }
  if (run != nullptr) {
    const auto prior = prior_of(*run);
    if (!prior) return forward_error(prior);
    task.prior = *prior;
  }
  if (!task.prior && !task.flight->description().truth) {
    return fail(ErrorCode::kInvalidOptions,
                "{}: holds no truth to start from; 'nadir localise' takes a start (--prior, "
                "--global), and such a run can be run again here",
                task.flight->description().path.string());
  }
  return {};
}

void Session::Implementation::say_what_of_map_changed(const OpenRun& run) {
  if (!run.document || run.document->header.map_hash.empty()) return;
  const RunHeader& header = run.document->header;
  if (header.map_hash == map->hash) return;
  add_notice(
      Notice::Kind::kWarning,
      fmt::format("{} was made on {}, whose cells are not those of the map that is open, {}: "
                  "what differs may be the map's doing",
                  run.name, header.map_path, map->path.string()));
}

Result<void> Session::Implementation::perform(const actions::Rerun& action) {
  const OpenRun* const run = run_to_rerun(action.from);
  const auto path_of_flight = flight_to_localise(run);
  if (!path_of_flight) return forward_error(path_of_flight);
  if (!map || !map->index) {
    return fail(ErrorCode::kInvalidOptions, "{}",
                map ? "the map is still being read" : "no map is open: open one first");
  }
  const auto base = draft_base();
  const auto options = draft_options();
  if (!base || !options) return tl::unexpected(base ? options.error() : base.error());
  if (const auto valid = validate_run(*options); !valid) {
    return tl::unexpected(without_dashes(valid.error()));
  }
  RerunTask task{.flight = flight_of(*path_of_flight),
                 .map = map->index,
                 .map_path = map->path.string(),
                 .preset = base->preset,
                 .options = *options,
                 .prior = std::nullopt,
                 .parent = {},
                 .from_s = 0.0,
                 .run = {},
                 .threads = threads_for_reruns()};
  if (auto start = set_start(task, action.from, run); !start) return start;
  const auto path = name_of_next_run(task.flight->description(), run);
  if (!path) return forward_error(path);
  task.run = *path;
  const auto prior = run != nullptr ? prior_of(*run) : Result<std::optional<Prior>>(task.prior);
  const std::string name = path->stem().string();
  if (run != nullptr) say_what_of_map_changed(*run);
  const RunDocument* const studied = active_document();
  const RerunOrigin origin{
      {task.preset, task.options},
      prior,
      studied != nullptr ? std::optional(studied->clock_s(playback.time_s)) : std::nullopt};
  reruns.push_back({++last_number, name, *path, *path_of_flight, map->path.string(), origin,
                    Job<RerunProgress, RerunOutcome>(
                        [task = std::move(task)](const WorkContext& context, const auto& publish) {
                          return rerun(task, context, [&publish](RerunProgress progress) {
                            publish(std::make_shared<const RerunProgress>(progress));
                          });
                        })});
  list_what_is_written();  // so that the next start knows of it, whatever happens
  // From here: the moment that is studied stays in sight. From the start: watch it go.
  const bool is_watched = action.from != RerunFrom::kCursor;
  stop_following();
  const ViewState seen = kept.view;
  open_run(path->string());
  if (seen.active_run != 0) {  // what is seen stays until there is something else to see
    kept.view.active_run = seen.active_run;
    kept.view.selected_particle = seen.selected_particle;
    coming = ComingRun{path->string(), is_watched};
  } else if (is_watched) {
    followed_run = path->string();
  }
  playback.is_playing = false;
  save_now();
  return {};
}

void Session::Implementation::show_coming_run() {
  if (!coming) return;
  const auto found = std::find_if(runs.begin(), runs.end(),
                                  [this](const OpenRun& run) { return run.path == coming->path; });
  // Its first step is decoded before it is shown, so that nothing flickers.
  const bool has_something = found != runs.end() && found->document &&
                             !found->document->steps.empty() && found->cache &&
                             found->cache->is_cursor_ready();
  if (!has_something) return;
  const std::string path = coming->path;
  if (coming->is_followed && found->is_live) followed_run = path;
  coming.reset();
  amend([&path](KeptState& state) {
    const auto run = std::find_if(state.view.runs.begin(), state.view.runs.end(),
                                  [&path](const RunLook& look) { return look.path == path; });
    if (run == state.view.runs.end()) return;
    run->is_shown = true;
    state.view.active_run = static_cast<int>(run - state.view.runs.begin()) + 1;
    state.view.selected_particle.reset();
  });
  reconcile();
  request_steps();
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
  list_what_is_written();
  const std::string path = work.run.string();
  const auto found = std::find_if(runs.begin(), runs.end(),
                                  [&](const OpenRun& run) { return run.path == work.run; });
  if (found != runs.end()) {
    works[static_cast<std::size_t>(found - runs.begin())].live->stage = LiveRun::Stage::kEnded;
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
  if (!outcome->fault.empty()) {
    notice.kind = Notice::Kind::kError;
    notice.text = fmt::format("{} failed after {} steps; they are kept: {}", work.name,
                              outcome->steps, outcome->fault);
  } else if (outcome->was_stopped) {
    notice.text = fmt::format("{} was stopped; its {} steps are kept", work.name, outcome->steps);
  } else {
    notice.text = fmt::format("{} is done: {} steps", work.name, outcome->steps);
  }
  notice.details = path;
  if (found == runs.end()) {
    notice.remedy = actions::OpenFile{path};
    notice.remedy_title = "Open it";
  }
  add_notice(notice);
}

}  // namespace nadir
