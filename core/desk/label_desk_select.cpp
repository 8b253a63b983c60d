// SPDX-License-Identifier: Apache-2.0
#include <set>

#include "core/desk/label_desk.h"
#include "core/desk/object_index.h"

namespace nadir {
namespace {

bool is_in_box(const PlaneBounds& box, const Eigen::Vector2d& place) {
  return (place.array() >= box.low.array()).all() && (place.array() <= box.high.array()).all();
}

/// Adds, removes or turns over some that are each given once. O((n + m) log n).
void pick(std::vector<PickedVertex>& picked,
          std::span<const PickedVertex> vertices,
          SelectHow how) {
  std::set<VertexRef> members;
  for (const PickedVertex& one : picked) members.insert(one.at);
  std::set<VertexRef> leaving;
  for (const PickedVertex& vertex : vertices) {
    if (members.count(vertex.at) == 0) {
      if (how != SelectHow::kRemove) picked.push_back(vertex);
    } else if (how == SelectHow::kRemove || how == SelectHow::kToggle) {
      leaving.insert(vertex.at);
    }
  }
  if (leaving.empty()) return;
  std::erase_if(picked, [&](const PickedVertex& one) { return leaving.count(one.at) > 0; });
}

}  // namespace

Result<void> LabelDesk::select(std::span<const ObjectId> objects, SelectHow how) {
  for (const ObjectId id : objects) {
    if (sheet_.now().object(id) == nullptr) {
      return fail(ErrorCode::kInvalidOptions, "there is no object {}", id);
    }
  }
  selection_.choose(objects, how);
  return {};
}

void LabelDesk::select_at(const Eigen::Vector2d& point_in_enu_m, double reach_m, SelectHow how) {
  const auto at_place = objects_at(sheet_.now(), sheet_.objects(), point_in_enu_m, reach_m);
  if (how != SelectHow::kInstead) {
    if (!at_place.empty()) selection_.choose(std::span(at_place).first(1), how);
    return;
  }
  const auto next = selection_.next_of(at_place, point_in_enu_m, reach_m);
  if (next) {
    selection_.choose(std::span(&*next, 1), how);
  } else {
    selection_.clear();
  }
}

void LabelDesk::select_within(const PlaneBounds& box, SelectHow how) {
  selection_.choose(objects_within(sheet_.now(), sheet_.objects(), box), how);
}

void LabelDesk::select_all() {
  std::vector<ObjectId> all;
  all.reserve(sheet_.now().objects().size());
  for (const auto& [id, placed] : sheet_.now().objects()) all.push_back(id);
  selection_.choose(all, SelectHow::kInstead);
}

void LabelDesk::pick_at(const Eigen::Vector2d& point_in_enu_m, double reach_m, SelectHow how) {
  if (how == SelectHow::kInstead) picked_.clear();
  const auto snap = sheet_.places().nearest(point_in_enu_m, reach_m);
  if (!snap || snap->kind != SnapKind::kVertex) {
    select_at(point_in_enu_m, reach_m, how);
    return;
  }
  const PickedVertex vertex{snap->at, snap->in_enu_m};
  pick(picked_, std::span(&vertex, 1), how);
  if (!selection_.contains(snap->at.object)) {
    selection_.choose(std::span(&snap->at.object, 1),
                      how == SelectHow::kInstead ? how : SelectHow::kAdd);
  }
}

void LabelDesk::pick_within(const PlaneBounds& box, SelectHow how) {
  if (how == SelectHow::kInstead) picked_.clear();
  std::vector<PickedVertex> within;
  for (const ObjectId id : selection_.ids()) {
    const auto object = sheet_.now().object(id);
    for (std::size_t ring = 0; ring < object->rings.size(); ++ring) {
      for (std::size_t place = 0; place < object->rings[ring].size(); ++place) {
        const Eigen::Vector2d& point = object->rings[ring][place];
        if (is_in_box(box, point)) within.push_back({{id, ring, place}, point});
      }
    }
  }
  pick(picked_, within, how);
}

}  // namespace nadir
