// SPDX-License-Identifier: Apache-2.0
#include "core/session/commands.h"

#include <algorithm>
#include <array>

#include "core/session/session.h"

namespace nadir {
namespace {

constexpr std::string_view kFile = "File", kEdit = "Edit", kView = "View", kRunMenu = "Run",
                           kGo = "Go", kHelp = "Help";

constexpr std::array kCommands = {
    Command{"open", "Open...", kFile, "Ctrl+O", false, "file folder load"},
    Command{"open-demo", "Open the demo", kFile, "", true},
    Command{"close-run", "Close run...", kFile, "", false},
    Command{"export", "Export figure or film...", kFile, "Ctrl+S", false,
            "save picture video png svg pdf mp4"},
    Command{"export-table", "Export table...", kFile, "", false, "csv spreadsheet"},
    Command{"report", "Write report...", kFile, "", false, "html figures tables"},
    Command{"save", "Save session now", kFile, "", true, "keep write retry preferences"},
    Command{"quit", "Quit", kFile, "Ctrl+Q", true, "exit close leave"},

    Command{"undo", "Undo", kEdit, "Ctrl+Z", true},
    Command{"redo", "Redo", kEdit, "Ctrl+Y", true},
    Command{"copy-view", "Copy view", kEdit, "Ctrl+C", true},
    Command{"paste-view", "Paste view", kEdit, "Ctrl+V", false},
    Command{"bookmark", "Bookmark this moment", kEdit, "B", true, "mark flag"},
    Command{"show bookmark", "Bookmark with a note...", kEdit, "Shift+B", true},
    Command{"dismiss", "Dismiss all notices", kEdit, "", true},
    Command{"show preferences", "Preferences...", kEdit, "Ctrl+,", true,
            "options configuration memory"},

    Command{"fit flight", "Fit flight", kView, "F", true},
    Command{"fit map", "Fit map", kView, "Shift+F", true},
    Command{"fit particles", "Fit particles", kView, "P", true},
    Command{"zoom 1.5", "Zoom in", kView, "+", true},
    Command{"zoom 0.6666666666666666", "Zoom out", kView, "-", true},
    Command{"rotate 15", "Turn map left", kView, "Shift+Left", true},
    Command{"rotate -15", "Turn map right", kView, "Shift+Right", true},
    Command{"up north", "North up", kView, "N", true},
    Command{"up heading", "Heading up", kView, "H", true},
    Command{"follow toggle", "Follow the estimate", kView, "C", true},
    Command{"tool pan", "Pan with the pointer", kView, "V", true},
    Command{"tool measure", "Measure distance and area", kView, "M", true},
    Command{"tool pick", "Pick particles", kView, "I", true},
    Command{"measure", "Measure anew", kView, "Shift+M", true},
    Command{"lay-at estimate", "Topview at the estimate", kView, "Shift+E", true},
    Command{"lay-at truth", "Topview at the truth", kView, "Shift+T", true},
    Command{"lay-at odometry", "Topview at the odometry", kView, "Shift+O", true},
    Command{"map-only toggle", "Map only", kView, "Tab", true},
    Command{"split-view toggle", "Split view of two runs", kView, "S", true},
    Command{"layer picture toggle", "Layer: picture", kView, "1", true},
    Command{"layer labels toggle", "Layer: labels", kView, "2", true},
    Command{"layer reconstruction toggle", "Layer: reconstruction", kView, "3", true,
            "points cloud"},
    Command{"layer error-surface toggle", "Layer: error surface", kView, "4", true},
    Command{"layer topview toggle", "Layer: topview", kView, "5", true},
    Command{"layer disagreement toggle", "Layer: disagreement", kView, "6", true},
    Command{"layer particles toggle", "Layer: particles", kView, "7", true},
    Command{"layer odometry toggle", "Layer: odometry", kView, "8", true},
    Command{"layer truth toggle", "Layer: truth", kView, "9", true},
    Command{"layer estimate toggle", "Layer: estimate", kView, "0", true},
    Command{"layer ellipses toggle", "Layer: ellipses", kView, "", true, "covariance uncertainty"},
    Command{"layer modes toggle", "Layer: modes", kView, "", true},
    Command{"layer graticule toggle", "Layer: graticule", kView, "", true, "grid"},
    Command{"layer legend toggle", "Layer: legend", kView, "", true},
    Command{"panel layers toggle", "Panel: layers", kView, "F2", true},
    Command{"panel runs toggle", "Panel: runs", kView, "F3", true},
    Command{"panel bookmarks toggle", "Panel: bookmarks", kView, "F4", true},
    Command{"panel moment toggle", "Panel: moment", kView, "F5", true},
    Command{"panel why toggle", "Panel: why here?", kView, "F6", true, "explain diagnose cost"},
    Command{"panel settings toggle", "Panel: settings of the next run", kView, "F7", true,
            "options parameters"},
    Command{"panel scene toggle", "Panel: 3D scene", kView, "F8", true},
    Command{"panel topview toggle", "Panel: topview", kView, "F9", true},
    Command{"panel camera toggle", "Panel: camera", kView, "F10", true},
    Command{"panel timeline toggle", "Panel: timeline", kView, "F11", true},
    Command{"panel log toggle", "Panel: log", kView, "F12", true},
    Command{"panel status toggle", "Panel: status line", kView, "", true},
    Command{"strip position-error toggle", "Strip: position error", kView, "", true,
            "rmse metres drift"},
    Command{"strip orientation-error toggle", "Strip: orientation error", kView, "", true,
            "yaw heading degrees rmse"},
    Command{"strip sigma toggle", "Strip: standard deviations", kView, "", true,
            "uncertainty spread"},
    Command{"strip sample-size toggle", "Strip: effective sample size", kView, "", true,
            "ess neff"},
    Command{"strip agreement toggle", "Strip: agreement with the map", kView, "", true},
    Command{"strip nees toggle", "Strip: NEES coverage", kView, "", true, "consistency"},
    Command{"strip update-time toggle", "Strip: update time", kView, "", true,
            "computing speed milliseconds"},
    Command{"strip streams toggle", "Strip: gaps in streams", kView, "", true},
    Command{"save-layout", "Keep layout...", kView, "", false},
    Command{"layout", "Use layout...", kView, "", false},
    Command{"layout default", "Default layout", kView, "", true},
    Command{"theme dark", "Dark theme", kView, "", true, "night black"},
    Command{"theme light", "Light theme", kView, "", true, "day white"},
    Command{"scale 0", "Interface scale: the screen's own", kView, "Ctrl+0", true},
    Command{"scale 1", "Interface scale 1", kView, "", true},
    Command{"scale 1.5", "Interface scale 1.5", kView, "", true},
    Command{"scale 2", "Interface scale 2", kView, "", true},
    Command{"reduced-motion toggle", "Reduced motion", kView, "", true},

    Command{"rerun start", "Rerun from the start", kRunMenu, "Ctrl+R", true, "localise again"},
    Command{"rerun cursor", "Rerun from here", kRunMenu, "Ctrl+Shift+R", true,
            "localise again cursor"},
    Command{"rerun flight", "Localise the opened flight", kRunMenu, "", true, "run new"},
    Command{"cancel", "Stop the newest work", kRunMenu, "", true},
    Command{"option", "Set an option of the next run...", kRunMenu, "", false},
    Command{"preset", "Use a preset or recipe...", kRunMenu, "", false},
    Command{"preset run", "Options of the active run", kRunMenu, "", true},
    Command{"save-preset", "Save options as recipe...", kRunMenu, "", false},
    Command{"run", "Go to run...", kRunMenu, "", false},
    Command{"show-run", "Show or hide a run...", kRunMenu, "", false},

    Command{"play toggle", "Play or pause", kGo, "Space", true},
    Command{"step -1", "Step back", kGo, "Left", true},
    Command{"step 1", "Step on", kGo, "Right", true},
    Command{"step -10", "Ten steps back", kGo, "Down", true},
    Command{"step 10", "Ten steps on", kGo, "Up", true},
    Command{"go start", "To the start", kGo, "Home", true},
    Command{"go end", "To the end", kGo, "End", true},
    Command{"go previous-worst", "Previous worst moment", kGo, "[", true},
    Command{"go next-worst", "Next worst moment", kGo, "]", true},
    Command{"go worst", "The worst moment", kGo, "W", true, "worst"},
    Command{"go previous-bookmark", "Previous bookmark", kGo, "Ctrl+Left", true},
    Command{"go next-bookmark", "Next bookmark", kGo, "Ctrl+Right", true},
    Command{"divergence", "First divergence from a run...", kGo, "", false},
    Command{"seek", "To a time...", kGo, "", false},
    Command{"show place", "To coordinates...", kGo, "G", true, "place mgrs utm latitude longitude"},
    Command{"speed 0.1", "Speed 0.1", kGo, "", true},
    Command{"speed 0.5", "Speed 0.5", kGo, "", true},
    Command{"speed 1", "Speed 1", kGo, "", true},
    Command{"speed 2", "Speed 2", kGo, "", true},
    Command{"speed 5", "Speed 5", kGo, "", true},
    Command{"speed 10", "Speed 10", kGo, "", true},
    Command{"speed 20", "Speed 20", kGo, "", true},
    Command{"loop", "Play all, without a loop", kGo, "", true},

    Command{"show palette", "Command palette", kHelp, "Ctrl+P", true},
    Command{"show shortcuts", "Shortcuts", kHelp, "?", true, "keys keyboard help"},
    Command{"show about", "About Nadir", kHelp, "", true},
    Command{"show none", "Close what lies over the window", kHelp, "Escape", true},
};

bool is_one_of(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
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

std::span<const Command> session_commands() { return kCommands; }

std::string why_not(const Command& command, const Session& session) {
  const std::size_t blank = command.text.find(' ');
  const std::string_view name = command.text.substr(0, blank);
  const std::string_view rest =
      blank == std::string_view::npos ? std::string_view() : command.text.substr(blank + 1);
  if (name == "undo") return session.undo_title() ? "" : "nothing has been changed yet";
  if (name == "redo") return session.redo_title() ? "" : "nothing has been taken back";
  if (name == "cancel") return session.jobs().empty() ? "no work is going on" : "";
  if (name == "dismiss") return session.notices().empty() ? "there is no notice" : "";
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
