// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <variant>
#include <vector>

#include "core/base/result.h"
#include "core/session/view_state.h"

/// Everything that a user can ask for. Menu, palette, shortcut, script and log all speak of the same actions by the same
/// words: kForm is the command with its arguments, kHelp what it does. Times are seconds after the active run's first step.
namespace nadir::actions {

// clang-format off
#define NADIR_ACTION_FIELDS(...)                                  \
  auto fields() { return std::tie(__VA_ARGS__); }                 \
  auto fields() const { return std::tie(__VA_ARGS__); }
// clang-format on

// Files.
struct OpenFile {
  static constexpr std::string_view kForm = "open PATH";
  static constexpr std::string_view kHelp = "Open a run, a map, a flight, a recipe or a figure";
  std::string path;
  NADIR_ACTION_FIELDS(path)
  friend bool operator==(const OpenFile&, const OpenFile&) = default;
};
struct OpenDemo {
  static constexpr std::string_view kForm = "open-demo";
  static constexpr std::string_view kHelp = "Make and open the demo: a flight over a small town";
  NADIR_ACTION_FIELDS()
  friend bool operator==(const OpenDemo&, const OpenDemo&) = default;
};
struct CloseRun {
  static constexpr std::string_view kForm = "close-run RUN";
  static constexpr std::string_view kHelp = "Close a run; its file stays";
  int run = 1;
  NADIR_ACTION_FIELDS(run)
  friend bool operator==(const CloseRun&, const CloseRun&) = default;
};
struct Quit {
  static constexpr std::string_view kForm = "quit";
  static constexpr std::string_view kHelp = "Leave; everything is kept for the next start";
  NADIR_ACTION_FIELDS()
  friend bool operator==(const Quit&, const Quit&) = default;
};

// Time.
struct Seek {
  static constexpr std::string_view kForm = "seek SECONDS";
  static constexpr std::string_view kHelp = "Go to a moment";
  double time_s = 0.0;
  NADIR_ACTION_FIELDS(time_s)
  friend bool operator==(const Seek&, const Seek&) = default;
};
struct StepBy {
  static constexpr std::string_view kForm = "step COUNT";
  static constexpr std::string_view kHelp = "Go so many steps of the run on, or back";
  int steps = 1;
  NADIR_ACTION_FIELDS(steps)
  friend bool operator==(const StepBy&, const StepBy&) = default;
};
struct GoTo {
  static constexpr std::string_view kForm = "go PLACE";
  static constexpr std::string_view kHelp =
      "Go to the start, the end, or the next or previous worst moment or bookmark";
  Moment moment = Moment::kStart;
  NADIR_ACTION_FIELDS(moment)
  friend bool operator==(const GoTo&, const GoTo&) = default;
};
struct Play {
  static constexpr std::string_view kForm = "play {on|off|toggle}";
  static constexpr std::string_view kHelp = "Play, pause, or either";
  Switch to = Switch::kToggle;
  NADIR_ACTION_FIELDS(to)
  friend bool operator==(const Play&, const Play&) = default;
};
struct SetSpeed {
  static constexpr std::string_view kForm = "speed FACTOR";
  static constexpr std::string_view kHelp = "Flight seconds per second of playing, 0.1 to 20";
  double speed = 1.0;
  NADIR_ACTION_FIELDS(speed)
  friend bool operator==(const SetSpeed&, const SetSpeed&) = default;
};
struct SetLoop {
  static constexpr std::string_view kForm = "loop [FROM TO]";
  static constexpr std::string_view kHelp = "Play this range again and again; without one, all";
  std::optional<double> from_s, to_s;
  NADIR_ACTION_FIELDS(from_s, to_s)
  friend bool operator==(const SetLoop&, const SetLoop&) = default;
};

// Map.
struct LookAt {
  static constexpr std::string_view kForm = "look EAST NORTH [METRES]";
  static constexpr std::string_view kHelp = "Show a place of the map, so many metres across";
  double east_m = 0.0, north_m = 0.0;
  std::optional<double> width_m;
  NADIR_ACTION_FIELDS(east_m, north_m, width_m)
  friend bool operator==(const LookAt&, const LookAt&) = default;
};
struct Zoom {
  static constexpr std::string_view kForm = "zoom FACTOR [EAST NORTH]";
  static constexpr std::string_view kHelp =
      "Show it so many times larger, around a point that stays";
  double factor = 1.5;
  std::optional<double> east_m, north_m;
  NADIR_ACTION_FIELDS(factor, east_m, north_m)
  friend bool operator==(const Zoom&, const Zoom&) = default;
};
struct Rotate {
  static constexpr std::string_view kForm = "rotate DEGREES";
  static constexpr std::string_view kHelp = "Turn the map counter-clockwise";
  double angle_deg = 0.0;
  NADIR_ACTION_FIELDS(angle_deg)
  friend bool operator==(const Rotate&, const Rotate&) = default;
};
struct Fit {
  static constexpr std::string_view kForm = "fit {flight|map|particles}";
  static constexpr std::string_view kHelp = "Show the whole flight, the whole map or all particles";
  FitTo to = FitTo::kFlight;
  NADIR_ACTION_FIELDS(to)
  friend bool operator==(const Fit&, const Fit&) = default;
};
struct Follow {
  static constexpr std::string_view kForm = "follow {on|off|toggle}";
  static constexpr std::string_view kHelp = "Keep the estimate in the middle of the map";
  Switch to = Switch::kToggle;
  NADIR_ACTION_FIELDS(to)
  friend bool operator==(const Follow&, const Follow&) = default;
};
struct SetUp {
  static constexpr std::string_view kForm = "up {north|heading|free}";
  static constexpr std::string_view kHelp = "What is up on the map";
  MapUp up = MapUp::kNorth;
  NADIR_ACTION_FIELDS(up)
  friend bool operator==(const SetUp&, const SetUp&) = default;
};
struct GoToPlace {
  static constexpr std::string_view kForm = "place TEXT";
  static constexpr std::string_view kHelp =
      "Show a place by its coordinates: EAST NORTH in metres, LAT, LON in degrees, or MGRS";
  std::string text;
  NADIR_ACTION_FIELDS(text)
  friend bool operator==(const GoToPlace&, const GoToPlace&) = default;
};
struct LayTopview {
  static constexpr std::string_view kForm = "lay-at {estimate|truth|odometry}";
  static constexpr std::string_view kHelp = "Pose at which the topview lies on the map";
  PoseSource at = PoseSource::kEstimate;
  NADIR_ACTION_FIELDS(at)
  friend bool operator==(const LayTopview&, const LayTopview&) = default;
};
struct SelectParticle {
  static constexpr std::string_view kForm = "select-particle [INDEX]";
  static constexpr std::string_view kHelp =
      "Show pose, weight and errors of a particle; without one, of none";
  std::optional<int> index;
  NADIR_ACTION_FIELDS(index)
  friend bool operator==(const SelectParticle&, const SelectParticle&) = default;
};
struct MeasurePoint {
  static constexpr std::string_view kForm = "measure [EAST NORTH]";
  static constexpr std::string_view kHelp =
      "Add a point to what is measured; without one, measure anew";
  std::optional<double> east_m, north_m;
  NADIR_ACTION_FIELDS(east_m, north_m)
  friend bool operator==(const MeasurePoint&, const MeasurePoint&) = default;
};
struct UseTool {
  static constexpr std::string_view kForm = "tool {pan|measure|pick}";
  static constexpr std::string_view kHelp = "What a click on the map does";
  MapTool tool = MapTool::kPan;
  NADIR_ACTION_FIELDS(tool)
  friend bool operator==(const UseTool&, const UseTool&) = default;
};
struct ShowLayer {
  static constexpr std::string_view kForm = "layer NAME {on|off|toggle}";
  static constexpr std::string_view kHelp = "Show or hide a layer of the map";
  Layer layer = Layer::kPicture;
  Switch to = Switch::kToggle;
  NADIR_ACTION_FIELDS(layer, to)
  friend bool operator==(const ShowLayer&, const ShowLayer&) = default;
};
struct SetLayerOpacity {
  static constexpr std::string_view kForm = "layer-opacity NAME SHARE";
  static constexpr std::string_view kHelp = "How much a layer covers what is below it, 0 to 1";
  Layer layer = Layer::kPicture;
  double opacity = 1.0;
  NADIR_ACTION_FIELDS(layer, opacity)
  friend bool operator==(const SetLayerOpacity&, const SetLayerOpacity&) = default;
};
struct SetLayerColour {
  static constexpr std::string_view kForm = "layer-colour NAME [#RRGGBB]";
  static constexpr std::string_view kHelp = "Colour of a layer's lines; without one, the theme's";
  Layer layer = Layer::kEstimate;
  std::optional<std::string> colour;
  NADIR_ACTION_FIELDS(layer, colour)
  friend bool operator==(const SetLayerColour&, const SetLayerColour&) = default;
};
struct MoveLayer {
  static constexpr std::string_view kForm = "layer-move NAME PLACES";
  static constexpr std::string_view kHelp = "Raise a layer over others, or lower it";
  Layer layer = Layer::kPicture;
  int places = 1;
  NADIR_ACTION_FIELDS(layer, places)
  friend bool operator==(const MoveLayer&, const MoveLayer&) = default;
};

// Layout and look.
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
      "show {none|palette|shortcuts|preferences|about|place|bookmark}";
  static constexpr std::string_view kHelp =
      "Command palette, sheet of shortcuts, preferences ...; none closes it";
  Overlay overlay = Overlay::kNone;
  NADIR_ACTION_FIELDS(overlay)
  friend bool operator==(const ShowOverlay&, const ShowOverlay&) = default;
};

// Runs.
struct ActivateRun {
  static constexpr std::string_view kForm = "run RUN";
  static constexpr std::string_view kHelp = "Make an open run the one that all panels speak of";
  int run = 1;
  NADIR_ACTION_FIELDS(run)
  friend bool operator==(const ActivateRun&, const ActivateRun&) = default;
};
struct ShowRun {
  static constexpr std::string_view kForm = "show-run RUN {on|off|toggle}";
  static constexpr std::string_view kHelp = "Draw a run beside the active one, or not";
  int run = 1;
  Switch to = Switch::kToggle;
  NADIR_ACTION_FIELDS(run, to)
  friend bool operator==(const ShowRun&, const ShowRun&) = default;
};
struct GoToDivergence {
  static constexpr std::string_view kForm = "divergence RUN";
  static constexpr std::string_view kHelp = "Go to where a run first leaves the active one";
  int run = 2;
  NADIR_ACTION_FIELDS(run)
  friend bool operator==(const GoToDivergence&, const GoToDivergence&) = default;
};

// Rerun.
struct SetOption {
  static constexpr std::string_view kForm = "option NAME [VALUE]";
  static constexpr std::string_view kHelp =
      "Set an option of the next run; without a value, as the preset has it";
  std::string name;
  std::optional<std::string> value;
  NADIR_ACTION_FIELDS(name, value)
  friend bool operator==(const SetOption&, const SetOption&) = default;
};
struct UsePreset {
  static constexpr std::string_view kForm = "preset NAME";
  static constexpr std::string_view kHelp =
      "Take all options of the next run from a preset or recipe file, or 'run' for the active "
      "run's";
  std::string name;
  NADIR_ACTION_FIELDS(name)
  friend bool operator==(const UsePreset&, const UsePreset&) = default;
};
struct SavePreset {
  static constexpr std::string_view kForm = "save-preset FILE";
  static constexpr std::string_view kHelp =
      "Write the options of the next run as a recipe for nadir localise";
  std::string file;
  NADIR_ACTION_FIELDS(file)
  friend bool operator==(const SavePreset&, const SavePreset&) = default;
};
struct Rerun {
  static constexpr std::string_view kForm = "rerun {start|cursor}";
  static constexpr std::string_view kHelp =
      "Localise the flight again, from its start or from here with the recorded particles";
  RerunFrom from = RerunFrom::kStart;
  NADIR_ACTION_FIELDS(from)
  friend bool operator==(const Rerun&, const Rerun&) = default;
};
struct CancelJob {
  static constexpr std::string_view kForm = "cancel [JOB]";
  static constexpr std::string_view kHelp =
      "Stop work in the background; without a number, the newest";
  std::optional<int> job;
  NADIR_ACTION_FIELDS(job)
  friend bool operator==(const CancelJob&, const CancelJob&) = default;
};

// Export.
struct ExportFigure {
  static constexpr std::string_view kForm = "export FILE [FIGURE]";
  static constexpr std::string_view kHelp =
      "Draw this moment, or another figure, as .png, .svg or .pdf, or the loop's range as .mp4";
  std::string file;
  std::optional<std::string> figure;
  NADIR_ACTION_FIELDS(file, figure)
  friend bool operator==(const ExportFigure&, const ExportFigure&) = default;
};
struct ExportTable {
  static constexpr std::string_view kForm = "export-table FILE";
  static constexpr std::string_view kHelp = "Every step of the active run as .csv";
  std::string file;
  NADIR_ACTION_FIELDS(file)
  friend bool operator==(const ExportTable&, const ExportTable&) = default;
};
struct WriteReport {
  static constexpr std::string_view kForm = "report FOLDER";
  static constexpr std::string_view kHelp =
      "All figures and tables of the shown runs with an index page";
  std::string folder;
  NADIR_ACTION_FIELDS(folder)
  friend bool operator==(const WriteReport&, const WriteReport&) = default;
};
struct Copy {
  static constexpr std::string_view kForm = "copy TEXT";
  static constexpr std::string_view kHelp = "Put a text on the clipboard";
  std::string text;
  NADIR_ACTION_FIELDS(text)
  friend bool operator==(const Copy&, const Copy&) = default;
};
/// The window's whole look as text, to send to somebody or to keep.
struct CopyView {
  static constexpr std::string_view kForm = "copy-view";
  static constexpr std::string_view kHelp =
      "Put this view, its moment and its runs on the clipboard as text";
  NADIR_ACTION_FIELDS()
  friend bool operator==(const CopyView&, const CopyView&) = default;
};
struct PasteView {
  static constexpr std::string_view kForm = "paste-view TEXT";
  static constexpr std::string_view kHelp = "Show what copy-view has put on the clipboard";
  std::string text;
  NADIR_ACTION_FIELDS(text)
  friend bool operator==(const PasteView&, const PasteView&) = default;
};

// Bookmarks, notices, history.
struct AddBookmark {
  static constexpr std::string_view kForm = "bookmark [NOTE]";
  static constexpr std::string_view kHelp = "Mark this moment of the active run, with a note";
  std::optional<std::string> note;
  NADIR_ACTION_FIELDS(note)
  friend bool operator==(const AddBookmark&, const AddBookmark&) = default;
};
struct EditBookmark {
  static constexpr std::string_view kForm = "bookmark-note NUMBER NOTE";
  static constexpr std::string_view kHelp = "Change the note of a bookmark";
  int bookmark = 1;
  std::string note;
  NADIR_ACTION_FIELDS(bookmark, note)
  friend bool operator==(const EditBookmark&, const EditBookmark&) = default;
};
struct RemoveBookmark {
  static constexpr std::string_view kForm = "bookmark-remove NUMBER";
  static constexpr std::string_view kHelp = "Take a bookmark away";
  int bookmark = 1;
  NADIR_ACTION_FIELDS(bookmark)
  friend bool operator==(const RemoveBookmark&, const RemoveBookmark&) = default;
};
struct DismissNotice {
  static constexpr std::string_view kForm = "dismiss [NOTICE]";
  static constexpr std::string_view kHelp = "Put a notice away as read; without a number, all";
  std::optional<int> notice;
  NADIR_ACTION_FIELDS(notice)
  friend bool operator==(const DismissNotice&, const DismissNotice&) = default;
};
struct Undo {
  static constexpr std::string_view kForm = "undo";
  static constexpr std::string_view kHelp = "Take the last change back";
  NADIR_ACTION_FIELDS()
  friend bool operator==(const Undo&, const Undo&) = default;
};
struct Redo {
  static constexpr std::string_view kForm = "redo";
  static constexpr std::string_view kHelp = "Do again what was taken back";
  NADIR_ACTION_FIELDS()
  friend bool operator==(const Redo&, const Redo&) = default;
};

#undef NADIR_ACTION_FIELDS

}  // namespace nadir::actions

namespace nadir {

/// One thing that a user asked for.
using Action = std::variant<actions::OpenFile,
                            actions::OpenDemo,
                            actions::CloseRun,
                            actions::Quit,
                            actions::Seek,
                            actions::StepBy,
                            actions::GoTo,
                            actions::Play,
                            actions::SetSpeed,
                            actions::SetLoop,
                            actions::LookAt,
                            actions::Zoom,
                            actions::Rotate,
                            actions::Fit,
                            actions::Follow,
                            actions::SetUp,
                            actions::GoToPlace,
                            actions::LayTopview,
                            actions::SelectParticle,
                            actions::MeasurePoint,
                            actions::UseTool,
                            actions::ShowLayer,
                            actions::SetLayerOpacity,
                            actions::SetLayerColour,
                            actions::MoveLayer,
                            actions::ShowPanel,
                            actions::MoveSplitter,
                            actions::MapOnly,
                            actions::SplitView,
                            actions::SaveLayout,
                            actions::UseLayout,
                            actions::SetTheme,
                            actions::SetScale,
                            actions::ReduceMotion,
                            actions::SetMemory,
                            actions::ShowStrip,
                            actions::MoveStrip,
                            actions::SetStripHeight,
                            actions::ShowOverlay,
                            actions::ActivateRun,
                            actions::ShowRun,
                            actions::GoToDivergence,
                            actions::SetOption,
                            actions::UsePreset,
                            actions::SavePreset,
                            actions::Rerun,
                            actions::CancelJob,
                            actions::ExportFigure,
                            actions::ExportTable,
                            actions::WriteReport,
                            actions::Copy,
                            actions::CopyView,
                            actions::PasteView,
                            actions::AddBookmark,
                            actions::EditBookmark,
                            actions::RemoveBookmark,
                            actions::DismissNotice,
                            actions::Undo,
                            actions::Redo>;

/// What a panel returns: usually none, at most a few.
using Actions = std::vector<Action>;

/// The words of an action: "seek 12.5", "layer particles off", "export \"my figures/a.svg\"". Its last text argument is
/// quoted where it needs to be; parse_action() gives the same action again.
[[nodiscard]] std::string action_text(const Action& action);

/// @errors kInvalidOptions: no such action (names the nearest), too many, too few or wrong arguments, in one sentence that
/// says the form: "seek abc: SECONDS is not a number (seek SECONDS)".
[[nodiscard]] Result<Action> parse_action(std::string_view text);

/// Name, form and help of every action, in the order above.
struct ActionHelp {
  std::string_view name, form, help;
};
[[nodiscard]] std::vector<ActionHelp> action_helps();
[[nodiscard]] std::string_view action_name(const Action& action);

}  // namespace nadir
