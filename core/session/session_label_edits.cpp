// SPDX-License-Identifier: Apache-2.0
// What changes labels. Each is one step of their history, on disk when it returns.
#include <charconv>
#include <cmath>

#include "core/session/session_core.h"

namespace nadir {
namespace {

constexpr std::string_view kNothing = "nothing";
constexpr double kPastedAway = 0.02;  // of the view, so that a copy is seen beside what it is of

Result<ClassId> class_named(const std::string& name) {
  const auto named = NamedClass::from_text(name);
  if (!named) return forward_error(named);
  return named->id;
}

/// What a brush of a class paints with. @param over  Whether it covers what lies above its class.
Result<PaintValue> paint_named(const std::string& name, LabelTool tool) {
  if (name == kNothing) return PaintValue{kNoPaint};
  const auto id = class_named(name);
  if (!id) return forward_error(id);
  tool.kind = ToolKind::kBrush;
  tool.class_id.id = *id;
  return paint_value(tool);
}

/// The object of a number; 0: the first that is selected.
ObjectId object_of(const LabelDesk& desk, std::int64_t number) {
  const std::vector<ObjectId>& selected = desk.selection().ids();
  return number == 0 && !selected.empty() ? selected.front() : number;
}

VertexRef vertex_of(const LabelDesk& desk, std::int64_t object, int ring, int place) {
  return {object_of(desk, object), static_cast<std::size_t>(std::max(ring, 0)),
          static_cast<std::size_t>(std::max(place, 0))};
}

}  // namespace

actions::StrokeLabels stroke_of_hand(const LabelDesk& desk) {
  const LabelTool& tool = desk.tool();
  const bool erases = tool.kind == ToolKind::kEraser;
  return {erases ? std::string(kNothing) : tool.class_id.text(),
          brush_radius_m(tool, desk.sheet().now().grid().metres_per_cell),
          {desk.points().ring()}};
}

Result<void> Session::Implementation::draw(ObjectKind kind,
                                           const std::string& class_name,
                                           double width_m,
                                           const PlaceList& through) {
  const auto desk = need_desk();
  if (!desk) return forward_error(desk);
  const auto id = class_named(class_name);
  if (!id) return forward_error(id);
  return (*desk)->draw({kind, *id, width_m}, through.in_enu_m);
}

Result<void> Session::Implementation::perform(const actions::DrawArea& action) {
  return draw(ObjectKind::kArea, action.class_name, 0.0, action.places);
}

Result<void> Session::Implementation::perform(const actions::DrawLine& action) {
  return draw(ObjectKind::kLine, action.class_name, action.width_m, action.places);
}

Result<void> Session::Implementation::perform(const actions::DrawOutline& action) {
  return draw(ObjectKind::kOutline, action.class_name, action.thickness_m, action.places);
}

Result<void> Session::Implementation::perform(const actions::DrawStreet& action) {
  const auto desk = need_desk();
  if (!desk) return forward_error(desk);
  std::vector<std::string> names;
  for (const StreetProfile& profile : (*desk)->profiles()) {
    if (profile.name == action.profile) {
      return (*desk)->draw_street(profile, action.places.in_enu_m);
    }
    names.push_back(profile.name);
  }
  const std::string nearest = nearest_word(action.profile, names);
  return fail(ErrorCode::kInvalidOptions, "there is no street profile '{}'{}", action.profile,
              nearest.empty() ? std::string() : fmt::format("; did you mean {}?", nearest));
}

Result<void> Session::Implementation::perform(const actions::CutHole& action) {
  const auto desk = need_desk();
  if (!desk) return forward_error(desk);
  return (*desk)->cut_hole(object_of(**desk, action.object), action.places.in_enu_m);
}

Result<void> Session::Implementation::perform(const actions::StrokeLabels& action) {
  const auto desk = need_desk();
  if (!desk) return forward_error(desk);
  const auto paint = paint_named(action.class_name, label.tool);
  if (!paint) return forward_error(paint);
  return (*desk)->stroke(action.places.in_enu_m, action.radius_m, *paint);
}

Result<void> Session::Implementation::perform(const actions::FillLabels& action) {
  const auto desk = need_desk();
  if (!desk) return forward_error(desk);
  const auto paint = paint_named(action.class_name, label.tool);
  if (!paint) return forward_error(paint);
  return (*desk)->fill({action.east_m, action.north_m}, *paint);
}

Result<void> Session::Implementation::perform(const actions::RecodeLabels& action) {
  const auto desk = need_desk();
  if (!desk) return forward_error(desk);
  const auto from = class_named(action.from), to = class_named(action.to);
  if (!from) return forward_error(from);
  if (!to) return forward_error(to);
  const Ring& ring = action.within.in_enu_m;
  return (*desk)->recode(*from, *to, ring.empty() ? std::nullopt : std::optional<Ring>(ring));
}

Result<void> Session::Implementation::perform(const actions::MoveVertex& action) {
  const auto desk = need_desk();
  if (!desk) return forward_error(desk);
  return (*desk)->move_vertex(vertex_of(**desk, action.object, action.ring, action.place),
                              {action.east_m, action.north_m});
}

Result<void> Session::Implementation::perform(const actions::AddVertex& action) {
  const auto desk = need_desk();
  if (!desk) return forward_error(desk);
  return (*desk)->add_vertex(vertex_of(**desk, action.object, action.ring, action.place),
                             {action.east_m, action.north_m});
}

Result<void> Session::Implementation::perform(const actions::MoveLabels& action) {
  const auto desk = need_desk();
  if (!desk) return forward_error(desk);
  const Eigen::Vector2d by_m(action.east_m, action.north_m);
  return (*desk)->picked().empty() ? (*desk)->move_selected(by_m) : (*desk)->move_picked(by_m);
}

Result<void> Session::Implementation::perform(const actions::DuplicateLabels& action) {
  const auto desk = need_desk();
  if (!desk) return forward_error(desk);
  return (*desk)->duplicate_selected({action.east_m, action.north_m});
}

Result<void> Session::Implementation::perform(const actions::CopyBeside& action) {
  const auto desk = need_desk();
  if (!desk) return forward_error(desk);
  return (*desk)->copy_beside(action.by_m);
}

Result<void> Session::Implementation::copy_labels(LabelDesk& desk) {
  auto text = desk.copy();
  if (!text) return forward_error(text);
  effects.emplace_back(SetClipboardEffect{std::move(*text)});
  return {};
}

Result<void> Session::Implementation::perform(const actions::EditLabels& action) {
  const auto found = need_desk();
  if (!found) return forward_error(found);
  LabelDesk& desk = **found;
  switch (action.command) {
    case LabelCommand::kSelectAll:
      desk.select_all();
      return {};
    case LabelCommand::kDelete:
      return desk.picked().empty() ? desk.delete_selected() : desk.remove_picked();
    case LabelCommand::kCopy:
      return copy_labels(desk);
    case LabelCommand::kCut: {
      auto copied = copy_labels(desk);
      if (!copied) return copied;
      auto gone = desk.delete_selected();
      if (!gone) effects.pop_back();
      return gone;
    }
    case LabelCommand::kMerge:
      return desk.merge();
    case LabelCommand::kSubtract:
      return desk.subtract();
    case LabelCommand::kClip:
      return desk.clip(ClipSide::kThis);
    case LabelCommand::kClipOthers:
      return desk.clip(ClipSide::kOthers);
    case LabelCommand::kSmooth:
      return desk.smooth();
    case LabelCommand::kSimplify:
      return desk.simplify();
    case LabelCommand::kSquare:
      return desk.orthogonalise();
    case LabelCommand::kUp:
      return desk.reorder(OrderMove::kUp);
    case LabelCommand::kDown:
      return desk.reorder(OrderMove::kDown);
    case LabelCommand::kTop:
      return desk.reorder(OrderMove::kTop);
    case LabelCommand::kBottom:
      return desk.reorder(OrderMove::kBottom);
    case LabelCommand::kToPaint:
      return desk.objects_to_paint();
    case LabelCommand::kPaintToObjects:
      return desk.paint_to_objects();
  }
  return {};
}

Result<void> Session::Implementation::perform(const actions::SetLabel& action) {
  const auto desk = need_desk();
  if (!desk) return forward_error(desk);
  switch (action.part) {
    case LabelPart::kClass: {
      const auto id = class_named(action.value);
      if (!id) return forward_error(id);
      return (*desk)->set_class(*id);
    }
    case LabelPart::kWidth: {
      double width_m = 0.0;
      const char* const end = action.value.data() + action.value.size();
      const auto [at, error] = std::from_chars(action.value.data(), end, width_m);
      if (action.value.empty() || error != std::errc() || at != end || !std::isfinite(width_m)) {
        return fail(ErrorCode::kInvalidOptions, "'{}' is not a width in metres", action.value);
      }
      return (*desk)->set_width(width_m);
    }
    case LabelPart::kNote:
      return (*desk)->set_note(action.value);
  }
  return {};
}

Result<void> Session::Implementation::perform(const actions::JoinBorders& action) {
  const auto desk = need_desk();
  if (!desk) return forward_error(desk);
  return (*desk)->join_borders(action.reach_m);
}

Result<void> Session::Implementation::perform(const actions::SplitLabels& action) {
  const auto desk = need_desk();
  if (!desk) return forward_error(desk);
  return (*desk)->split(action.line.in_enu_m);
}

Result<void> Session::Implementation::perform(const actions::PasteLabels& action) {
  const auto desk = need_desk();
  if (!desk) return forward_error(desk);
  const double away_m = kPastedAway * resolved_look().width_m;
  return (*desk)->paste(action.text, {away_m, -away_m});
}

Result<void> Session::Implementation::perform(const actions::GoToLabelStep& action) {
  const auto desk = need_desk();
  if (!desk) return forward_error(desk);
  if (action.step == (*desk)->sheet().step()) return {};  // also 0 of labels that are not begun
  return (*desk)->go_to(action.step);
}

}  // namespace nadir
