// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/desk/select_how.h"
#include "core/exchange/label_format.h"
#include "core/session/action_fields.h"
#include "core/session/action_lists.h"
#include "core/session/label_view.h"

/// Labels of an overhead: what is open, the tool at work, what is selected, files. Coordinates are east and north in metres of
/// the labels' project plane.
namespace nadir {

enum class TraceWay { kNear, kFar };
template <>
struct EnumNames<TraceWay> {
  static constexpr std::array<std::string_view, 2> kNames = {"near", "far"};
};

enum class LegPart { kLength, kBearing, kTurn };
template <>
struct EnumNames<LegPart> {
  static constexpr std::array<std::string_view, 3> kNames = {"length", "bearing", "turn"};
};

}  // namespace nadir

namespace nadir::actions {

struct OpenLabels {
  static constexpr std::string_view kForm = "label FILE";
  static constexpr std::string_view kHelp =
      "Draw labels on a map package, an image or a labelling document";
  std::string path;
  NADIR_ACTION_FIELDS(path)
  friend bool operator==(const OpenLabels&, const OpenLabels&) = default;
};

struct CloseLabels {
  static constexpr std::string_view kForm = "close-labels";
  static constexpr std::string_view kHelp =
      "Close what is labelled; everything drawn is on disk already";
  NADIR_ACTION_FIELDS()
  friend bool operator==(const CloseLabels&, const CloseLabels&) = default;
};

struct SetWorkspace {
  static constexpr std::string_view kForm = "workspace {replay|label}";
  static constexpr std::string_view kHelp = "What the window is for: runs, or labels";
  Workspace to = Workspace::kReplay;
  NADIR_ACTION_FIELDS(to)
  friend bool operator==(const SetWorkspace&, const SetWorkspace&) = default;
};

struct ShowLabelTab {
  static constexpr std::string_view kForm = "label-tab {objects|checks|review|history|image}";
  static constexpr std::string_view kHelp = "What the column beside the labels shows";
  LabelTab tab = LabelTab::kObjects;
  NADIR_ACTION_FIELDS(tab)
  friend bool operator==(const ShowLabelTab&, const ShowLabelTab&) = default;
};

struct ShowBorders {
  static constexpr std::string_view kForm = "borders {on|off|toggle}";
  static constexpr std::string_view kHelp = "Show the borders of all labelled objects";
  Switch to = Switch::kToggle;
  NADIR_ACTION_FIELDS(to)
  friend bool operator==(const ShowBorders&, const ShowBorders&) = default;
};

struct SetLabelOpacity {
  static constexpr std::string_view kForm = "label-opacity {labels|picture} SHARE";
  static constexpr std::string_view kHelp =
      "How much labels, or the picture below them, cover where labels are drawn, 0 to 1";
  LabelLayer layer = LabelLayer::kLabels;
  double share = 1.0;
  NADIR_ACTION_FIELDS(layer, share)
  friend bool operator==(const SetLabelOpacity&, const SetLabelOpacity&) = default;
};

struct SetLabelOption {
  static constexpr std::string_view kForm = "label-option NAME VALUE";
  static constexpr std::string_view kHelp =
      "Set an option of the labelling tool: its kind (tool), class, widths, radius, snapping";
  std::string name;
  std::string value;
  NADIR_ACTION_FIELDS(name, value)
  friend bool operator==(const SetLabelOption&, const SetLabelOption&) = default;
};

struct LastClass {
  static constexpr std::string_view kForm = "last-class";
  static constexpr std::string_view kHelp = "Go back to the class that was drawn before";
  NADIR_ACTION_FIELDS()
  friend bool operator==(const LastClass&, const LastClass&) = default;
};

struct AddPlace {
  static constexpr std::string_view kForm =
      "point EAST NORTH [REACH] [{instead|add|remove|toggle}]";
  static constexpr std::string_view kHelp =
      "A place of the tool at work, or what it does there; it may be drawn so many metres";
  double east_m = 0.0;
  double north_m = 0.0;
  std::optional<double> reach_m;
  std::optional<SelectHow> how;
  NADIR_ACTION_FIELDS(east_m, north_m, reach_m, how)
  friend bool operator==(const AddPlace&, const AddPlace&) = default;
};

struct TraceTo {
  static constexpr std::string_view kForm = "trace EAST NORTH REACH {near|far}";
  static constexpr std::string_view kHelp =
      "Along the border from the last place to this one, the near or the far way round";
  double east_m = 0.0;
  double north_m = 0.0;
  double reach_m = 1.0;
  TraceWay way = TraceWay::kNear;
  NADIR_ACTION_FIELDS(east_m, north_m, reach_m, way)
  friend bool operator==(const TraceTo&, const TraceTo&) = default;
};

struct TypeLeg {
  static constexpr std::string_view kForm = "leg {length|bearing|turn} [NUMBER]";
  static constexpr std::string_view kHelp =
      "Length in metres, bearing or turn to the right in degrees of the leg to the next place; "
      "without one, as the hand has it";
  LegPart part = LegPart::kLength;
  std::optional<double> number;
  NADIR_ACTION_FIELDS(part, number)
  friend bool operator==(const TypeLeg&, const TypeLeg&) = default;
};

struct FinishTool {
  static constexpr std::string_view kForm = "finish";
  static constexpr std::string_view kHelp = "Finish what the tool is drawing";
  NADIR_ACTION_FIELDS()
  friend bool operator==(const FinishTool&, const FinishTool&) = default;
};

struct CancelTool {
  static constexpr std::string_view kForm = "cancel-tool";
  static constexpr std::string_view kHelp =
      "Drop the places of the tool, else the selection, else go back to selecting";
  NADIR_ACTION_FIELDS()
  friend bool operator==(const CancelTool&, const CancelTool&) = default;
};

struct SelectLabels {
  static constexpr std::string_view kForm = "select-labels [OBJECT...]";
  static constexpr std::string_view kHelp = "Select objects by their numbers; without one, none";
  NumberList objects;
  NADIR_ACTION_FIELDS(objects)
  friend bool operator==(const SelectLabels&, const SelectLabels&) = default;
};

struct SelectBox {
  static constexpr std::string_view kForm =
      "select-box WEST SOUTH EAST NORTH [{instead|add|remove|toggle}]";
  static constexpr std::string_view kHelp =
      "Select what lies within a box; with the tool vertices, corners";
  double west_m = 0.0;
  double south_m = 0.0;
  double east_m = 0.0;
  double north_m = 0.0;
  std::optional<SelectHow> how;
  NADIR_ACTION_FIELDS(west_m, south_m, east_m, north_m, how)
  friend bool operator==(const SelectBox&, const SelectBox&) = default;
};

struct GoToLabelStep {
  static constexpr std::string_view kForm = "label-step NUMBER";
  static constexpr std::string_view kHelp =
      "Go to a step of the labels' history; 0: before the first";
  std::int64_t step = 0;
  NADIR_ACTION_FIELDS(step)
  friend bool operator==(const GoToLabelStep&, const GoToLabelStep&) = default;
};

struct ExportLabels {
  static constexpr std::string_view kForm =
      "export-labels {package|geojson|shapefile|class-images|indexed-png|coco} FILE";
  static constexpr std::string_view kHelp = "Write the labels for other programs";
  LabelFormat format = LabelFormat::kMapPackage;
  std::string path;
  NADIR_ACTION_FIELDS(format, path)
  friend bool operator==(const ExportLabels&, const ExportLabels&) = default;
};

struct ImportLabels {
  static constexpr std::string_view kForm = "import-labels FILE";
  static constexpr std::string_view kHelp =
      "Take what another program has drawn, by the rules that fit it";
  std::string path;
  NADIR_ACTION_FIELDS(path)
  friend bool operator==(const ImportLabels&, const ImportLabels&) = default;
};

struct SaveLabelsCopy {
  static constexpr std::string_view kForm = "save-labels-copy FILE";
  static constexpr std::string_view kHelp = "Write the labels as they are into another document";
  std::string path;
  NADIR_ACTION_FIELDS(path)
  friend bool operator==(const SaveLabelsCopy&, const SaveLabelsCopy&) = default;
};

}  // namespace nadir::actions
