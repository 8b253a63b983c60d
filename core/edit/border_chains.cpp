// SPDX-License-Identifier: Apache-2.0
#include "core/edit/border_chains.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

#include "core/edit/edge_tree.h"
#include "core/edit/edit_builder.h"

namespace nadir {
namespace {

constexpr std::array<double, 5> kStrengths{1.0, 0.5, 0.25, 0.125, 0.0};

/// Places that border on one, as far as two.
struct PlaceNeighbours {
  Eigen::Vector2d first = Eigen::Vector2d::Zero(), second = Eigen::Vector2d::Zero();
  int count = 0;  ///< 3: more than two.

  void add(const Eigen::Vector2d& place) {
    if ((count > 0 && place == first) || (count > 1 && place == second)) return;
    if (count == 0) first = place;
    if (count == 1) second = place;
    count = std::min(3, count + 1);
  }
};

class ChainFinder {
 public:
  ChainFinder(const LabelDocument& document, std::span<const LabelObject* const> selected) {
    PlaceSet places;
    PlaneBounds bounds;
    for (const LabelObject* const object : selected) {
      selected_.insert(object->id);
      for (const Ring& ring : object->rings) {
        for (const Eigen::Vector2d& place : ring) {
          places.insert(place);
          bounds.include(place);
        }
      }
    }
    for (const auto& [id, placed] : document.objects()) {
      if (selected_.count(id) == 0 &&
          (!do_meet(placed.bounds, bounds) || !has_any(*placed.object, places))) {
        continue;
      }
      add_edges(*placed.object);
      borders_.objects.push_back({placed.object.get(), {}});
    }
  }

  ChainedBorders find() {
    for (ChainedObject& chained : borders_.objects) {
      const bool is_ring = is_closed(chained.object->kind);
      const bool is_selected = selected_.count(chained.object->id) > 0;
      for (const Ring& ring : chained.object->rings) {
        chained.rings.push_back(cut(without_repeats(ring, is_ring), is_ring, is_selected));
      }
    }
    return std::move(borders_);
  }

 private:
  static bool has_any(const LabelObject& object, const PlaceSet& places) {
    return std::any_of(object.rings.begin(), object.rings.end(), [&](const Ring& ring) {
      return std::any_of(ring.begin(), ring.end(),
                         [&](const Eigen::Vector2d& place) { return places.count(place) > 0; });
    });
  }
  void add_edges(const LabelObject& object) {
    const bool is_ring = is_closed(object.kind);
    for (const Ring& given : object.rings) {
      const Ring ring = without_repeats(given, is_ring);
      for (std::size_t i = is_ring ? 0 : 1; i < ring.size(); ++i) {
        const Eigen::Vector2d& before = ring[i > 0 ? i - 1 : ring.size() - 1];
        neighbours_[before].add(ring[i]);
        neighbours_[ring[i]].add(before);
      }
      if (is_ring || ring.empty()) continue;
      neighbours_[ring.front()].count = 3;
      neighbours_[ring.back()].count = 3;
    }
  }
  [[nodiscard]] bool is_node(const Eigen::Vector2d& place) const {
    const auto found = neighbours_.find(place);
    return found == neighbours_.end() || found->second.count != 2;
  }

  std::vector<ChainUse> cut(const Ring& ring, bool is_ring, bool is_selected) {
    std::vector<std::size_t> nodes;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      if (is_node(ring[i])) nodes.push_back(i);
    }
    if (is_ring && nodes.empty()) return {loop(ring, is_selected)};
    std::vector<ChainUse> uses;
    const std::size_t chains = is_ring ? nodes.size() : nodes.size() - 1;
    for (std::size_t i = 0; i < chains; ++i) {
      std::size_t end = nodes[(i + 1) % nodes.size()];
      if (end <= nodes[i]) end += ring.size();
      Ring places;
      for (std::size_t at = nodes[i]; at <= end; ++at) places.push_back(ring[at % ring.size()]);
      uses.push_back(known(std::move(places), false, is_selected));
    }
    return uses;
  }
  ChainUse loop(Ring ring, bool is_selected) {
    std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end(), lies_before), ring.end());
    const bool is_reversed = ring.size() > 2 && lies_before(ring.back(), ring[1]);
    if (is_reversed) std::reverse(ring.begin() + 1, ring.end());
    ChainUse use = known(std::move(ring), true, is_selected);
    use.is_reversed = is_reversed;
    return use;
  }
  /// The chain, in the direction in which it was or will be kept. Inner places have two neighbours, so that the first two and
  /// the last tell chains apart.
  ChainUse known(Ring places, bool is_loop, bool is_selected) {
    const std::size_t last = places.size() - 1;
    const bool is_reversed =
        !is_loop && (lies_before(places[last], places[0]) ||
                     (places[last] == places[0] && lies_before(places[last - 1], places[1])));
    if (is_reversed) std::reverse(places.begin(), places.end());
    const Eigen::Vector2d& second = places[std::min<std::size_t>(1, last)];
    const std::array<double, 6> key{places[0].x(), places[0].y(),    second.x(),
                                    second.y(),    places[last].x(), places[last].y()};
    const auto [found, is_new] = keys_.try_emplace(key, borders_.chains.size());
    if (is_new) borders_.chains.push_back({std::move(places), is_loop, false});
    borders_.chains[found->second].is_selected |= is_selected;
    return {found->second, is_reversed};
  }

  std::set<ObjectId> selected_;
  PlaceMap<PlaceNeighbours> neighbours_;
  std::map<std::array<double, 6>, std::size_t> keys_;
  ChainedBorders borders_;
};

Ring joined_chains(const std::vector<ChainUse>& uses,
                   const std::vector<Ring>& chains,
                   bool is_ring) {
  Ring ring;
  for (const ChainUse& use : uses) {
    const Ring& places = chains[use.chain];
    if (use.is_reversed) {
      ring.insert(ring.end(), places.rbegin(), places.rend());
    } else {
      ring.insert(ring.end(), places.begin(), places.end());
    }
  }
  return without_repeats(std::move(ring), is_ring);
}

}  // namespace

ChainedBorders chained_borders(const LabelDocument& document,
                               std::span<const LabelObject* const> selected) {
  return ChainFinder(document, selected).find();
}

Result<LabelEdit> reshape_borders(const LabelDocument& document,
                                  std::span<const ObjectId> objects,
                                  const char* title,
                                  const ReshapeChain& reshape) {
  const auto selected = selected_objects(document, objects);
  if (!selected) return forward_error(selected);
  const ChainedBorders borders = chained_borders(document, *selected);
  std::vector<std::size_t> strengths;
  std::vector<Ring> reshaped;
  const auto apply = [&](std::size_t chain) {
    const BorderChain& as_it_was = borders.chains[chain];
    const double strength = kStrengths[strengths[chain]];
    reshaped[chain] = strength > 0.0 ? reshape(as_it_was, strength) : as_it_was.places;
  };
  for (const BorderChain& chain : borders.chains) {
    strengths.push_back(chain.is_selected ? 0 : kStrengths.size() - 1);
    reshaped.emplace_back();
    apply(reshaped.size() - 1);
  }
  std::vector<LabelObject> changed(borders.objects.size());
  std::vector<bool> is_done(borders.objects.size(), false);
  for (bool is_sound = false; !is_sound;) {
    is_sound = true;
    std::set<std::size_t> weaker;
    for (std::size_t i = 0; i < borders.objects.size(); ++i) {
      if (is_done[i]) continue;
      const ChainedObject& chained = borders.objects[i];
      changed[i] = *chained.object;
      is_done[i] = true;
      bool is_same = true;
      for (std::size_t ring = 0; ring < chained.rings.size(); ++ring) {
        for (const ChainUse& use : chained.rings[ring]) {
          is_same = is_same && reshaped[use.chain] == borders.chains[use.chain].places;
        }
        changed[i].rings[ring] =
            joined_chains(chained.rings[ring], reshaped, is_closed(chained.object->kind));
      }
      if (is_same) {
        changed[i] = *chained.object;
      } else if (!is_as_sound(*chained.object, changed[i])) {
        for (const auto& ring : chained.rings) {
          for (const ChainUse& use : ring) weaker.insert(use.chain);
        }
      }
    }
    for (const std::size_t chain : weaker) {
      if (strengths[chain] + 1 >= kStrengths.size()) continue;
      ++strengths[chain];
      apply(chain);
      is_sound = false;
    }
    // All that have one of these are looked at once more.
    for (std::size_t i = 0; i < borders.objects.size(); ++i) {
      for (const auto& ring : borders.objects[i].rings) {
        for (const ChainUse& use : ring) {
          if (weaker.count(use.chain) > 0) is_done[i] = false;
        }
      }
    }
  }
  EditBuilder builder(document, title);
  for (const LabelObject& object : changed) builder.change(object.id).rings = object.rings;
  return builder.edit();
}

}  // namespace nadir
