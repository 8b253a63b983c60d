// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "core/label/label_object.h"

namespace nadir {

/// Equal places have equal hashes, those of 0 and -0 too.
struct PlaceHash {
  [[nodiscard]] std::size_t operator()(const Eigen::Vector2d& place) const {
    const std::size_t x = std::hash<double>{}(place.x() + 0.0);
    return (x ^ (x >> 29U)) * 0x9E3779B97F4A7C15U + std::hash<double>{}(place.y() + 0.0);
  }
};
using PlaceSet = std::unordered_set<Eigen::Vector2d, PlaceHash>;
template <typename T>
using PlaceMap = std::unordered_map<Eigen::Vector2d, T, PlaceHash>;

/// An order of places, for what must not depend on where somebody began to draw.
[[nodiscard]] inline bool lies_before(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
}
[[nodiscard]] inline bool is_closed(ObjectKind kind) { return kind != ObjectKind::kLine; }
/// The rectangle between two places, wider by a reach.
[[nodiscard]] PlaneBounds box_around(const Eigen::Vector2d& a,
                                     const Eigen::Vector2d& b,
                                     double reach_m = 0.0);
[[nodiscard]] inline bool do_meet(const PlaneBounds& a, const PlaneBounds& b) {
  return !a.is_empty && !b.is_empty && (a.low.array() <= b.high.array()).all() &&
         (b.low.array() <= a.high.array()).all();
}
/// The nearest place of an edge.
[[nodiscard]] Eigen::Vector2d nearest_on_edge(const Eigen::Vector2d& a,
                                              const Eigen::Vector2d& b,
                                              const Eigen::Vector2d& place);
/// Where two edges pass through each other between their ends; nothing where they only touch.
[[nodiscard]] std::optional<Eigen::Vector2d> crossing_of_edges(const Eigen::Vector2d& a,
                                                               const Eigen::Vector2d& b,
                                                               const Eigen::Vector2d& c,
                                                               const Eigen::Vector2d& d);
/// Without places that repeat the one before; a closed ring's last counts as before its first.
[[nodiscard]] Ring without_repeats(Ring ring, bool is_closed);
/// Positive where it turns to the left.
[[nodiscard]] double signed_area_m2(const Ring& ring);

/// Edges of rings by where they lie, for rings of millions of places. Private to core.
class EdgeTree {
 public:
  /// O(places). @param rings  Must outlive the tree and stay as they are.
  EdgeTree(std::span<const Ring> rings, bool is_closed);

  struct Edge {
    std::size_t ring = 0, place = 0;  ///< That it begins with.
    Eigen::Vector2d from = Eigen::Vector2d::Zero(), to = Eigen::Vector2d::Zero();
  };
  [[nodiscard]] std::size_t size() const { return begins_.back(); }
  [[nodiscard]] Edge edge(std::size_t number) const;

  /// Calls `visit(edge)` for all edges whose bounds meet a box, in the order of rings and places.
  template <typename Visit>
  void visit(const PlaneBounds& box, const Visit& visit) const {
    if (!levels_.empty()) visit_node(levels_.size() - 1, 0, box, visit);
  }
  /// Calls `visit(edge, edge)` for all pairs of edges whose bounds meet, until it returns false.
  /// @returns whether it was called for all.
  template <typename Visit>
  bool visit_pairs(const Visit& visit) const {
    return levels_.empty() || visit_pair(levels_.size() - 1, 0, 0, visit);
  }
  /// Whether a place is inside of closed rings, by odd and even.
  [[nodiscard]] bool holds(const Eigen::Vector2d& place) const;

 private:
  static constexpr std::size_t kLeaf = 8;  ///< Edges.

  [[nodiscard]] static PlaneBounds bounds(const Edge& edge) {
    return box_around(edge.from, edge.to);
  }
  template <typename Visit>
  void visit_leaf(std::size_t leaf, const Visit& visit) const {
    const std::size_t end = std::min(size(), (leaf + 1) * kLeaf);
    for (std::size_t i = leaf * kLeaf; i < end; ++i) visit(edge(i));
  }
  template <typename Visit>
  void visit_node(std::size_t level,
                  std::size_t node,
                  const PlaneBounds& box,
                  const Visit& visit) const {
    if (!do_meet(levels_[level][node], box)) return;
    if (level == 0) {
      visit_leaf(node, [&](const Edge& edge) {
        if (do_meet(bounds(edge), box)) visit(edge);
      });
      return;
    }
    const std::size_t end = std::min(levels_[level - 1].size(), 2 * node + 2);
    for (std::size_t i = 2 * node; i < end; ++i) visit_node(level - 1, i, box, visit);
  }
  template <typename Visit>
  bool visit_pair(std::size_t level, std::size_t a, std::size_t b, const Visit& visit) const {
    if (!do_meet(levels_[level][a], levels_[level][b])) return true;
    if (level == 0) return visit_edges(a, b, visit);
    const std::size_t count = levels_[level - 1].size();
    for (std::size_t i = 2 * a; i < std::min(count, 2 * a + 2); ++i) {
      for (std::size_t j = a == b ? i : 2 * b; j < std::min(count, 2 * b + 2); ++j) {
        if (!visit_pair(level - 1, i, j, visit)) return false;
      }
    }
    return true;
  }
  template <typename Visit>
  bool visit_edges(std::size_t leaf_a, std::size_t leaf_b, const Visit& visit) const {
    for (std::size_t i = leaf_a * kLeaf; i < std::min(size(), (leaf_a + 1) * kLeaf); ++i) {
      const Edge first = edge(i);
      const std::size_t from = leaf_a == leaf_b ? i + 1 : leaf_b * kLeaf;
      for (std::size_t j = from; j < std::min(size(), (leaf_b + 1) * kLeaf); ++j) {
        const Edge second = edge(j);
        if (do_meet(bounds(first), bounds(second)) && !visit(first, second)) return false;
      }
    }
    return true;
  }

  std::span<const Ring> rings_;
  std::vector<std::size_t> begins_;               ///< Number of each ring's first edge, and of all.
  std::vector<std::vector<PlaneBounds>> levels_;  ///< Of eight edges, of sixteen, ... of all.
};

/// How often closed rings cross themselves and each other.
/// @errors kInvalidOptions: more often than anybody draws, or so intricately that counting takes too long.
[[nodiscard]] Result<std::size_t> count_crossings(std::span<const Ring> rings);
/// A place where an object crosses itself more than before; nothing where it does not, nor does a line ever.
/// @param before  Null: a new object. @errors those of count_crossings().
[[nodiscard]] Result<std::optional<Eigen::Vector2d>> new_crossing(const LabelObject* before,
                                                                  const LabelObject& after);
/// Whether an object whose places were moved is what it may be, turns no ring over and crosses itself no more than before.
/// @param before  With as many rings.
[[nodiscard]] bool is_as_sound(const LabelObject& before, const LabelObject& after);

}  // namespace nadir
