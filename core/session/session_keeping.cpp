// SPDX-License-Identifier: Apache-2.0
// What stays from one start to the next.
#include <algorithm>
#include <system_error>

#include "core/session/saved_files.h"
#include "core/session/session_core.h"

namespace nadir {
namespace fs = std::filesystem;

namespace {

constexpr double kBetweenSavesS = 1.0;
constexpr double kBetweenSavesWhilePlayingS = 10.0, kBetweenAttemptsS = 10.0;

}  // namespace

std::string Session::Implementation::session_text() const {
  SavedView saved{kept.view, playback, label};
  saved.playback.is_playing = false;
  return view_text(saved);
}

Preferences Session::Implementation::preferences() const {
  return {kept.view.appearance, kept.memory_megabytes, recents,
          recent_commands,      kept.layouts,          turned_sections};
}

void Session::Implementation::refuse_file(const fs::path& file, const Error& error) {
  std::string what = "it stays as it is, and nothing is kept in its place";
  if (error.code != ErrorCode::kUnsupported) {
    const fs::path aside = set_aside(file);
    what = aside.empty() ? "it is not used" : "it is not used, and kept as " + aside.string();
  }
  add_notice(Notice::Kind::kWarning, fmt::format("{}; {}", error.message, what));
}

void Session::Implementation::read_preferences() {
  if (places.config.empty()) return;
  const fs::path file = places.config / kPreferencesFile;
  const auto text = text_if_there(file);
  if (!text) {
    add_notice(Notice::Kind::kWarning, text.error().message);
    return;
  }
  if (!*text) return;
  auto read = parse_preferences(**text, file.string());
  if (!read) {
    refuse_file(file, read.error());
    return;
  }
  kept.view.appearance = read->appearance;
  kept.memory_megabytes = read->memory_megabytes;
  kept.layouts = std::move(read->layouts);
  recents = std::move(read->recents);
  recent_commands = std::move(read->recent_commands);
  turned_sections = std::move(read->turned_sections);
}

void Session::Implementation::begin_keeping() {
  read_preferences();
  // What nobody has changed is not written: a window that opens nothing leaves the last session as it is.
  saved_session = session_text();
  saved_preferences = preferences();
  for (const std::string& run : listed_runs(places.config).unfinished) {
    unfinished.push_back(run);
    Notice notice;
    notice.kind = Notice::Kind::kWarning;
    notice.text = fmt::format(
        "{} was being made when Nadir was ended; what it had recorded until then is there", run);
    notice.remedy = actions::OpenFile{run};
    notice.remedy_title = "Open it";
    add_notice(notice);
  }
}

void Session::Implementation::list_what_is_written() {
  std::vector<std::string> paths;
  for (const RerunWork& work : reruns) paths.push_back(work.run.string());
  if (const auto kept_list = writing.keep(paths); !kept_list) {
    take_saving(forward_error(kept_list), {});
  }
}

void Session::Implementation::restore() {
  if (places.config.empty()) return;
  const fs::path file = places.config / kSessionFile;
  const auto text = text_if_there(file);
  if (!text) {
    add_notice(Notice::Kind::kWarning, text.error().message);
    return;
  }
  if (!*text) return;
  auto saved = parse_view_text(**text, file.string());
  if (!saved) {
    refuse_file(file, saved.error());
    return;
  }
  ViewState& view = saved->view;
  std::error_code error;
  // Those are offered, or another window is at work on them.
  for (const std::string& run : listed_runs(places.config).incomplete) take_run_out(view, run);
  const auto is_gone = [&](const std::string& path) {
    if (path.empty() || fs::exists(path, error)) return false;
    add_notice(Notice::Kind::kWarning, fmt::format("{}: is not there any more", path));
    return true;
  };
  const std::vector<RunLook> looks = view.runs;
  for (const RunLook& look : looks) {
    if (is_gone(look.path)) take_run_out(view, look.path);
  }
  if (is_gone(view.map_path)) view.map_path.clear();
  if (is_gone(view.flight_path)) view.flight_path.clear();
  kept.view = std::move(view);
  playback = saved->playback;
  label = std::move(saved->label);
  if (is_gone(label.path)) {
    label.path.clear();
    label.workspace = Workspace::kReplay;
  }
  wanted_time_s = playback.time_s;
  reconcile();
}

Savings Session::Implementation::changed_since_saving() const {
  Savings savings{std::nullopt, std::nullopt, saved_preferences};
  if (places.keeps_session) {
    std::string text = session_text();
    if (is_saving_due || text != saved_session) savings.session = std::move(text);
  }
  Preferences now = preferences();
  if (is_saving_due || !(now == saved_preferences)) savings.preferences = std::move(now);
  return savings;
}

void Session::Implementation::poll_saving(double elapsed_s) {
  if (places.config.empty()) return;
  if (saving) {
    if (!saving->is_done()) return;
    const Result<int> outcome = *std::as_const(*saving).outcome();
    saving.reset();
    take_saving(outcome, std::exchange(being_saved, {}));
  }
  since_saving_s += std::max(elapsed_s, 0.0);
  const double wait_s = !saving_fault.empty() ? kBetweenAttemptsS
                        : playback.is_playing ? kBetweenSavesWhilePlayingS
                                              : kBetweenSavesS;
  if (since_saving_s < wait_s) return;
  since_saving_s = 0.0;
  being_saved = changed_since_saving();
  if (being_saved.is_empty()) return;
  is_saving_due = false;
  saving.emplace([folder = places.config, savings = being_saved](
                     const WorkContext& /*context*/, const auto& /*publish*/) -> Result<int> {
    if (const auto saved = save_files(folder, savings); !saved) return forward_error(saved);
    return 0;
  });
}

void Session::Implementation::take_saving(const Result<int>& outcome, const Savings& what) {
  const bool had_failed = !saving_fault.empty();
  saving_fault = outcome ? std::string() : outcome.error().message;
  if (outcome) {
    if (what.session) saved_session = *what.session;
    if (what.preferences) saved_preferences = *what.preferences;
    forget_notices([](const Notice& notice) {
      return notice.remedy && std::holds_alternative<actions::SaveNow>(*notice.remedy);
    });
    return;
  }
  if (had_failed) return;
  Notice notice;
  notice.kind = Notice::Kind::kWarning;
  notice.text = (places.keeps_session ? "what is open cannot be kept for the next start: "
                                      : "preferences cannot be kept: ") +
                saving_fault;
  notice.remedy = actions::SaveNow{};
  notice.remedy_title = "Try again";
  add_notice(notice);
}

void Session::Implementation::save_soon() {
  is_saving_due = true;
  since_saving_s = kBetweenAttemptsS;
}

void Session::Implementation::save_now() {
  if (places.config.empty()) return;
  saving.reset();  // waits for the one before, so that this one is the last
  const Savings savings = changed_since_saving();
  if (savings.is_empty()) return;
  const auto saved = save_files(places.config, savings);
  take_saving(saved ? Result<int>(0) : Result<int>(forward_error(saved)), savings);
}

std::span<const std::string> Session::turned_sections() const {
  return implementation_->turned_sections;
}

void Session::keep_turned_sections(std::vector<std::string> paths) {
  implementation_->turned_sections = std::move(paths);
}

}  // namespace nadir
