// SPDX-License-Identifier: Apache-2.0
// What stays from one start to the next.
#include <algorithm>
#include <system_error>

#include "core/base/staged_output.h"
#include "core/run/run_file.h"
#include "core/session/session_core.h"
#include "core/session/view_text.h"

namespace nadir {
namespace fs = std::filesystem;

namespace {

constexpr double kBetweenSavesS = 1.0;
constexpr double kBetweenSavesWhilePlayingS = 10.0;
constexpr const char* kSessionFile = "session.toml";
constexpr const char* kPreferencesFile = "preferences.toml";

/// Writes both files, those that have changed.
Result<int> save_texts(const fs::path& folder,
                       const std::optional<std::string>& session,
                       const std::optional<std::string>& preferences) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) return fail(ErrorCode::kIo, "{}: {}", folder.string(), error.message());
  for (const auto& [name, text] :
       {std::pair(kSessionFile, &session), std::pair(kPreferencesFile, &preferences)}) {
    if (!*text) continue;
    if (const auto written = write_text_file(folder / name, **text); !written) {
      return forward_error(written);
    }
  }
  return 0;
}

/// Nothing where there is no such file.
Result<std::optional<std::string>> text_if_there(const fs::path& file) {
  std::error_code error;
  if (!fs::exists(file, error)) return std::optional<std::string>();
  constexpr std::uintmax_t kMostBytes = 4U << 20U;
  auto text = read_text_file(file, kMostBytes);
  if (!text) return forward_error(text);
  return std::optional(std::move(*text));
}

}  // namespace

std::string Session::Implementation::session_text() const {
  SavedView saved{kept.view, playback, {}};
  saved.playback.is_playing = false;
  if (!is_leaving) {
    for (const RerunWork& work : reruns) saved.writing.push_back(work.run.string());
  }
  return view_text(saved);
}

std::string Session::Implementation::preferences_text() const {
  return nadir::preferences_text(
      {kept.view.appearance, kept.memory_megabytes, recents, kept.layouts});
}

void Session::Implementation::set_damaged_aside(const fs::path& file, const Error& error) {
  const fs::path aside = file.string() + ".damaged";
  std::error_code failed;
  fs::rename(file, aside, failed);
  add_notice(Notice::Kind::kWarning, failed ? fmt::format("{}; it is not used", error.message)
                                            : fmt::format("{}; it is not used, and kept as {}",
                                                          error.message, aside.string()));
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
  auto preferences = parse_preferences(**text, file.string());
  if (!preferences) {
    set_damaged_aside(file, preferences.error());
    return;
  }
  kept.view.appearance = preferences->appearance;
  kept.memory_megabytes = preferences->memory_megabytes;
  kept.layouts = std::move(preferences->layouts);
  recents = std::move(preferences->recents);
  saved_preferences = **text;
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
    set_damaged_aside(file, saved.error());
    return;
  }
  ViewState& view = saved->view;
  std::error_code error;
  for (const std::string& run : saved->writing) {
    take_run_out(view, run);
    // Still being written: by another window of Nadir, which shows it.
    if (!fs::exists(run, error) || !RunWriter::check_output(run)) continue;
    Notice notice;
    notice.kind = Notice::Kind::kWarning;
    notice.text = fmt::format(
        "{} was being made when Nadir was ended; what it had recorded until then is there", run);
    notice.remedy = actions::OpenFile{run};
    notice.remedy_title = "Open it";
    add_notice(std::move(notice));
  }
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
  wanted_time_s = playback.time_s;
  reconcile();
}

void Session::Implementation::poll_saving(double elapsed_s) {
  if (places.config.empty()) return;
  if (saving) {
    if (!saving->is_done()) return;
    const Result<int>& outcome = *std::as_const(*saving).outcome();
    if (!outcome && !has_saving_failed) {
      add_notice(Notice::Kind::kWarning,
                 "what is open cannot be kept for the next start: " + outcome.error().message);
    }
    has_saving_failed = !outcome;
    saving.reset();
  }
  since_saving_s += std::max(elapsed_s, 0.0);
  if (since_saving_s < (playback.is_playing ? kBetweenSavesWhilePlayingS : kBetweenSavesS)) return;
  since_saving_s = 0.0;
  std::optional<std::string> session, preferences;
  if (std::string text = session_text(); text != saved_session) session = std::move(text);
  if (std::string text = preferences_text(); text != saved_preferences) {
    preferences = std::move(text);
  }
  if (!session && !preferences) return;
  if (session) saved_session = *session;
  if (preferences) saved_preferences = *preferences;
  saving.emplace([folder = places.config, session, preferences](const WorkContext& /*context*/,
                                                                const auto& /*publish*/) {
    return save_texts(folder, session, preferences);
  });
}

void Session::Implementation::save_now() {
  if (places.config.empty()) return;
  saving.reset();  // waits for the one before, so that this one is the last
  saved_session = session_text();
  saved_preferences = preferences_text();
  const auto saved = save_texts(places.config, saved_session, saved_preferences);
  if (!saved && !has_saving_failed) {
    add_notice(Notice::Kind::kWarning,
               "what is open cannot be kept for the next start: " + saved.error().message);
    has_saving_failed = true;
  }
}

}  // namespace nadir
