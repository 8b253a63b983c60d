// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/field.h"

namespace nadir {

enum class Switch { kOff, kOn, kToggle };
template <>
struct EnumNames<Switch> {
  static constexpr std::array<std::string_view, 3> kNames = {"off", "on", "toggle"};
};
/// @returns what the switch makes of a value.
[[nodiscard]] constexpr bool switched(bool now, Switch to) {
  return to == Switch::kToggle ? !now : to == Switch::kOn;
}

/// Where playback can jump. Worst moments are those of core/session/worst_moments.h.
enum class Moment {
  kStart,
  kEnd,
  kNextWorst,
  kPreviousWorst,
  kWorst,
  kNextBookmark,
  kPreviousBookmark
};
template <>
struct EnumNames<Moment> {
  static constexpr std::array<std::string_view, 7> kNames = {
      "start", "end",           "next-worst",       "previous-worst",
      "worst", "next-bookmark", "previous-bookmark"};
};

enum class FitTo { kFlight, kMap, kParticles };
template <>
struct EnumNames<FitTo> {
  static constexpr std::array<std::string_view, 3> kNames = {"flight", "map", "particles"};
};

enum class MapUp { kNorth, kHeading, kFree };
template <>
struct EnumNames<MapUp> {
  static constexpr std::array<std::string_view, 3> kNames = {"north", "heading", "free"};
};

enum class PoseSource { kEstimate, kTruth, kOdometry };
template <>
struct EnumNames<PoseSource> {
  static constexpr std::array<std::string_view, 3> kNames = {"estimate", "truth", "odometry"};
};

enum class MapTool { kPan, kMeasure, kPick };
template <>
struct EnumNames<MapTool> {
  static constexpr std::array<std::string_view, 3> kNames = {"pan", "measure", "pick"};
};

/// What the map is made of, from the ground up as drawn at first.
enum class Layer {
  kPicture,
  kLabels,
  kReconstruction,
  kErrorSurface,
  kTopview,
  kDisagreement,
  kParticles,
  kOdometry,
  kTruth,
  kEstimate,
  kEllipses,
  kModes,
  kGraticule,
  kLegend
};
template <>
struct EnumNames<Layer> {
  static constexpr std::array<std::string_view, 14> kNames = {
      "picture",      "labels",    "reconstruction", "error-surface", "topview",
      "disagreement", "particles", "odometry",       "truth",         "estimate",
      "ellipses",     "modes",     "graticule",      "legend"};
};
inline constexpr std::size_t kLayerCount = EnumNames<Layer>::kNames.size();

enum class Panel {
  kLayers,
  kRuns,
  kBookmarks,
  kMoment,
  kWhy,
  kSettings,
  kScene,
  kTopview,
  kCamera,
  kTimeline,
  kStatus,
  kLog
};
template <>
struct EnumNames<Panel> {
  static constexpr std::array<std::string_view, 12> kNames = {
      "layers", "runs",    "bookmarks", "moment",   "why",    "settings",
      "scene",  "topview", "camera",    "timeline", "status", "log"};
};
inline constexpr std::size_t kPanelCount = EnumNames<Panel>::kNames.size();

enum class Splitter { kLeft, kRight, kTimeline };
template <>
struct EnumNames<Splitter> {
  static constexpr std::array<std::string_view, 3> kNames = {"left", "right", "timeline"};
};

enum class LightOrDark { kLight, kDark };
template <>
struct EnumNames<LightOrDark> {
  static constexpr std::array<std::string_view, 2> kNames = {"light", "dark"};
};

enum class Strip {
  kPositionError,
  kOrientationError,
  kSigma,
  kSampleSize,
  kAgreement,
  kNees,
  kUpdateTime,
  kStreams
};
template <>
struct EnumNames<Strip> {
  static constexpr std::array<std::string_view, 8> kNames = {
      "position-error", "orientation-error", "sigma",  "sample-size", "agreement",
      "nees",           "update-time",       "streams"};
};
inline constexpr std::size_t kStripCount = EnumNames<Strip>::kNames.size();

enum class Overlay {
  kNone,
  kPalette,
  kShortcuts,
  kPreferences,
  kAbout,
  kPlace,
  kBookmark,
  kOpen,
  kExport,
  kSaveRecipe
};
template <>
struct EnumNames<Overlay> {
  static constexpr std::array<std::string_view, 10> kNames = {
      "none",  "palette",  "shortcuts", "preferences", "about",
      "place", "bookmark", "open",      "export",      "save-recipe"};
};

/// kFlight: not the active run's flight, but the one that was opened by itself.
enum class RerunFrom { kStart, kCursor, kFlight };
template <>
struct EnumNames<RerunFrom> {
  static constexpr std::array<std::string_view, 3> kNames = {"start", "cursor", "flight"};
};

struct LayerLook {
  bool is_visible = true;
  double opacity = 1.0;               ///< In [0, 1].
  std::optional<std::string> colour;  ///< "#RRGGBB"; nothing: the theme's.
  friend bool operator==(const LayerLook&, const LayerLook&) = default;
};

/// What the map shows. Where it follows, centre and up are those of the estimate of the moment, and these stay unused.
struct MapLook {
  Eigen::Vector2d centre_in_enu_m = Eigen::Vector2d::Zero();
  double width_m = 0.0;  ///< Of ground across the view; 0: not chosen yet, all of the flight.
  double up_rad = 1.5707963267948966;  ///< Counter-clockwise from east; used where up is kFree.
  MapUp up = MapUp::kNorth;
  bool is_following = false;
  PoseSource topview_at = PoseSource::kEstimate;
  MapTool tool = MapTool::kPan;
  std::vector<Eigen::Vector2d> measured_in_enu_m;
  bool is_split = false;
  std::array<LayerLook, kLayerCount> layers;
  std::vector<Layer> order;  ///< From the ground up; each layer once.
  friend bool operator==(const MapLook&, const MapLook&) = default;
  [[nodiscard]] const LayerLook& layer(Layer which) const {
    return layers[static_cast<std::size_t>(which)];
  }
  [[nodiscard]] LayerLook& layer(Layer which) { return layers[static_cast<std::size_t>(which)]; }
};

struct StripLook {
  Strip strip = Strip::kPositionError;
  bool is_visible = true;
  double height_pt = 34.0;
  friend bool operator==(const StripLook&, const StripLook&) = default;
};

/// How the window is divided. Points are 1/96 inch at interface scale 1.
struct WindowLayout {
  double left_pt = 320.0, right_pt = 380.0, timeline_pt = 216.0;
  bool is_map_only = false;
  std::array<bool, kPanelCount> is_shown{};
  Panel left_tab = Panel::kLayers, right_tab = Panel::kMoment;
  std::vector<StripLook> strips;  ///< From the top; each once.
  friend bool operator==(const WindowLayout&, const WindowLayout&) = default;
  [[nodiscard]] bool shows(Panel panel) const { return is_shown[static_cast<std::size_t>(panel)]; }
};

struct Appearance {
  LightOrDark theme = LightOrDark::kDark;
  double scale = 0.0;  ///< 0: the screen's own.
  bool is_motion_reduced = false;
  friend bool operator==(const Appearance&, const Appearance&) = default;
};

/// In place of a preset's name: the options of the active run; without a run, those of the default preset.
inline constexpr const char* kOptionsOfRun = "run";

/// What the next run is made with.
struct RunDraft {
  std::string preset = kOptionsOfRun;
  std::map<std::string, std::string> changed;  ///< Options that differ from those, as text.
  friend bool operator==(const RunDraft&, const RunDraft&) = default;
};

struct RunLook {
  std::string path;
  bool is_shown = true;
  int colour = 0;  ///< Of run_colour(); kept while the run is open.
  friend bool operator==(const RunLook&, const RunLook&) = default;
};

/// Everything about the window that undo takes back, as a value; time and playing are not in it.
struct ViewState {
  std::string map_path;       ///< Empty: none.
  std::string flight_path;    ///< Opened by itself, to be localised; empty: none.
  std::vector<RunLook> runs;  ///< Open ones, in order; numbers of actions count from 1.
  int active_run = 0;         ///< Number; 0: none.
  MapLook map;
  WindowLayout layout;
  Appearance appearance;
  RunDraft draft;
  std::optional<int> selected_particle;
  friend bool operator==(const ViewState&, const ViewState&) = default;
};

[[nodiscard]] MapLook default_map_look();
[[nodiscard]] WindowLayout default_layout();
[[nodiscard]] ViewState default_view_state();

/// The nearest layout that a window can have: sizes in range, every strip once, tabs that are shown.
[[nodiscard]] WindowLayout repaired(WindowLayout layout);
/// The nearest state that a session can have, for what was read from a file or a clipboard: every layer and strip once,
/// opacities and sizes in range, each run once, an active run among them.
[[nodiscard]] ViewState repaired(ViewState view);

enum class Column { kLeft, kRight };
/// The column in whose tabs a panel is; nothing for those that have a place of their own.
[[nodiscard]] std::optional<Column> column_of(Panel panel);

// Ranges of what can be set about the view; outside it is refused, or repaired where it comes from a file.
inline constexpr double kLeastMapWidthM = 0.1, kMostMapWidthM = 1e6;
inline constexpr double kLeastColumnPt = 160.0, kMostColumnPt = 1200.0;
inline constexpr double kLeastTimelinePt = 60.0, kMostTimelinePt = 900.0;
inline constexpr double kLeastStripPt = 16.0, kMostStripPt = 400.0;
inline constexpr int kLeastMemoryMegabytes = 16, kMostMemoryMegabytes = 65'536;
inline constexpr double kLeastScale = 0.75, kMostScale = 3.0;
/// "#1B7F57".
[[nodiscard]] bool is_colour_text(std::string_view text);

}  // namespace nadir
