// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <utility>

#include "core/desk/label_desk.h"
#include "core/desk/object_index.h"
#include "core/label/paint_objects.h"

namespace nadir {
namespace {

std::vector<ObjectId> areas_across(const LabelSheet& sheet, const Ring& line) {
  PlaneBounds box;
  for (const Eigen::Vector2d& place : line) box.include(place);
  std::vector<ObjectId> areas;
  if (box.is_empty) return areas;
  for (const ObjectId id : sheet.objects().near(box)) {
    if (sheet.now().object(id)->kind == ObjectKind::kArea) areas.push_back(id);
  }
  return areas;
}

}  // namespace

Result<void> LabelDesk::move_selected(const Eigen::Vector2d& by_m) {
  if (auto any = needs_selection(); !any) return any;
  return take(move_objects(sheet_.now(), selection_.ids(), by_m), Chooses::kAsBefore);
}

Result<void> LabelDesk::delete_selected() {
  if (auto any = needs_selection(); !any) return any;
  return take(nadir::remove(sheet_.now(), selection_.ids()), Chooses::kAsBefore);
}

Result<void> LabelDesk::duplicate_selected(const Eigen::Vector2d& by_m) {
  if (auto any = needs_selection(); !any) return any;
  return take(duplicate(sheet_.now(), selection_.ids(), by_m), Chooses::kWhatWasMade);
}

Result<void> LabelDesk::copy_beside(double by_m) {
  if (auto any = needs_selection(); !any) return any;
  return take(nadir::copy_beside(sheet_.now(), selection_.ids().front(), by_m),
              Chooses::kWhatWasMade);
}

Result<std::string> LabelDesk::copy() const {
  if (auto any = needs_selection(); !any) return forward_error(any);
  return objects_text(sheet_.now(), selection_.ids());
}

Result<void> LabelDesk::paste(std::string_view text, const Eigen::Vector2d& by_m) {
  return take(nadir::paste(sheet_.now(), text, by_m), Chooses::kWhatWasMade);
}

Result<void> LabelDesk::set_class(ClassId id) {
  if (auto any = needs_selection(); !any) return any;
  return take(reclass(sheet_.now(), selection_.ids(), id), Chooses::kAsBefore);
}

Result<void> LabelDesk::set_width(double width_m) {
  if (auto any = needs_selection(); !any) return any;
  std::vector<ObjectId> wide;
  for (const ObjectId id : selection_.ids()) {
    if (sheet_.now().object(id)->kind != ObjectKind::kArea) wide.push_back(id);
  }
  if (wide.empty()) return fail(ErrorCode::kInvalidOptions, "areas have no width");
  return take(nadir::set_width(sheet_.now(), wide, width_m), Chooses::kAsBefore);
}

Result<void> LabelDesk::set_note(const std::string& note) {
  if (auto any = needs_selection(); !any) return any;
  LabelEdit edit{.title = "Change note", .objects = {}, .tiles = {}, .values = {}};
  for (const ObjectId id : selection_.ids()) {
    const auto before = sheet_.now().object(id);
    if (before->note == note) continue;
    LabelObject after = *before;
    after.note = note;
    edit.objects.push_back({before, std::make_shared<const LabelObject>(std::move(after))});
  }
  return take(edit, Chooses::kAsBefore);
}

Result<void> LabelDesk::reorder(OrderMove move) {
  if (auto any = needs_selection(); !any) return any;
  return take(nadir::reorder(sheet_.now(), selection_.ids(), move), Chooses::kAsBefore);
}

Result<void> LabelDesk::smooth() {
  if (auto any = needs_selection(); !any) return any;
  return take(nadir::smooth(sheet_.now(), selection_.ids()), Chooses::kAsBefore);
}

Result<void> LabelDesk::simplify() {
  if (auto any = needs_selection(); !any) return any;
  return take(nadir::simplify(sheet_.now(), selection_.ids(), tool_.simplify_m),
              Chooses::kAsBefore);
}

Result<void> LabelDesk::orthogonalise() {
  if (auto any = needs_selection(); !any) return any;
  return take(
      nadir::orthogonalise(sheet_.now(), selection_.ids(), Angle::degrees(tool_.straighten_deg)),
      Chooses::kAsBefore);
}

Result<void> LabelDesk::join_borders(double reach_m) {
  if (auto any = needs_selection(); !any) return any;
  return take(nadir::join_borders(sheet_.now(), selection_.ids(), reach_m), Chooses::kAsBefore);
}

Result<void> LabelDesk::merge() {
  if (auto any = needs_selection(); !any) return any;
  return take(nadir::merge(sheet_.now(), selection_.ids()), Chooses::kAsBefore);
}

Result<void> LabelDesk::subtract() {
  const std::vector<ObjectId>& chosen = selection_.ids();
  if (chosen.size() < 2) {
    return fail(ErrorCode::kInvalidOptions,
                "subtracting needs two objects, of which the first stays");
  }
  return take(nadir::subtract(sheet_.now(), chosen.front(), std::span(chosen).subspan(1)),
              Chooses::kAsBefore);
}

Result<void> LabelDesk::clip(ClipSide side) {
  if (auto any = needs_selection(); !any) return any;
  return take(nadir::clip(sheet_.now(), selection_.ids(), side), Chooses::kAsBefore);
}

Result<void> LabelDesk::split(const Ring& line) {
  const std::vector<ObjectId> objects =
      selection_.empty() ? areas_across(sheet_, line) : selection_.ids();
  if (objects.empty()) {
    return fail(ErrorCode::kInvalidOptions, "the line crosses no area, and none is selected");
  }
  return take(nadir::split(sheet_.now(), objects, line), Chooses::kAsBefore);
}

Result<void> LabelDesk::objects_to_paint() {
  if (auto any = needs_selection(); !any) return any;
  return take(nadir::objects_to_paint(sheet_.now(), selection_.ids()), Chooses::kAsBefore);
}

}  // namespace nadir
