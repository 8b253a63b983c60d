// SPDX-License-Identifier: Apache-2.0
#include "core/session/commands.h"

#include <algorithm>

#include "core/desk/label_desk.h"
#include "core/session/label_view.h"
#include "core/session/session.h"

namespace nadir {
namespace {

bool is_one_of(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

std::string why_no_labels(std::string_view name, const Session& session) {
  if (is_one_of(name, {"label-option", "last-class", "borders"})) return "";
  const LabelDesk* const desk = session.label_desk();
  if (desk == nullptr) {
    return session.label_view().path.empty() ? "open labels first"
                                             : "labels are still being opened";
  }
  if (name == "finish" && desk->points().empty()) return "nothing is being drawn";
  const bool needs_selection =
      is_one_of(name, {"labels", "set-label", "duplicate-labels", "copy-beside", "join-borders"});
  return needs_selection && desk->selection().empty() && desk->picked().empty()
             ? "select something first"
             : "";
}

std::string why_no_run(const Session& session) {
  const OpenRun* const run = session.active_run();
  if (run == nullptr) return "open a run first";
  return run->document ? "" : "the run is still being read";
}

std::string why_no_rerun(const Session& session, RerunFrom from) {
  if (from == RerunFrom::kCursor) {
    if (std::string why = why_no_run(session); !why.empty()) return why;
  }
  const OpenRun* const run = session.run_to_rerun(from);
  if (run != nullptr && !run->document && !run->is_live) return "the run is still being read";
  if (const auto flight = session.flight_to_rerun(from); !flight) {
    if (run != nullptr) return flight.error().message;
    if (!session.view().flight_path.empty()) return "the flight is still being read";
    return from == RerunFrom::kFlight ? "open a flight first" : "open a run or a flight first";
  }
  const OpenMap* const map = session.map();
  if (map == nullptr) return "open a map first";
  return map->index ? "" : "the map is still being read";
}

std::string why_not_go(std::string_view place, const Session& session) {
  if (std::string why = why_no_run(session); !why.empty()) return why;
  const OpenRun& run = *session.active_run();
  if (place.ends_with("worst") && run.moments.empty()) return "nothing of this run stands out";
  if (place.ends_with("bookmark") && run.bookmarks.empty()) return "this run has no bookmark";
  return "";
}

}  // namespace

std::string why_not(const Command& command, const Session& session) {
  const std::size_t blank = command.text.find(' ');
  const std::string_view name = command.text.substr(0, blank);
  const std::string_view rest =
      blank == std::string_view::npos ? std::string_view() : command.text.substr(blank + 1);
  if (name == "undo") return session.undo_title() ? "" : "nothing has been changed yet";
  if (name == "redo") return session.redo_title() ? "" : "nothing has been taken back";
  if (name == "cancel") return session.jobs().empty() ? "no work is going on" : "";
  if (name == "dismiss") return session.notices().empty() ? "there is no notice" : "";
  if (command.menu == kLabelMenu) {
    const bool takes_all = is_one_of(rest, {"select-all", "paint-to-objects"});
    return why_no_labels(takes_all ? "" : name, session);
  }
  if (command.text == "workspace label") {
    const bool has_some = !session.label_view().path.empty() || !session.view().map_path.empty();
    return has_some ? "" : "open a map or an image first";
  }
  if (name == "go") return why_not_go(rest, session);
  if (name == "rerun") {
    return why_no_rerun(session, rest == "flight"   ? RerunFrom::kFlight
                                 : rest == "cursor" ? RerunFrom::kCursor
                                                    : RerunFrom::kStart);
  }
  if (is_one_of(name, {"run", "show-run", "close-run"})) {
    return session.runs().empty() ? "open a run first" : "";
  }
  if (is_one_of(name, {"split-view", "divergence"})) {
    return session.runs().size() < 2 ? "open a second run first" : "";
  }
  const bool is_of_map = is_one_of(command.text, {"fit map", "show place"});
  if (is_of_map && session.map() == nullptr) {
    return session.active_run() == nullptr ? "open a map or a run first" : "";
  }
  const bool is_of_moment = is_one_of(
      command.text, {"fit flight", "fit particles", "preset run", "show bookmark", "bookmark"});
  if (is_of_moment || is_one_of(name, {"play", "step", "seek", "export", "export-table", "report",
                                       "loop", "follow", "lay-at"})) {
    return why_no_run(session);
  }
  if (command.text == "tool pick") return why_no_run(session);
  if (name == "measure") {
    return session.view().map.measured_in_enu_m.empty() ? "nothing is measured" : "";
  }
  return "";
}

}  // namespace nadir
