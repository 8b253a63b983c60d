// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <utility>

#include "core/desk/label_desk.h"
#include "core/desk/object_index.h"

namespace nadir {
namespace {

constexpr int kCirclePlaces = 64;
/// Beyond it nobody sees more of a preview.
constexpr std::size_t kMostBorderCandidates = 16;

Result<void> check_place(const Eigen::Vector2d& place) {
  // Written so that NaN is refused.
  if (place.cwiseAbs().maxCoeff() <= kMostObjectCoordinateM && place.allFinite()) return {};
  return fail(ErrorCode::kInvalidOptions, "the place is not within {:.0f} km of the map",
              kMostObjectCoordinateM / 1000.0);
}

LabelObject shown(ObjectKind kind, ClassId class_id, double width_m, Ring places) {
  LabelObject object;
  object.kind = kind;
  object.class_id = class_id;
  object.width_m = width_m;
  object.rings = {std::move(places)};
  return object;
}

/// Only a line for the eye.
LabelObject guide(ClassId class_id, Ring places) {
  return shown(ObjectKind::kLine, class_id, 0.0, std::move(places));
}

Ring circle_of(const Ring& places) {
  return circle(places[0], (places[1] - places[0]).norm(), kCirclePlaces);
}

/// On which borders a place lies now: what it snapped to may have changed since, and neighbours share it.
std::vector<VertexRef> borders_at(const ToolPoint& point, const SnapIndex& index) {
  std::vector<VertexRef> borders;
  if (!point.snap) return borders;
  if (point.snap->kind == SnapKind::kVertex) borders = index.at(point.in_enu_m);
  if (point.snap->kind == SnapKind::kEdge) borders = index.edges_at(point.in_enu_m);
  if (borders.size() > kMostBorderCandidates) borders.resize(kMostBorderCandidates);
  return borders;
}

}  // namespace

Result<void> LabelDesk::set_tool(const LabelTool& tool) {
  if (auto valid = validate(tool); !valid) return valid;
  if (tool.kind != tool_.kind) {
    points_.clear();
    image_tool_.clear();
    if (tool.kind != ToolKind::kVertices) picked_.clear();
  }
  const bool finds_so = tool.wand == tool_.wand && tool.superpixels == tool_.superpixels &&
                        tool.grab_cut == tool_.grab_cut;
  if (!finds_so) {
    if (auto found = image_tool_.tell_again(tool); !found) return found;
  }
  tool_ = tool;
  return {};
}

ToolPoint LabelDesk::aim(const Eigen::Vector2d& hand_in_enu_m, double reach_m) const {
  return points_.aim(tool_, sheet_.places(), hand_in_enu_m, reach_m);
}

Result<void> LabelDesk::add_point(const Eigen::Vector2d& hand_in_enu_m,
                                  double reach_m,
                                  SelectHow how) {
  if (auto sound = check_place(hand_in_enu_m); !sound) return sound;
  switch (tool_.kind) {
    case ToolKind::kSelect:
      select_at(hand_in_enu_m, reach_m, how);
      return {};
    case ToolKind::kVertices:
      pick_at(hand_in_enu_m, reach_m, how);
      return {};
    case ToolKind::kFill:
      return fill(hand_in_enu_m, paint_value(tool_));
    case ToolKind::kWand:
    case ToolKind::kSuperpixels:
    case ToolKind::kGrabCut:
      return tell_image({{hand_in_enu_m}, how == SelectHow::kRemove || how == SelectHow::kToggle});
    case ToolKind::kScissors:
      return add_scissored(hand_in_enu_m, reach_m);
    default:
      break;
  }
  const ToolPoint point = aim(hand_in_enu_m, reach_m);
  if (auto sound = check_place(point.in_enu_m); !sound) return sound;
  if (point.closes) return finish();
  // The same place again, as the second half of a double click, is none.
  if (!points_.empty() && points_.all().back().in_enu_m == point.in_enu_m) return {};
  if (points_.size() + 1 != most_points(tool_.kind)) {
    points_.add(point);
    return {};
  }
  const ToolPoints before = points_;
  points_.add(point);
  auto finished = finish();
  if (!finished) points_ = before;
  return finished;
}

Result<void> LabelDesk::add_traced(const Eigen::Vector2d& hand_in_enu_m,
                                   double reach_m,
                                   bool takes_other_way,
                                   double beside_m) {
  if (points_.empty() || most_points(tool_.kind) != 0 || draws_freely(tool_.kind)) {
    return fail(ErrorCode::kInvalidOptions, "a trace begins at a place of what is being drawn");
  }
  const SnapIndex& index = sheet_.places();
  const auto target = index.nearest(hand_in_enu_m, reach_m);
  if (!target) return fail(ErrorCode::kInvalidOptions, "there is no border to trace to");
  const auto from = borders_at(points_.all().back(), index);
  const auto to = borders_at({target->in_enu_m, target, false}, index);
  for (const VertexRef& start : from) {
    for (const VertexRef& end : to) {
      if (start.object != end.object || start.ring != end.ring) continue;
      Snap from_snap = *points_.all().back().snap;
      Snap to_snap = *target;
      from_snap.at = start;
      to_snap.at = end;
      const auto way =
          traced(*sheet_.now().object(start.object), from_snap, to_snap, takes_other_way, beside_m);
      if (!way) return forward_error(way);
      for (const Eigen::Vector2d& place : *way) {
        if (points_.all().back().in_enu_m != place) points_.add({place, std::nullopt, false});
      }
      if (beside_m == 0.0) {  // So that the next trace can go on from here.
        points_.take_back();
        points_.add({target->in_enu_m, to_snap, false});
      }
      return {};
    }
  }
  return fail(ErrorCode::kInvalidOptions,
              "a trace begins and ends on the border of one and the same object");
}

std::vector<LabelObject> LabelDesk::coming(const Eigen::Vector2d& hand_in_enu_m,
                                           double reach_m) const {
  const ClassId class_id = tool_.class_id.id;
  if (image_tool_.is_told()) {
    LabelObject found = shown(ObjectKind::kArea, class_id, 0.0, {});
    found.rings = image_tool_.borders();
    return {found};
  }
  if (points_.empty()) return {};
  const ToolPoint next = aim(hand_in_enu_m, reach_m);
  Ring places = points_.ring();
  if (tool_.kind == ToolKind::kScissors) {
    const Ring line = coming_line(next);
    places.insert(places.end(), line.begin(), line.end());
  }
  if (!next.closes && places.back() != next.in_enu_m) places.push_back(next.in_enu_m);
  if (places.size() < least_points(tool_.kind)) return {guide(class_id, std::move(places))};
  switch (tool_.kind) {
    case ToolKind::kArea:
    case ToolKind::kRecode:
    case ToolKind::kScissors:
      return {shown(ObjectKind::kArea, class_id, 0.0, std::move(places))};
    case ToolKind::kRectangle:
      return {shown(ObjectKind::kArea, class_id, 0.0, rectangle_of(places))};
    case ToolKind::kCircle:
      return {shown(ObjectKind::kArea, class_id, 0.0, circle_of(places))};
    case ToolKind::kHole:
      return {shown(ObjectKind::kArea, kUnclassified, 0.0, std::move(places))};
    case ToolKind::kOutline:
      return {shown(ObjectKind::kOutline, class_id, tool_.outline_thickness_m, std::move(places))};
    case ToolKind::kLine:
      return {shown(ObjectKind::kLine, class_id, tool_.line_width_m, std::move(places))};
    case ToolKind::kBrush:
    case ToolKind::kEraser: {
      const double radius_m = brush_radius_m(tool_, sheet_.now().grid().metres_per_cell);
      return {shown(ObjectKind::kLine,
                    tool_.kind == ToolKind::kBrush ? class_id : ClassId{kUnclassified},
                    2.0 * radius_m, std::move(places))};
    }
    case ToolKind::kStreet: {
      const auto across = profile();
      if (!across) break;
      const auto edit = nadir::draw_street(sheet_.now(), **across, places);
      if (!edit) break;
      std::vector<LabelObject> lines;
      for (const ObjectChange& change : edit->objects) lines.push_back(*change.after);
      for (LabelObject& line : lines) line.id = 0;
      return lines;
    }
    default:
      break;
  }
  return {guide(class_id, std::move(places))};
}

Result<void> LabelDesk::finish() {
  if (tool_.kind == ToolKind::kSelect || tool_.kind == ToolKind::kVertices ||
      tool_.kind == ToolKind::kFill) {
    return {};
  }
  if (finds_on_image(tool_.kind)) return finish_found();
  Ring places = points_.ring();
  const bool is_everywhere = tool_.kind == ToolKind::kRecode && places.empty();
  const std::size_t least = least_points(tool_.kind);
  if (places.size() < least && !is_everywhere) {
    return fail(ErrorCode::kInvalidOptions, "{} needs {} place{}, and has {}",
                enum_name(tool_.kind), least, least == 1 ? "" : "s", places.size());
  }
  auto done = finish_ring(places);
  if (done) points_.clear();
  return done;
}

Result<void> LabelDesk::finish_ring(const Ring& places) {
  const ClassId class_id = tool_.class_id.id;
  switch (tool_.kind) {
    case ToolKind::kArea:
    case ToolKind::kScissors:
      return draw({ObjectKind::kArea, class_id, 0.0}, places);
    case ToolKind::kRectangle:
      return draw({ObjectKind::kArea, class_id, 0.0}, rectangle_of(places));
    case ToolKind::kCircle:
      return draw({ObjectKind::kArea, class_id, 0.0}, circle_of(places));
    case ToolKind::kLine:
      return draw({ObjectKind::kLine, class_id, tool_.line_width_m}, places);
    case ToolKind::kOutline:
      return draw({ObjectKind::kOutline, class_id, tool_.outline_thickness_m}, places);
    case ToolKind::kStreet: {
      const auto across = profile();
      if (!across) return forward_error(across);
      return draw_street(**across, places);
    }
    case ToolKind::kHole: {
      const auto object = object_for_hole(places);
      if (!object) {
        return fail(ErrorCode::kInvalidOptions, "the hole lies in no area, and none is selected");
      }
      return cut_hole(*object, places);
    }
    case ToolKind::kSplit:
      return split(places);
    case ToolKind::kBrush:
    case ToolKind::kEraser:
      return stroke(places, brush_radius_m(tool_, sheet_.now().grid().metres_per_cell),
                    paint_value(tool_));
    case ToolKind::kRecode:
      return recode(tool_.recode_from.id, class_id,
                    places.empty() ? std::nullopt : std::optional<Ring>(places));
    default:
      return {};
  }
}

bool LabelDesk::cancel() {
  const bool is_at_work = !points_.empty() || image_tool_.is_told();
  points_.clear();
  image_tool_.clear();
  if (is_at_work) return true;
  if (!picked_.empty() || !selection_.empty()) {
    picked_.clear();
    selection_.clear();
    return true;
  }
  if (tool_.kind == ToolKind::kSelect) return false;
  tool_.kind = ToolKind::kSelect;
  return true;
}

Result<const StreetProfile*> LabelDesk::profile() const {
  const std::string& name = tool_.street_profile.value;
  const auto found = std::find_if(profiles_.begin(), profiles_.end(),
                                  [&](const StreetProfile& one) { return one.name == name; });
  if (found != profiles_.end()) return &*found;
  return fail(ErrorCode::kInvalidOptions, "there is no street profile \"{}\"", name);
}

std::optional<ObjectId> LabelDesk::object_for_hole(const Ring& hole) const {
  const auto takes_holes = [this](ObjectId id) {
    return sheet_.now().object(id)->kind != ObjectKind::kLine;
  };
  for (const ObjectId id : selection_.ids()) {
    if (takes_holes(id)) return id;
  }
  for (const ObjectId id : objects_at(sheet_.now(), sheet_.objects(), hole.front(), 0.0)) {
    if (takes_holes(id)) return id;
  }
  return std::nullopt;
}

}  // namespace nadir
