// SPDX-License-Identifier: Apache-2.0
#include <map>
#include <memory>
#include <utility>

#include "core/desk/label_desk.h"
#include "core/label/edit_paint.h"
#include "core/label/paint_objects.h"

namespace nadir {
namespace {

bool is_finite(const Ring& places) {
  for (const Eigen::Vector2d& place : places) {
    if (!place.allFinite()) return false;
  }
  return true;
}

Result<void> needs_picked(const std::vector<PickedVertex>& picked) {
  if (!picked.empty()) return {};
  return fail(ErrorCode::kInvalidOptions, "no corner is picked");
}

std::vector<VertexRef> places_of(const std::vector<PickedVertex>& picked) {
  std::vector<VertexRef> vertices;
  vertices.reserve(picked.size());
  for (const PickedVertex& one : picked) vertices.push_back(one.at);
  return vertices;
}

std::string words_of_paint(PaintValue value, const char* verb) {
  if (value == kNoPaint) return "Erase";
  return fmt::format("{} {}", verb, class_info(painted_class(value)).name);
}

std::vector<LabelObject> objects_after(const Result<LabelEdit>& edit) {
  std::vector<LabelObject> objects;
  if (!edit) return objects;
  for (const ObjectChange& change : edit->objects) {
    if (change.after != nullptr) objects.push_back(*change.after);
  }
  return objects;
}

}  // namespace

Result<void> LabelDesk::draw(const DrawnWith& with, Ring places) {
  return take(nadir::draw(sheet_.now(), with, std::move(places)), Chooses::kWhatWasMade);
}

Result<void> LabelDesk::draw_street(const StreetProfile& profile, const Ring& centre_line) {
  return take(nadir::draw_street(sheet_.now(), profile, centre_line), Chooses::kWhatWasMade);
}

Result<void> LabelDesk::cut_hole(ObjectId object, Ring hole) {
  return take(nadir::cut_hole(sheet_.now(), object, std::move(hole)), Chooses::kAsBefore);
}

Result<void> LabelDesk::stroke(const Ring& path, double radius_m, PaintValue value) {
  if (path.empty()) return fail(ErrorCode::kInvalidOptions, "a stroke needs a place");
  if (!is_finite(path)) return fail(ErrorCode::kInvalidOptions, "a stroke's place is no number");
  if (!(radius_m > 0.0 && radius_m <= kMostObjectWidthM)) {
    return fail(ErrorCode::kInvalidOptions, "a brush's radius of {} m is not in (0, {:.0f}]",
                radius_m, kMostObjectWidthM);
  }
  if (!is_paint_value(value)) return fail(ErrorCode::kInvalidOptions, "{} is no paint", value);
  return take(paint_stroke(sheet_.now(), path, radius_m, value, words_of_paint(value, "Paint")),
              Chooses::kAsBefore);
}

Result<void> LabelDesk::fill(const Eigen::Vector2d& at_in_enu_m, PaintValue value) {
  if (!at_in_enu_m.allFinite())
    return fail(ErrorCode::kInvalidOptions, "the place to fill is no number");
  if (!is_paint_value(value)) return fail(ErrorCode::kInvalidOptions, "{} is no paint", value);
  return take(flood_fill(sheet_.now(), at_in_enu_m, value, words_of_paint(value, "Fill with")),
              Chooses::kAsBefore);
}

Result<void> LabelDesk::recode(ClassId from, ClassId to, const std::optional<Ring>& within) {
  return take(nadir::recode(sheet_.now(), from, to, within), Chooses::kAsBefore);
}

Result<void> LabelDesk::move_vertex(const VertexRef& vertex, const Eigen::Vector2d& to) {
  return take_picked_along(nadir::move_vertex(sheet_.now(), vertex, to, shared()));
}

Result<void> LabelDesk::add_vertex(const VertexRef& before, const Eigen::Vector2d& at) {
  return take(nadir::add_vertex(sheet_.now(), before, at, shared()), Chooses::kAsBefore);
}

Result<void> LabelDesk::move_picked(const Eigen::Vector2d& by_m) {
  if (auto any = needs_picked(picked_); !any) return any;
  if (!by_m.allFinite()) return fail(ErrorCode::kInvalidOptions, "the shift is no number");
  return take_picked_along(move_vertices(sheet_.now(), places_of(picked_), by_m, shared()));
}

/// Corners that were picked are picked where they are now, unless their ring has got or lost some.
Result<void> LabelDesk::take_picked_along(const Result<LabelEdit>& edit) {
  if (!edit) return forward_error(edit);
  const std::vector<PickedVertex> earlier = picked_;
  if (auto done = take(edit, Chooses::kAsBefore); !done) return done;
  std::map<ObjectId, const ObjectChange*> changes;
  for (const ObjectChange& change : edit->objects) {
    if (change.before != nullptr) changes[change.before->id] = &change;
  }
  picked_.clear();
  for (PickedVertex picked : earlier) {
    const auto change = changes.find(picked.at.object);
    if (change != changes.end()) {
      const auto& [before, after] = *change->second;
      const bool has_same_places =
          after != nullptr && after->rings.size() == before->rings.size() &&
          after->rings[picked.at.ring].size() == before->rings[picked.at.ring].size();
      if (!has_same_places) continue;
      picked.in_enu_m = after->rings[picked.at.ring][picked.at.place];
    }
    picked_.push_back(picked);
  }
  return {};
}

Result<void> LabelDesk::remove_picked() {
  if (auto any = needs_picked(picked_); !any) return any;
  const std::vector<VertexRef> vertices = places_of(picked_);
  auto removed = take(remove_vertices(sheet_.now(), vertices, shared()), Chooses::kAsBefore);
  if (removed) picked_.clear();
  return removed;
}

Result<void> LabelDesk::paint_to_objects() {
  return take(nadir::paint_to_objects(sheet_.now()), Chooses::kWhatWasMade);
}

Result<void> LabelDesk::set_value(const std::string& key,
                                  const std::string& text,
                                  const std::string& title) {
  const auto before = sheet_.now().value(key);
  if (before == nullptr ? text.empty() : *before == text) return {};
  const auto after = text.empty() ? nullptr : std::make_shared<const std::string>(text);
  return commit({.title = title, .objects = {}, .tiles = {}, .values = {{key, {before, after}}}});
}

std::optional<Snap> LabelDesk::snap_dragged(const Eigen::Vector2d& point_in_enu_m,
                                            double reach_m) const {
  if (!tool_.snaps || !(reach_m > 0.0)) return std::nullopt;
  return sheet_.places().nearest(point_in_enu_m, reach_m, selection_.ids());
}

std::vector<LabelObject> LabelDesk::coming_move(const Eigen::Vector2d& by_m) const {
  return objects_after(move_objects(sheet_.now(), selection_.ids(), by_m));
}

std::vector<LabelObject> LabelDesk::coming_picked(const Eigen::Vector2d& by_m) const {
  return objects_after(move_vertices(sheet_.now(), places_of(picked_), by_m, shared()));
}

std::vector<LabelObject> LabelDesk::coming_vertex(const VertexRef& vertex,
                                                  const Eigen::Vector2d& to) const {
  return objects_after(nadir::move_vertex(sheet_.now(), vertex, to, shared()));
}

}  // namespace nadir
