// SPDX-License-Identifier: Apache-2.0
#include "core/edit/snapping.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/edit/edge_tree.h"
#include "core/edit/near_places.h"

namespace nadir {
namespace {

/// The places of a border, without heights: edges do not count the width of what they draw.
PlaneBounds places_bounds(const LabelObject& object) {
  PlaneBounds bounds;
  for (const Ring& ring : object.rings) {
    for (const Eigen::Vector2d& place : ring) bounds.include(place);
  }
  return bounds;
}

/// Takes what is nearer, or as near and earlier.
struct Nearest {
  double distance_m;
  std::optional<Snap> found;

  void take(double candidate_m, SnapKind kind, const Eigen::Vector2d& place, const VertexRef& at) {
    if (!(candidate_m <= distance_m)) return;
    if (found && candidate_m == distance_m && found->at <= at) return;
    distance_m = candidate_m;
    found = Snap{kind, place, at};
  }
};

double along_ring(const Ring& ring, std::size_t from, std::size_t to) {
  return (ring[to % ring.size()] - ring[from % ring.size()]).norm();
}

/// From a snapped place on, the places after it up to another one, as the ring goes.
Ring walked(const Ring& ring, const Snap& from, const Snap& to) {
  Ring way{from.in_enu_m};
  const std::size_t count = ring.size();
  const auto offset = [&](const Snap& snap) {
    return (snap.in_enu_m - ring[snap.at.place]).norm();
  };
  std::size_t steps = (to.at.place + count - from.at.place) % count;
  // On one and the same edge, but behind: all the way around.
  if (steps == 0 && offset(to) < offset(from)) steps = count;
  // What was snapped may lie on a corner but for rounding; the ends stay as they are.
  const auto is_new = [&](const Eigen::Vector2d& place) {
    return (place - way.back()).norm() > kTouchM;
  };
  for (std::size_t i = 1; i <= steps; ++i) {
    const Eigen::Vector2d& place = ring[(from.at.place + i) % count];
    if (is_new(place)) way.push_back(place);
  }
  if (!is_new(to.in_enu_m) && way.size() > 1) way.pop_back();
  if (way.back() != to.in_enu_m) way.push_back(to.in_enu_m);
  return way;
}

double length_of(const Ring& way) {
  double length = 0.0;
  for (std::size_t i = 1; i < way.size(); ++i) length += along_ring(way, i - 1, i);
  return length;
}

}  // namespace

struct SnapIndex::Entry {
  std::shared_ptr<const LabelObject> object;
  EdgeTree edges;
};

SnapIndex::SnapIndex(const LabelDocument& document) {
  for (const auto& [id, placed] : document.objects()) add(placed.object);
}
SnapIndex::SnapIndex(SnapIndex&&) noexcept = default;
SnapIndex& SnapIndex::operator=(SnapIndex&&) noexcept = default;
SnapIndex::~SnapIndex() = default;

void SnapIndex::apply(const LabelEdit& edit) {
  for (const auto& [before, after] : edit.objects) {
    if (before != nullptr) remove(before->id);
    if (after != nullptr) add(after);
  }
}

void SnapIndex::add(const std::shared_ptr<const LabelObject>& object) {
  where_[object->id] = entries_.size();
  bounds_.push_back(places_bounds(*object));
  entries_.push_back({object, EdgeTree(object->rings, is_closed(object->kind))});
}

void SnapIndex::remove(ObjectId id) {
  const auto found = where_.find(id);
  if (found == where_.end()) return;
  const std::size_t at = found->second;
  where_.erase(found);
  if (at + 1 < entries_.size()) {
    entries_[at] = std::move(entries_.back());
    bounds_[at] = bounds_.back();
    where_[entries_[at].object->id] = at;
  }
  entries_.pop_back();
  bounds_.pop_back();
}

std::optional<Snap> SnapIndex::nearest(const Eigen::Vector2d& point_in_enu_m,
                                       double reach_m,
                                       std::span<const ObjectId> without) const {
  const PlaneBounds box = box_around(point_in_enu_m, point_in_enu_m, reach_m);
  Nearest vertex{reach_m, {}};
  Nearest edge{reach_m, {}};
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    if (!do_meet(bounds_[i], box)) continue;
    const ObjectId id = entries_[i].object->id;
    if (std::find(without.begin(), without.end(), id) != without.end()) continue;
    entries_[i].edges.visit(box, [&](const EdgeTree::Edge& near) {
      const VertexRef from{id, near.ring, near.place};
      const std::size_t count = entries_[i].object->rings[near.ring].size();
      const VertexRef to{id, near.ring, near.place + 1 < count ? near.place + 1 : 0};
      vertex.take((near.from - point_in_enu_m).norm(), SnapKind::kVertex, near.from, from);
      vertex.take((near.to - point_in_enu_m).norm(), SnapKind::kVertex, near.to, to);
      const Eigen::Vector2d foot = nearest_on_edge(near.from, near.to, point_in_enu_m);
      edge.take((foot - point_in_enu_m).norm(), SnapKind::kEdge, on_lattice(foot), from);
    });
  }
  return vertex.found ? vertex.found : edge.found;
}

std::vector<VertexRef> SnapIndex::at(const Eigen::Vector2d& point_in_enu_m) const {
  const PlaneBounds box = box_around(point_in_enu_m, point_in_enu_m, kTouchM);
  const auto is_there = [&](const Eigen::Vector2d& place) {
    return (place - point_in_enu_m).norm() <= kTouchM;
  };
  std::vector<VertexRef> found;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    if (!do_meet(bounds_[i], box)) continue;
    const LabelObject& object = *entries_[i].object;
    entries_[i].edges.visit(box, [&](const EdgeTree::Edge& edge) {
      const std::size_t next = edge.place + 1 < object.rings[edge.ring].size() ? edge.place + 1 : 0;
      if (is_there(edge.from)) found.push_back({object.id, edge.ring, edge.place});
      if (is_there(edge.to)) found.push_back({object.id, edge.ring, next});
    });
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

std::vector<VertexRef> SnapIndex::edges_at(const Eigen::Vector2d& point_in_enu_m) const {
  const PlaneBounds box = box_around(point_in_enu_m, point_in_enu_m, kTouchM);
  std::vector<VertexRef> found;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    if (!do_meet(bounds_[i], box)) continue;
    entries_[i].edges.visit(box, [&](const EdgeTree::Edge& edge) {
      const Eigen::Vector2d foot = nearest_on_edge(edge.from, edge.to, point_in_enu_m);
      if ((foot - point_in_enu_m).norm() > kTouchM) return;
      found.push_back({entries_[i].object->id, edge.ring, edge.place});
    });
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::optional<Snap> snap_to_direction(const Ring& drawn,
                                      const Eigen::Vector2d& point_in_enu_m,
                                      double reach_m) {
  if (drawn.size() < 2) return std::nullopt;
  const Eigen::Vector2d& last = drawn.back();
  const Eigen::Vector2d leg = last - drawn[drawn.size() - 2];
  if (!(leg.norm() > 0.0)) return std::nullopt;
  const Eigen::Vector2d along = leg.normalized();
  const Eigen::Vector2d aside(-along.y(), along.x());
  const Eigen::Vector2d there = point_in_enu_m - last;
  const Eigen::Vector2d ahead = last + std::max(0.0, there.dot(along)) * along;
  const Eigen::Vector2d square = last + there.dot(aside) * aside;
  const double from_ahead_m = (ahead - point_in_enu_m).norm();
  const double from_square_m = (square - point_in_enu_m).norm();
  if (std::min(from_ahead_m, from_square_m) > reach_m) return std::nullopt;
  if (from_ahead_m <= from_square_m) return Snap{SnapKind::kAlong, on_lattice(ahead), {}};
  return Snap{SnapKind::kSquare, on_lattice(square), {}};
}

Eigen::Vector2d typed_place(const Eigen::Vector2d& last_in_enu_m,
                            const Eigen::Vector2d& pointer_in_enu_m,
                            std::optional<double> length_m,
                            std::optional<Angle> yaw) {
  const Eigen::Vector2d there = pointer_in_enu_m - last_in_enu_m;
  Eigen::Vector2d direction = there.norm() > 0.0 ? there.normalized() : Eigen::Vector2d::UnitX();
  if (yaw) direction = {std::cos(yaw->radians()), std::sin(yaw->radians())};
  const double length = length_m ? *length_m : std::max(0.0, there.dot(direction));
  return on_lattice(last_in_enu_m + length * direction);
}

Result<Ring> traced(const LabelObject& object,
                    const Snap& from,
                    const Snap& to,
                    bool takes_other_way,
                    double beside_m) {
  const auto is_of_it = [&](const Snap& snap) {
    return snap.at.object == object.id && snap.at.ring < object.rings.size() &&
           snap.at.place < object.rings[snap.at.ring].size();
  };
  if (!is_of_it(from) || !is_of_it(to) || from.at.ring != to.at.ring) {
    return fail(ErrorCode::kInvalidOptions, "both places must lie on the same border");
  }
  const Ring& ring = object.rings[from.at.ring];
  Ring way = walked(ring, from, to);
  Ring back = walked(ring, to, from);
  std::reverse(back.begin(), back.end());
  if (is_closed(object.kind)) {
    const bool takes_back = (length_of(back) < length_of(way)) != takes_other_way;
    if (takes_back) way = std::move(back);
  } else {
    if (takes_other_way) {
      return fail(ErrorCode::kInvalidOptions, "along a line there is one way only");
    }
    // Of both ways around the one that does not jump from its end to its beginning.
    const auto distance = [&](const Snap& snap) {
      return (snap.in_enu_m - ring[snap.at.place]).norm();
    };
    const bool goes_back =
        std::pair(to.at.place, distance(to)) < std::pair(from.at.place, distance(from));
    if (goes_back) way = std::move(back);
  }
  if (beside_m == 0.0) return way;
  auto parallel = beside(way, beside_m);
  if (!parallel) return forward_error(parallel);
  if (parallel->size() != 1) {
    return fail(ErrorCode::kInvalidOptions,
                "the border bends too sharply for a parallel {:.2f} m beside it", beside_m);
  }
  return std::move(parallel->front());
}

}  // namespace nadir
