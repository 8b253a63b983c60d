// SPDX-License-Identifier: Apache-2.0
#include "core/edit/box_tree.h"

#include <numeric>
#include <utility>

namespace nadir {

BoxTree::BoxTree(std::vector<PlaneBounds> boxes) : boxes_(std::move(boxes)), order_(boxes_.size()) {
  if (boxes_.empty()) return;
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  sort(0, order_.size());
  std::vector<PlaneBounds> leaves((order_.size() + kLeaf - 1) / kLeaf);
  const auto take_in = [](PlaneBounds& around, const PlaneBounds& box) {
    if (box.is_empty) return;
    around.include(box.low);
    around.include(box.high);
  };
  for (std::size_t i = 0; i < order_.size(); ++i) take_in(leaves[i / kLeaf], boxes_[order_[i]]);
  levels_.push_back(std::move(leaves));
  while (levels_.back().size() > 1) {
    const std::vector<PlaneBounds>& below = levels_.back();
    std::vector<PlaneBounds> level((below.size() + 1) / 2);
    for (std::size_t i = 0; i < below.size(); ++i) take_in(level[i / 2], below[i]);
    levels_.push_back(std::move(level));
  }
}

/// Puts each half of a range on its side of where its middles are spread most, and so on down to a leaf.
void BoxTree::sort(std::size_t begin, std::size_t end) {
  if (end - begin <= kLeaf) return;
  // Halves begin where nodes do.
  std::size_t half = kLeaf;
  while (2 * half < end - begin) half *= 2;
  const auto twice_middle = [&](std::size_t number) -> Eigen::Vector2d {
    return boxes_[number].low + boxes_[number].high;
  };
  PlaneBounds spread;
  for (std::size_t i = begin; i < end; ++i) spread.include(twice_middle(order_[i]));
  const Eigen::Vector2d sides = spread.high - spread.low;
  const int axis = sides.x() >= sides.y() ? 0 : 1;
  const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(begin), at(begin + half), at(end), [&](std::size_t a, std::size_t b) {
    const double of_a = twice_middle(a)[axis];
    const double of_b = twice_middle(b)[axis];
    return of_a < of_b || (of_a == of_b && a < b);
  });
  sort(begin, begin + half);
  sort(begin + half, end);
}

}  // namespace nadir
