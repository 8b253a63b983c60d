// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <limits>
#include <unordered_map>
#include <utility>

#include "core/edit/box_tree.h"
#include "core/edit/edit_builder.h"
#include "core/edit/edit_objects.h"

namespace nadir {
namespace {

/// Where an object stands while others move: the number of one that stays, and how far from that among those that were put
/// below it or above it.
using Standing = std::pair<std::int64_t, std::int64_t>;

/// All objects of a document from the lowest to the top-most, some of which are to move.
class DrawingOrder {
 public:
  DrawingOrder(const LabelDocument& document, std::span<const LabelObject* const> moving) {
    all_.reserve(document.objects().size());
    for (const auto& [id, placed] : document.objects()) all_.push_back(&placed);
    std::sort(all_.begin(), all_.end(), [](const PlacedObject* a, const PlacedObject* b) {
      return std::pair(a->object->order, a->object->id) <
             std::pair(b->object->order, b->object->id);
    });
    std::unordered_map<ObjectId, std::size_t> number_of;
    for (std::size_t i = 0; i < all_.size(); ++i) number_of[all_[i]->object->id] = i;
    moves_.resize(all_.size(), false);
    for (const LabelObject* const object : moving) {
      moving_.push_back(number_of.at(object->id));
      moves_[moving_.back()] = true;
    }
    std::sort(moving_.begin(), moving_.end());
    for (std::size_t i = 0; i < all_.size(); ++i) {
      standing_.emplace_back(static_cast<std::int64_t>(i), 0);
    }
  }

  /// Above or below all others, in the order that they have.
  void move_to_end(bool is_top) {
    // Are they there already?
    const std::size_t first = is_top ? all_.size() - moving_.size() : 0;
    if (moving_.front() == first && moving_.back() == first + moving_.size() - 1) return;
    const std::int64_t end = is_top ? static_cast<std::int64_t>(all_.size()) : -1;
    for (std::size_t i = 0; i < moving_.size(); ++i) {
      standing_[moving_[i]] = {end, static_cast<std::int64_t>(i)};
    }
  }

  /// Each past the next that its bounds meet, unless that moves too.
  void move_by_one(bool goes_up) {
    std::vector<PlaneBounds> boxes;
    boxes.reserve(all_.size());
    for (const PlacedObject* const placed : all_) boxes.push_back(placed->bounds);
    const BoxTree tree(std::move(boxes));
    const auto count = static_cast<std::int64_t>(moving_.size());
    for (std::int64_t i = 0; i < count; ++i) {
      // The foremost first, so that those behind it come to lie behind it again.
      const std::size_t number = moving_[static_cast<std::size_t>(goes_up ? count - 1 - i : i)];
      std::optional<std::size_t> next;
      tree.visit(all_[number]->bounds, [&](std::size_t other) {
        const bool is_ahead =
            goes_up ? standing_[other] > standing_[number] : standing_[other] < standing_[number];
        if (!is_ahead) return;
        const bool is_nearer = !next || (goes_up ? standing_[other] < standing_[*next]
                                                 : standing_[other] > standing_[*next]);
        if (is_nearer) next = other;
      });
      if (!next || moves_[*next]) continue;
      const auto passed = static_cast<std::int64_t>(*next);
      standing_[number] = {passed, goes_up ? count - i : i - count};
    }
  }

  /// Gives what has moved orders between those of what stays, as near as can be to what was passed; where there is no room,
  /// what lies above moves up. Calls `give(object, order)` for all that get another one.
  template <typename Give>
  void number(bool goes_up, const Give& give) const {
    std::vector<std::size_t> sequence(all_.size());
    for (std::size_t i = 0; i < sequence.size(); ++i) sequence[i] = i;
    std::sort(sequence.begin(), sequence.end(),
              [&](std::size_t a, std::size_t b) { return standing_[a] < standing_[b]; });
    // Far from where numbers end.
    constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max() / 4;
    const auto order_at = [&](std::size_t i) {
      return std::clamp(all_[sequence[i]]->object->order, -kMost, kMost);
    };
    const auto has_moved = [&](std::size_t i) {
      return standing_[sequence[i]] != Standing(static_cast<std::int64_t>(sequence[i]), 0);
    };
    const auto next_that_stays = [&](std::size_t i) {
      while (i < sequence.size() && has_moved(i)) ++i;
      return i;
    };
    std::optional<std::int64_t> below;
    for (std::size_t begin = 0; begin < sequence.size();) {
      if (!has_moved(begin)) {
        below = order_at(begin++);
        continue;
      }
      std::size_t end = next_that_stays(begin);
      std::int64_t step = step_between(below, end, order_at, end - begin, 1);
      const bool is_tight = step == 0;
      while (step == 0) {
        end = next_that_stays(end + 1);
        // Twice the room that is needed, so that the next time nothing else has to move.
        step = step_between(below, end, order_at, end - begin, 2);
      }
      const std::size_t count = end - begin;
      const bool counts_from_above = !below || (!goes_up && !is_tight && end < sequence.size());
      for (std::size_t i = 0; i < count; ++i) {
        const std::int64_t order = counts_from_above
                                       ? order_at(end) - step * static_cast<std::int64_t>(count - i)
                                       : *below + step * static_cast<std::int64_t>(i + 1);
        const LabelObject& object = *all_[sequence[begin + i]]->object;
        if (order != object.order) give(object, order);
      }
      if (below) below = *below + step * static_cast<std::int64_t>(count);
      begin = end;
    }
  }

 private:
  /// How far apart so many lie between two that stay; 0 where they have no room. At least one of both is there.
  template <typename OrderAt>
  [[nodiscard]] std::int64_t step_between(std::optional<std::int64_t> below,
                                          std::size_t end,
                                          const OrderAt& order_at,
                                          std::size_t count,
                                          std::int64_t least) const {
    if (!below || end == all_.size()) return kOrderStep;
    const std::int64_t step = (order_at(end) - *below) / static_cast<std::int64_t>(count + 1);
    return step < least ? 0 : std::min(step, kOrderStep);
  }

  std::vector<const PlacedObject*> all_;
  std::vector<std::size_t> moving_;  ///< Numbers of `all_`, rising.
  std::vector<bool> moves_;
  std::vector<Standing> standing_;
};

}  // namespace

Result<LabelEdit> reorder(const LabelDocument& document,
                          std::span<const ObjectId> objects,
                          OrderMove move) {
  const auto selected = selected_objects(document, objects);
  if (!selected) return forward_error(selected);
  const bool goes_up = move == OrderMove::kUp || move == OrderMove::kTop;
  DrawingOrder order(document, *selected);
  if (move == OrderMove::kUp || move == OrderMove::kDown) {
    order.move_by_one(goes_up);
  } else {
    order.move_to_end(goes_up);
  }
  constexpr std::array<const char*, 4> kTitles{"Raise", "Lower", "To the top", "To the bottom"};
  EditBuilder builder(document, kTitles.at(static_cast<std::size_t>(move)));
  order.number(goes_up, [&](const LabelObject& object, std::int64_t number) {
    builder.change(object.id).order = number;
  });
  return builder.edit();
}

}  // namespace nadir
