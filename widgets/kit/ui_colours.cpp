// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <charconv>
#include <cmath>

#include "widgets/kit/ui_canvas.h"
#include "widgets/kit/ui_frame.h"

namespace nadir::kit {
namespace {

std::string hex_of(Rgba colour) {
  return fmt::format("#{:02X}{:02X}{:02X}", colour.red, colour.green, colour.blue);
}

/// "#0B6FB8" or "0b6fb8"; keeps the alpha of `before`.
std::optional<Rgba> read_hex(std::string text, Rgba before) {
  if (!text.empty() && text.front() == '#') text.erase(0, 1);
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, 16);
  if (text.size() != 6 || error != std::errc() || end != text.data() + text.size())
    return std::nullopt;
  return Rgba{static_cast<std::uint8_t>(value >> 16U), static_cast<std::uint8_t>(value >> 8U),
              static_cast<std::uint8_t>(value), before.alpha};
}

/// Joins what one part of the picker says with what the others said.
void take(Edit<Rgba>& all, Rgba value, const Edit<double>& part) {
  if (part.is_changed || part.is_editing || part.was_committed) all.value = value;
  all.is_changed = all.is_changed || part.is_changed;
  all.is_editing = all.is_editing || part.is_editing;
  all.was_committed = all.was_committed || part.was_committed;
}

}  // namespace

Edit<Rgba> Ui::Frame::draw_picker(Ui& ui, Rgba colour) {
  Edit<Rgba> edit;
  edit.value = colour;
  std::array<float, 3> channels = {static_cast<float>(colour.red) / 255.0F,
                                   static_cast<float>(colour.green) / 255.0F,
                                   static_cast<float>(colour.blue) / 255.0F};
  ImGui::SetNextItemWidth(narrow(ui.px(212)));
  const ImGuiID id = ImGui::GetID("##picker");
  if (const Draft* const current = draft(id)) {
    channels = {static_cast<float>(current->colour.red) / 255.0F,
                static_cast<float>(current->colour.green) / 255.0F,
                static_cast<float>(current->colour.blue) / 255.0F};
  }
  const bool is_changed =
      ImGui::ColorPicker3("##picker", channels.data(),
                          ImGuiColorEditFlags_NoInputs | ImGuiColorEditFlags_NoSidePreview |
                              ImGuiColorEditFlags_NoLabel | ImGuiColorEditFlags_NoOptions);
  const auto channel = [](float value) {
    return static_cast<std::uint8_t>(std::lround(255.0F * std::clamp(value, 0.0F, 1.0F)));
  };
  if (ImGui::IsItemActivated()) {
    Draft& begun = begin_draft(id);
    begun.colour = begun.start_colour = colour;
  }
  if (Draft* const current = draft(id)) {
    if (is_changed)
      current->colour =
          Rgba{channel(channels[0]), channel(channels[1]), channel(channels[2]), colour.alpha};
    edit.value = current->colour;
    edit.is_changed = is_changed;
    edit.is_editing = ImGui::IsItemActive();
    if (!edit.is_editing) {
      edit.was_committed = !(current->colour == current->start_colour);
      end_draft();
    }
  }
  const Rgba now = edit.value;
  ui.space(ui.px(8));
  const Scope labels = ui.label_width(ui.px(64));
  NumberOptions byte;
  byte.least = 0.0;
  byte.most = 255.0;
  byte.decimals = 0;
  const auto slide = [&](const char* label, std::uint8_t Rgba::*part) {
    ui.next_width(ui.px(230));
    const Edit<double> slid = ui.slider(label, now.*part, byte);
    Rgba changed = now;
    changed.*part = static_cast<std::uint8_t>(std::lround(slid.value));
    take(edit, changed, slid);
  };
  slide("Red", &Rgba::red);
  slide("Green", &Rgba::green);
  slide("Blue", &Rgba::blue);
  TextOptions hex;
  hex.width = ui.px(230);
  const TextEdit typed = ui.text_input("Hex", hex_of(now), hex);
  if (const auto read = read_hex(typed.value, now); read && typed.was_committed) {
    edit.value = *read;
    edit.is_changed = edit.was_committed = true;
  }
  return edit;
}

Edit<Rgba> Ui::colour(const std::string& label, Rgba colour, const Hint& hint) {
  Frame& frame = *frame_;
  const Placed placed = frame.place_labelled(label, frame.d(28));
  const Pressed pressed = frame.press(placed);
  frame.draw_label(placed, label);
  ImRect swatch = placed.field;
  swatch.Max.x = std::min(swatch.Max.x, swatch.Min.x + frame.d(36));
  swatch.Expand({0.0F, -frame.d(4)});
  frame.fill(swatch, frame.shade(packed({colour.red, colour.green, colour.blue})), 3.0);
  frame.frame(swatch,
              frame.shade(pressed.is_hovered ? frame.state.look.text : frame.state.look.line), 3.0);
  const ImRect digits({swatch.Max.x + frame.d(8), placed.field.Min.y}, placed.field.Max);
  if (digits.GetWidth() > 0.0F) {
    frame.write_in(digits, hex_of(colour), frame.state.fonts->numbers,
                   frame.shade(frame.state.look.muted));
  }
  const ImGuiID popup = ImHashStr("##picker", 0, placed.id);
  const bool is_open = ImGui::IsPopupOpen(popup, ImGuiPopupFlags_None);
  Control& control = frame.note(ControlKind::kColour, label, swatch);
  control.value = hex_of(colour);
  control.is_selected = is_open;
  control.label_rect = rect_of(placed.label);
  frame.explain(hint);
  if (pressed.was_clicked && !is_open) ImGui::OpenPopupEx(popup, ImGuiPopupFlags_None);
  Edit<Rgba> edit;
  edit.value = colour;
  ImGui::SetNextWindowPos({swatch.Min.x, swatch.Max.y + frame.d(4)}, ImGuiCond_Appearing);
  if (const Scope picker = frame.open_popup(popup, label)) edit = frame.draw_picker(*this, colour);
  return edit;
}

}  // namespace nadir::kit
