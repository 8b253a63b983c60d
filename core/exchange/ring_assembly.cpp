// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/ring_assembly.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

namespace nadir {
namespace {

bool is_inside(const Eigen::Vector2d& point, const Ring& ring) {
  bool inside = false;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    const Eigen::Vector2d& a = ring[j];
    const Eigen::Vector2d& b = ring[i];
    if ((a.y() > point.y()) == (b.y() > point.y())) continue;
    const double x = a.x() + (point.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
    if (point.x() < x) inside = !inside;
  }
  return inside;
}

/// By most of some of its places, for rings touch.
bool is_ring_inside(const Ring& ring, const Ring& other) {
  constexpr std::size_t kAsked = 15;
  const std::size_t step = ring.size() / kAsked + 1;
  int votes = 0;
  for (std::size_t i = 0; i < ring.size(); i += step) votes += is_inside(ring[i], other) ? 1 : -1;
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

}  // namespace

std::vector<std::vector<Ring>> areas_of(std::vector<Ring> rings) {
  std::vector<PlaneBounds> bounds;
  bounds.reserve(rings.size());
  for (const Ring& ring : rings) bounds.push_back(bounds_of(ring));
  std::vector<std::vector<std::size_t>> around(rings.size());
  for (std::size_t i = 0; i < rings.size(); ++i) {
    for (std::size_t j = 0; j < rings.size(); ++j) {
      if (i != j && holds(bounds[j], bounds[i]) && is_ring_inside(rings[i], rings[j])) {
        around[i].push_back(j);
      }
    }
  }
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
  std::unordered_multimap<std::int64_t, std::size_t> ends;
  for (std::size_t i = 0; i < ways.size(); ++i) {
    if (ways[i].empty() || ways[i].front() == ways[i].back()) continue;
    ends.emplace(ways[i].front(), i);
    ends.emplace(ways[i].back(), i);
  }
  std::vector<bool> is_used(ways.size(), false);
  std::vector<NodeChain> chains;
  for (std::size_t first = 0; first < ways.size(); ++first) {
    if (is_used[first] || ways[first].empty()) continue;
    is_used[first] = true;
    NodeChain chain = std::move(ways[first]);
    bool was_turned = false;
    while (chain.size() < 2 || chain.front() != chain.back()) {
      const auto [begin, end] = ends.equal_range(chain.back());
      const auto next =
          std::find_if(begin, end, [&](const auto& entry) { return !is_used[entry.second]; });
      if (next == end) {
        if (was_turned) break;
        was_turned = true;  // Once more from its other end.
        std::reverse(chain.begin(), chain.end());
        continue;
      }
      NodeChain& way = ways[next->second];
      is_used[next->second] = true;
      if (way.front() != chain.back()) std::reverse(way.begin(), way.end());
      chain.insert(chain.end(), way.begin() + 1, way.end());
    }
    chains.push_back(std::move(chain));
  }
  return chains;
}

}  // namespace nadir
