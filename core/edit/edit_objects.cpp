// SPDX-License-Identifier: Apache-2.0
#include "core/edit/edit_objects.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/base/require.h"
#include "core/edit/edge_tree.h"
#include "core/edit/edit_builder.h"
#include "core/edit/polygon_algebra.h"

namespace nadir {

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

}  // namespace nadir
