// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "core/assist/grab_cut.h"
#include "core/assist/magic_wand.h"
#include "core/assist/scissors.h"
#include "core/assist/superpixels.h"
#include "core/base/field.h"
#include "core/label/label_object.h"
#include "core/label/label_paint.h"

namespace nadir {

enum class ToolKind {
  kSelect,       ///< A place selects what lies there.
  kVertices,     ///< A place picks what corner is there.
  kArea,         ///< Corners, as many as it takes.
  kLine,         ///< Places along its middle.
  kOutline,      ///< Corners, as an area.
  kRectangle,    ///< Its first edge, and how far it reaches beside it: three places.
  kCircle,       ///< Middle and rim: two places.
  kStreet,       ///< Places along the middle of a street, which becomes lines by its profile.
  kHole,         ///< Corners of a hole in what is selected, or lies around it.
  kSplit,        ///< A line across what is selected, or all that it meets.
  kBrush,        ///< A stroke of paint.
  kEraser,       ///< A stroke that takes paint away.
  kFill,         ///< A place: the cells of one class that hang together with it.
  kRecode,       ///< Corners of where one class becomes another.
  kMeasure,      ///< Places of a way or around a piece of ground; changes nothing.
  kWand,         ///< Places: what of the image hangs together with them and is of their colour.
  kSuperpixels,  ///< Strokes over pieces of the image.
  kGrabCut,      ///< A rectangle, then strokes on what of the image is wanted and what is not.
  kScissors,     ///< Corners of an area, between which its border follows edges of the image.
};
template <>
struct EnumNames<ToolKind> {
  static constexpr std::array<std::string_view, 19> kNames = {
      "select",  "vertices", "area",        "line",     "outline", "rectangle", "circle",
      "street",  "hole",     "split",       "brush",    "eraser",  "fill",      "recode",
      "measure", "wand",     "superpixels", "grab-cut", "scissors"};
};

enum class BrushUnit {
  kMetres,
  kCells,  ///< Of the labels, which are the pixels of their image.
};
template <>
struct EnumNames<BrushUnit> {
  static constexpr std::array<std::string_view, 2> kNames = {"metres", "cells"};
};

/// What becomes of what was found on the image.
enum class FoundAs { kPaint, kAreas };
template <>
struct EnumNames<FoundAs> {
  static constexpr std::array<std::string_view, 2> kNames = {"paint", "areas"};
};

/// A class as an option: by its name, or "unclassified".
struct NamedClass {
  ClassId id = kUnclassified;

  static constexpr std::string_view kForm = "CLASS";
  [[nodiscard]] static Result<NamedClass> from_text(std::string_view text);
  [[nodiscard]] std::string text() const { return std::string(class_info(id).name); }
  /// @errors kInvalidOptions: a class that no map can hold, as the sky.
  [[nodiscard]] Result<void> check() const;
  friend bool operator==(const NamedClass&, const NamedClass&) = default;
};

/// A text as an option. One line; may be empty.
struct PlainText {
  std::string value;

  static constexpr std::string_view kForm = "TEXT";
  [[nodiscard]] static Result<PlainText> from_text(std::string_view text);
  [[nodiscard]] std::string text() const { return value; }
  [[nodiscard]] Result<void> check() const;
  friend bool operator==(const PlainText&, const PlainText&) = default;
};

/// What a hand draws with. A plain value, kept from one start to the next.
struct LabelTool {
  ToolKind kind = ToolKind::kSelect;
  NamedClass class_id{kRoad};
  NamedClass last_class{kTerrain};   ///< That was in use before; see toggle_class().
  NamedClass recode_from{kTerrain};  ///< What recoding turns into `class_id`.
  double line_width_m = 3.5;
  double outline_thickness_m = 0.3;
  BrushUnit brush_unit = BrushUnit::kMetres;
  double brush_radius_m = 1.0;
  double brush_radius_cells = 10.0;
  bool paints_over = false;  ///< Whether the brush covers what lies above its class.
  PlainText street_profile{"residential street"};
  bool snaps = true;
  bool shares_borders = true;  ///< Whether borders that others share move together.
  double simplify_m = 0.1;
  double straighten_deg = 20.0;
  AssistWindowOptions assist;  ///< What the last four kinds look at.
  WandOptions wand;
  SuperpixelOptions superpixels;
  GrabCutOptions grab_cut;
  ScissorsOptions scissors;
  FoundAs found_as = FoundAs::kPaint;
  DrawCellsOptions found;
  friend bool operator==(const LabelTool&, const LabelTool&) = default;
};

template <typename Options, typename Visitor>
void visit_fields(Options& tool, Visitor&& visit) requires
    std::is_same_v<std::remove_const_t<Options>, LabelTool> {
  visit(tool.kind, Field{"tool", "", "What the hand does"});
  visit(tool.class_id, Field{"class", "", "Class that is drawn"});
  visit(tool.last_class, Field{"last-class", "", "Class that was drawn before"});
  visit(tool.recode_from, Field{"recode-from", "", "Class that recoding replaces"});
  visit(tool.line_width_m, Field{"line-width", "m", "Width of lines", 0.01, 1'000.0});
  visit(tool.outline_thickness_m,
        Field{"outline-thickness", "m", "Thickness of outlines, inwards", 0.01, 100.0});
  visit(tool.brush_unit, Field{"brush-unit", "", "What the brush is measured in"});
  visit(tool.brush_radius_m, Field{"brush-radius", "m", "Radius of the brush", 0.01, 10'000.0});
  visit(tool.brush_radius_cells,
        Field{"brush-cells", "cells", "Radius of the brush", 0.5, 10'000.0});
  visit(tool.paints_over, Field{"paint-over", "", "Paint covers objects of higher classes too"});
  visit(tool.street_profile, Field{"street-profile", "", "What a street is made of, across"});
  visit(tool.snaps, Field{"snap", "", "Places go to corners, edges and right angles nearby"});
  visit(tool.shares_borders, Field{"shared-borders", "", "Borders that touch move together"});
  visit(tool.simplify_m,
        Field{"simplify", "m", "How far simplifying may move a border", 0.001, 100.0});
  visit(tool.straighten_deg,
        Field{"straighten", "deg", "How far from right angles edges are made square", 0.1, 45.0});
  visit_fields(tool.assist, visit);
  visit_fields(tool.wand, visit);
  visit_fields(tool.superpixels, visit);
  visit_fields(tool.grab_cut, visit);
  visit_fields(tool.scissors, visit);
  visit(tool.found_as, Field{"found-as", "", "What becomes of what was found on the image"});
  visit_fields(tool.found, visit);
}

/// Takes a class into use; the one before can be had back.
void use_class(LabelTool& tool, ClassId id);
/// Goes back to the class before, and forth again.
void toggle_class(LabelTool& tool);

[[nodiscard]] double brush_radius_m(const LabelTool& tool, double metres_per_cell);
/// What brush and fill paint with.
[[nodiscard]] PaintValue paint_value(const LabelTool& tool);

/// How many places a tool takes: it is done by itself with the last of them. 0: any number.
[[nodiscard]] std::size_t most_points(ToolKind kind);
/// With fewer it cannot be finished.
[[nodiscard]] std::size_t least_points(ToolKind kind);
/// Whether its places are corners of something closed.
[[nodiscard]] bool draws_ring(ToolKind kind);
/// Whether it takes no places but those under the hand, as a brush does.
[[nodiscard]] bool draws_freely(ToolKind kind);
/// Whether it finds pieces of the image by strokes (ImageTool).
[[nodiscard]] bool finds_on_image(ToolKind kind);

}  // namespace nadir
