// SPDX-License-Identifier: Apache-2.0
#include "core/edit/edit_objects.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "core/base/require.h"
#include "core/edit/edge_tree.h"
#include "core/edit/edit_builder.h"
#include "core/edit/polygon_algebra.h"

namespace nadir {
namespace {

using DrawingOrder = std::vector<std::pair<std::int64_t, ObjectId>>;

/// What lies about where an object does, itself included, from the lowest.
DrawingOrder order_around(const LabelDocument& document,
                          const std::map<ObjectId, std::int64_t>& moved,
                          const PlaneBounds& bounds) {
  DrawingOrder order;
  for (const auto& [id, placed] : document.objects()) {
    if (!do_meet(placed.bounds, bounds)) continue;
    const auto found = moved.find(id);
    order.emplace_back(found != moved.end() ? found->second : placed.object->order, id);
  }
  std::sort(order.begin(), order.end());
  return order;
}

/// Puts an object between two others that are drawn one after the other; where there is no room, what is above moves up.
void put_between(std::map<ObjectId, std::int64_t>& moved,
                 ObjectId id,
                 const DrawingOrder& order,
                 std::size_t above) {
  if (above == 0) {
    moved[id] = order.front().first - kOrderStep;
    return;
  }
  const std::int64_t below = order[above - 1].first;
  if (above < order.size() && order[above].first - below < 2) {
    std::int64_t least = below + 2;
    for (std::size_t i = above; i < order.size() && order[i].first < least; ++i) {
      if (order[i].second != id) moved[order[i].second] = least++;
    }
    moved[id] = below + 1;
    return;
  }
  moved[id] = above < order.size() ? below + (order[above].first - below) / 2 : below + kOrderStep;
}

}  // namespace

Result<LabelEdit> draw(const LabelDocument& document, const DrawnWith& with, Ring places) {
  EditBuilder builder(document, fmt::format("Draw {}", class_info(with.class_id).name));
  for (Eigen::Vector2d& place : places) place = on_lattice(place);
  builder.add({.id = 0,
               .kind = with.kind,
               .class_id = with.class_id,
               .order = builder.next_order(with.class_id),
               .width_m = with.width_m,
               .rings = {std::move(places)},
               .note = {}});
  // Before anything is made of what is no border.
  if (auto sound = builder.edit(); !sound) return sound;
  builder.share_new_places();
  return builder.edit();
}

Ring rectangle(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double to_the_left_m) {
  const Eigen::Vector2d along = to - from;
  const double length = along.norm();
  const Eigen::Vector2d aside =
      length > 0.0
          ? Eigen::Vector2d(Eigen::Vector2d(-along.y(), along.x()) * (to_the_left_m / length))
          : Eigen::Vector2d(Eigen::Vector2d::Zero());
  return {on_lattice(from), on_lattice(to), on_lattice(to + aside), on_lattice(from + aside)};
}

Ring circle(const Eigen::Vector2d& centre_in_enu_m, double radius_m, int places) {
  NADIR_REQUIRE(places >= 3);
  Ring ring;
  for (int i = 0; i < places; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / places;
    ring.push_back(
        on_lattice(centre_in_enu_m + radius_m * Eigen::Vector2d(std::cos(angle), std::sin(angle))));
  }
  return ring;
}

Result<LabelEdit> remove(const LabelDocument& document, std::span<const ObjectId> objects) {
  const auto selected = selected_objects(document, objects);
  if (!selected) return forward_error(selected);
  EditBuilder builder(document, "Delete");
  for (const LabelObject* const object : *selected) builder.remove(object->id);
  return builder.edit();
}

Result<LabelEdit> reclass(const LabelDocument& document,
                          std::span<const ObjectId> objects,
                          ClassId to) {
  auto selected = selected_objects(document, objects);
  if (!selected) return forward_error(selected);
  std::stable_sort(selected->begin(), selected->end(),
                   [](const LabelObject* a, const LabelObject* b) { return a->order < b->order; });
  EditBuilder builder(document, fmt::format("Change to {}", class_info(to).name));
  for (const LabelObject* const object : *selected) {
    if (object->class_id == to) continue;
    LabelObject& changed = builder.change(object->id);
    changed.class_id = to;
    changed.order = builder.next_order(to);
  }
  return builder.edit();
}

Result<LabelEdit> set_width(const LabelDocument& document,
                            std::span<const ObjectId> objects,
                            double width_m) {
  const auto selected = selected_objects(document, objects);
  if (!selected) return forward_error(selected);
  EditBuilder builder(document, "Change width");
  for (const LabelObject* const object : *selected) {
    if (object->kind == ObjectKind::kArea) {
      return fail(ErrorCode::kInvalidOptions, "{} has no width", object_name(*object));
    }
    builder.change(object->id).width_m = width_m;
  }
  return builder.edit();
}

Result<LabelEdit> reorder(const LabelDocument& document,
                          std::span<const ObjectId> objects,
                          OrderMove move) {
  auto selected = selected_objects(document, objects);
  if (!selected) return forward_error(selected);
  // In such an order that none overtakes another that moves too.
  const bool is_from_top = move == OrderMove::kUp || move == OrderMove::kBottom;
  std::stable_sort(selected->begin(), selected->end(),
                   [&](const LabelObject* a, const LabelObject* b) {
                     const auto key_a = std::pair(a->order, a->id);
                     const auto key_b = std::pair(b->order, b->id);
                     return is_from_top ? key_b < key_a : key_a < key_b;
                   });
  PlaneBounds everywhere;
  for (const auto& [id, placed] : document.objects()) {
    everywhere.include(placed.bounds.low);
    everywhere.include(placed.bounds.high);
  }
  std::map<ObjectId, std::int64_t> moved;
  for (const LabelObject* const object : *selected) {
    const bool is_by_one = move == OrderMove::kUp || move == OrderMove::kDown;
    DrawingOrder order =
        order_around(document, moved, is_by_one ? drawn_bounds(*object) : everywhere);
    const auto own = std::find_if(order.begin(), order.end(),
                                  [&](const auto& at) { return at.second == object->id; });
    const auto at = static_cast<std::size_t>(own - order.begin());
    const bool goes_up = move == OrderMove::kUp || move == OrderMove::kTop;
    if (goes_up ? at + 1 == order.size() : at == 0) continue;
    order.erase(own);
    // One that moves too is not overtaken.
    const std::size_t next = goes_up ? at : at - 1;
    if (is_by_one && moved.count(order[next].second) > 0 &&
        std::any_of(selected->begin(), selected->end(),
                    [&](const LabelObject* other) { return other->id == order[next].second; })) {
      continue;
    }
    // Between what is drawn anywhere, not only about here.
    const auto passed = order[next];
    DrawingOrder all = order_around(document, moved, everywhere);
    all.erase(std::find_if(all.begin(), all.end(),
                           [&](const auto& other) { return other.second == object->id; }));
    std::size_t above = 0;
    if (move == OrderMove::kTop) above = all.size();
    if (is_by_one) {
      above = static_cast<std::size_t>(std::find(all.begin(), all.end(), passed) - all.begin()) +
              (goes_up ? 1 : 0);
    }
    put_between(moved, object->id, all, above);
  }
  constexpr std::array<const char*, 4> kTitles{"Raise", "Lower", "To the top", "To the bottom"};
  EditBuilder builder(document, kTitles.at(static_cast<std::size_t>(move)));
  for (const auto& [id, order] : moved) builder.change(id).order = order;
  return builder.edit();
}

}  // namespace nadir
