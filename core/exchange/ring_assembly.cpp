// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/ring_assembly.h"

#include <algorithm>
#include <span>
#include <unordered_map>
#include <utility>

#include "core/edit/box_tree.h"
#include "core/edit/edge_tree.h"

namespace nadir {
namespace {

/// By most of some of its places, for rings touch.
bool is_ring_inside(const Ring& ring, const EdgeTree& other) {
  constexpr std::size_t kAsked = 15;
  const std::size_t step = ring.size() / kAsked + 1;
  int votes = 0;
  for (std::size_t i = 0; i < ring.size(); i += step) votes += other.holds(ring[i]) ? 1 : -1;
  return votes > 0;
}

PlaneBounds bounds_of(const Ring& ring) {
  PlaneBounds bounds;
  for (const Eigen::Vector2d& point : ring) bounds.include(point);
  return bounds;
}

bool holds(const PlaneBounds& outer, const PlaneBounds& inner) {
  return (outer.low.array() <= inner.low.array()).all() &&
         (outer.high.array() >= inner.high.array()).all();
}

/// Which rings lie around each. @errors kCancelled.
Result<std::vector<std::vector<std::size_t>>> rings_around(const std::vector<Ring>& rings,
                                                           const WorkContext& context) {
  std::vector<PlaneBounds> bounds;
  bounds.reserve(rings.size());
  for (const Ring& ring : rings) bounds.push_back(bounds_of(ring));
  const BoxTree tree(bounds);
  std::unordered_map<std::size_t, EdgeTree> edges;  // Of those that have something in their bounds.
  std::vector<std::vector<std::size_t>> around(rings.size());
  for (std::size_t i = 0; i < rings.size(); ++i) {
    if (i % 256 == 0 && context.is_stopped()) return fail(ErrorCode::kCancelled, "cancelled");
    PlaneBounds corner;
    corner.include(bounds[i].low);
    tree.visit(corner, [&](std::size_t j) {
      if (i == j || !holds(bounds[j], bounds[i])) return;
      const EdgeTree& of_ring =
          edges.try_emplace(j, std::span<const Ring>(&rings[j], 1), true).first->second;
      if (is_ring_inside(rings[i], of_ring)) around[i].push_back(j);
    });
    std::sort(around[i].begin(), around[i].end());
  }
  return around;
}

}  // namespace

Result<std::vector<std::vector<Ring>>> areas_of(std::vector<Ring> rings,
                                                const WorkContext& context) {
  const auto found = rings_around(rings, context);
  if (!found) return forward_error(found);
  const std::vector<std::vector<std::size_t>>& around = *found;
  std::vector<std::vector<Ring>> areas;
  std::unordered_map<std::size_t, std::size_t> area_of;
  for (std::size_t i = 0; i < rings.size(); ++i) {
    if (around[i].size() % 2 != 0) continue;
    area_of[i] = areas.size();
    areas.push_back({rings[i]});
  }
  for (std::size_t i = 0; i < rings.size(); ++i) {
    if (around[i].size() % 2 == 0) continue;
    // The innermost of those around it.
    for (const std::size_t j : around[i]) {
      if (around[j].size() + 1 != around[i].size() || area_of.count(j) == 0) continue;
      areas[area_of[j]].push_back(std::move(rings[i]));
      break;
    }
  }
  return areas;
}

std::vector<NodeChain> join_ways(std::vector<NodeChain> ways) {
  std::unordered_map<std::int64_t, std::vector<std::size_t>> ends;
  for (std::size_t i = ways.size(); i-- > 0;) {
    if (ways[i].empty() || ways[i].front() == ways[i].back()) continue;
    ends[ways[i].front()].push_back(i);
    ends[ways[i].back()].push_back(i);
  }
  std::vector<bool> is_used(ways.size(), false);
  std::vector<NodeChain> chains;
  for (std::size_t first = 0; first < ways.size(); ++first) {
    if (is_used[first] || ways[first].empty()) continue;
    is_used[first] = true;
    NodeChain chain = std::move(ways[first]);
    bool was_turned = false;
    while (chain.size() < 2 || chain.front() != chain.back()) {
      std::vector<std::size_t>& there = ends[chain.back()];
      while (!there.empty() && is_used[there.back()]) there.pop_back();
      if (there.empty()) {
        if (was_turned) break;
        was_turned = true;  // Once more from its other end.
        std::reverse(chain.begin(), chain.end());
        continue;
      }
      NodeChain& way = ways[there.back()];
      is_used[there.back()] = true;
      if (way.front() != chain.back()) std::reverse(way.begin(), way.end());
      chain.insert(chain.end(), way.begin() + 1, way.end());
    }
    chains.push_back(std::move(chain));
  }
  return chains;
}

}  // namespace nadir
