// SPDX-License-Identifier: Apache-2.0
#include "widgets/kit/ui_frame.h"

#include <algorithm>
#include <cmath>

#include "core/base/require.h"
#include "widgets/canvas/printable.h"
#include "widgets/kit/ui_canvas.h"

namespace nadir::kit {
namespace {

constexpr double kLabelShare = 0.46;
constexpr double kMostLabelWidth = 190.0;

/// Where a text is cut so that it and "…" fit.
std::string cut_to(const std::string& line, ImFont* font, float width) {
  const float dots = font->CalcTextSizeA(font->FontSize, FLT_MAX, 0.0F, "…").x;
  const char* end = nullptr;
  font->CalcTextSizeA(font->FontSize, std::max(0.0F, width - dots), 0.0F, line.c_str(), nullptr,
                      &end);
  std::string kept(line.c_str(), end == nullptr ? line.c_str() : end);
  while (!kept.empty() && kept.back() == ' ') kept.pop_back();
  return kept + "…";
}

}  // namespace

Ui::Frame::~Frame() = default;

ImFont* Ui::Frame::font(TextLook look) const {
  switch (look) {
    case TextLook::kHeading:
      return state.fonts->semibold;
    case TextLook::kNumber:
    case TextLook::kMutedNumber:
      return state.fonts->numbers;
    default:
      return state.fonts->text;
  }
}

ImU32 Ui::Frame::colour(TextLook look) const {
  switch (look) {
    case TextLook::kMuted:
    case TextLook::kMutedNumber:
      return state.look.muted;
    case TextLook::kGood:
      return state.look.good;
    case TextLook::kWarning:
      return state.look.warning;
    case TextLook::kBad:
      return state.look.bad;
    case TextLook::kAccent:
      return state.look.accent;
    default:
      return state.look.text;
  }
}

ImU32 Ui::Frame::shade(ImU32 the_colour) const {
  if (!is_disabled()) return the_colour;
  const ImU32 alpha = (the_colour >> IM_COL32_A_SHIFT) * 45U / 100U;
  return (the_colour & ~IM_COL32_A_MASK) | (alpha << IM_COL32_A_SHIFT);
}

std::string Ui::Frame::shown(const std::string& label) { return label.substr(0, label.find("##")); }

float Ui::Frame::room_width() const { return std::max(1.0F, ImGui::GetContentRegionAvail().x); }

ImVec2 Ui::Frame::text_size(const std::string& line, ImFont* the_font) const {
  return the_font->CalcTextSizeA(the_font->FontSize, FLT_MAX, 0.0F, printable(line).c_str());
}

void Ui::Frame::shift_line_texts(float height) {
  if (!is_same_line) {
    line_texts.clear();
    return;
  }
  const ImGuiWindow* const window = ImGui::GetCurrentWindow();
  for (LineText& text : line_texts) {
    const float down = std::floor((height - text.height) / 2.0F);
    if (down <= 0.0F || text.list != window->DrawList) continue;
    for (int i = text.first_vertex; i < text.end_vertex; ++i) text.list->VtxBuffer[i].pos.y += down;
    controls.at(text.control).rect.top += down;
    text.top += down;
    text.height = height;
  }
}

Placed Ui::Frame::place(const std::string& label, const ImVec2& size, float gap, bool is_text) {
  ImGuiWindow* const window = ImGui::GetCurrentWindow();
  shift_line_texts(size.y);
  const bool begins_line = !is_same_line;
  is_same_line = false;
  Placed placed;
  placed.id = is_text ? 0 : window->GetID(("##" + label).c_str());
  ImVec2 at = window->DC.CursorPos;
  if (begins_line) line_height = 0.0F;
  const bool is_highest = size.y > line_height;
  if (line_height > size.y) at.y += std::floor((line_height - size.y) / 2.0F);
  line_height = std::max(line_height, size.y);
  placed.box = placed.field = ImRect(at, {at.x + size.x, at.y + size.y});
  ImGui::ItemSize({size.x, size.y + (at.y - window->DC.CursorPos.y) + (is_highest ? gap : 0.0F)});
  placed.is_visible = ImGui::ItemAdd(placed.box, placed.id);
  next_width = 0.0F;
  return placed;
}

Placed Ui::Frame::place_labelled(const std::string& label, float height) {
  ImGuiWindow* const window = ImGui::GetCurrentWindow();
  const std::string words = shown(label);
  const float width = next_width > 0.0F ? next_width : room_width();
  const double wanted = label_widths.empty() ? -1.0 : label_widths.back();
  const float label_width =
      words.empty() ? 0.0F
      : wanted < 0.0
          ? narrow(std::floor(std::min(kLabelShare * width, kMostLabelWidth * state.scale)))
          : narrow(wanted);
  const bool is_above = !words.empty() && wanted == 0.0;
  const float above = is_above ? d(20) : 0.0F;
  shift_line_texts(height + above);
  Placed placed;
  placed.id = window->GetID(("##" + label).c_str());
  const ImVec2 at = window->DC.CursorPos;
  placed.box = ImRect(at, {at.x + width, at.y + above + height});
  placed.field = placed.box;
  placed.field.Min.y += above;
  if (is_above) {
    placed.label = ImRect(at, {at.x + width, at.y + above});
  } else {
    placed.field.Min.x += label_width;
    if (label_width > 0.0F) placed.label = ImRect(at, {at.x + label_width - d(8), at.y + height});
  }
  const float gap = is_same_line ? 0.0F : d(4);
  is_same_line = false;
  line_height = placed.box.GetHeight();
  ImGui::ItemSize({placed.box.GetWidth(), placed.box.GetHeight() + gap});
  placed.is_visible = ImGui::ItemAdd(placed.field, placed.id);
  next_width = 0.0F;
  return placed;
}

bool Ui::Frame::add_part(const ImRect& box, ImGuiID id) { return ImGui::ItemAdd(box, id); }

Pressed Ui::Frame::press(const Placed& placed, ImGuiButtonFlags flags, const Stop& stop) {
  return press(placed.field, placed.id, flags, stop);
}

Pressed Ui::Frame::press(const ImRect& box, ImGuiID id, ImGuiButtonFlags flags, const Stop& stop) {
  last_id = id;
  last_box = box;
  is_last_hovered = ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled |
                                         ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
  if (is_disabled()) return {false, false, false};
  bool is_hovered = false;
  bool is_held = false;
  const bool was_clicked = ImGui::ButtonBehavior(box, id, &is_hovered, &is_held, flags);
  if (!stop.is_stop) return {was_clicked, is_hovered, is_held};
  add_stop(box, id, stop);
  if (is_held) state.focus.id = id;
  return {was_clicked || (stop.takes_press && is_pressed_by_key(id)), is_hovered, is_held};
}

void Ui::Frame::draw_label(const Placed& placed, const std::string& label, bool is_marked) {
  if (placed.label.GetWidth() <= 0.0F) return;
  ImRect words = placed.label;
  if (is_marked) {
    const float radius = 2.5F * narrow(state.scale);
    const ImVec2 at(words.Min.x + radius, std::floor((words.Min.y + words.Max.y) / 2.0F));
    ImGui::GetWindowDrawList()->AddCircleFilled(at, radius, shade(state.look.accent));
    words.Min.x += 2.0F * radius + d(5);
  }
  write_in(words, shown(label), state.fonts->text, shade(state.look.text));
}

Control& Ui::Frame::note(ControlKind kind, const std::string& label, const ImRect& box) {
  const ImGuiWindow* const window = ImGui::GetCurrentWindow();
  Control control;
  control.path = prefix + label;
  control.kind = kind;
  control.label = shown(label);
  control.rect = rect_of(box);
  control.is_enabled = !is_disabled();
  ImRect seen = box;
  seen.ClipWith(window->ClipRect);
  control.is_visible = !window->SkipItems && seen.GetWidth() > 0.0F && seen.GetHeight() > 0.0F;
  control.is_hovered = is_last_hovered;
  control.is_focused = std::exchange(is_noting_focused, false);
  if (is_disabled()) control.tooltip = disabled_reasons.back();
  if (!state.scroll_to.empty() && state.scroll_to == control.path) {
    ImGui::ScrollToRect(ImGui::GetCurrentWindow(), box, ImGuiScrollFlags_KeepVisibleCenterY);
    state.scroll_to.clear();
  }
  controls.push_back(std::move(control));
  if (is_disabled() && is_last_hovered && !disabled_reasons.back().empty())
    wish_tooltip(controls.back(), {});
  return controls.back();
}

void Ui::Frame::write(const ImVec2& at,
                      const std::string& line,
                      ImFont* the_font,
                      ImU32 the_colour) const {
  ImGui::GetWindowDrawList()->AddText(the_font, the_font->FontSize, at, the_colour,
                                      printable(line).c_str());
}

bool Ui::Frame::write_in(const ImRect& box,
                         const std::string& words,
                         ImFont* the_font,
                         ImU32 the_colour,
                         Align align) const {
  // Of bytes that are no character Dear ImGui takes the letters behind them for a part.
  const std::string line = printable(words);
  const ImVec2 size = text_size(line, the_font);
  const float top = std::floor((box.Min.y + box.Max.y - size.y) / 2.0F + 0.5F);
  if (size.x > box.GetWidth() + 0.5F) {
    write({box.Min.x, top}, cut_to(line, the_font, box.GetWidth()), the_font, the_colour);
    return false;
  }
  float left = box.Min.x;
  if (align == Align::kCentre) left += std::floor((box.GetWidth() - size.x) / 2.0F);
  if (align == Align::kRight || align == Align::kDecimal) left = box.Max.x - size.x;
  write({left, top}, line, the_font, the_colour);
  return true;
}

void Ui::Frame::write_icon(const ImRect& box, Icon icon, ImU32 the_colour) const {
  write_in(box, icon_text(icon), state.fonts->text, the_colour, Align::kCentre);
}

void Ui::Frame::fill(const ImRect& box, ImU32 the_colour, double radius) const {
  ImGui::GetWindowDrawList()->AddRectFilled(box.Min, box.Max, the_colour,
                                            narrow(radius * state.scale));
}

void Ui::Frame::frame(const ImRect& box, ImU32 the_colour, double radius) const {
  ImGui::GetWindowDrawList()->AddRect(box.Min, box.Max, the_colour, narrow(radius * state.scale));
}

Draft* Ui::Frame::draft(ImGuiID id) {
  if (state.draft.id != id) return nullptr;
  state.draft.last_frame = ImGui::GetFrameCount();
  return &state.draft;
}

Draft& Ui::Frame::begin_draft(ImGuiID id) {
  if (state.draft.is_typing && state.draft.had_keyboard && state.draft.id != id)
    state.abandoned = state.draft;
  state.draft = {};
  state.draft.id = id;
  state.draft.last_frame = ImGui::GetFrameCount();
  return state.draft;
}

std::optional<Draft> Ui::Frame::take_abandoned(ImGuiID id) {
  if (state.abandoned.id != id) return std::nullopt;
  return std::exchange(state.abandoned, {});
}

void Ui::Frame::end_draft() { state.draft = {}; }

Scope Ui::Frame::push_scope(const std::string& name, bool with_imgui_id) {
  const std::size_t length = prefix.size();
  prefix += name + "/";
  if (with_imgui_id) ImGui::PushID(name.c_str());
  return {true, [this, length, with_imgui_id] {
            if (with_imgui_id) ImGui::PopID();
            prefix.resize(length);
          }};
}

}  // namespace nadir::kit
