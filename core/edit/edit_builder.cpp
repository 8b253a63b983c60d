// SPDX-License-Identifier: Apache-2.0
#include "core/edit/edit_builder.h"

#include <algorithm>
#include <memory>
#include <set>
#include <utility>

#include "core/base/require.h"
#include "core/edit/edge_tree.h"
#include "core/edit/near_places.h"

namespace nadir {
namespace {

/// A ring that has all places which lie on it.
Ring with_places(const Ring& ring, bool is_ring, const NearPlaces& places) {
  Ring all;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Eigen::Vector2d from = places.nearest(ring[i]).value_or(ring[i]);
    all.push_back(from);
    if (i + 1 == ring.size() && !is_ring) break;
    const Eigen::Vector2d& next = ring[i + 1 < ring.size() ? i + 1 : 0];
    const Eigen::Vector2d to = places.nearest(next).value_or(next);
    std::vector<Eigen::Vector2d> on_edge;
    places.visit(box_around(from, to, kTouchM), [&](const Eigen::Vector2d& place) {
      if ((nearest_on_edge(from, to, place) - place).norm() > kTouchM) return;
      if ((place - from).norm() <= kTouchM || (place - to).norm() <= kTouchM) return;
      on_edge.push_back(place);
    });
    std::sort(on_edge.begin(), on_edge.end(),
              [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
                return (a - from).squaredNorm() < (b - from).squaredNorm();
              });
    all.insert(all.end(), on_edge.begin(), on_edge.end());
  }
  return all;
}

void tidy(LabelObject& object) {
  const bool is_ring = is_closed(object.kind);
  for (Ring& ring : object.rings) ring = without_repeats(std::move(ring), is_ring);
  if (!is_ring || object.rings.empty()) return;
  const auto is_no_hole = [](const Ring& ring) { return ring.size() < 3; };
  object.rings.erase(std::remove_if(object.rings.begin() + 1, object.rings.end(), is_no_hole),
                     object.rings.end());
}

}  // namespace

const LabelObject* EditBuilder::now(ObjectId id) const {
  const auto changed = changed_.find(id);
  if (changed != changed_.end()) return changed->second ? &*changed->second : nullptr;
  const auto found = document_.objects().find(id);
  return found == document_.objects().end() ? nullptr : found->second.object.get();
}

LabelObject& EditBuilder::change(ObjectId id) {
  const LabelObject* const object = now(id);
  NADIR_REQUIRE(object != nullptr);
  return *changed_.try_emplace(id, *object).first->second;
}

ObjectId EditBuilder::add(LabelObject object) {
  object.id = next_id_++;
  changed_.insert_or_assign(object.id, std::move(object));
  return next_id_ - 1;
}

std::int64_t EditBuilder::next_order(ClassId id) {
  const auto [found, is_first] = orders_.try_emplace(id, 0);
  const std::int64_t top = (std::int64_t{drawing_level(id)} + 1) * kOrdersPerLevel - 1;
  found->second = is_first ? document_.next_order(id) : std::min(found->second + kOrderStep, top);
  return found->second;
}

void EditBuilder::replace(ObjectId id, std::vector<std::vector<Ring>> pieces) {
  if (pieces.empty()) {
    remove(id);
    return;
  }
  const LabelObject object = *now(id);
  const auto of_piece = whole_of_.find(id);
  const ObjectId whole = of_piece != whole_of_.end() ? of_piece->second : id;
  for (std::size_t i = 1; i < pieces.size(); ++i) {
    LabelObject piece = object;
    piece.rings = std::move(pieces[i]);
    const ObjectId added = add(std::move(piece));
    whole_of_[added] = whole;
    cut_off_[whole].push_back(added);
  }
  change(id).rings = std::move(pieces.front());
}

std::span<const ObjectId> EditBuilder::cut_off(ObjectId id) const {
  const auto found = cut_off_.find(id);
  if (found == cut_off_.end()) return {};
  return found->second;
}

std::vector<Eigen::Vector2d> EditBuilder::new_places() const {
  PlaceSet earlier;
  for (const auto& [id, after] : changed_) {
    if (const auto before = document_.object(id)) {
      for (const Ring& ring : before->rings) earlier.insert(ring.begin(), ring.end());
    }
  }
  std::vector<Eigen::Vector2d> places;
  for (const auto& [id, after] : changed_) {
    if (!after) continue;
    for (const Ring& ring : after->rings) {
      std::copy_if(ring.begin(), ring.end(), std::back_inserter(places),
                   [&](const Eigen::Vector2d& place) { return earlier.count(place) == 0; });
    }
  }
  return places;
}

void EditBuilder::share_new_places() {
  const NearPlaces places(new_places());
  if (places.bounds().is_empty) return;
  std::vector<ObjectId> ids;
  for (const auto& [id, placed] : document_.objects()) {
    PlaneBounds bounds = placed.bounds;
    bounds.grow(kTouchM);
    if (do_meet(bounds, places.bounds())) ids.push_back(id);
  }
  for (const auto& [id, after] : changed_) {
    if (after && document_.object(id) == nullptr) ids.push_back(id);
  }
  for (const ObjectId id : ids) {
    const LabelObject* const object = now(id);
    if (object == nullptr) continue;
    std::vector<Ring> rings;
    for (const Ring& ring : object->rings) {
      rings.push_back(with_places(ring, is_closed(object->kind), places));
    }
    if (rings != object->rings) change(id).rings = std::move(rings);
  }
}

Result<void> EditBuilder::check(const LabelObject* before, const LabelObject& after) const {
  if (auto sound = check_object(after); !sound) return sound;
  if (!is_closed(after.kind)) return {};
  const auto crossing = new_crossing(before, after);
  if (!crossing) return forward_error(crossing, object_name(after));
  if (*crossing) {
    return fail(ErrorCode::kInvalidOptions, "{} would cross itself at {:.2f} E, {:.2f} N",
                object_name(after), (*crossing)->x(), (*crossing)->y());
  }
  const bool had_inside = before == nullptr || signed_area_m2(before->rings.front()) != 0.0;
  if (had_inside && signed_area_m2(after.rings.front()) == 0.0) {
    return fail(ErrorCode::kInvalidOptions, "{} would have no inside", object_name(after));
  }
  return {};
}

Result<LabelEdit> EditBuilder::edit() {
  LabelEdit edit{.title = title_, .objects = {}, .tiles = {}, .values = {}};
  for (auto& [id, after] : changed_) {
    const auto before = document_.object(id);
    if (!after) {
      if (before != nullptr) edit.objects.push_back({before, nullptr});
      continue;
    }
    tidy(*after);
    if (before != nullptr && *before == *after) continue;
    if (const auto sound = check(before.get(), *after); !sound) return forward_error(sound, title_);
    edit.objects.push_back({before, std::make_shared<const LabelObject>(*after)});
  }
  return edit;
}

Result<std::vector<const LabelObject*>> selected_objects(const LabelDocument& document,
                                                         std::span<const ObjectId> ids) {
  if (ids.empty()) return fail(ErrorCode::kInvalidOptions, "no object is selected");
  std::vector<const LabelObject*> objects;
  for (const ObjectId id : std::set<ObjectId>(ids.begin(), ids.end())) {
    const auto found = document.objects().find(id);
    if (found == document.objects().end()) {
      return fail(ErrorCode::kInvalidOptions, "there is no object {}", id);
    }
    objects.push_back(found->second.object.get());
  }
  return objects;
}

std::string object_name(const LabelObject& object) {
  return fmt::format("{} {}", enum_name(object.kind), object.id);
}

}  // namespace nadir
