// SPDX-License-Identifier: Apache-2.0
// Opening what lies on the disk, told by what is in it.
#include <algorithm>
#include <system_error>

#include "core/base/staged_output.h"
#include "core/session/file_kind.h"
#include "core/session/session_core.h"

namespace nadir {
namespace fs = std::filesystem;

std::string absolute_path(const fs::path& path) {
  std::error_code error;
  const fs::path whole = fs::absolute(path, error);
  fs::path normal = (error ? path : whole).lexically_normal();
  if (!normal.has_filename() && normal.has_parent_path() && normal != normal.root_path()) {
    normal = normal.parent_path();
  }
  return normal.string();
}

void take_run_out(ViewState& view, const std::string& path) {
  const auto found = std::find_if(view.runs.begin(), view.runs.end(),
                                  [&](const RunLook& look) { return look.path == path; });
  if (found == view.runs.end()) return;
  const int number = static_cast<int>(found - view.runs.begin()) + 1;
  view.runs.erase(found);
  const int count = static_cast<int>(view.runs.size());
  if (view.active_run == number) view.selected_particle.reset();
  if (view.active_run >= number) --view.active_run;
  view.active_run = std::clamp(view.active_run, std::min(count, 1), count);
  if (count < 2) view.map.is_split = false;
}

void Session::Implementation::remember(const std::string& path) {
  std::erase(recents, path);
  recents.insert(recents.begin(), path);
  if (recents.size() > kMostRecents) recents.pop_back();
}

void Session::Implementation::go_to_run_instead(const std::string& path) {
  if (coming && coming->is_followed && coming->path == path) followed_run = path;
  coming.reset();
}

void Session::Implementation::open_run(const std::string& path) {
  go_to_run_instead(path);
  ViewState& view = kept.view;
  const auto found = std::find_if(view.runs.begin(), view.runs.end(),
                                  [&](const RunLook& look) { return look.path == path; });
  if (found != view.runs.end()) {
    found->is_shown = true;
    view.active_run = static_cast<int>(found - view.runs.begin()) + 1;
    return;
  }
  int colour = 0;  // the first that no other run has
  const auto is_taken = [&](const RunLook& look) { return look.colour == colour; };
  while (std::any_of(view.runs.begin(), view.runs.end(), is_taken)) ++colour;
  view.runs.push_back({path, true, colour});
  view.active_run = static_cast<int>(view.runs.size());
  view.selected_particle.reset();
}

Result<void> Session::Implementation::open_map(const fs::path& package) {
  // A few lines of text: whether it is a map at all is said at once.
  const auto provenance = read_map_provenance(package);
  if (!provenance) return forward_error(provenance);
  map_wishes.clear();  // this one is meant, not that of a run which is still being read
  look_at_map(absolute_path(package));
  return {};
}

void Session::Implementation::look_at_map(const std::string& path) {
  if (kept.view.map_path != path && !kept.view.map_path.empty()) {
    kept.view.map.width_m = 0.0;  // what was looked at lies elsewhere
    kept.view.map.measured_in_enu_m.clear();
  }
  kept.view.map_path = path;
}

void Session::Implementation::use_map_of_active_run() {
  const ViewState& view = kept.view;
  if (view.active_run == 0) return;
  const std::string& run = view.runs.at(static_cast<std::size_t>(view.active_run) - 1).path;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (runs[i].path.string() != run || works[i].map_path.empty()) continue;
    look_at_map(works[i].map_path);
  }
}

Result<void> Session::Implementation::perform(const actions::OpenFile& action) {
  if (action.path.empty()) return fail(ErrorCode::kInvalidOptions, "no file is named");
  const auto found = file_to_open(absolute_path(action.path));
  if (!found) return forward_error(found);
  const fs::path& path = found->path;
  switch (found->kind) {
    case FileKind::kRun: {
      const auto open = std::find_if(runs.begin(), runs.end(),
                                     [&path](const OpenRun& run) { return run.path == path; });
      if (open == runs.end()) {
        map_wishes[path.string()] = {history.last_change() + 1, false};
      } else {
        works[static_cast<std::size_t>(open - runs.begin())].is_opened_again = true;
      }
      open_run(path.string());
      settle_unfinished(path.string());
      return {};
    }
    case FileKind::kMap:
      return open_map(path);
    case FileKind::kLabels:
      return perform(actions::OpenLabels{path.string()});
    case FileKind::kFolder:
    case FileKind::kOther:
    case FileKind::kFlight:
      kept.view.flight_path = path.string();
      // One that could not be read may be whole now.
      if (const auto flight = flights.find(path.string()); flight != flights.end()) {
        flight->second.has_failed = false;
      }
      return {};
    case FileKind::kFigureRecipe: {
      const auto text = read_text_file(path, kMostRecipeBytes);
      if (!text) return forward_error(text);
      return open_recipe(*text, path);
    }
    case FileKind::kRunRecipe:
      return perform(actions::UsePreset{path.string()});
    case FileKind::kFigure:
      if (!places.recipe_in_figure) {
        return fail(ErrorCode::kUnsupported, "{}: figures cannot be opened here", path.string());
      }
      open_recipe_later(path);
      return {};
  }
  return {};
}

Result<void> Session::Implementation::perform(const actions::OpenDemo& /*action*/) {
  if (places.data.empty()) {
    return fail(ErrorCode::kIo, "there is no folder to make the demo in");
  }
  const bool is_being_made =
      std::any_of(effect_works.begin(), effect_works.end(),
                  [](const EffectWork& work) { return work.opens_result && !work.is_cancelled; });
  if (is_being_made) return fail(ErrorCode::kInvalidOptions, "the demo is being made already");
  const fs::path folder = places.data / "demo";
  const fs::path run = folder / "run.nadir";
  // One whose making was ended before its end is made again.
  if (const auto made = RunReader::open(run); made && made->is_complete()) {
    return perform(actions::OpenFile{run.string()});
  }
  EffectWork& work = begin_effect("making the demo");
  work.opens_result = true;
  effects.emplace_back(MakeDemoEffect{work.number, absolute_path(folder)});
  return {};
}

Result<void> Session::Implementation::perform(const actions::CloseRun& action) {
  const auto index = run_of(action.run);
  if (!index) return forward_error(index);
  if (coming && runs[*index].path == coming->path) coming.reset();
  const bool was_active = action.run == kept.view.active_run;
  take_run_out(kept.view, runs[*index].path.string());
  if (was_active) use_map_of_active_run();
  return {};
}

Result<void> Session::Implementation::perform(const actions::SaveNow& /*action*/) {
  if (places.config.empty()) {
    return fail(ErrorCode::kInvalidOptions, "there is no folder to keep preferences in");
  }
  if (!places.keeps_session) {
    add_notice(Notice::Kind::kInfo,
               "Preferences are saved. What is open now is not: the next start shows what was open "
               "before this window.");
  }
  save_soon();
  return {};
}

Result<void> Session::Implementation::perform(const actions::Quit& /*action*/) {
  effects.emplace_back(QuitEffect{});
  return {};
}

Result<void> Session::Implementation::perform(const actions::ActivateRun& action) {
  const auto index = run_of(action.run);
  if (!index) return forward_error(index);
  go_to_run_instead(kept.view.runs.at(*index).path);
  if (kept.view.active_run != action.run) kept.view.selected_particle.reset();
  kept.view.active_run = action.run;
  kept.view.runs.at(*index).is_shown = true;
  use_map_of_active_run();
  return {};
}

Result<void> Session::Implementation::perform(const actions::ShowRun& action) {
  const auto index = run_of(action.run);
  if (!index) return forward_error(index);
  RunLook& look = kept.view.runs.at(*index);
  if (action.run == kept.view.active_run && !switched(look.is_shown, action.to)) {
    return fail(ErrorCode::kInvalidOptions, "{} is the active run, which is always shown",
                runs[*index].name);
  }
  look.is_shown = switched(look.is_shown, action.to);
  return {};
}

}  // namespace nadir
