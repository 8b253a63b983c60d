// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/edit/edge_tree.h"
#include "core/edit/edit_builder.h"
#include "core/edit/edit_vertices.h"
#include "core/edit/polygon_algebra.h"

namespace nadir {
namespace {

/// Places that others join, in square bins as wide as the reach.
class JoinedPlaces {
 public:
  explicit JoinedPlaces(double reach_m) : reach_m_(reach_m) {}

  struct Joined {
    Eigen::Vector2d place;
    ObjectId of;  ///< Whose place it was first.
  };
  void add(const Joined& joined) {
    bins_[key(bin(joined.place.x()), bin(joined.place.y()))].push_back(joined);
  }
  /// Calls `visit(joined)` for all within the bounds.
  template <typename Visit>
  void visit(const PlaneBounds& box, const Visit& visit) const {
    const std::int64_t columns = bin(box.high.x()) - bin(box.low.x()) + 1;
    const std::int64_t rows = bin(box.high.y()) - bin(box.low.y()) + 1;
    const auto visit_bin = [&](const std::vector<Joined>& joined) {
      for (const Joined& candidate : joined) {
        if (do_meet(box_around(candidate.place, candidate.place), box)) visit(candidate);
      }
    };
    if (static_cast<double>(columns) * static_cast<double>(rows) >
        static_cast<double>(bins_.size())) {
      for (const auto& [where, joined] : bins_) visit_bin(joined);
      return;
    }
    for (std::int64_t row = 0; row < rows; ++row) {
      for (std::int64_t column = 0; column < columns; ++column) {
        const auto found = bins_.find(key(bin(box.low.x()) + column, bin(box.low.y()) + row));
        if (found != bins_.end()) visit_bin(found->second);
      }
    }
  }
  /// The nearest within reach that was not an object's own; else the place itself on the lattice, which others may join.
  Eigen::Vector2d joined(const Eigen::Vector2d& given, ObjectId of) {
    Eigen::Vector2d place = on_lattice(given);
    double least = reach_m_;
    const Eigen::Vector2d* found = nullptr;
    bool is_there = false;
    visit(box_around(place, place, reach_m_), [&](const Joined& candidate) {
      is_there = is_there || candidate.place == place;
      const double distance = (candidate.place - place).norm();
      if (candidate.of == of || distance > least) return;
      if (distance == least && found != nullptr && lies_before(*found, candidate.place)) return;
      least = distance;
      found = &candidate.place;
    });
    if (found != nullptr) return *found;
    if (!is_there) add({place, of});
    return place;
  }

 private:
  [[nodiscard]] std::int64_t bin(double metres) const {
    return static_cast<std::int64_t>(std::floor(metres / reach_m_));
  }
  static std::uint64_t key(std::int64_t column, std::int64_t row) {
    return static_cast<std::uint64_t>(column) * 0x9E3779B97F4A7C15U ^
           static_cast<std::uint64_t>(row);
  }
  double reach_m_;
  std::unordered_map<std::uint64_t, std::vector<Joined>> bins_;
};

/// A ring with the places of others that lie on its edges.
Ring with_joined(const Ring& ring, bool is_ring, double reach_m, const JoinedPlaces& places) {
  Ring all;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    all.push_back(ring[i]);
    if (i + 1 == ring.size() && !is_ring) break;
    const Eigen::Vector2d& from = ring[i];
    const Eigen::Vector2d& to = ring[i + 1 < ring.size() ? i + 1 : 0];
    std::vector<Eigen::Vector2d> on_edge;
    places.visit(box_around(from, to, reach_m), [&](const JoinedPlaces::Joined& candidate) {
      const Eigen::Vector2d& place = candidate.place;
      const double along = (place - from).dot(to - from);
      if (!(along > 0.0 && along < (to - from).squaredNorm()) || place == from || place == to)
        return;
      if ((nearest_on_edge(from, to, place) - place).norm() <= reach_m) on_edge.push_back(place);
    });
    std::sort(on_edge.begin(), on_edge.end(),
              [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
                const double far_a = (a - from).dot(to - from);
                const double far_b = (b - from).dot(to - from);
                return far_a < far_b || (far_a == far_b && lies_before(a, b));
              });
    all.insert(all.end(), on_edge.begin(), on_edge.end());
  }
  return without_repeats(std::move(all), is_ring);
}

}  // namespace

Result<LabelEdit> join_borders(const LabelDocument& document,
                               std::span<const ObjectId> objects,
                               double reach_m) {
  if (!(reach_m >= kLatticeM && reach_m <= 100.0)) {
    return fail(ErrorCode::kInvalidOptions, "a reach of {} m is not in [{:.6f}, 100]", reach_m,
                kLatticeM);
  }
  const auto selected = selected_objects(document, objects);
  if (!selected) return forward_error(selected);
  EditBuilder builder(document, "Join borders");
  JoinedPlaces places(reach_m);
  std::vector<LabelObject> joined;
  for (const LabelObject* const object : *selected) {
    LabelObject after = *object;
    for (Ring& ring : after.rings) {
      for (Eigen::Vector2d& place : ring) place = places.joined(place, object->id);
      ring = without_repeats(std::move(ring), is_closed(object->kind));
    }
    if (!is_as_sound(*object, after)) after = *object;
    joined.push_back(std::move(after));
  }
  for (std::size_t i = 0; i < joined.size(); ++i) {
    LabelObject after = joined[i];
    for (Ring& ring : after.rings) {
      ring = with_joined(ring, is_closed(after.kind), reach_m, places);
    }
    if (!is_as_sound(joined[i], after)) after = joined[i];
    builder.change(after.id).rings = std::move(after.rings);
  }
  return builder.edit();
}

}  // namespace nadir
