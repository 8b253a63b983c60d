// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "widgets/kit/ui_canvas.h"
#include "widgets/kit/ui_frame.h"

namespace nadir::kit {
namespace {

constexpr ImGuiWindowFlags kBare = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                   ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav |
                                   ImGuiWindowFlags_NoFocusOnAppearing;

ImU32 colour_of(Surface surface, const Look& look) {
  switch (surface) {
    case Surface::kWindow:
      return look.window;
    case Surface::kPanel:
      return look.panel;
    case Surface::kRaised:
      return look.raised;
    case Surface::kPlate:
      return look.plate;
    case Surface::kNone:
      break;
  }
  return 0;
}

constexpr double kSplitterStep = 16.0;  ///< Of one press of an arrow.

/// Popups that it opened stay above it.
void bring_to_front() {
  if (ImGui::GetCurrentContext()->OpenPopupStack.Size == 0)
    ImGui::BringWindowToDisplayFront(ImGui::GetCurrentWindow());
}

}  // namespace

Scope Ui::region(const std::string& name, const Rect& rect, const RegionStyle& style) {
  Frame& frame = *frame_;
  ImGuiWindowFlags flags = kBare;
  if (!style.is_above) flags |= ImGuiWindowFlags_NoBringToFrontOnFocus;
  if (style.surface == Surface::kNone) flags |= ImGuiWindowFlags_NoBackground;
  if (!style.takes_input) flags |= ImGuiWindowFlags_NoInputs;
  if (!style.has_scroll) flags |= ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse;
  const float padding = style.padding < 0.0 ? frame.d(12) : narrow(style.padding);
  ImGui::SetNextWindowPos({narrow(rect.left), narrow(rect.top)});
  ImGui::SetNextWindowSize({narrow(std::max(1.0, rect.width)), narrow(std::max(1.0, rect.height))});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(padding, padding));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, style.has_border ? 1.0F : 0.0F);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, style.is_above ? frame.d(4) : 0.0F);
  ImGui::PushStyleColor(ImGuiCol_WindowBg, colour_of(style.surface, frame.state.look));
  const std::string window_name = "region/" + frame.prefix + name;
  ImGui::Begin(window_name.c_str(), nullptr, flags);
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(3);
  // Dear ImGui puts new windows that stay where they are below all others.
  if (style.is_above || ImGui::IsWindowAppearing()) bring_to_front();
  if (!name.empty()) frame.note(ControlKind::kRegion, name, box_of(rect));
  const std::size_t length = frame.prefix.size();
  if (!name.empty()) frame.prefix += name + "/";
  return {true, [&frame, length] {
            ImGui::End();
            frame.prefix.resize(length);
          }};
}

Overlay Ui::overlay(const std::string& name, const OverlayStyle& style) {
  Frame& frame = *frame_;
  const Rect whole = screen();
  const int depth_before = std::exchange(frame.box_depth, ++frame.boxes);
  frame.top_layer = std::max(frame.top_layer, kLayersOfABox * frame.box_depth);
  const std::string window_name = "overlay/" + frame.prefix + name;
  ImGui::SetNextWindowPos({0.0F, 0.0F});
  ImGui::SetNextWindowSize({narrow(whole.width), narrow(whole.height)});
  ImGui::PushStyleColor(ImGuiCol_WindowBg, style.dims_rest ? frame.state.look.dimming : 0U);
  ImGui::Begin((window_name + "/dimmed").c_str(), nullptr, kBare | ImGuiWindowFlags_NoScrollbar);
  ImGui::PopStyleColor();
  bring_to_front();
  if (frame.lowest_box == nullptr) frame.lowest_box = ImGui::GetCurrentWindow();
  const bool was_clicked_beside = ImGui::IsWindowHovered() && ImGui::IsMouseClicked(0);
  ImGui::End();

  const float width = narrow(std::min(style.width, whole.width - 2.0 * frame.d(12)));
  const float height = narrow(std::min(style.height, whole.height - 2.0 * frame.d(12)));
  const bool is_upper = style.place == OverlayPlace::kUpperThird;
  ImGui::SetNextWindowPos({narrow(std::floor(whole.width / 2.0)),
                           narrow(std::floor(whole.height * (is_upper ? 0.14 : 0.5)))},
                          ImGuiCond_Always, {0.5F, is_upper ? 0.0F : 0.5F});
  ImGui::SetNextWindowSizeConstraints({width, 1.0F},
                                      {width, narrow(whole.height * (is_upper ? 0.8 : 0.94))});
  if (style.height > 0.0) ImGui::SetNextWindowSize({width, height});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(frame.d(16), frame.d(16)));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1.0F);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, frame.d(6));
  ImGui::Begin(window_name.c_str(), nullptr,
               kBare | (style.height > 0.0 ? 0 : ImGuiWindowFlags_AlwaysAutoResize));
  ImGui::PopStyleVar(3);
  bring_to_front();
  if (ImGui::IsWindowAppearing()) ImGui::SetWindowFocus();
  const ImGuiWindow* const window = ImGui::GetCurrentWindow();
  frame.note(ControlKind::kOverlay, name,
             {window->Pos, {window->Pos.x + window->Size.x, window->Pos.y + window->Size.y}});
  frame.box_places.push_back(window->Rect());
  frame.top_box = window->ID;
  const bool was_escaped = ImGui::GetCurrentContext()->OpenPopupStack.Size == 0 &&
                           ImGui::IsKeyPressed(static_cast<int>(Key::kEscape), false);
  const std::size_t length = frame.prefix.size();
  frame.prefix += name + "/";
  return {Scope(true,
                [&frame, length, depth_before] {
                  ImGui::End();
                  frame.prefix.resize(length);
                  frame.box_depth = depth_before;
                }),
          was_clicked_beside || was_escaped};
}

Scope Ui::scroll_area(const std::string& name, double height) {
  const Frame& frame = *frame_;
  ImGui::BeginChild(name.c_str(), {0.0F, narrow(height)}, false, ImGuiWindowFlags_NoNav);
  ImGuiWindow* const window = ImGui::GetCurrentWindow();
  if (window->ScrollbarY) {  // content does not touch the bar
    window->ContentRegionRect.Max.x -= frame.d(6);
    window->WorkRect.Max.x -= frame.d(6);
  }
  return {true, [] { ImGui::EndChild(); }};
}

Edit<double> Ui::splitter(const std::string& name,
                          const Rect& rect,
                          Axis axis,
                          double size,
                          double least,
                          double most,
                          bool grows_backwards) {
  Frame& frame = *frame_;
  ImGui::SetNextWindowPos({narrow(rect.left), narrow(rect.top)});
  ImGui::SetNextWindowSize({narrow(std::max(1.0, rect.width)), narrow(std::max(1.0, rect.height))});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0F, 0.0F));
  ImGui::Begin(("splitter/" + frame.prefix + name).c_str(), nullptr,
               kBare | ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoScrollbar |
                   ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::PopStyleVar();
  bring_to_front();
  Edit<double> edit =
      frame.drag_splitter(name, box_of(rect), axis, size, least, most, grows_backwards);
  ImGui::End();
  return edit;
}

Edit<double> Ui::splitter(const std::string& name, double size, double least, double most) {
  Frame& frame = *frame_;
  const ImVec2 at = ImGui::GetCurrentWindow()->DC.CursorPos;
  const ImRect box(at, {at.x + frame.room_width(), at.y + frame.d(8)});
  ImGui::ItemSize(box.GetSize());
  return frame.drag_splitter(name, box, Axis::kVertical, size, least, most, false);
}

Edit<double> Ui::Frame::drag_splitter(const std::string& name,
                                      const ImRect& box,
                                      Axis axis,
                                      double size,
                                      double least,
                                      double most,
                                      bool grows_backwards) {
  const ImGuiID id = ImGui::GetCurrentWindow()->GetID(name.c_str());
  add_part(box, id);
  const bool is_across = axis == Axis::kHorizontal;
  const Arrows arrows = is_across ? Arrows::kSideways : Arrows::kUpDown;
  const Pressed pressed =
      press(box, id, ImGuiButtonFlags_PressedOnClick | ImGuiButtonFlags_FlattenChildren,
            {.takes_press = false, .arrows = arrows, .is_handle = true});
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const double at = is_across ? mouse.x : mouse.y;
  Edit<double> edit;
  edit.value = size;
  if (pressed.was_clicked) {
    Draft& begun = begin_draft(id);
    begun.start_number = size;
    begun.number = at;
  }
  if (const Draft* const current = draft(id)) {
    const double moved = (at - current->number) * (grows_backwards ? -1.0 : 1.0);
    edit.value = std::clamp(current->start_number + moved, std::min(least, most), most);
    edit.is_changed = edit.value != size;
    edit.is_editing = pressed.is_held;
    if (!pressed.is_held) {
      edit.was_committed = edit.value != current->start_number;
      end_draft();
    }
  }
  if (const int steps = arrow_steps(id, arrows); steps != 0) {
    // The line goes where the arrow points: up is less of what lies above it.
    const double moved = (is_across == grows_backwards ? -1.0 : 1.0) * steps * d(kSplitterStep);
    edit.value = std::clamp(size + moved, std::min(least, most), std::max(least, most));
    edit.is_changed = edit.was_committed = edit.value != size;
  }
  if (pressed.is_hovered || pressed.is_held)
    ImGui::SetMouseCursor(is_across ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
  const bool is_lit = pressed.is_hovered || pressed.is_held;
  const ImVec2 middle = box.GetCenter();
  const float half = is_lit ? d(1) : 0.5F;
  const float x = std::floor(middle.x);
  const float y = std::floor(middle.y);
  const ImRect line = is_across
                          ? ImRect({x - half + 0.5F, box.Min.y}, {x + half + 0.5F, box.Max.y})
                          : ImRect({box.Min.x, y - half + 0.5F}, {box.Max.x, y + half + 0.5F});
  fill(line, is_lit ? state.look.accent : state.look.line, 0.0);
  note(ControlKind::kSplitter, name, box).value = fmt::format("{:.0f}", edit.value);
  return edit;
}

}  // namespace nadir::kit
