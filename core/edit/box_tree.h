// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "core/label/label_grid.h"

namespace nadir {

/// Rectangles by where they lie, for what is asked of tens of thousands of them at once. Private to core.
class BoxTree {
 public:
  /// O(n log n). @param boxes  Empty ones are never found.
  explicit BoxTree(std::vector<PlaneBounds> boxes);

  [[nodiscard]] std::size_t size() const { return boxes_.size(); }
  /// Around all of them.
  [[nodiscard]] PlaneBounds bounds() const {
    return levels_.empty() ? PlaneBounds() : levels_.back().front();
  }
  /// Calls `visit(number)` for all boxes that meet a rectangle, edges included, in an order that depends on the boxes alone.
  template <typename Visit>
  void visit(const PlaneBounds& box, const Visit& visit) const {
    if (!levels_.empty() && !box.is_empty) visit_node(levels_.size() - 1, 0, box, visit);
  }

 private:
  static constexpr std::size_t kLeaf = 8;  ///< Boxes.

  [[nodiscard]] static bool meet(const PlaneBounds& a, const PlaneBounds& b) {
    return !a.is_empty && (a.low.array() <= b.high.array()).all() &&
           (b.low.array() <= a.high.array()).all();
  }
  void sort(std::size_t begin, std::size_t end);
  template <typename Visit>
  void visit_node(std::size_t level,
                  std::size_t node,
                  const PlaneBounds& box,
                  const Visit& visit) const {
    if (!meet(levels_[level][node], box)) return;
    if (level == 0) {
      const std::size_t end = std::min(order_.size(), (node + 1) * kLeaf);
      for (std::size_t i = node * kLeaf; i < end; ++i) {
        if (meet(boxes_[order_[i]], box)) visit(order_[i]);
      }
      return;
    }
    const std::size_t end = std::min(levels_[level - 1].size(), 2 * node + 2);
    for (std::size_t i = 2 * node; i < end; ++i) visit_node(level - 1, i, box, visit);
  }

  std::vector<PlaneBounds> boxes_;
  std::vector<std::size_t> order_;                ///< Numbers of boxes, neighbours side by side.
  std::vector<std::vector<PlaneBounds>> levels_;  ///< Around eight, sixteen, ... all of them.
};

}  // namespace nadir
