// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "widgets/kit/ui_canvas.h"
#include "widgets/kit/ui_frame.h"

namespace nadir::kit {
namespace {

constexpr double kListRowHeight = 28.0;

/// Of the rows of one list, which share the scope around them. A row without words of its own is named by a scope, and its
/// list lies around that.
ImGuiID list_of(std::string scope, const std::string& name) {
  if (name.starts_with("##") && !scope.empty()) {
    scope.pop_back();
    scope.erase(scope.rfind('/') + 1);
  }
  return ImHashStr(scope.c_str(), scope.size(), ImGui::GetCurrentWindow()->ID);
}

}  // namespace

/// @param stop  Of which group it is, whether it is selected, and can be pressed.
RowInput Ui::Frame::press_row(const ImRect& box, ImGuiID id, Stop stop) {
  stop.arrows = Arrows::kUpDown;
  const Pressed pressed = press(box, id, ImGuiButtonFlags_AllowItemOverlap, stop);
  ImGui::SetItemAllowOverlap();
  RowInput input;
  input.is_hovered = is_last_hovered && !is_disabled();
  input.was_clicked = pressed.was_clicked;
  input.was_double_clicked = pressed.is_hovered && ImGui::IsMouseDoubleClicked(0);
  input.was_right_clicked = input.is_hovered && right_clicked();
  input.modifiers = state.input.modifiers;
  if (stop.is_selected) {
    fill(box, shade(state.look.accent_soft));
  } else if (pressed.is_hovered || pressed.is_held) {
    fill(box, state.look.hovered);
  }
  return input;
}

bool Ui::Frame::right_clicked() const {
  return ImGui::IsMouseReleased(1) && ImGui::GetIO().MouseDragMaxDistanceSqr[1] < 16.0F;
}

RowInput Ui::list_row(const std::string& name, const ListRow& row) {
  Frame& frame = *frame_;
  const Look& colours = frame.state.look;
  const float width = frame.next_width > 0.0F ? frame.next_width : frame.room_width();
  const Placed placed = frame.place(name, {width, frame.d(kListRowHeight)}, 0.0F);
  const RowInput input = frame.press_row(placed.box, placed.id,
                                         {.is_stop = row.is_stop,
                                          .group = list_of(frame.prefix, name),
                                          .is_selected = row.is_selected});
  ImRect inside = placed.box;
  inside.Expand({-frame.d(8), 0.0F});
  if (row.colour) {
    ImGui::GetWindowDrawList()->AddCircleFilled(
        {inside.Min.x + frame.d(5), std::floor(inside.GetCenter().y)}, frame.d(5),
        frame.shade(packed(*row.colour)));
    inside.Min.x += frame.d(18);
  }
  if (row.icon != Icon::kNone) {
    frame.write_icon({inside.Min, {inside.Min.x + frame.d(18), inside.Max.y}}, row.icon,
                     frame.shade(row.is_selected ? colours.accent : colours.muted));
    inside.Min.x += frame.d(26);
  }
  if (!row.detail.empty()) {
    ImFont* const font =
        row.is_detail_number ? frame.state.fonts->numbers : frame.state.fonts->text;
    const float detail = std::min(inside.GetWidth() / 2.0F, frame.text_size(row.detail, font).x);
    frame.write_in({{inside.Max.x - detail, inside.Min.y}, {inside.Max.x + 0.5F, inside.Max.y}},
                   row.detail, font, frame.shade(colours.muted), Align::kRight);
    inside.Max.x -= detail + frame.d(8);
  }
  const bool is_whole = frame.write_in(inside, Frame::shown(name), frame.font(row.look),
                                       frame.shade(frame.colour(row.look)));
  Control& control = frame.note(ControlKind::kRow, name, placed.box);
  control.value = row.detail;
  control.is_selected = row.is_selected;
  Hint hint = row.hint;
  if (!is_whole && hint.text.empty()) hint.text = Frame::shown(name);
  frame.explain(hint, !is_whole);
  return input;
}

Scope Ui::section(const std::string& label, bool is_open_at_first, const std::string& detail) {
  Frame& frame = *frame_;
  const Look& colours = frame.state.look;
  const Placed placed = frame.place(label, {frame.room_width(), frame.d(32)}, 0.0F);
  const Pressed pressed = frame.press(placed);
  std::set<std::string>& turned = frame.state.turned_sections;
  const std::string path = frame.prefix + label;
  if (pressed.was_clicked && turned.erase(path) == 0) turned.insert(path);
  const bool is_open = is_open_at_first != turned.contains(path);
  ImRect inside = placed.box;
  frame.fill({placed.box.Min, {placed.box.Max.x, placed.box.Min.y + 1.0F}},
             frame.shade(colours.line), 0.0);
  frame.write_icon(
      {{inside.Min.x - frame.d(4), inside.Min.y}, {inside.Min.x + frame.d(12), inside.Max.y}},
      is_open ? Icon::kCaretDown : Icon::kCaretRight,
      frame.shade(pressed.is_hovered ? colours.text : colours.muted));
  inside.Min.x += frame.d(18);
  if (!detail.empty()) {
    const float width =
        std::min(inside.GetWidth() / 2.0F, frame.text_size(detail, frame.state.fonts->text).x);
    frame.write_in({{inside.Max.x - width, inside.Min.y}, {inside.Max.x + 0.5F, inside.Max.y}},
                   detail, frame.state.fonts->text, frame.shade(colours.muted), Align::kRight);
    inside.Max.x -= width + frame.d(8);
  }
  frame.write_in(inside, Frame::shown(label), frame.state.fonts->semibold,
                 frame.shade(colours.text));
  frame.note(ControlKind::kSection, label, placed.box).value = is_open ? "open" : "closed";
  if (!is_open) return {};
  const std::size_t length = frame.prefix.size();
  frame.prefix += label + "/";
  ImGui::PushID(label.c_str());
  return {true, [&frame, length] {
            ImGui::PopID();
            frame.prefix.resize(length);
            frame.is_same_line = false;
            ImGui::ItemSize({0.0F, frame.d(8)});
          }};
}

}  // namespace nadir::kit
