// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <set>
#include <utility>

#include "core/edit/box_tree.h"
#include "core/edit/edge_tree.h"
#include "core/edit/edit_builder.h"
#include "core/edit/edit_objects.h"
#include "core/edit/near_places.h"

namespace nadir {
namespace {

/// What rounding to the lattice leaves between two borders that were one.
bool is_sliver(const std::vector<Ring>& part) {
  double around_m = 0.0;
  const Ring& border = part.front();
  for (std::size_t i = 0, before = border.size() - 1; i < border.size(); before = i++) {
    around_m += (border[i] - border[before]).norm();
  }
  return area_m2({{part}}) <= kTouchM * around_m;
}

/// Areas and outlines of a document by where they lie; what is cut off them meanwhile lies where they did.
class ClosedObjects {
 public:
  explicit ClosedObjects(const LabelDocument& document)
      : ids_(closed_ids(document)), tree_(bounds_of(document, ids_)) {}

  /// Those that count for an object on a side and whose bounds meet its own, as they are now, by their numbers.
  [[nodiscard]] std::vector<const LabelObject*> others_about(const LabelObject& object,
                                                             ClipSide side,
                                                             const EditBuilder& builder) const {
    const PlaneBounds bounds = drawn_bounds(object);
    const std::int64_t level = level_of_order(object.order);
    std::vector<const LabelObject*> others;
    const auto take = [&](ObjectId id) {
      const LabelObject* const other = builder.now(id);
      if (other == nullptr || id == object.id) return;
      const std::int64_t others_level = level_of_order(other->order);
      const bool counts = side == ClipSide::kThis ? others_level >= level : others_level <= level;
      if (counts && do_meet(drawn_bounds(*other), bounds)) others.push_back(other);
    };
    tree_.visit(bounds, [&](std::size_t number) {
      take(ids_[number]);
      for (const ObjectId piece : builder.cut_off(ids_[number])) take(piece);
    });
    std::sort(others.begin(), others.end(),
              [](const LabelObject* a, const LabelObject* b) { return a->id < b->id; });
    return others;
  }

 private:
  static std::vector<ObjectId> closed_ids(const LabelDocument& document) {
    std::vector<ObjectId> ids;
    for (const auto& [id, placed] : document.objects()) {
      if (is_closed(placed.object->kind)) ids.push_back(id);
    }
    return ids;
  }
  static std::vector<PlaneBounds> bounds_of(const LabelDocument& document,
                                            const std::vector<ObjectId>& ids) {
    std::vector<PlaneBounds> bounds;
    bounds.reserve(ids.size());
    for (const ObjectId id : ids) bounds.push_back(document.objects().at(id).bounds);
    return bounds;
  }
  std::vector<ObjectId> ids_;
  BoxTree tree_;
};

/// Takes from one object what others cover, or from them what it covers. Whether it changes anything.
Result<bool> clip_one(EditBuilder& builder,
                      const LabelObject& object,
                      const std::vector<const LabelObject*>& others,
                      ClipSide side) {
  if (others.empty()) return false;
  if (side == ClipSide::kThis) {
    std::vector<Region> regions;
    for (const LabelObject* const other : others) {
      auto region = region_of(*other);
      if (!region) return forward_error(region, object_name(*other));
      regions.push_back(std::move(*region));
    }
    const auto all = united(regions);
    if (!all) return forward_error(all, "Clip");
    return take_from(builder, object, *all);
  }
  const auto region = region_of(object);
  if (!region) return forward_error(region, object_name(object));
  bool has_cut = false;
  for (const LabelObject* const other : others) {
    auto taken = take_from(builder, *other, *region);
    if (!taken) return taken;
    has_cut = has_cut || *taken;
  }
  return has_cut;
}

}  // namespace

Result<bool> take_from(EditBuilder& builder, const LabelObject& object, const Region& region) {
  if (!is_closed(object.kind)) {
    std::vector<std::vector<Ring>> outside;
    const CutLine done = cut(object.rings.front(), region);
    for (const CutLine::Piece& piece : done.pieces) {
      if (!piece.is_inside) outside.push_back({piece.places});
    }
    if (outside.size() == done.pieces.size()) return false;
    builder.replace(object.id, std::move(outside));
    return true;
  }
  const auto whole = region_of(object);
  if (!whole) return forward_error(whole, object_name(object));
  auto rest = without(*whole, region);
  if (!rest) return forward_error(rest, object_name(object));
  if (is_equal_area(area_m2(*whole), area_m2(*rest))) return false;
  std::erase_if(rest->parts, is_sliver);
  std::stable_sort(rest->parts.begin(), rest->parts.end(),
                   [](const auto& a, const auto& b) { return area_m2({{a}}) > area_m2({{b}}); });
  builder.replace(object.id, std::move(rest->parts));
  return true;
}

Result<LabelEdit> subtract(const LabelDocument& document,
                           ObjectId from,
                           std::span<const ObjectId> cuts) {
  const auto object = selected_objects(document, std::span(&from, 1));
  if (!object) return forward_error(object);
  const LabelObject& whole = *object->front();
  const auto others = selected_objects(document, cuts);
  if (!others) return forward_error(others);
  std::vector<Region> regions;
  for (const LabelObject* const other : *others) {
    if (other == &whole) {
      return fail(ErrorCode::kInvalidOptions, "an object cannot be cut by itself");
    }
    auto region = region_of(*other);
    if (!region) return forward_error(region, object_name(*other));
    regions.push_back(std::move(*region));
  }
  const auto all = united(regions);
  if (!all) return forward_error(all, "Subtract");
  EditBuilder builder(document, "Subtract");
  const auto has_cut = take_from(builder, whole, *all);
  if (!has_cut) return forward_error(has_cut);
  if (*has_cut) builder.share_new_places();
  return builder.edit();
}

Result<LabelEdit> clip(const LabelDocument& document,
                       std::span<const ObjectId> objects,
                       ClipSide side) {
  if (const auto selected = selected_objects(document, objects); !selected) {
    return forward_error(selected);
  }
  EditBuilder builder(document, side == ClipSide::kThis ? "Clip" : "Clip neighbours");
  const ClosedObjects closed(document);
  std::set<ObjectId> done;
  bool has_cut = false;
  for (const ObjectId id : objects) {
    const LabelObject* const object = builder.now(id);
    if (object == nullptr || !done.insert(id).second) continue;  // Covered by one before.
    if (!is_closed(object->kind)) {
      return fail(ErrorCode::kInvalidOptions, "{} is no area", object_name(*object));
    }
    const auto cut = clip_one(builder, *object, closed.others_about(*object, side, builder), side);
    if (!cut) return forward_error(cut);
    has_cut = has_cut || *cut;
  }
  if (has_cut) builder.share_new_places();
  return builder.edit();
}

}  // namespace nadir
