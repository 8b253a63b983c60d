// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "core/base/require.h"
#include "widgets/kit/ui_canvas.h"
#include "widgets/kit/ui_frame.h"

namespace nadir::kit {
namespace {

constexpr float kAreaDragThreshold = 4.0F;

Eigen::Vector2d on_page(const ImVec2& point, const ImRect& box) {
  return {static_cast<double>(point.x) - box.Min.x, static_cast<double>(box.Max.y) - point.y};
}

}  // namespace

/// What the button does that went down in this area, or goes down now.
void Ui::Frame::follow_press(const ImRect& box, ImGuiID id, AreaInput& input) {
  const ImGuiIO& io = ImGui::GetIO();
  AreaPress& press_now = state.area_press;
  if (input.is_hovered && press_now.id == 0 && !is_disabled()) {
    for (const MouseButton button :
         {MouseButton::kLeft, MouseButton::kRight, MouseButton::kMiddle}) {
      if (!ImGui::IsMouseClicked(static_cast<int>(button))) continue;
      press_now = {id, button, io.MousePos, false,
                   ImGui::IsMouseDoubleClicked(static_cast<int>(button))};
      input.pressed = button;
      break;
    }
  }
  if (press_now.id != id) return;
  const auto button = static_cast<int>(press_now.button);
  const bool is_down = ImGui::IsMouseDown(button);
  const ImVec2 total(io.MousePos.x - press_now.start.x, io.MousePos.y - press_now.start.y);
  const bool was_drag = press_now.is_drag;
  if (std::max(std::abs(total.x), std::abs(total.y)) >= kAreaDragThreshold)
    press_now.is_drag = true;
  if (press_now.is_drag) {
    AreaDrag drag;
    drag.button = press_now.button;
    drag.start = on_page(press_now.start, box);
    drag.total = {total.x, -total.y};
    drag.was_started = !was_drag;
    drag.delta = drag.was_started ? drag.total : Eigen::Vector2d(io.MouseDelta.x, -io.MouseDelta.y);
    drag.was_released = !is_down;
    input.drag = drag;
  } else if (!is_down && box.Contains(io.MousePos)) {
    input.clicked = press_now.button;
    if (press_now.is_second) input.double_clicked = press_now.button;
  }
  if (!is_down) press_now = {};
}

AreaInput Ui::area(const std::string& name, const Eigen::Vector2d& size, Wheel wheel) {
  Frame& frame = *frame_;
  const Rect left = room();
  const ImVec2 taken(narrow(size.x() > 0.0 ? size.x() : std::max(1.0, left.width)),
                     narrow(size.y() > 0.0 ? size.y() : std::max(1.0, left.height)));
  const Placed placed = frame.place(name, taken, 0.0F);
  frame.press(placed,
              ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                  ImGuiButtonFlags_MouseButtonMiddle | ImGuiButtonFlags_AllowItemOverlap,
              {.is_stop = false});
  ImGui::SetItemAllowOverlap();
  const ImGuiIO& io = ImGui::GetIO();
  AreaInput input;
  input.rect = rect_of(placed.box);
  input.is_hovered = frame.is_last_hovered && !frame.is_disabled();
  input.mouse =
      ImGui::IsMousePosValid() ? on_page(io.MousePos, placed.box) : Eigen::Vector2d(-1.0, -1.0);
  input.modifiers = frame.state.input.modifiers;
  if (input.is_hovered) {
    if (wheel == Wheel::kOwn) {
      ImGui::SetItemUsingMouseWheel();
      input.wheel = {io.MouseWheelH, io.MouseWheel};
    }
    frame.state.hovered_area = placed.id;
  } else if (frame.state.hovered_area == placed.id) {
    frame.state.hovered_area = 0;
  }
  frame.follow_press(placed.box, placed.id, input);
  frame.area = input.rect;
  frame.area_list = ImGui::GetWindowDrawList();
  frame.canvas.reset();
  frame.note(ControlKind::kArea, name, placed.box);
  return input;
}

Canvas& Ui::canvas() {
  Frame& frame = *frame_;
  NADIR_REQUIRE(frame.area_list != nullptr);
  if (!frame.canvas)
    frame.canvas = std::make_unique<UiCanvas>(*frame.area_list, frame.area, *frame.state.fonts,
                                              frame.state.pictures);
  return *frame.canvas;
}

void Ui::image(TextureId texture, bool is_bottom_row_first) {
  image(texture, {0.0, 0.0, frame_->area.width, frame_->area.height}, is_bottom_row_first);
}

void Ui::image(TextureId texture, const PageRect& where, bool is_bottom_row_first) {
  const Frame& frame = *frame_;
  NADIR_REQUIRE(frame.area_list != nullptr);
  const ImRect area = box_of(frame.area);
  const ImVec2 upper_left(area.Min.x + narrow(where.left), area.Max.y - narrow(where.top()));
  const ImVec2 lower_right(area.Min.x + narrow(where.right()), area.Max.y - narrow(where.bottom));
  frame.area_list->PushClipRect(area.Min, area.Max, true);
  frame.area_list->AddImage(UiPictures::texture_id(texture), upper_left, lower_right,
                            is_bottom_row_first ? ImVec2(0.0F, 1.0F) : ImVec2(0.0F, 0.0F),
                            is_bottom_row_first ? ImVec2(1.0F, 0.0F) : ImVec2(1.0F, 1.0F));
  frame.area_list->PopClipRect();
}

}  // namespace nadir::kit
