// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "core/edit/box_tree.h"
#include "core/edit/polygon_algebra.h"

namespace nadir {

/// How far rounding may put a place from a border, or from another place, that it was on.
inline constexpr double kTouchM = 2.0 * kLatticeM;

/// Places to be found near others. Private to this module.
class NearPlaces {
 public:
  /// O(n log n).
  explicit NearPlaces(std::vector<Eigen::Vector2d> places);

  /// Around all of them, wider by kTouchM.
  [[nodiscard]] const PlaneBounds& bounds() const { return bounds_; }
  template <typename Visit>
  void visit(const PlaneBounds& box, const Visit& visit) const {
    tree_.visit(box, [&](std::size_t number) { visit(places_[number]); });
  }
  /// The nearest within kTouchM; of equally near ones the one that lies_before() others.
  [[nodiscard]] std::optional<Eigen::Vector2d> nearest(const Eigen::Vector2d& place) const;
  /// Of those within kTouchM the one that lies_before() others, so that what is all within it gets one and the same.
  [[nodiscard]] std::optional<Eigen::Vector2d> first_near(const Eigen::Vector2d& place) const;

 private:
  std::vector<Eigen::Vector2d> places_;  ///< Sorted, each once.
  BoxTree tree_;
  PlaneBounds bounds_;
};

}  // namespace nadir
