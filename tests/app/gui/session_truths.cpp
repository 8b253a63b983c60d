// SPDX-License-Identifier: Apache-2.0
#include "tests/app/gui/session_truths.h"

#include <fmt/format.h>

#include <cmath>
#include <set>

#include "core/desk/label_desk.h"
#include "core/label/label_store.h"
#include "core/session/label_view.h"
#include "core/session/view_text.h"

namespace nadir {
namespace {

std::string fault_of_runs(const Session& session) {
  const ViewState& view = session.view();
  if (session.runs().size() != view.runs.size()) {
    return fmt::format("{} runs are open, and the view has {}", session.runs().size(),
                       view.runs.size());
  }
  std::set<std::string> paths;
  for (std::size_t i = 0; i < view.runs.size(); ++i) {
    if (!paths.insert(view.runs[i].path).second) return view.runs[i].path + " is open twice";
    if (session.runs()[i].path != view.runs[i].path) return "runs and view have another order";
  }
  const int most = static_cast<int>(view.runs.size());
  if (view.active_run < 0 || view.active_run > most || (most > 0 && view.active_run == 0)) {
    return fmt::format("of {} runs number {} is active", most, view.active_run);
  }
  if ((session.active_run() == nullptr) != (view.active_run == 0)) return "the active run is none";
  if (most > 0 && !view.runs[static_cast<std::size_t>(view.active_run) - 1].is_shown) {
    return "the active run is hidden";
  }
  return "";
}

std::string fault_of_cursor(const Session& session) {
  const Playback& playback = session.playback();
  if (!std::isfinite(playback.time_s) || playback.time_s < 0.0) {
    return fmt::format("the cursor stands at {} s", playback.time_s);
  }
  if (!(playback.speed >= kLeastSpeed && playback.speed <= kMostSpeed)) {
    return fmt::format("the speed is {}", playback.speed);
  }
  if (playback.loop_from_s.has_value() != playback.loop_to_s.has_value()) return "half a loop";
  if (playback.loop_from_s && !(*playback.loop_from_s < *playback.loop_to_s)) {
    return "the loop ends before it begins";
  }
  const OpenRun* const run = session.active_run();
  if (run == nullptr || !run->document || run->document->steps.empty()) return "";
  const bool may_wait = run->is_live;  // for what is still being written
  if (!may_wait && playback.time_s > run->document->duration_s() + 1e-9) {
    return fmt::format("the cursor stands at {} s of {} s", playback.time_s,
                       run->document->duration_s());
  }
  const auto index = session.step_index();
  if (!index || *index >= run->document->steps.size()) return "there is no step at the cursor";
  return "";
}

/// The view, and where its text changes it.
std::string fault_of_text(const Session& session) {
  SavedView saved{session.view(), session.playback(), session.label_view()};
  saved.playback.is_playing = false;
  const std::string text = view_text(saved);
  const auto again = parse_view_text(text, "its text");
  if (!again) return "the view cannot be read again: " + again.error().message + "\n" + text;
  if (!(again->view == saved.view)) {
    return "its text is another view:\n" + text + "\nand that one's text:\n" + view_text(*again);
  }
  if (!(again->label == saved.label)) return "its text labels something else:\n" + text;
  if (!(again->playback == saved.playback)) return "its text is another playback:\n" + text;
  if (!(repaired(saved.view) == saved.view)) return "the view needs to be repaired:\n" + text;
  return "";
}

std::string fault_of_log(const Session& session) {
  if (session.log().empty() || session.log().back().starts_with("#")) return "";
  const std::string& line = session.log().back();
  const auto action = parse_action(line);
  if (!action) return fmt::format("the log says '{}': {}", line, action.error().message);
  if (action_text(*action) == line) return "";
  return fmt::format("the log says '{}' and means '{}'", line, action_text(*action));
}

/// Whether what is drawn on is what lies on the disk.
std::string fault_of_labels(const Session& session) {
  const LabelView& view = session.label_view();
  if (view.workspace == Workspace::kLabel && view.path.empty()) return "nothing is labelled";
  const LabelDesk* const desk = session.label_desk();
  if (desk == nullptr) return "";
  if (!(desk->tool() == view.tool)) return "the tool is another one than the view's";
  for (const ObjectId id : desk->selection().ids()) {
    if (desk->sheet().now().object(id) == nullptr)
      return fmt::format("{} is selected and gone", id);
  }
  if (!desk->sheet().is_on_disk()) return "";
  const auto store = LabelStore::open(desk->sheet().path(), "a reader", LabelAccess::kRead);
  if (!store) return "the labels cannot be read again: " + store.error().message;
  return store->document() == desk->sheet().now() ? "" : "labels and their file differ";
}

/// What of a session undo goes through.
struct Undoable {
  ViewState view;
  std::vector<std::string> layouts;
  int memory_megabytes;
  std::map<std::string, std::vector<Bookmark>> bookmarks;
};

Undoable undoable(const Session& session) {
  Undoable now{session.view(), session.layout_names(), session.memory_budget_megabytes(), {}};
  for (const OpenRun& run : session.runs()) {
    if (run.document) now.bookmarks[run.path.string()] = run.bookmarks;
  }
  return now;
}

}  // namespace

std::string fault_of(const Session& session) {
  for (const auto& check :
       {fault_of_runs, fault_of_cursor, fault_of_text, fault_of_log, fault_of_labels}) {
    if (std::string fault = check(session); !fault.empty()) return fault;
  }
  return "";
}

std::string fault_of_undo(Session& session) {
  const auto title = session.undo_title();
  if (!title) return "";
  // Places of a tool go one by one, by other words.
  const LabelDesk* const desk = session.label_desk();
  const bool draws_labels = session.label_view().workspace == Workspace::kLabel;
  if (draws_labels && desk != nullptr && !desk->points().empty()) return "";
  const Undoable before = undoable(session);
  if (const auto undone = session.apply(actions::Undo{}); !undone) {
    return session.view() == before.view ? "" : "undo failed and changed the view";
  }
  if (session.redo_title() != title) {
    return fmt::format("after undoing '{}' redo offers '{}'", *title,
                       session.redo_title().value_or("nothing"));
  }
  if (const auto redone = session.apply(actions::Redo{}); !redone) {
    return fmt::format("'{}' cannot be done again: {}", *title, redone.error().message);
  }
  const Undoable after = undoable(session);
  const auto text_of = [](const ViewState& view) { return view_text({view, {}}); };
  if (!(after.view == before.view)) {
    return fmt::format("'{}', undone and done again, is another view:\n{}\nbefore:\n{}", *title,
                       text_of(after.view), text_of(before.view));
  }
  if (after.layouts != before.layouts) return *title + " changed layouts";
  if (after.memory_megabytes != before.memory_megabytes) return *title + " changed the memory";
  for (const auto& [run, bookmarks] : after.bookmarks) {
    const auto kept = before.bookmarks.find(run);
    if (kept != before.bookmarks.end() && kept->second != bookmarks) {
      return fmt::format("'{}' changed bookmarks of {}", *title, run);
    }
  }
  return "";
}

}  // namespace nadir
