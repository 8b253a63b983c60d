// SPDX-License-Identifier: Apache-2.0
// Drags over labels: strokes, boxes, what is moved.
#include <algorithm>

#include "core/desk/object_index.h"
#include "widgets/panels/label_gestures.h"
#include "widgets/panels/picture_area.h"

namespace nadir {
Eigen::Vector2d LabelGestures::dragged_to() const {
  Eigen::Vector2d mouse = under_mouse();
  if (!desk_.tool().snaps) return mouse;
  const auto snap = desk_.snap_dragged(mouse, reach_m());
  return snap ? snap->in_enu_m : mouse;
}

void LabelGestures::drag() {
  const bool is_left = area_.drag && area_.drag->button == kit::MouseButton::kLeft;
  if (!is_left) {
    state_ = {};
    return;
  }
  if (!takes_drags()) return;
  if (area_.drag->was_started) {
    begin_drag(camera_.enu_from_page(middle_of_pixel(area_.drag->start), where_));
  }
  if (state_.holds == LabelDragState::Holds::kStroke) add_to_stroke();
  if (area_.drag->was_released) end_drag();
}

void LabelGestures::begin_drag(const Eigen::Vector2d& start_in_enu_m) {
  using Holds = LabelDragState::Holds;
  state_ = {};
  state_.from_in_enu_m = start_in_enu_m;
  if (draws_freely(desk_.tool().kind)) {
    state_.holds = Holds::kStroke;
    asked_.emplace_back(actions::AddPlace{start_in_enu_m.x(), start_in_enu_m.y(), {}, {}});
    return;
  }
  state_.holds = Holds::kBox;
  if (how() != SelectHow::kInstead) return;
  if (desk_.tool().kind == ToolKind::kVertices) {
    const auto corner = selected_corner_at(desk_, start_in_enu_m, reach_m());
    if (!corner) return;
    const bool is_picked = std::any_of(desk_.picked().begin(), desk_.picked().end(),
                                       [&](const PickedVertex& one) { return one.at == *corner; });
    state_.vertex = *corner;
    state_.from_in_enu_m =
        desk_.sheet().now().object(corner->object)->rings[corner->ring][corner->place];
    // One of several that were picked takes the others along.
    state_.holds = is_picked && desk_.picked().size() > 1 ? Holds::kObjects : Holds::kVertex;
    return;
  }
  const auto below =
      objects_at(desk_.sheet().now(), desk_.sheet().objects(), start_in_enu_m, reach_m());
  const bool is_on_selected = std::any_of(
      below.begin(), below.end(), [&](ObjectId id) { return desk_.selection().contains(id); });
  if (is_on_selected) state_.holds = Holds::kObjects;
}

void LabelGestures::add_to_stroke() {
  const Eigen::Vector2d place = under_mouse();
  // Nearer to each other than that nobody sees a difference.
  const double least_m = std::max(0.5 * camera_.metres_per_px, 0.05 * brush_m().value_or(0.0));
  if ((place - state_.from_in_enu_m).norm() < least_m) return;
  state_.from_in_enu_m = place;
  asked_.emplace_back(actions::AddPlace{place.x(), place.y(), {}, {}});
}

void LabelGestures::end_drag() {
  using Holds = LabelDragState::Holds;
  const LabelDragState held = std::exchange(state_, {});
  switch (held.holds) {
    case Holds::kNothing:
      return;
    case Holds::kStroke:
      // Escape has dropped its places.
      if (!desk_.points().empty() || !asked_.empty()) asked_.emplace_back(actions::FinishTool{});
      return;
    case Holds::kBox: {
      const Eigen::Vector2d to = under_mouse();
      const Eigen::Vector2d low = held.from_in_enu_m.cwiseMin(to);
      const Eigen::Vector2d high = held.from_in_enu_m.cwiseMax(to);
      asked_.emplace_back(actions::SelectBox{low.x(), low.y(), high.x(), high.y(), how()});
      return;
    }
    case Holds::kObjects: {
      const Eigen::Vector2d by_m = dragged_to() - held.from_in_enu_m;
      asked_.emplace_back(actions::MoveLabels{by_m.x(), by_m.y()});
      return;
    }
    case Holds::kVertex: {
      const Eigen::Vector2d to = dragged_to();
      asked_.emplace_back(actions::MoveVertex{held.vertex.object,
                                              static_cast<int>(held.vertex.ring),
                                              static_cast<int>(held.vertex.place), to.x(), to.y()});
      return;
    }
  }
}

}  // namespace nadir
