// SPDX-License-Identifier: Apache-2.0
// A map whose labels are drawn: what the hand does on it, and what lies over it.
#include <fmt/format.h>

#include "core/base/angle.h"
#include "core/desk/label_desk.h"
#include "widgets/panels/label_gestures.h"
#include "widgets/panels/label_overlay_model.h"
#include "widgets/panels/map_pane.h"
#include "widgets/views/label_objects_view.h"
#include "widgets/views/map_furniture.h"

namespace nadir {
namespace {

constexpr double kLabelTextPt = 12.0;

using Holds = LabelDragState::Holds;

/// What a drag that has begun is about to do.
void add_dragged(LabelOverlay& overlay,
                 const LabelDesk& desk,
                 const LabelGestures& hand,
                 const LabelDragState& state) {
  if (state.holds == Holds::kBox) {
    const Eigen::Vector2d &a = state.from_in_enu_m, b = hand.under_mouse();
    const Ring box = {a, {b.x(), a.y()}, b, {a.x(), b.y()}, a};
    overlay.coming.push_back({{box}, false, kUnclassified});
    return;
  }
  if (state.holds != Holds::kObjects && state.holds != Holds::kVertex) return;
  const Eigen::Vector2d to = hand.dragged_to();
  const Eigen::Vector2d by_m = to - state.from_in_enu_m;
  const auto objects =
      state.holds == Holds::kVertex ? desk.coming_vertex(state.vertex, to) : desk.coming_move(by_m);
  for (LabelOverlay::Coming& shape : coming_shapes(objects)) {
    overlay.coming.push_back(std::move(shape));
  }
  overlay.words.push_back({state.from_in_enu_m, to, fmt::format("{:.2f} m", by_m.norm()), true});
}

}  // namespace

void MapPaneView::handle_label_gestures() {
  const LabelDesk& desk = *model_.labels;
  if (area_.is_hovered) {
    state_.readout = map_readout(under_mouse(), nullptr, model_.plane ? &*model_.plane : nullptr);
    const UnderPlace below = desk.under(under_mouse());
    state_.readout->class_name =
        below.is_on_grid ? std::string(class_info(below.class_id).name) : "off the map";
    if (below.is_on_grid) state_.readout->class_id = below.class_id;
    if (area_.wheel.y() != 0.0) zoom_by_wheel();
  }
  LabelGestures hand(ui_, area_, desk, camera_, where_, state_.label_drag);
  const bool is_left = area_.drag && area_.drag->button == kit::MouseButton::kLeft;
  if (!is_left || !hand.takes_drags()) drag();
  for (Action& action : hand.handle()) asked_.push_back(std::move(action));
  const bool opens_menu = area_.clicked == kit::MouseButton::kRight && desk.points().empty();
  if (opens_menu) state_.menu_in_enu_m = under_mouse();
}

void MapPaneView::draw_label_content() {
  const LabelDesk& desk = *model_.labels;
  Canvas& canvas = ui_.canvas();
  canvas.fill(corners_of(area_.page()), ui_.theme().window);
  MapGround ground;
  ground.camera = camera_;
  ground.width_px = static_cast<int>(where_.width);
  ground.height_px = static_cast<int>(where_.height);
  ground.is_of_labels = true;
  draw_ground(ground);
  const MapFrame frame{where_, camera_, ui_.px(96.0 / 72.0)};
  const LabelGestures hand(ui_, area_, desk, camera_, where_, state_.label_drag);
  const bool is_free = state_.label_drag.holds == Holds::kNothing;
  const bool follows = area_.is_hovered && (is_free || state_.label_drag.holds == Holds::kStroke);
  LabelOverlay overlay = label_overlay_of(
      desk, follows ? std::optional(LabelHand{hand.under_mouse(), hand.reach_m()}) : std::nullopt);
  add_dragged(overlay, desk, hand, state_.label_drag);
  draw_label_overlay(canvas, frame, overlay, ui_.theme());
  MapFrame sharp = frame;
  sharp.px_per_pt = ui_.px(kLabelTextPt) / kScaleBarTextPt;
  draw_scale_bar(canvas, sharp, ui_.theme());
  draw_north_arrow(canvas, frame, ui_.theme());
  state_.room = {where_.width / where_.height, 0.0, 0.0, 0.0, 0.0};
}

}  // namespace nadir
