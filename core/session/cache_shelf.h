// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <memory>
#include <set>
#include <utility>

namespace nadir::detail {

/// Decoded items of one kind by their index, with what they weigh. Not for several threads at once.
template <typename Item>
class CacheShelf {
 public:
  [[nodiscard]] std::shared_ptr<const Item> find(std::size_t index) const {
    const auto found = items_.find(index);
    return found == items_.end() ? nullptr : found->second.item;
  }
  /// The nearest item that is at most `reach` away, of two the earlier one.
  [[nodiscard]] std::shared_ptr<const Item> nearest(std::size_t index, std::size_t reach) const {
    std::shared_ptr<const Item> best;
    std::size_t best_away = reach;
    auto after = items_.lower_bound(index);
    if (after != items_.end() && after->first - index <= reach) {
      best = after->second.item;
      best_away = after->first - index;
    }
    if (after != items_.begin()) {
      --after;
      if (index - after->first <= best_away) best = after->second.item;
    }
    return best;
  }
  /// Whether there is nothing left to do for it: it is there, it is broken, or it found no room.
  [[nodiscard]] bool is_settled(std::size_t index) const {
    return items_.count(index) > 0 || broken_.count(index) > 0 || without_room_.count(index) > 0;
  }
  void mark_broken(std::size_t index) { broken_.insert(index); }
  void forget_broken() { broken_.clear(); }

  /// Puts an item there, then drops those that are farthest until the others fit into the budget; one at distance 0
  /// always stays. What found no room itself is remembered until forget_room().
  /// @param distance  Of an index from where somebody looks; 0 there.
  template <typename Distance>
  void put(std::size_t index,
           std::shared_ptr<const Item> item,
           std::size_t bytes,
           std::size_t budget,
           const Distance& distance) {
    largest_ = std::max(largest_, bytes);
    used_ += bytes;
    items_[index] = {std::move(item), bytes};
    shrink(budget, distance);
    if (items_.count(index) == 0) without_room_.insert(index);
  }
  template <typename Distance>
  void shrink(std::size_t budget, const Distance& distance) {
    while (used_ > budget) {
      const auto farthest = find_farthest(distance);
      if (farthest == items_.end() || distance(farthest->first) == 0) return;
      used_ -= farthest->second.bytes;
      items_.erase(farthest);
    }
  }
  /// Whether one more item at a distance would stay: there is room, or something farther away to drop.
  template <typename Distance>
  [[nodiscard]] bool has_room(std::size_t budget,
                              std::size_t at_distance,
                              const Distance& distance) const {
    if (used_ + largest_ <= budget) return true;
    const auto farthest = find_farthest(distance);
    return farthest != items_.end() && distance(farthest->first) > at_distance;
  }
  void forget_room() { without_room_.clear(); }
  void clear() { *this = CacheShelf(); }
  [[nodiscard]] std::size_t used() const { return used_; }

 private:
  struct Entry {
    std::shared_ptr<const Item> item;
    std::size_t bytes = 0;
  };

  /// Distances rise to both sides of where somebody looks, so it is the first item or the last.
  template <typename Distance, typename Items>
  static auto farthest_of(Items& items, const Distance& distance) {
    if (items.empty()) return items.end();
    const auto first = items.begin();
    const auto last = std::prev(items.end());
    return distance(first->first) > distance(last->first) ? first : last;
  }
  template <typename Distance>
  auto find_farthest(const Distance& distance) {
    return farthest_of(items_, distance);
  }
  template <typename Distance>
  auto find_farthest(const Distance& distance) const {
    return farthest_of(items_, distance);
  }

  std::map<std::size_t, Entry> items_;
  std::set<std::size_t> broken_, without_room_;
  std::size_t used_ = 0;
  std::size_t largest_ = 0;  ///< Of all so far: what the next one may weigh.
};

}  // namespace nadir::detail
