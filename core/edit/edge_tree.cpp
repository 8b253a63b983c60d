// SPDX-License-Identifier: Apache-2.0
#include "core/edit/edge_tree.h"

#include <cmath>
#include <limits>
#include <utility>

namespace nadir {
namespace {

constexpr std::size_t kMostCrossings = 100'000;
/// Pairs of edges that lie near each other: some seconds.
constexpr std::size_t kMostPairs = 200'000'000;
/// Pairs of a changed edge and any other that are looked at one by one.
constexpr std::size_t kFewPairs = 10'000'000;

/// On which side of a to b a place is; 0 where rounding does not let one tell.
int side_of(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& place) {
  const Eigen::Vector2d along = b - a;
  const Eigen::Vector2d there = place - a;
  const double one = along.x() * there.y();
  const double other = along.y() * there.x();
  // Differences of places on the lattice are exact, so that only products and their difference are rounded.
  const double least =
      4.0 * std::numeric_limits<double>::epsilon() * (std::abs(one) + std::abs(other));
  const double twice_area = one - other;
  if (std::abs(twice_area) <= least) return 0;
  return twice_area > 0.0 ? 1 : -1;
}

/// Edges of a ring that another one has not at the same place of its order: [begin, end).
struct ChangedEdges {
  std::size_t begin = 0, end = 0;
};
ChangedEdges changed_edges(const Ring& ring, const Ring& other) {
  const std::size_t shorter = std::min(ring.size(), other.size());
  std::size_t same = 0;
  while (same < shorter && ring[same] == other[same]) ++same;
  if (same == ring.size() && same == other.size()) return {};
  std::size_t same_at_end = 0;
  while (same_at_end + same < shorter &&
         ring[ring.size() - 1 - same_at_end] == other[other.size() - 1 - same_at_end]) {
    ++same_at_end;
  }
  // With the edge that leads there; the one of the last place leads to the first.
  if (same == 0 || same_at_end == 0) return {same == 0 ? 0 : same - 1, ring.size()};
  return {same - 1, ring.size() - same_at_end};
}

struct Crossings {
  std::size_t count = 0;
  std::optional<Eigen::Vector2d> first;
};

/// Of the edges that changed with all others. `changed` has one for each ring.
Crossings crossings_of_changed(std::span<const Ring> rings,
                               const std::vector<ChangedEdges>& changed) {
  Crossings found;
  const auto to = [](const Ring& ring, std::size_t place) {
    return ring[place + 1 < ring.size() ? place + 1 : 0];
  };
  for (std::size_t i = 0; i < rings.size(); ++i) {
    for (std::size_t a = changed[i].begin; a < changed[i].end; ++a) {
      const PlaneBounds bounds = box_around(rings[i][a], to(rings[i], a));
      for (std::size_t j = 0; j < rings.size(); ++j) {
        const Ring& other = rings[j];
        for (std::size_t b = 0; b < other.size(); ++b) {
          const bool is_looked_at_anyway =
              b >= changed[j].begin && b < changed[j].end && (j < i || (j == i && b <= a));
          if (is_looked_at_anyway || !do_meet(bounds, box_around(other[b], to(other, b)))) continue;
          const auto crossing =
              crossing_of_edges(rings[i][a], to(rings[i], a), other[b], to(other, b));
          if (!crossing) continue;
          if (!found.first) found.first = crossing;
          ++found.count;
        }
      }
    }
  }
  return found;
}

Result<Crossings> all_crossings(std::span<const Ring> rings) {
  Crossings found;
  std::size_t pairs = 0;
  const EdgeTree tree(rings, true);
  const bool is_done =
      tree.visit_pairs([&](const EdgeTree::Edge& first, const EdgeTree::Edge& second) {
        const auto crossing = crossing_of_edges(first.from, first.to, second.from, second.to);
        if (crossing) {
          if (!found.first) found.first = crossing;
          ++found.count;
        }
        return ++pairs <= kMostPairs && found.count <= kMostCrossings;
      });
  if (is_done) return found;
  return fail(ErrorCode::kInvalidOptions,
              "borders cross more than {} times, or are too intricate to tell", kMostCrossings);
}

}  // namespace

PlaneBounds box_around(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double reach_m) {
  PlaneBounds bounds;
  bounds.include(a);
  bounds.include(b);
  bounds.grow(reach_m);
  return bounds;
}

Eigen::Vector2d nearest_on_edge(const Eigen::Vector2d& a,
                                const Eigen::Vector2d& b,
                                const Eigen::Vector2d& place) {
  const Eigen::Vector2d along = b - a;
  const double length = along.squaredNorm();
  if (!(length > 0.0)) return a;
  return a + std::clamp((place - a).dot(along) / length, 0.0, 1.0) * along;
}

std::optional<Eigen::Vector2d> crossing_of_edges(const Eigen::Vector2d& a,
                                                 const Eigen::Vector2d& b,
                                                 const Eigen::Vector2d& c,
                                                 const Eigen::Vector2d& d) {
  if (side_of(a, b, c) * side_of(a, b, d) >= 0) return std::nullopt;
  if (side_of(c, d, a) * side_of(c, d, b) >= 0) return std::nullopt;
  const Eigen::Vector2d along = b - a;
  const Eigen::Vector2d across = d - c;
  const double t = ((c - a).x() * across.y() - (c - a).y() * across.x()) /
                   (along.x() * across.y() - along.y() * across.x());
  return Eigen::Vector2d(a + t * along);
}

Ring without_repeats(Ring ring, bool is_closed) {
  ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
  while (is_closed && ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
  return ring;
}

double signed_area_m2(const Ring& ring) {
  double twice = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    // From the ring's first place, because far from 0 products lose their last digits.
    const Eigen::Vector2d from = ring[i] - ring.front();
    const Eigen::Vector2d to = ring[i + 1 < ring.size() ? i + 1 : 0] - ring.front();
    twice += from.x() * to.y() - from.y() * to.x();
  }
  return twice / 2.0;
}

EdgeTree::EdgeTree(std::span<const Ring> rings, bool is_closed) : rings_(rings), begins_{0} {
  for (const Ring& ring : rings) {
    const std::size_t edges = is_closed || ring.empty() ? ring.size() : ring.size() - 1;
    begins_.push_back(begins_.back() + edges);
  }
  if (size() == 0) return;
  levels_.emplace_back((size() + kLeaf - 1) / kLeaf);
  for (std::size_t leaf = 0; leaf < levels_.front().size(); ++leaf) {
    visit_leaf(leaf, [&](const Edge& edge) {
      levels_.front()[leaf].include(edge.from);
      levels_.front()[leaf].include(edge.to);
    });
  }
  while (levels_.back().size() > 1) {
    const std::vector<PlaneBounds>& below = levels_.back();
    std::vector<PlaneBounds> level((below.size() + 1) / 2);
    for (std::size_t i = 0; i < below.size(); ++i) {
      level[i / 2].include(below[i].low);
      level[i / 2].include(below[i].high);
    }
    levels_.push_back(std::move(level));
  }
}

EdgeTree::Edge EdgeTree::edge(std::size_t number) const {
  // Rings are few, and mostly one; empty ones have no edges.
  std::size_t ring = 0;
  if (rings_.size() > 1) {
    ring = static_cast<std::size_t>(std::upper_bound(begins_.begin(), begins_.end(), number) -
                                    begins_.begin() - 1);
  }
  const Ring& places = rings_[ring];
  const std::size_t place = number - begins_[ring];
  return {ring, place, places[place], places[place + 1 < places.size() ? place + 1 : 0]};
}

bool EdgeTree::holds(const Eigen::Vector2d& place) const {
  PlaneBounds ray = box_around(place, place);
  ray.high.x() = std::numeric_limits<double>::infinity();
  bool is_inside = false;
  visit(ray, [&](const Edge& edge) {
    const bool goes_up = edge.from.y() <= place.y();
    if (goes_up == (edge.to.y() <= place.y())) return;
    const Eigen::Vector2d& lower = goes_up ? edge.from : edge.to;
    const Eigen::Vector2d& upper = goes_up ? edge.to : edge.from;
    if (side_of(lower, upper, place) > 0) is_inside = !is_inside;
  });
  return is_inside;
}

Result<std::size_t> count_crossings(std::span<const Ring> rings) {
  const auto crossings = all_crossings(rings);
  if (!crossings) return forward_error(crossings);
  return crossings->count;
}

Result<std::optional<Eigen::Vector2d>> new_crossing(const LabelObject* before,
                                                    const LabelObject& after) {
  if (!is_closed(after.kind)) return std::nullopt;
  if (before != nullptr && before->rings == after.rings) return std::nullopt;
  std::size_t pairs = kFewPairs + 1;
  std::vector<ChangedEdges> changed;
  std::vector<ChangedEdges> replaced;
  if (before != nullptr && before->rings.size() == after.rings.size()) {
    std::size_t edges = 0;
    std::size_t changes = 0;
    for (std::size_t i = 0; i < after.rings.size(); ++i) {
      changed.push_back(changed_edges(after.rings[i], before->rings[i]));
      replaced.push_back(changed_edges(before->rings[i], after.rings[i]));
      edges += std::max(before->rings[i].size(), after.rings[i].size());
      changes += changed.back().end - changed.back().begin;
      changes += replaced.back().end - replaced.back().begin;
    }
    pairs = edges * changes;
  }
  if (pairs <= kFewPairs) {
    const Crossings now = crossings_of_changed(after.rings, changed);
    if (now.count == 0) return std::nullopt;
    if (now.count > crossings_of_changed(before->rings, replaced).count) return now.first;
    return std::nullopt;
  }
  const auto now = all_crossings(after.rings);
  if (!now) return forward_error(now);
  if (now->count == 0 || before == nullptr) return now->first;
  const auto earlier = all_crossings(before->rings);
  if (!earlier) return forward_error(earlier);
  if (now->count > earlier->count) return now->first;
  return std::nullopt;
}

bool is_as_sound(const LabelObject& before, const LabelObject& after) {
  if (!check_object(after)) return false;
  if (!is_closed(after.kind)) return true;
  for (std::size_t i = 0; i < after.rings.size(); ++i) {
    // What turns over, or has no inside left, was narrower than it was moved.
    if (signed_area_m2(before.rings[i]) * signed_area_m2(after.rings[i]) <= 0.0) return false;
  }
  const auto crossing = new_crossing(&before, after);
  return crossing && !*crossing;
}

}  // namespace nadir
