// SPDX-License-Identifier: Apache-2.0
#include "core/desk/label_tool.h"

#include <algorithm>
#include <utility>

namespace nadir {

Result<NamedClass> NamedClass::from_text(std::string_view text) {
  if (plain_class_name(text) == plain_class_name(class_info(kUnclassified).name)) {
    return NamedClass{kUnclassified};
  }
  const auto id = class_from_name(text);
  if (!id) return fail(ErrorCode::kInvalidOptions, "{} is no class", text);
  return NamedClass{*id};
}

Result<void> NamedClass::check() const {
  if (id == kUnclassified || (can_lie_in_overhead(id) && !is_movable(id))) return {};
  return fail(ErrorCode::kInvalidOptions, "no map holds {}", class_info(id).name);
}

Result<PlainText> PlainText::from_text(std::string_view text) {
  return PlainText{std::string(text)};
}

Result<void> PlainText::check() const {
  const bool is_line =
      std::none_of(value.begin(), value.end(), [](char c) { return c == '\n' || c == '\r'; });
  if (is_line && value.size() <= 4096) return {};
  return fail(ErrorCode::kInvalidOptions, "it is not one line of at most 4096 characters");
}

void use_class(LabelTool& tool, ClassId id) {
  if (tool.class_id.id == id) return;
  tool.last_class = std::exchange(tool.class_id, NamedClass{id});
}

void toggle_class(LabelTool& tool) { std::swap(tool.class_id, tool.last_class); }

double brush_radius_m(const LabelTool& tool, double metres_per_cell) {
  return tool.brush_unit == BrushUnit::kMetres ? tool.brush_radius_m
                                               : tool.brush_radius_cells * metres_per_cell;
}

PaintValue paint_value(const LabelTool& tool) {
  const ClassId id = tool.class_id.id;
  if (tool.kind == ToolKind::kEraser) return kNoPaint;
  if (id == kUnclassified) return kUnclassified;  // Covers everything by itself.
  return static_cast<PaintValue>(tool.paints_over ? id + kPaintOver : id);
}

std::size_t most_points(ToolKind kind) {
  switch (kind) {
    case ToolKind::kSelect:
    case ToolKind::kVertices:
    case ToolKind::kFill:
      return 1;
    case ToolKind::kCircle:
      return 2;
    case ToolKind::kRectangle:
      return 3;
    default:
      return 0;
  }
}

std::size_t least_points(ToolKind kind) {
  switch (kind) {
    case ToolKind::kArea:
    case ToolKind::kOutline:
    case ToolKind::kRectangle:
    case ToolKind::kHole:
    case ToolKind::kRecode:
    case ToolKind::kScissors:
      return 3;
    case ToolKind::kLine:
    case ToolKind::kCircle:
    case ToolKind::kStreet:
    case ToolKind::kSplit:
      return 2;
    default:
      return 1;
  }
}

bool draws_ring(ToolKind kind) {
  return kind == ToolKind::kArea || kind == ToolKind::kOutline || kind == ToolKind::kHole ||
         kind == ToolKind::kRecode || kind == ToolKind::kScissors;
}

bool draws_freely(ToolKind kind) {
  return kind == ToolKind::kBrush || kind == ToolKind::kEraser || kind == ToolKind::kFill;
}

bool finds_on_image(ToolKind kind) {
  return kind == ToolKind::kWand || kind == ToolKind::kSuperpixels || kind == ToolKind::kGrabCut;
}

}  // namespace nadir
