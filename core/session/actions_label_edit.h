// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/field.h"
#include "core/session/action_fields.h"
#include "core/session/action_lists.h"

/// What changes labels: each is one step of their history. Coordinates are east and north in metres of the labels' project
/// plane; classes are named as in resources/palettes/classes.csv, or "unclassified".
namespace nadir {

enum class LabelPart { kClass, kWidth, kNote };
template <>
struct EnumNames<LabelPart> {
  static constexpr std::array<std::string_view, 3> kNames = {"class", "width", "note"};
};

/// What needs no more to be said.
enum class LabelCommand {
  kSelectAll,
  kDelete,  ///< The corners that are picked, else what is selected.
  kCopy,
  kCut,
  kMerge,
  kSubtract,
  kClip,
  kClipOthers,
  kSmooth,
  kSimplify,
  kSquare,
  kUp,
  kDown,
  kTop,
  kBottom,
  kToPaint,
  kPaintToObjects,
};
template <>
struct EnumNames<LabelCommand> {
  static constexpr std::array<std::string_view, 17> kNames = {
      "select-all", "delete",      "copy",   "cut",      "merge",           "subtract",
      "clip",       "clip-others", "smooth", "simplify", "square",          "up",
      "down",       "top",         "bottom", "to-paint", "paint-to-objects"};
};

}  // namespace nadir

namespace nadir::actions {

struct DrawArea {
  static constexpr std::string_view kForm = "draw-area CLASS EAST,NORTH...";
  static constexpr std::string_view kHelp = "Draw an area";
  std::string class_name;
  PlaceList places;
  NADIR_ACTION_FIELDS(class_name, places)
  friend bool operator==(const DrawArea&, const DrawArea&) = default;
};

struct DrawLine {
  static constexpr std::string_view kForm = "draw-line CLASS WIDTH EAST,NORTH...";
  static constexpr std::string_view kHelp = "Draw a line, so many metres wide";
  std::string class_name;
  double width_m = 1.0;
  PlaceList places;
  NADIR_ACTION_FIELDS(class_name, width_m, places)
  friend bool operator==(const DrawLine&, const DrawLine&) = default;
};

struct DrawOutline {
  static constexpr std::string_view kForm = "draw-outline CLASS THICKNESS EAST,NORTH...";
  static constexpr std::string_view kHelp =
      "Draw a contour, so many metres thick, of which nobody sees the inside";
  std::string class_name;
  double thickness_m = 0.3;
  PlaceList places;
  NADIR_ACTION_FIELDS(class_name, thickness_m, places)
  friend bool operator==(const DrawOutline&, const DrawOutline&) = default;
};

struct DrawStreet {
  static constexpr std::string_view kForm = "draw-street PROFILE EAST,NORTH...";
  static constexpr std::string_view kHelp = "Draw all strips of a street along its middle";
  std::string profile;
  PlaceList places;
  NADIR_ACTION_FIELDS(profile, places)
  friend bool operator==(const DrawStreet&, const DrawStreet&) = default;
};

struct CutHole {
  static constexpr std::string_view kForm = "cut-hole OBJECT EAST,NORTH...";
  static constexpr std::string_view kHelp = "Cut a hole into an object; 0: what is selected";
  std::int64_t object = 0;
  PlaceList places;
  NADIR_ACTION_FIELDS(object, places)
  friend bool operator==(const CutHole&, const CutHole&) = default;
};

struct StrokeLabels {
  static constexpr std::string_view kForm = "stroke CLASS RADIUS EAST,NORTH...";
  static constexpr std::string_view kHelp =
      "Paint along a way, so many metres to each side; the class \"nothing\" takes paint away";
  std::string class_name;
  double radius_m = 1.0;
  PlaceList places;
  NADIR_ACTION_FIELDS(class_name, radius_m, places)
  friend bool operator==(const StrokeLabels&, const StrokeLabels&) = default;
};

struct FillLabels {
  static constexpr std::string_view kForm = "fill CLASS EAST NORTH";
  static constexpr std::string_view kHelp =
      "Paint the cells of one class that hang together with a place";
  std::string class_name;
  double east_m = 0.0;
  double north_m = 0.0;
  NADIR_ACTION_FIELDS(class_name, east_m, north_m)
  friend bool operator==(const FillLabels&, const FillLabels&) = default;
};

struct RecodeLabels {
  static constexpr std::string_view kForm = "recode CLASS NEW-CLASS [EAST,NORTH...]";
  static constexpr std::string_view kHelp =
      "Turn one class into another, everywhere or within a ring";
  std::string from;
  std::string to;
  PlaceList within;
  NADIR_ACTION_FIELDS(from, to, within)
  friend bool operator==(const RecodeLabels&, const RecodeLabels&) = default;
};

struct MoveVertex {
  static constexpr std::string_view kForm = "move-vertex OBJECT RING CORNER EAST NORTH";
  static constexpr std::string_view kHelp =
      "Move a corner, counted from 0, of an object; 0: what is selected";
  std::int64_t object = 0;
  int ring = 0;
  int place = 0;
  double east_m = 0.0;
  double north_m = 0.0;
  NADIR_ACTION_FIELDS(object, ring, place, east_m, north_m)
  friend bool operator==(const MoveVertex&, const MoveVertex&) = default;
};

struct AddVertex {
  static constexpr std::string_view kForm = "add-vertex OBJECT RING CORNER EAST NORTH";
  static constexpr std::string_view kHelp =
      "Add a corner after another, counted from 0, to an object; 0: what is selected";
  std::int64_t object = 0;
  int ring = 0;
  int place = 0;
  double east_m = 0.0;
  double north_m = 0.0;
  NADIR_ACTION_FIELDS(object, ring, place, east_m, north_m)
  friend bool operator==(const AddVertex&, const AddVertex&) = default;
};

struct MoveLabels {
  static constexpr std::string_view kForm = "move-labels EAST NORTH";
  static constexpr std::string_view kHelp =
      "Move the corners that are picked, else what is selected, by so many metres";
  double east_m = 0.0;
  double north_m = 0.0;
  NADIR_ACTION_FIELDS(east_m, north_m)
  friend bool operator==(const MoveLabels&, const MoveLabels&) = default;
};

struct DuplicateLabels {
  static constexpr std::string_view kForm = "duplicate-labels EAST NORTH";
  static constexpr std::string_view kHelp = "A copy of what is selected, so many metres away";
  double east_m = 0.0;
  double north_m = 0.0;
  NADIR_ACTION_FIELDS(east_m, north_m)
  friend bool operator==(const DuplicateLabels&, const DuplicateLabels&) = default;
};

struct CopyBeside {
  static constexpr std::string_view kForm = "copy-beside METRES";
  static constexpr std::string_view kHelp =
      "A parallel: left of a line, around an area; negative: to the right, inside";
  double by_m = 1.0;
  NADIR_ACTION_FIELDS(by_m)
  friend bool operator==(const CopyBeside&, const CopyBeside&) = default;
};

struct EditLabels {
  static constexpr std::string_view kForm =
      "labels "
      "{select-all|delete|copy|cut|merge|subtract|clip|clip-others|smooth|simplify|square|up|down|"
      "top|bottom|to-paint|paint-to-objects}";
  static constexpr std::string_view kHelp = "What is done to selected labels";
  LabelCommand command = LabelCommand::kSelectAll;
  NADIR_ACTION_FIELDS(command)
  friend bool operator==(const EditLabels&, const EditLabels&) = default;
};

struct SetLabel {
  static constexpr std::string_view kForm = "set-label {class|width|note} VALUE";
  static constexpr std::string_view kHelp = "Class, width in metres or note of what is selected";
  LabelPart part = LabelPart::kClass;
  std::string value;
  NADIR_ACTION_FIELDS(part, value)
  friend bool operator==(const SetLabel&, const SetLabel&) = default;
};

struct JoinBorders {
  static constexpr std::string_view kForm = "join-borders METRES";
  static constexpr std::string_view kHelp =
      "Borders of what is selected that lie within reach of each other become one";
  double reach_m = 0.1;
  NADIR_ACTION_FIELDS(reach_m)
  friend bool operator==(const JoinBorders&, const JoinBorders&) = default;
};

struct SplitLabels {
  static constexpr std::string_view kForm = "split-labels EAST,NORTH...";
  static constexpr std::string_view kHelp = "Cut what is selected, or all that a line crosses";
  PlaceList line;
  NADIR_ACTION_FIELDS(line)
  friend bool operator==(const SplitLabels&, const SplitLabels&) = default;
};

struct PasteLabels {
  static constexpr std::string_view kForm = "paste-labels TEXT";
  static constexpr std::string_view kHelp = "Paste what \"labels copy\" has copied";
  std::string text;
  NADIR_ACTION_FIELDS(text)
  friend bool operator==(const PasteLabels&, const PasteLabels&) = default;
};

}  // namespace nadir::actions
