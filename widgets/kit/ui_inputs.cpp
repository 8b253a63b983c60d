// SPDX-License-Identifier: Apache-2.0
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/utf8.h"
#include "widgets/kit/ui_canvas.h"
#include "widgets/kit/ui_frame.h"

namespace nadir::kit {

bool Ui::Frame::type_draft(
    const ImRect& box, ImGuiID id, const std::string& label, ImFont* the_font, int flags) {
  Draft& current = *draft(id);
  ImGuiContext& imgui = *ImGui::GetCurrentContext();
  // Somebody else was pressed in this frame, and drawn before; Dear ImGui would take the mouse away from that one.
  if (current.had_keyboard && imgui.ActiveId != id) return false;
  // Where there is no room for the field, Dear ImGui draws none and would miss it; it goes on when there is some again.
  if (imgui.CurrentWindow->SkipItems) return true;
  if (!current.had_keyboard) imgui.NavActivateId = imgui.NavActivateInputId = id;
  std::array<char, 4096> buffer = {};
  // Dear ImGui edits characters, and would replace bytes that are none: those of a file's name, say.
  utf8_of_bytes(current.text).copy(buffer.data(), buffer.size() - 1);
  ImGui::PushFont(the_font);
  ImGui::PushStyleVar(
      ImGuiStyleVar_FramePadding,
      ImVec2(d(6), std::floor((box.GetHeight() - the_font->FontSize) / 2.0F + 0.5F)));
  const ImVec2 cursor = imgui.CurrentWindow->DC.CursorPos;
  ImGui::TempInputText(box, id, ("##" + label).c_str(), buffer.data(),
                       static_cast<int>(buffer.size()), flags);
  imgui.CurrentWindow->DC.CursorPos = cursor;
  ImGui::PopStyleVar();
  ImGui::PopFont();
  const bool has_keyboard = imgui.ActiveId == id;
  current.text = bytes_of_utf8(buffer.data());
  if (has_keyboard) current.had_keyboard = true;
  return has_keyboard || !current.had_keyboard;
}

void Ui::Frame::put_caret_at_end(ImGuiID id) const {
  ImGuiInputTextState& typing = ImGui::GetCurrentContext()->InputTextState;
  if (typing.ID != id) return;
  typing.Stb.cursor = typing.Stb.select_start = typing.Stb.select_end = typing.CurLenW;
}

TextEdit Ui::Frame::edit_text(const ImRect& box,
                              ImGuiID id,
                              const std::string& label,
                              const std::string& text,
                              const TextOptions& options) {
  const int frame_count = ImGui::GetFrameCount();
  bool takes_focus = false;
  if (options.takes_focus && !is_disabled()) {
    const auto [seen, is_new] = state.last_drawn.try_emplace(id, frame_count);
    takes_focus = is_new;
    seen->second = frame_count;
  }
  const bool is_replaced = options.takes_focus_now && !is_disabled();
  if (is_replaced) {
    if (draft(id) != nullptr) end_draft();
    takes_focus = true;
  }
  if (takes_focus) state.focus.id = id;
  const bool is_typing = draft(id) != nullptr;
  if (is_typing) add_stop(box, id, {});
  takes_focus = takes_focus || (!is_typing && has_arrived(id) && !is_disabled());
  const Pressed pressed = is_typing ? Pressed{} : press(box, id, ImGuiButtonFlags_PressedOnClick);
  TextEdit edit;
  edit.value = text;
  if (const auto left = take_abandoned(id)) {
    edit.value = left->text;
    edit.was_committed = left->text != left->start_text;
    edit.is_changed = left->text != text;
  }
  if (pressed.was_clicked || takes_focus) {
    if (ImGui::GetCurrentContext()->ActiveId == id) ImGui::ClearActiveID();
    Draft& begun = begin_draft(id);
    begun.text = begun.start_text = text;
    begun.is_typing = begun.is_text = true;
    begun.takes_tab = options.takes_tab;
  }
  const bool is_hovered_now =
      ImGui::IsMouseHoveringRect(box.Min, box.Max) && ImGui::IsWindowHovered();
  if (is_hovered_now && !is_disabled()) ImGui::SetMouseCursor(ImGuiMouseCursor_TextInput);
  if (Draft* const current = draft(id)) {
    last_id = id;
    is_last_hovered = is_hovered_now;
    const std::string before = current->text;
    const bool has_keyboard = type_draft(box, id, label, state.fonts->text,
                                         takes_focus ? ImGuiInputTextFlags_AutoSelectAll : 0);
    if (is_replaced) put_caret_at_end(id);
    edit.value = current->text;
    edit.is_changed = current->text != before;
    edit.is_editing = has_keyboard;
    edit.wants_completion = has_keyboard && ImGui::IsKeyPressed(static_cast<int>(Key::kTab), false);
    edit.went_back = has_keyboard && before.empty() &&
                     ImGui::IsKeyPressed(static_cast<int>(Key::kBackspace), false);
    if (!has_keyboard) {
      edit.was_entered = ImGui::IsKeyPressed(static_cast<int>(Key::kEnter), false) ||
                         ImGui::IsKeyPressed(static_cast<int>(Key::kPadEnter), false);
      edit.was_cancelled = ImGui::IsKeyPressed(static_cast<int>(Key::kEscape), false);
      if (edit.was_cancelled) edit.value = current->start_text;
      edit.is_changed = edit.value != before;
      edit.was_committed = edit.value != current->start_text;
      end_draft();
    }
  }
  const bool is_open = draft(id) != nullptr;
  if (!is_open) {
    ImRect inside = box;
    inside.Expand({-d(6), 0.0F});
    const bool is_empty = edit.value.empty();
    write_in(inside, is_empty ? options.placeholder : edit.value, state.fonts->text,
             shade(is_empty ? state.look.muted : state.look.text));
  } else if (edit.value.empty()) {
    write_in({{box.Min.x + d(6), box.Min.y}, {box.Max.x - d(6), box.Max.y}}, options.placeholder,
             state.fonts->text, shade(state.look.muted));
  }
  return edit;
}

TextEdit Ui::Frame::edit_lines(const ImRect& box,
                               const std::string& label,
                               const std::string& text) {
  const ImGuiID id = ImGui::GetCurrentWindow()->GetID(label.c_str());
  Draft* current = draft(id);
  TextEdit edit;
  edit.value = current == nullptr ? text : current->text;
  const std::string before = edit.value;
  std::string shown = utf8_of_bytes(before);
  ImGui::PushFont(state.fonts->text);
  ImGui::PushStyleColor(ImGuiCol_FrameBg, 0U);
  ImGui::SetCursorScreenPos(box.Min);
  add_stop(box, id, {});
  if (current == nullptr && !is_disabled() && (has_arrived(id) || is_pressed_by_key(id))) {
    ImGuiContext& imgui = *ImGui::GetCurrentContext();
    imgui.NavActivateId = imgui.NavActivateInputId = id;
  }
  ImGui::InputTextMultiline(label.c_str(), &shown, box.GetSize());
  edit.value = bytes_of_utf8(shown);
  ImGui::PopStyleColor();
  ImGui::PopFont();
  is_last_hovered = ImGui::IsItemHovered();
  if (ImGui::IsItemActivated()) {
    current = &begin_draft(id);
    current->text = current->start_text = text;
    current->is_typing = current->is_text = current->had_keyboard = true;
  }
  edit.is_changed = edit.value != before;
  edit.is_editing = ImGui::IsItemActive();
  if (current == nullptr) return edit;
  current->text = edit.value;
  if (!edit.is_editing) {
    edit.was_cancelled = ImGui::IsKeyPressed(static_cast<int>(Key::kEscape), false);
    edit.was_committed = edit.value != current->start_text;
    end_draft();
  }
  return edit;
}

TextEdit Ui::text_input(const std::string& label,
                        const std::string& text,
                        const TextOptions& options) {
  Frame& frame = *frame_;
  if (options.width > 0.0) frame.next_width = narrow(options.width);
  const float height = frame.d(options.is_multiline ? 84 : 28);
  TextEdit edit;
  Placed placed;
  if (options.is_multiline) {
    const ImVec2 max_before = ImGui::GetCurrentWindow()->DC.CursorMaxPos;
    placed = frame.place_labelled(label + "##box", height);
    const ImVec2 after = ImGui::GetCursorScreenPos();
    frame.draw_label(placed, label);
    frame.fill(placed.field, frame.shade(frame.state.look.raised));
    edit = frame.edit_lines(placed.field, label, text);
    ImGui::SetCursorScreenPos(after);
    ImGui::GetCurrentWindow()->DC.CursorMaxPos = {std::max(max_before.x, placed.box.Max.x),
                                                  std::max(max_before.y, placed.box.Max.y)};
  } else {
    placed = frame.place_labelled(label, height);
    frame.draw_label(placed, label);
    frame.fill(placed.field, frame.shade(frame.state.look.raised));
    edit = frame.edit_text(placed.field, placed.id, label, text, options);
  }
  frame.frame(placed.field,
              frame.shade(edit.is_editing ? frame.state.look.accent : frame.state.look.line));
  Control& control = frame.note(ControlKind::kTextInput, label, placed.field);
  control.value = edit.value;
  control.label_rect = rect_of(placed.label);
  frame.explain(options.hint);
  return edit;
}

TextEdit Ui::search_input(const std::string& name,
                          const std::string& text,
                          const TextOptions& options) {
  Frame& frame = *frame_;
  const float width = options.width > 0.0       ? narrow(options.width)
                      : frame.next_width > 0.0F ? frame.next_width
                                                : frame.room_width();
  const Placed placed = frame.place(name, {width, frame.d(28)}, frame.d(4));
  const float side = frame.d(26);
  frame.fill(placed.box, frame.shade(frame.state.look.raised));
  frame.write_icon({placed.box.Min, {placed.box.Min.x + side, placed.box.Max.y}}, Icon::kSearch,
                   frame.shade(frame.state.look.muted));
  const bool has_clear = !text.empty();
  const ImRect inside({placed.box.Min.x + side - frame.d(4), placed.box.Min.y},
                      {placed.box.Max.x - (has_clear ? side : 0.0F), placed.box.Max.y});
  TextEdit edit = frame.edit_text(inside, placed.id, name, text, options);
  edit.was_committed = edit.was_committed || edit.is_changed;
  frame.frame(placed.box,
              frame.shade(edit.is_editing ? frame.state.look.accent : frame.state.look.line));
  Control& control = frame.note(ControlKind::kTextInput, name, inside);
  control.value = edit.value;
  frame.explain(options.hint);
  if (!has_clear) return edit;
  ImGui::PushID(name.c_str());
  const ImRect clear({placed.box.Max.x - side, placed.box.Min.y}, placed.box.Max);
  const ImGuiID id = ImGui::GetCurrentWindow()->GetID("Clear");
  frame.add_part(clear, id);
  const Pressed pressed = frame.press(clear, id);
  frame.write_icon(
      clear, Icon::kClose,
      frame.shade(pressed.is_hovered ? frame.state.look.text : frame.state.look.muted));
  frame.note(ControlKind::kIconButton, name + "/Clear", clear);
  frame.explain({"Clear the search", ""});
  ImGui::PopID();
  if (pressed.was_clicked) {
    edit = {};
    edit.is_changed = edit.was_committed = true;
    if (frame.draft(placed.id) != nullptr) frame.end_draft();
    if (frame.state.abandoned.id == placed.id) frame.state.abandoned = {};
  }
  return edit;
}

}  // namespace nadir::kit
