// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "core/base/require.h"
#include "widgets/kit/ui_canvas.h"
#include "widgets/kit/ui_frame.h"

namespace nadir::kit {
namespace {

struct ButtonColours {
  ImU32 fill = 0, border = 0, words = 0;
};

ButtonColours colours_of(ButtonLook look, const Pressed& pressed, bool is_on, const Look& colours) {
  const ImU32 over = pressed.is_held ? colours.held : pressed.is_hovered ? colours.hovered : 0;
  switch (look) {
    case ButtonLook::kPrimary:
      return {pressed.is_hovered || pressed.is_held ? colours.accent_hovered : colours.accent, 0,
              colours.on_accent};
    case ButtonLook::kQuiet:
      return {is_on ? colours.accent_soft : over, 0, is_on ? colours.accent : colours.text};
    case ButtonLook::kNormal:
      break;
  }
  return {is_on       ? colours.accent_soft
          : over != 0 ? over
                      : colours.raised,
          is_on ? colours.accent : colours.line, is_on ? colours.accent : colours.text};
}

}  // namespace

bool Ui::button(const std::string& label, ButtonLook look, const Hint& hint, Icon icon) {
  Frame& frame = *frame_;
  const std::string words = Frame::shown(label);
  ImFont* const font =
      look == ButtonLook::kPrimary ? frame.state.fonts->semibold : frame.state.fonts->text;
  const float icon_width = icon == Icon::kNone ? 0.0F : frame.d(24);
  const float own = std::ceil(frame.text_size(words, font).x) + icon_width + 2.0F * frame.d(12);
  if (frame.is_same_line && frame.next_width <= 0.0F && own > frame.room_width() + 0.5F) {
    frame.is_same_line = false;  // it gets a line of its own rather than be cut
    ImGui::NewLine();
  }
  const Placed placed = frame.place(
      label, {frame.next_width > 0.0F ? frame.next_width : own, frame.d(28)}, frame.d(4));
  const Pressed pressed = frame.press(placed);
  const ButtonColours colours = colours_of(look, pressed, false, frame.state.look);
  if (colours.fill != 0) frame.fill(placed.box, frame.shade(colours.fill));
  if (colours.border != 0) frame.frame(placed.box, frame.shade(colours.border));
  if (frame.ring && frame.has_focus(placed.id))
    frame.ring->is_on_accent = look == ButtonLook::kPrimary;
  ImRect inside = placed.box;
  bool is_whole = true;
  if (icon != Icon::kNone) {
    const float left =
        std::max(inside.Min.x + frame.d(4),
                 std::floor((inside.Min.x + inside.Max.x - own) / 2.0F) + frame.d(8));
    frame.write_icon({{left, inside.Min.y}, {left + frame.d(20), inside.Max.y}}, icon,
                     frame.shade(colours.words));
    inside.Min.x = left + frame.d(28);
    inside.Max.x -= frame.d(4);
    is_whole = frame.write_in(inside, words, font, frame.shade(colours.words));
  } else {
    inside.Expand({-std::min(frame.d(4), inside.GetWidth() / 4.0F), 0.0F});
    is_whole = frame.write_in(inside, words, font, frame.shade(colours.words), Align::kCentre);
  }
  frame.note(ControlKind::kButton, label, placed.box);
  Hint said = hint;
  if (!is_whole && said.text.empty()) said.text = words;
  frame.explain(said, !is_whole);
  return pressed.was_clicked;
}

bool Ui::icon_button(
    const std::string& name, Icon icon, const Hint& hint, bool is_on, ButtonLook look) {
  NADIR_REQUIRE(!hint.text.empty());
  Frame& frame = *frame_;
  const float side = frame.d(28);
  const Placed placed =
      frame.place(name, {frame.next_width > 0.0F ? frame.next_width : side, side}, frame.d(4));
  const Pressed pressed = frame.press(placed);
  const ButtonColours colours = colours_of(look, pressed, is_on, frame.state.look);
  if (colours.fill != 0) frame.fill(placed.box, frame.shade(colours.fill));
  if (colours.border != 0) frame.frame(placed.box, frame.shade(colours.border));
  frame.write_icon(placed.box, icon, frame.shade(colours.words));
  Control& control = frame.note(ControlKind::kIconButton, name, placed.box);
  control.value = is_on ? "on" : "off";
  control.is_selected = is_on;
  frame.explain(hint);
  return pressed.was_clicked;
}

bool Ui::link(const std::string& label, const Hint& hint) {
  Frame& frame = *frame_;
  ImFont* const font = frame.state.fonts->text;
  const std::string words = Frame::shown(label);
  const Placed placed =
      frame.place(label, {std::ceil(frame.text_size(words, font).x), frame.d(20)}, 0.0F);
  const Pressed pressed = frame.press(placed);
  if (pressed.is_hovered) {
    ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    frame.fill(
        {{placed.box.Min.x, placed.box.Max.y - 2.0F}, {placed.box.Max.x, placed.box.Max.y - 1.0F}},
        frame.state.look.accent, 0.0);
  }
  frame.write_in({placed.box.Min, {placed.box.Max.x + 1.0F, placed.box.Max.y}}, words, font,
                 frame.shade(frame.state.look.accent));
  frame.note(ControlKind::kButton, label, placed.box);
  frame.explain(hint);
  return pressed.was_clicked;
}

std::optional<bool> Ui::checkbox(const std::string& label, bool is_on, const Hint& hint) {
  Frame& frame = *frame_;
  const Look& colours = frame.state.look;
  const std::string words = Frame::shown(label);
  const float side = frame.d(16);
  const float words_width =
      words.empty()
          ? 0.0F
          : frame.d(8) + std::ceil(frame.text_size(words, frame.state.fonts->text).x) + 1.0F;
  const Placed placed = frame.place(label, {side + words_width, frame.d(28)}, 0.0F);
  const Pressed pressed = frame.press(placed);
  const float top = std::floor((placed.box.Min.y + placed.box.Max.y - side) / 2.0F);
  const ImRect box({placed.box.Min.x, top}, {placed.box.Min.x + side, top + side});
  if (is_on) {
    frame.fill(box, frame.shade(pressed.is_hovered ? colours.accent_hovered : colours.accent), 3.0);
    ImGui::RenderCheckMark(ImGui::GetWindowDrawList(),
                           {box.Min.x + frame.d(3), box.Min.y + frame.d(3)},
                           frame.shade(colours.on_accent), side - 2.0F * frame.d(3));
  } else {
    frame.fill(box, frame.shade(pressed.is_hovered ? colours.hovered : colours.raised), 3.0);
    frame.frame(box, frame.shade(colours.muted), 3.0);
  }
  frame.write_in(
      {{box.Max.x + frame.d(8), placed.box.Min.y}, {placed.box.Max.x + 1.0F, placed.box.Max.y}},
      words, frame.state.fonts->text, frame.shade(colours.text));
  Control& control = frame.note(ControlKind::kCheckbox, label, placed.box);
  control.value = is_on ? "on" : "off";
  control.is_selected = is_on;
  frame.explain(hint);
  return pressed.was_clicked ? std::optional<bool>(!is_on) : std::nullopt;
}

std::optional<bool> Ui::eye(const std::string& name, bool is_on, const Hint& hint) {
  Frame& frame = *frame_;
  const Look& colours = frame.state.look;
  const Placed placed = frame.place(name, {frame.d(28), frame.d(28)}, 0.0F);
  const Pressed pressed = frame.press(placed);
  if (pressed.is_hovered) frame.fill(placed.box, colours.hovered);
  frame.write_icon(placed.box, is_on ? Icon::kEye : Icon::kEyeSlash,
                   frame.shade(is_on ? colours.text : colours.muted));
  Control& control = frame.note(ControlKind::kEye, name, placed.box);
  control.value = is_on ? "on" : "off";
  control.is_selected = is_on;
  frame.explain(hint.text.empty()
                    ? Hint{is_on ? "Hide" : "Show", hint.shortcut, hint.unit, hint.source}
                    : hint);
  return pressed.was_clicked ? std::optional<bool>(!is_on) : std::nullopt;
}

bool Ui::rail_button(const std::string& name, Icon icon, const Hint& hint, bool is_chosen) {
  NADIR_REQUIRE(!hint.text.empty());
  Frame& frame = *frame_;
  const Look& colours = frame.state.look;
  const Placed placed = frame.place(name, {frame.room_width(), frame.d(52)}, 0.0F);
  const Pressed pressed = frame.press(placed);
  if (pressed.is_hovered || pressed.is_held) frame.fill(placed.box, colours.hovered, 0.0);
  if (is_chosen) {
    frame.fill(placed.box, colours.accent_soft, 0.0);
    frame.fill({placed.box.Min, {placed.box.Min.x + frame.d(2), placed.box.Max.y}}, colours.accent,
               0.0);
  }
  const ImU32 ink = frame.shade(is_chosen ? colours.accent : colours.muted);
  const float middle = placed.box.Min.y + frame.d(21);
  frame.write_icon(
      {{placed.box.Min.x, middle - frame.d(12)}, {placed.box.Max.x, middle + frame.d(12)}}, icon,
      ink);
  frame.write_in({{placed.box.Min.x, placed.box.Max.y - frame.d(22)},
                  {placed.box.Max.x, placed.box.Max.y - frame.d(4)}},
                 Frame::shown(name), frame.state.fonts->small_text,
                 frame.shade(is_chosen ? colours.text : colours.muted), Align::kCentre);
  frame.note(ControlKind::kTab, name, placed.box).is_selected = is_chosen;
  frame.explain(hint);
  return pressed.was_clicked;
}

}  // namespace nadir::kit
