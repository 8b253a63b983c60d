// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/desk/label_desk.h"
#include "core/session/action.h"
#include "widgets/kit/ui.h"
#include "widgets/views/map_camera.h"

namespace nadir {

/// What a hand holds while it drags over labels; kept from frame to frame, and gone when it lets go.
struct LabelDragState {
  enum class Holds { kNothing, kStroke, kBox, kObjects, kVertex };
  Holds holds = Holds::kNothing;
  Eigen::Vector2d from_in_enu_m = Eigen::Vector2d::Zero();
  VertexRef vertex;  ///< Of kVertex.
};

/// Understands what the mouse does on a map whose labels are drawn, for one frame. Points of the page are the area's.
class LabelGestures {
 public:
  /// @param camera, where  That the map is drawn with.
  LabelGestures(const kit::Ui& ui,
                const kit::AreaInput& area,
                const LabelDesk& desk,
                const MapCamera& camera,
                const PageRect& where,
                LabelDragState& state)
      : ui_(ui), area_(area), desk_(desk), camera_(camera), where_(where), state_(state) {}

  /// What was asked for in this frame.
  [[nodiscard]] Actions handle();
  /// Whether a drag of the left button belongs to the tool, and does not move the map.
  [[nodiscard]] bool takes_drags() const;
  /// How near is near: a few pixels on the ground.
  [[nodiscard]] double reach_m() const;
  [[nodiscard]] Eigen::Vector2d under_mouse() const;
  /// Where what is dragged would come now: the mouse, or what is near enough to hold on to.
  [[nodiscard]] Eigen::Vector2d dragged_to() const;
  /// Radius on the ground of the brush at work; nothing with other tools.
  [[nodiscard]] std::optional<double> brush_m() const;

 private:
  void click();
  void double_click();
  void change_brush();
  // label_drags.cpp
  void drag();
  void begin_drag(const Eigen::Vector2d& start_in_enu_m);
  void end_drag();
  void add_to_stroke();
  [[nodiscard]] SelectHow how() const;

  const kit::Ui& ui_;
  const kit::AreaInput& area_;
  const LabelDesk& desk_;
  const MapCamera& camera_;
  PageRect where_;
  LabelDragState& state_;
  Actions asked_;
};

/// The corner of what is selected that is nearest to a place, within reach.
[[nodiscard]] std::optional<VertexRef> selected_corner_at(const LabelDesk& desk,
                                                          const Eigen::Vector2d& place_in_enu_m,
                                                          double reach_m);

}  // namespace nadir
