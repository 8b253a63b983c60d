// SPDX-License-Identifier: Apache-2.0
// What leaves the window: figures, tables, reports and texts.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <system_error>

#include "core/base/staged_output.h"
#include "core/session/export_kinds.h"
#include "core/session/figure_request.h"
#include "core/session/run_table.h"
#include "core/session/session_core.h"
#include "core/session/view_text.h"

namespace nadir {
namespace fs = std::filesystem;

namespace {

constexpr const char* kDefaultFigure = "moment";

std::string ending_of_output(const fs::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return ending;
}

/// One notice for all that there is to say of a file: "/maps/m.png was written; it does not show the error surface".
Notice notice_of_file(const EffectEnd& end, const std::vector<std::string>& warnings) {
  constexpr std::size_t kMostInSentence = 2;
  Notice notice;
  // What was wrong with it stays to be read; what the map shows and it does not was said before it was made.
  if (!end.warnings.empty()) notice.kind = Notice::Kind::kWarning;
  notice.text = end.made + " was written";
  if (warnings.size() > kMostInSentence) {
    notice.text += fmt::format(", with {} warnings", warnings.size());
    notice.details = fmt::format("{}", fmt::join(warnings, "\n"));
  } else {
    for (const std::string& warning : warnings) notice.text += "; " + warning;
  }
  return notice;
}

}  // namespace

EffectWork& Session::Implementation::begin_effect(std::string title) {
  EffectWork& work = effect_works.emplace_back();
  work.number = ++last_number;
  work.title = std::move(title);
  return work;
}

void Session::Implementation::report_effect(int job, double fraction, const std::string& activity) {
  for (EffectWork& work : effect_works) {
    if (work.number != job || work.is_cancelled) continue;
    work.fraction = std::clamp(fraction, 0.0, 1.0);
    work.activity = activity;
  }
}

void Session::Implementation::finish_effect(int job, const EffectEnd& end) {
  const auto found = std::find_if(effect_works.begin(), effect_works.end(),
                                  [job](const EffectWork& work) { return work.number == job; });
  if (found == effect_works.end()) return;
  const EffectWork work = *found;
  effect_works.erase(found);
  if (!end.error.empty()) {
    if (work.is_cancelled) {
      add_notice(Notice::Kind::kInfo, work.title + " was stopped");
    } else {
      add_notice(Notice::Kind::kError, end.error);
    }
    return;
  }
  if (work.opens_result) {
    static_cast<void>(apply(actions::OpenFile{end.made}));  // says itself why not
    for (const std::string& warning : end.warnings) add_notice(Notice::Kind::kWarning, warning);
    return;
  }
  std::vector<std::string> warnings = work.warnings;
  warnings.insert(warnings.end(), end.warnings.begin(), end.warnings.end());
  add_notice(notice_of_file(end, warnings));
}

Result<void> Session::Implementation::perform(const actions::ExportFigure& action) {
  if (action.file.empty()) return fail(ErrorCode::kInvalidOptions, "no file is named");
  const fs::path file = absolute_path(action.file);
  const std::string ending = ending_of_output(file);
  constexpr std::array<std::string_view, 4> kEndings = {".png", ".svg", ".pdf", ".mp4"};
  if (std::find(kEndings.begin(), kEndings.end(), ending) == kEndings.end()) {
    return fail(ErrorCode::kInvalidOptions, "{}: does not end in .png, .svg, .pdf or .mp4",
                file.string());
  }
  if (action.width_px &&
      (*action.width_px < kLeastFigureWidthPx || *action.width_px > kMostFigureWidthPx)) {
    return fail(ErrorCode::kInvalidOptions, "a width of {} pixels is not in [{}, {}]",
                *action.width_px, int{kLeastFigureWidthPx}, int{kMostFigureWidthPx});
  }
  FigureRequest request;
  request.width_px = action.width_px;
  request.figure = action.figure.value_or(kDefaultFigure);
  request.is_film = ending == ".mp4";
  const RunsOfFigure number = runs_of_figure(request.figure);
  if (number != RunsOfFigure::kNone) {
    const auto run = need_run();
    if (!run) return forward_error(run);
    request.runs.push_back((*run)->path.string());
    request.run_colour =
        kept.view.runs.at(static_cast<std::size_t>(kept.view.active_run) - 1).colour;
    for (const RunLook& look : kept.view.runs) {
      const bool is_other = look.path != request.runs.front();
      if (number == RunsOfFigure::kAll && look.is_shown && is_other) {
        request.runs.push_back(look.path);
      }
    }
  } else if (kept.view.map_path.empty()) {
    return fail(ErrorCode::kInvalidOptions, "no map is open: open one first");
  }
  if (const auto free = StagedOutput::file(file); !free) return forward_error(free);
  std::vector<std::string> warnings;
  const ExportKind* const kind = export_kind(request.figure);
  if (kind != nullptr) {
    const std::string missing = left_out_words(*kind, kept.view, active());
    if (!missing.empty()) warnings.push_back("it does not show " + missing);
  }
  request.map = kept.view.map_path;
  request.time_s = playback.time_s;
  request.look = resolved_look();
  request.theme = kept.view.appearance.theme;
  request.from_s = playback.loop_from_s;
  request.to_s = playback.loop_to_s;
  request.speed = playback.speed;
  EffectWork& work = begin_effect("drawing " + file.filename().string());
  work.warnings = std::move(warnings);
  effects.emplace_back(DrawFigureEffect{work.number, figure_recipe_text(request), file.string()});
  return {};
}

Result<void> Session::Implementation::perform(const actions::ExportTable& action) {
  if (action.file.empty()) return fail(ErrorCode::kInvalidOptions, "no file is named");
  const auto run = need_run();
  if (!run) return forward_error(run);
  const fs::path file = absolute_path(action.file);
  if (ending_of_output(file) != ".csv") {
    return fail(ErrorCode::kInvalidOptions, "{}: does not end in .csv", file.string());
  }
  if (const auto free = StagedOutput::file(file); !free) return forward_error(free);
  small_works.push_back({++last_number, "writing " + file.filename().string(),
                         Job<int, std::string>([document = (*run)->document, file](
                                                   const WorkContext& context,
                                                   const auto& /*publish*/) -> Result<std::string> {
                           const std::string table = run_table(*document);
                           if (context.is_stopped()) {
                             return fail(ErrorCode::kCancelled, "{}: was stopped", file.string());
                           }
                           if (auto written = write_text_file(file, table); !written) {
                             return forward_error(written);
                           }
                           return file.string();
                         }),
                         [this](const std::string& made) {
                           add_notice(Notice::Kind::kInfo, fmt::format("{} was written", made));
                         }});
  return {};
}

Result<void> Session::Implementation::perform(const actions::WriteReport& action) {
  if (action.folder.empty()) return fail(ErrorCode::kInvalidOptions, "no folder is named");
  const auto run = need_run();
  if (!run) return forward_error(run);
  const fs::path folder = absolute_path(action.folder);
  std::error_code error;
  if (!fs::is_directory(folder.parent_path(), error)) {
    return fail(ErrorCode::kIo, "{}: its folder does not exist", folder.string());
  }
  std::vector<std::string> shown;
  for (const RunLook& look : kept.view.runs) {
    if (look.is_shown) shown.push_back(look.path);
  }
  const int job = begin_effect("writing the report " + folder.filename().string()).number;
  effects.emplace_back(
      WriteReportEffect{job, std::move(shown), kept.view.map_path, folder.string()});
  return {};
}

Result<void> Session::Implementation::perform(const actions::Copy& action) {
  effects.emplace_back(SetClipboardEffect{action.text});
  return {};
}

Result<void> Session::Implementation::perform(const actions::CopyView& /*action*/) {
  SavedView saved{kept.view, playback, {}};
  saved.view.map = resolved_look();
  effects.emplace_back(SetClipboardEffect{view_text(saved)});
  return {};
}

Result<void> Session::Implementation::perform(const actions::PasteView& action) {
  auto pasted = parse_view_text(action.text, "the clipboard");
  if (!pasted) return forward_error(pasted);
  std::error_code error;
  std::vector<std::string> paths;
  for (const RunLook& run : pasted->view.runs) paths.push_back(run.path);
  if (!pasted->view.map_path.empty()) paths.push_back(pasted->view.map_path);
  if (!pasted->view.flight_path.empty()) paths.push_back(pasted->view.flight_path);
  for (const std::string& path : paths) {
    if (!fs::exists(path, error)) {
      return fail(ErrorCode::kNotFound, "{}: does not exist here, so the view cannot be shown",
                  path);
    }
  }
  kept.view = std::move(pasted->view);
  playback = pasted->playback;
  wanted_time_s = playback.time_s;
  stop_following();
  return {};
}

void Session::Implementation::poll_small_works() {
  for (std::size_t i = 0; i < small_works.size(); ++i) {
    if (!small_works[i].job.is_done()) continue;
    SmallWork work = std::move(small_works[i]);
    small_works.erase(small_works.begin() + static_cast<std::ptrdiff_t>(i));
    Result<std::string>& outcome = *work.job.outcome();
    if (!outcome && outcome.error().code == ErrorCode::kCancelled && work.is_cancelled) {
      add_notice(Notice::Kind::kInfo, work.title + " was stopped");
    } else if (!outcome) {
      add_notice(Notice::Kind::kError, outcome.error().message);
    } else if (!work.is_cancelled) {
      work.when_done(std::move(*outcome));
    }
    return;  // the next one with the next frame
  }
}

}  // namespace nadir
