// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <utility>

#include "widgets/canvas/printable.h"
#include "widgets/kit/ui_canvas.h"
#include "widgets/kit/ui_frame.h"

namespace nadir::kit {
namespace {

constexpr double kTextHeight = 20.0;
constexpr std::size_t kUnitCharacters = 4;

/// Words in lines as wide as the room: Dear ImGui would part them after the points within numbers too, and units from theirs.
std::string in_lines(const Ui::Frame& frame, const std::string& words, ImFont* font, float room) {
  std::string text, line;
  std::size_t at = 0;
  while (at < words.size()) {
    std::size_t end = std::min(words.find_first_of(" \n", at), words.size());
    const bool is_number = end > at && words[end - 1] >= '0' && words[end - 1] <= '9';
    if (is_number && end + 1 < words.size() && words[end] == ' ') {
      const std::size_t unit_end = std::min(words.find_first_of(" \n", end + 1), words.size());
      const bool is_digit = words[end + 1] >= '0' && words[end + 1] <= '9';
      const bool is_unit = !is_digit && unit_end - end - 1 <= kUnitCharacters;
      if (is_unit) end = unit_end;
    }
    const std::string word = words.substr(at, end - at);
    std::string longer = line;
    if (!line.empty()) longer += ' ';
    longer += word;
    if (!line.empty() && frame.text_size(longer, font).x > room) {
      text += line + "\n";
      line = word;
    } else {
      line = std::move(longer);
    }
    if (end < words.size() && words[end] == '\n') {
      text += line + "\n";
      line.clear();
    }
    at = end + 1;
  }
  return text + line;
}

}  // namespace

Placed Ui::Frame::place_text(const std::string& line, ImFont* the_font, float most_width) {
  const float width = std::min(most_width, std::ceil(text_size(line, the_font).x));
  const Placed placed = place(line, {width, d(kTextHeight)}, 0.0F, true);
  last_id = 0;
  last_box = placed.box;
  is_last_hovered = ImGui::IsItemHovered();
  return placed;
}

/// What has just been written as the beginning of a line: it may have to move down.
void Ui::Frame::keep_line_text(const Placed& placed, int first_vertex) {
  ImDrawList* const list = ImGui::GetWindowDrawList();
  line_texts.push_back({list, first_vertex, list->VtxBuffer.Size, controls.size() - 1,
                        placed.box.Min.y, std::max(line_height, placed.box.GetHeight())});
}

void Ui::text(const std::string& line, TextLook look) {
  Frame& frame = *frame_;
  ImFont* const font = frame.font(look);
  const Placed placed = frame.place_text(line, font, FLT_MAX);
  const int first_vertex = ImGui::GetWindowDrawList()->VtxBuffer.Size;
  frame.write_in({placed.box.Min, {placed.box.Max.x + 1.0F, placed.box.Max.y}}, line, font,
                 frame.shade(frame.colour(look)));
  frame.note(ControlKind::kText, line, placed.box).value = line;
  frame.keep_tooltip_clear_of(look);
  frame.keep_line_text(placed, first_vertex);
}

void Ui::wrapped(const std::string& words, TextLook look) {
  Frame& frame = *frame_;
  ImFont* const font = frame.font(look);
  ImGui::PushFont(font);
  ImGui::PushStyleColor(ImGuiCol_Text, frame.shade(frame.colour(look)));
  ImGui::PushTextWrapPos(0.0F);
  ImGui::TextUnformatted(in_lines(frame, printable(words), font, frame.room_width()).c_str());
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
  ImGui::PopFont();
  frame.is_last_hovered = ImGui::IsItemHovered();
  frame.note(ControlKind::kText, words, {ImGui::GetItemRectMin(), ImGui::GetItemRectMax()}).value =
      words;
  frame.keep_tooltip_clear_of(look);
}

void Ui::cut_text(const std::string& line, TextLook look, double reserve) {
  Frame& frame = *frame_;
  ImFont* const font = frame.font(look);
  const float room = std::max(1.0F, frame.room_width() - narrow(reserve));
  const Placed placed = frame.place_text(line, font, room);
  const int first_vertex = ImGui::GetWindowDrawList()->VtxBuffer.Size;
  const bool is_whole = frame.write_in(placed.box, line, font, frame.shade(frame.colour(look)));
  frame.note(ControlKind::kText, line, placed.box).value = line;
  frame.keep_line_text(placed, first_vertex);
  if (!is_whole) frame.explain({line, ""}, true);
}

void Ui::heading(const std::string& line) {
  Frame& frame = *frame_;
  const Placed placed = frame.place(line, {frame.room_width(), frame.d(28)}, 0.0F, true);
  frame.is_last_hovered = false;
  frame.write_in(placed.box, line, frame.state.fonts->semibold, frame.shade(frame.state.look.text));
  frame.note(ControlKind::kText, line, placed.box).value = line;
}

void Ui::number(const std::string& digits, const std::string& unit, TextLook look) {
  text(digits, look);
  if (unit.empty()) return;
  same_line(px(4));
  text(unit, TextLook::kMuted);
}

void Ui::read_out(const std::string& label,
                  const std::string& digits,
                  const std::string& unit,
                  const Hint& hint,
                  TextLook look) {
  Frame& frame = *frame_;
  const Placed placed = frame.place(label, {frame.room_width(), frame.d(24)}, 0.0F, true);
  frame.is_last_hovered = ImGui::IsItemHovered();
  // A warning is in another colour, but a number stays one.
  const bool is_number =
      look != TextLook::kNormal && !digits.empty() && digits.find_first_of("0123456789") <= 1;
  ImFont* const font = is_number ? frame.state.fonts->numbers : frame.font(look);
  const Look& colours = frame.state.look;
  ImRect right = placed.box;
  if (!unit.empty()) {
    frame.write_in(right, unit, frame.state.fonts->text, frame.shade(colours.muted), Align::kRight);
    right.Max.x -= frame.text_size(unit, frame.state.fonts->text).x + frame.d(4);
  }
  const float label_width = frame.text_size(Frame::shown(label), frame.state.fonts->text).x;
  right.Min.x =
      std::min(right.Max.x - 1.0F,
               std::max(right.Min.x, std::min(right.Min.x + label_width + frame.d(8),
                                              right.Max.x - frame.text_size(digits, font).x)));
  frame.write_in(right, digits, font, frame.shade(frame.colour(look)), Align::kRight);
  ImRect left = placed.box;
  left.Max.x = std::max(left.Min.x + 1.0F, right.Min.x);
  frame.write_in(left, Frame::shown(label), frame.state.fonts->text, frame.shade(colours.muted));
  Control& control = frame.note(ControlKind::kText, label, placed.box);
  control.value = unit.empty() ? digits : digits + " " + unit;
  if (!hint.text.empty() || !hint.source.empty()) frame.explain(hint);
}

void Ui::icon(Icon icon, TextLook look) {
  Frame& frame = *frame_;
  const Placed placed = frame.place("icon", {frame.d(20), frame.d(kTextHeight)}, 0.0F, true);
  frame.is_last_hovered = ImGui::IsItemHovered();
  const int first_vertex = ImGui::GetWindowDrawList()->VtxBuffer.Size;
  frame.write_icon(placed.box, icon, frame.shade(frame.colour(look)));
  frame.note(ControlKind::kText, icon_name(icon), placed.box);
  frame.keep_line_text(placed, first_vertex);
}

void Ui::colour_dot(Rgba colour) {
  Frame& frame = *frame_;
  const Placed placed = frame.place("dot", {frame.d(12), frame.d(kTextHeight)}, 0.0F, true);
  frame.is_last_hovered = ImGui::IsItemHovered();
  const int first_vertex = ImGui::GetWindowDrawList()->VtxBuffer.Size;
  ImGui::GetWindowDrawList()->AddCircleFilled(placed.box.GetCenter(), frame.d(5),
                                              frame.shade(packed(colour)));
  frame.note(ControlKind::kText, "dot", placed.box).value =
      fmt::format("#{:02X}{:02X}{:02X}", colour.red, colour.green, colour.blue);
  frame.keep_line_text(placed, first_vertex);
}

bool Ui::empty_state(Icon icon,
                     const std::string& sentence,
                     const std::string& button_label,
                     const std::string& shortcut) {
  Frame& frame = *frame_;
  const Rect left = room();
  const double words_width = std::min(left.width, px(280));
  const ImVec2 words = frame.state.fonts->text->CalcTextSizeA(
      frame.state.fonts->text->FontSize, FLT_MAX, narrow(words_width), printable(sentence).c_str());
  const double height = px(36) + words.y + (button_label.empty() ? 0.0 : px(12) + px(28));
  space(std::max(px(8), std::min(px(120), (left.height - height) / 3.0)));
  const float middle = narrow(left.left + left.width / 2.0);
  const float top = ImGui::GetCursorScreenPos().y;
  ImFont* const font = frame.state.fonts->text;
  ImDrawList* const list = ImGui::GetWindowDrawList();
  const std::string glyph = icon_text(icon);
  const float icon_px = font->FontSize * 1.5F;
  const ImVec2 icon_size = font->CalcTextSizeA(icon_px, FLT_MAX, 0.0F, glyph.c_str());
  list->AddText(font, icon_px, {std::floor(middle - icon_size.x / 2.0F), top},
                frame.shade(frame.state.look.muted), glyph.c_str());
  space(px(36));
  ImGui::SetCursorScreenPos(
      {std::floor(middle - narrow(words.x) / 2.0F), ImGui::GetCursorScreenPos().y});
  ImGui::PushStyleColor(ImGuiCol_Text, frame.shade(frame.state.look.muted));
  ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + words.x + 1.0F);
  ImGui::TextUnformatted(printable(sentence).c_str());
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
  frame.is_last_hovered = false;
  frame.note(ControlKind::kText, sentence, {ImGui::GetItemRectMin(), ImGui::GetItemRectMax()})
      .value = sentence;
  if (button_label.empty()) return false;
  space(px(12));
  const float width =
      std::ceil(frame.text_size(Frame::shown(button_label), font).x) + 2.0F * frame.d(12);
  ImGui::SetCursorScreenPos({std::floor(middle - width / 2.0F), ImGui::GetCursorScreenPos().y});
  return button(button_label, ButtonLook::kPrimary, {Frame::shown(button_label), shortcut});
}

double Ui::text_width(const std::string& line, TextLook look) const {
  return frame_->text_size(line, frame_->font(look)).x;
}

}  // namespace nadir::kit
