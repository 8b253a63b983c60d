// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "core/session/action_fields.h"
#include "core/session/view_state.h"

/// How the window is divided and looks.
namespace nadir::actions {

struct ShowPanel {
  static constexpr std::string_view kForm = "panel NAME {on|off|toggle}";
  static constexpr std::string_view kHelp =
      "Show or hide a panel, and bring it to the front of its tabs";
  Panel panel = Panel::kLayers;
  Switch to = Switch::kToggle;
  NADIR_ACTION_FIELDS(panel, to)
  friend bool operator==(const ShowPanel&, const ShowPanel&) = default;
};

struct MoveSplitter {
  static constexpr std::string_view kForm = "splitter {left|right|timeline} POINTS";
  static constexpr std::string_view kHelp = "Size of the left or right column or of the timeline";
  Splitter splitter = Splitter::kLeft;
  double size_pt = 0.0;
  NADIR_ACTION_FIELDS(splitter, size_pt)
  friend bool operator==(const MoveSplitter&, const MoveSplitter&) = default;
};

struct MapOnly {
  static constexpr std::string_view kForm = "map-only {on|off|toggle}";
  static constexpr std::string_view kHelp = "Fill the window with the map";
  Switch to = Switch::kToggle;
  NADIR_ACTION_FIELDS(to)
  friend bool operator==(const MapOnly&, const MapOnly&) = default;
};

struct SplitView {
  static constexpr std::string_view kForm = "split-view {on|off|toggle}";
  static constexpr std::string_view kHelp = "One map for each of two runs, moved together";
  Switch to = Switch::kToggle;
  NADIR_ACTION_FIELDS(to)
  friend bool operator==(const SplitView&, const SplitView&) = default;
};

struct SaveLayout {
  static constexpr std::string_view kForm = "save-layout NAME";
  static constexpr std::string_view kHelp = "Keep panels, splitters and strips under a name";
  std::string name;
  NADIR_ACTION_FIELDS(name)
  friend bool operator==(const SaveLayout&, const SaveLayout&) = default;
};

struct UseLayout {
  static constexpr std::string_view kForm = "layout NAME";
  static constexpr std::string_view kHelp =
      "Arrange the window as kept under a name; 'default' is always there";
  std::string name;
  NADIR_ACTION_FIELDS(name)
  friend bool operator==(const UseLayout&, const UseLayout&) = default;
};

struct SetTheme {
  static constexpr std::string_view kForm = "theme {light|dark}";
  static constexpr std::string_view kHelp = "Colours of the window";
  LightOrDark theme = LightOrDark::kDark;
  NADIR_ACTION_FIELDS(theme)
  friend bool operator==(const SetTheme&, const SetTheme&) = default;
};

struct SetScale {
  static constexpr std::string_view kForm = "scale FACTOR";
  static constexpr std::string_view kHelp =
      "Size of text and controls, 0.75 to 3; 0 is the screen's own";
  double scale = 0.0;
  NADIR_ACTION_FIELDS(scale)
  friend bool operator==(const SetScale&, const SetScale&) = default;
};

struct ReduceMotion {
  static constexpr std::string_view kForm = "reduced-motion {on|off|toggle}";
  static constexpr std::string_view kHelp = "Nothing moves that the user does not move";
  Switch to = Switch::kToggle;
  NADIR_ACTION_FIELDS(to)
  friend bool operator==(const ReduceMotion&, const ReduceMotion&) = default;
};

struct SetMemory {
  static constexpr std::string_view kForm = "memory MEGABYTES";
  static constexpr std::string_view kHelp = "Most memory for what is decoded of runs and flights";
  int megabytes = 256;
  NADIR_ACTION_FIELDS(megabytes)
  friend bool operator==(const SetMemory&, const SetMemory&) = default;
};

struct ShowStrip {
  static constexpr std::string_view kForm = "strip NAME {on|off|toggle}";
  static constexpr std::string_view kHelp = "Show or hide a strip of the timeline";
  Strip strip = Strip::kPositionError;
  Switch to = Switch::kToggle;
  NADIR_ACTION_FIELDS(strip, to)
  friend bool operator==(const ShowStrip&, const ShowStrip&) = default;
};

struct MoveStrip {
  static constexpr std::string_view kForm = "strip-move NAME PLACES";
  static constexpr std::string_view kHelp =
      "Move a strip so many places up, or down where negative";
  Strip strip = Strip::kPositionError;
  int places = 1;
  NADIR_ACTION_FIELDS(strip, places)
  friend bool operator==(const MoveStrip&, const MoveStrip&) = default;
};

struct SetStripHeight {
  static constexpr std::string_view kForm = "strip-height NAME POINTS";
  static constexpr std::string_view kHelp = "Height of a strip";
  Strip strip = Strip::kPositionError;
  double height_pt = 40.0;
  NADIR_ACTION_FIELDS(strip, height_pt)
  friend bool operator==(const SetStripHeight&, const SetStripHeight&) = default;
};

/// What lies over the window until it is closed.
struct ShowOverlay {
  static constexpr std::string_view kForm =
      "show {none|palette|shortcuts|preferences|about|place|bookmark|open|export|save-recipe}";
  static constexpr std::string_view kHelp =
      "Command palette, preferences, boxes of files ...; none closes it";
  Overlay overlay = Overlay::kNone;
  NADIR_ACTION_FIELDS(overlay)
  friend bool operator==(const ShowOverlay&, const ShowOverlay&) = default;
};

}  // namespace nadir::actions
