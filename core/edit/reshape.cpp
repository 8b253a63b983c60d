// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <utility>
#include <vector>

#include "core/edit/border_chains.h"
#include "core/edit/edge_tree.h"
#include "core/edit/edit_builder.h"
#include "core/edit/edit_vertices.h"
#include "core/edit/polygon_algebra.h"

namespace nadir {
namespace {

/// An object with more places is not made smoother, for each time doubles them.
constexpr std::size_t kMostSmoothedPlaces = 1'000'000;

/// Which places between two remain, the two included.
void keep_far_places(const Ring& places,
                     std::size_t begin,
                     std::size_t end,
                     double tolerance_m,
                     std::vector<bool>& is_kept) {
  std::vector<std::pair<std::size_t, std::size_t>> waiting{{begin, end}};
  is_kept[begin % places.size()] = is_kept[end % places.size()] = true;
  while (!waiting.empty()) {
    const auto [first, last] = waiting.back();
    waiting.pop_back();
    double most = tolerance_m;
    std::size_t farthest = first;
    for (std::size_t i = first + 1; i < last; ++i) {
      const Eigen::Vector2d& place = places[i];
      const double distance =
          (nearest_on_edge(places[first], places[last % places.size()], place) - place).norm();
      if (distance <= most) continue;
      most = distance;
      farthest = i;
    }
    if (farthest == first) continue;
    is_kept[farthest] = true;
    waiting.emplace_back(first, farthest);
    waiting.emplace_back(farthest, last);
  }
}

Ring simplified_chain(const BorderChain& chain, double tolerance_m) {
  const Ring& places = chain.places;
  if (places.size() < 3) return places;
  std::vector<bool> is_kept(places.size(), false);
  const std::size_t end = chain.is_loop ? places.size() : places.size() - 1;
  if (places[end % places.size()] == places.front()) {
    const auto farthest = std::max_element(
        places.begin(), places.end(), [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
          return (a - places.front()).norm() < (b - places.front()).norm();
        });
    const auto middle = static_cast<std::size_t>(farthest - places.begin());
    keep_far_places(places, 0, middle, tolerance_m, is_kept);
    keep_far_places(places, middle, end, tolerance_m, is_kept);
  } else {
    keep_far_places(places, 0, end, tolerance_m, is_kept);
  }
  Ring kept;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (is_kept[i]) kept.push_back(places[i]);
  }
  return kept;
}

/// @param cut  How much of each side goes, at each of its ends.
Ring smooth_chain(const BorderChain& chain, double cut) {
  const Ring& places = chain.places;
  Ring smooth;
  if (!chain.is_loop) smooth.push_back(places.front());
  const std::size_t count = places.size();
  for (std::size_t i = chain.is_loop ? 0 : 1; i + (chain.is_loop ? 0 : 1) < count; ++i) {
    const Eigen::Vector2d& before = places[i > 0 ? i - 1 : count - 1];
    const Eigen::Vector2d& after = places[(i + 1) % count];
    smooth.push_back(on_lattice(places[i] + cut * (before - places[i])));
    smooth.push_back(on_lattice(places[i] + cut * (after - places[i])));
  }
  if (!chain.is_loop) smooth.push_back(places.back());
  return smooth;
}

}  // namespace

Result<LabelEdit> smooth(const LabelDocument& document, std::span<const ObjectId> objects) {
  const auto selected = selected_objects(document, objects);
  if (!selected) return forward_error(selected);
  for (const LabelObject* const object : *selected) {
    std::size_t places = 0;
    for (const Ring& ring : object->rings) places += ring.size();
    if (places > kMostSmoothedPlaces) {
      return fail(ErrorCode::kInvalidOptions, "{} has {} places, and would get twice as many",
                  object_name(*object), places);
    }
  }
  return reshape_borders(document, objects, "Smooth",
                         [](const BorderChain& chain, double strength) {
                           return smooth_chain(chain, 0.25 * strength);
                         });
}

Result<LabelEdit> simplify(const LabelDocument& document,
                           std::span<const ObjectId> objects,
                           double tolerance_m) {
  if (!(tolerance_m > 0.0)) {
    return fail(ErrorCode::kInvalidOptions, "a tolerance of {} m leaves nothing out", tolerance_m);
  }
  return reshape_borders(document, objects, "Simplify",
                         [&](const BorderChain& chain, double strength) {
                           return simplified_chain(chain, tolerance_m * strength);
                         });
}

}  // namespace nadir
