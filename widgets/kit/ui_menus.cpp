// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "core/base/require.h"
#include "widgets/kit/ui_canvas.h"
#include "widgets/kit/ui_frame.h"

namespace nadir::kit {
namespace {

constexpr double kMenuWidth = 220.0;

}  // namespace

/// A popup with this name, if it is open. Its scope ends it.
Scope Ui::Frame::open_popup(ImGuiID id, const std::string& name) {
  if (!ImGui::IsPopupOpen(id, ImGuiPopupFlags_None)) {
    ImGui::GetCurrentContext()->NextWindowData.ClearFlags();
    return {};
  }
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(d(4), d(4)));
  const bool is_open = ImGui::BeginPopupEx(
      id, ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoTitleBar |
              ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoNav);
  ImGui::PopStyleVar();
  if (!is_open) return {};
  is_same_line = false;
  const std::size_t length = prefix.size();
  prefix += name + "/";
  ImGui::ItemSize({narrow(kMenuWidth * state.scale), 0.0F});
  return {true, [this, length] {
            prefix.resize(length);
            ImGui::EndPopup();
          }};
}

Scope Ui::menu_bar() {
  frame_->is_in_menu_bar = true;
  return {true, [this] { frame_->is_in_menu_bar = false; }};
}

Scope Ui::menu(const std::string& label) {
  Frame& frame = *frame_;
  const Look& colours = frame.state.look;
  const std::string words = Frame::shown(label);
  const bool is_bar = frame.is_in_menu_bar && frame.menu_depth == 0;
  ImFont* const font = frame.state.fonts->text;
  const float own = std::ceil(frame.text_size(words, font).x);
  if (is_bar && frame.has_bar_menu) same_line(0.0);
  const Placed placed = frame.place(
      label,
      {is_bar ? own + 2.0F * frame.d(10) : std::max(frame.room_width(), own + frame.d(64)),
       frame.d(28)},
      0.0F);
  if (is_bar) frame.has_bar_menu = true;
  const Stop stop{.arrows = is_bar ? Arrows::kSideways : Arrows::kUpDown,
                  .group = ImGui::GetCurrentWindow()->GetID(is_bar ? "##bar" : "##items"),
                  .opens_down = is_bar,
                  .opens_menu = !is_bar};
  const Pressed pressed = frame.press(placed, 0, stop);
  const bool was_opened = pressed.was_clicked || frame.state.focus.wanted_menu == placed.id ||
                          (is_bar ? frame.arrow_steps(placed.id, Arrows::kUpDown) != 0
                                  : frame.arrow_steps(placed.id, Arrows::kSideways) > 0);
  const ImGuiID popup = ImHashStr("##menu", 0, placed.id);
  const ImGuiContext& imgui = *ImGui::GetCurrentContext();
  bool is_open = ImGui::IsPopupOpen(popup, ImGuiPopupFlags_None);
  const bool is_mouse_over = ImGui::IsMouseHoveringRect(placed.box.Min, placed.box.Max) &&
                             imgui.HoveredWindow == imgui.CurrentWindow;
  const bool is_sibling_open = !is_open && imgui.OpenPopupStack.Size > imgui.BeginPopupStack.Size &&
                               frame.state.open_bar == imgui.CurrentWindow->ID;
  if (!frame.is_disabled() && ((was_opened && !is_open) ||
                               (is_mouse_over && !is_open && (is_bar ? is_sibling_open : true)))) {
    ImGui::OpenPopupEx(popup, ImGuiPopupFlags_None);
    frame.state.open_bar = imgui.CurrentWindow->ID;
    is_open = true;
  }
  if (is_open || pressed.is_hovered)
    frame.fill(placed.box, is_open ? colours.accent_soft : colours.hovered);
  ImRect inside = placed.box;
  inside.Expand({-frame.d(10), 0.0F});
  if (is_bar) {
    frame.write_in({inside.Min, {inside.Max.x + 1.0F, inside.Max.y}}, words, font,
                   frame.shade(colours.text));
  } else {
    inside.Min.x += frame.d(18);
    frame.write_in(inside, words, font, frame.shade(colours.text));
    frame.write_icon({{placed.box.Max.x - frame.d(24), placed.box.Min.y}, placed.box.Max},
                     Icon::kCaretRight, frame.shade(colours.muted));
  }
  frame.note(ControlKind::kMenu, label, placed.box).value = is_open ? "open" : "closed";
  if (!is_open) return {};
  ImGui::SetNextWindowPos(is_bar ? ImVec2(placed.box.Min.x, placed.box.Max.y + frame.d(2))
                                 : ImVec2(placed.box.Max.x, placed.box.Min.y - frame.d(4)));
  Scope popup_scope = frame.open_popup(popup, label);
  if (!popup_scope) return {};
  ++frame.menu_depth;
  return {true, [&frame, inner = std::make_shared<Scope>(std::move(popup_scope))]() mutable {
            --frame.menu_depth;
            inner.reset();
          }};
}

bool Ui::menu_item(const std::string& label, const MenuItem& item) {
  Frame& frame = *frame_;
  const Look& colours = frame.state.look;
  const Scope maybe_disabled = disabled(!item.disabled_because.empty(), item.disabled_because);
  const std::string words = Frame::shown(label);
  const float shortcut =
      item.shortcut.empty()
          ? 0.0F
          : frame.text_size(item.shortcut, frame.state.fonts->text).x + frame.d(24);
  const float own = std::ceil(frame.text_size(words, frame.state.fonts->text).x + shortcut) +
                    frame.d(28) + frame.d(12);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  Placed placed = frame.place(label, {own, frame.d(28)}, 0.0F);
  placed.box.Max.x = placed.field.Max.x =
      std::max(placed.box.Max.x, at.x + ImGui::GetContentRegionAvail().x);
  frame.add_part(placed.box, placed.id);
  const Stop stop{.arrows = Arrows::kUpDown, .group = ImGui::GetCurrentWindow()->GetID("##items")};
  const Pressed pressed = frame.press(placed, 0, stop);
  if (pressed.is_hovered || pressed.is_held) frame.fill(placed.box, colours.accent_soft);
  const ImRect mark({placed.box.Min.x + frame.d(4), placed.box.Min.y},
                    {placed.box.Min.x + frame.d(24), placed.box.Max.y});
  const Icon icon = item.is_checked ? Icon::kCheck : item.icon;
  if (icon != Icon::kNone)
    frame.write_icon(mark, icon, frame.shade(item.is_checked ? colours.accent : colours.muted));
  ImRect inside({placed.box.Min.x + frame.d(28), placed.box.Min.y},
                {placed.box.Max.x - frame.d(10), placed.box.Max.y});
  if (!item.shortcut.empty())
    frame.write_in(inside, item.shortcut, frame.state.fonts->text, frame.shade(colours.muted),
                   Align::kRight);
  inside.Max.x -= shortcut;
  frame.write_in({inside.Min, {inside.Max.x + 2.0F, inside.Max.y}}, words, frame.state.fonts->text,
                 frame.shade(colours.text));
  Control& control = frame.note(ControlKind::kMenuItem, label, placed.box);
  control.value = item.shortcut;
  control.is_selected = item.is_checked;
  if (!item.hint.empty() || !item.disabled_because.empty()) frame.explain({item.hint, ""});
  if (pressed.was_clicked) {
    // The whole chain of menus goes, whichever this one hangs on.
    ImGui::ClosePopupToLevel(0, true);
  }
  return pressed.was_clicked;
}

void Ui::menu_line() {
  Frame& frame = *frame_;
  frame.is_same_line = false;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float y = std::floor(at.y + frame.d(4));
  frame.fill({{at.x, y}, {at.x + ImGui::GetContentRegionAvail().x, y + 1.0F}},
             frame.state.look.line, 0.0);
  ImGui::ItemSize({0.0F, 2.0F * frame.d(4) + 1.0F});
}

void Ui::opens_context_menu(const std::string& name) {
  Frame& frame = *frame_;
  if (frame.is_disabled()) return;
  const ImGuiID popup = ImGui::GetCurrentWindow()->GetID(name.c_str());
  const bool is_asked = frame.state.input.modifiers == Modifiers{.shift = true} &&
                        ImGui::IsKeyPressed(static_cast<int>(Key::kF10), false);
  const bool is_by_key = is_asked && frame.has_focus(frame.last_id);
  if (!is_by_key && !(frame.is_last_hovered && frame.right_clicked())) return;
  ImGui::OpenPopupEx(popup, ImGuiPopupFlags_None);
  if (is_by_key) frame.menu_by_key = {popup, {frame.last_box.Min.x, frame.last_box.Max.y}};
}

Scope Ui::context_menu(const std::string& name) {
  Frame& frame = *frame_;
  const ImGuiID popup = ImGui::GetCurrentWindow()->GetID(name.c_str());
  opens_context_menu(name);
  if (frame.menu_by_key.first == popup) {  // there is no mouse that it could open at
    ImGui::SetNextWindowPos(frame.menu_by_key.second);
    frame.menu_by_key = {};
  }
  return frame.open_popup(popup, name);
}

Scope Ui::button_menu(const std::string& name, Icon icon, const Hint& hint) {
  Frame& frame = *frame_;
  const ImGuiID popup = ImHashStr("##menu", 0, ImGui::GetCurrentWindow()->GetID(name.c_str()));
  const bool was_open = ImGui::IsPopupOpen(popup, ImGuiPopupFlags_None);
  const bool was_clicked = icon_button(name, icon, hint, was_open);
  Control& control = frame.controls.back();
  control.kind = ControlKind::kMenu;
  control.value = was_open ? "open" : "closed";
  if (was_clicked && !was_open) ImGui::OpenPopupEx(popup, ImGuiPopupFlags_None);
  // To the side where there is room.
  const ImRect& box = frame.last_box;
  const bool opens_left = box.GetCenter().x > narrow(screen().width) / 2.0F;
  const bool opens_up = box.GetCenter().y > narrow(screen().height) / 2.0F;
  ImGui::SetNextWindowPos({opens_left ? box.Max.x : box.Min.x,
                           opens_up ? box.Min.y - frame.d(2) : box.Max.y + frame.d(2)},
                          ImGuiCond_Always, {opens_left ? 1.0F : 0.0F, opens_up ? 1.0F : 0.0F});
  return frame.open_popup(popup, name);
}

}  // namespace nadir::kit
