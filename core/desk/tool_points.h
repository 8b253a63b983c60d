// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "core/base/angle.h"
#include "core/desk/label_tool.h"
#include "core/edit/snapping.h"

namespace nadir {

/// Where the next place would be, and what it would hold on to.
struct ToolPoint {
  Eigen::Vector2d in_enu_m = Eigen::Vector2d::Zero();
  std::optional<Snap> snap;
  bool closes = false;  ///< It is the first place again, so that a ring is done.
};

/// Numbers typed for the next place; what is not typed follows the hand.
struct TypedLeg {
  std::optional<double> length_m;     ///< From the last place; of a circle its radius.
  std::optional<double> bearing_deg;  ///< Clockwise from north.
  bool is_turn = false;               ///< The bearing is counted from the last leg's, to the right.
  [[nodiscard]] bool empty() const { return !length_m && !bearing_deg; }
};

/// A way over the ground, or around a piece of it.
struct MeasuredWay {
  double length_m = 0.0;                 ///< Along all legs.
  std::optional<double> leg_m, leg_deg;  ///< Of the last leg; clockwise from north.
  std::optional<double> area_m2;         ///< Around it, from three places on.
};

/// The places that a tool at work has got, and those that were taken back.
class ToolPoints {
 public:
  [[nodiscard]] const std::vector<ToolPoint>& all() const { return points_; }
  [[nodiscard]] Ring ring() const;
  [[nodiscard]] bool empty() const { return points_.empty(); }
  [[nodiscard]] std::size_t size() const { return points_.size(); }
  [[nodiscard]] const TypedLeg& typed() const { return typed_; }

  void add(const ToolPoint& point);
  void type(const TypedLeg& leg) { typed_ = leg; }
  [[nodiscard]] bool can_give_again() const { return !taken_back_.empty(); }
  void take_back();   ///< The last one. @pre not empty().
  void give_again();  ///< @pre can_give_again().
  void clear();

  /// Where a place under the hand would come: what is typed counts most, then the ring's own beginning, corners, edges, and
  /// what continues the last leg or is square to it. On the lattice of polygon_algebra.h, but for corners, which are taken to
  /// the last bit.
  /// @param reach_m  How far it may be drawn; 0: not at all.
  [[nodiscard]] ToolPoint aim(const LabelTool& tool,
                              const SnapIndex& index,
                              const Eigen::Vector2d& hand_in_enu_m,
                              double reach_m) const;

 private:
  std::vector<ToolPoint> points_, taken_back_;
  TypedLeg typed_;
};

/// Along the places as they are given; around them, if need be, back to the first.
[[nodiscard]] MeasuredWay measured_way(const Ring& places);

/// The first edge from the first place to the second, as far to the side as the third is.
[[nodiscard]] Ring rectangle_of(const Ring& places);

}  // namespace nadir
