// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "widgets/kit/ui_canvas.h"
#include "widgets/kit/ui_frame.h"

namespace nadir::kit {
namespace {

std::string item_at(std::span<const std::string> items, std::size_t index) {
  return index < items.size() ? Ui::Frame::shown(items[index]) : std::string();
}

constexpr double kTabHeight = 32.0;

/// Of things of which one is chosen.
Stop one_of(ImGuiID group, bool is_chosen, Arrows arrows) {
  return {.arrows = arrows, .group = group, .is_selected = is_chosen, .is_chosen_by_arrows = true};
}

/// Where tabs lie, from the upper left corner of all: nearer to each other where they would not fit, and then in rows.
std::vector<ImRect> tab_parts(const Ui::Frame& frame, std::span<const std::string> titles) {
  std::vector<float> widths;
  float natural = 0.0F;
  for (const std::string& title : titles) {
    widths.push_back(
        std::ceil(frame.text_size(Ui::Frame::shown(title), frame.state.fonts->text).x));
    natural += widths.back() + 2.0F * frame.d(10);
  }
  const float room = frame.room_width();
  const float padding = natural <= room ? frame.d(10) : frame.d(6);
  const float height = frame.d(kTabHeight);
  std::vector<ImRect> parts;
  ImVec2 at(0.0F, 0.0F);
  for (const float words : widths) {
    const float width = std::min(room, words + 2.0F * padding);
    if (at.x > 0.0F && at.x + width > room) at = {0.0F, at.y + height};
    parts.push_back({at, {at.x + width, at.y + height}});
    at.x += width;
  }
  return parts;
}

}  // namespace

std::optional<std::size_t> Ui::choice(const std::string& label,
                                      std::span<const std::string> items,
                                      std::size_t chosen,
                                      const Hint& hint) {
  Frame& frame = *frame_;
  const Look& colours = frame.state.look;
  const Placed placed = frame.place_labelled(label, frame.d(28));
  frame.last_id = placed.id;
  frame.is_last_hovered = ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled);
  frame.draw_label(placed, label);
  frame.fill(placed.field, frame.shade(colours.raised));
  Control& whole = frame.note(ControlKind::kChoice, label, placed.field);
  whole.value = item_at(items, chosen);
  whole.label_rect = rect_of(placed.label);
  frame.explain(hint);
  std::optional<std::size_t> clicked;
  ImGui::PushID(label.c_str());
  const std::size_t length = frame.prefix.size();
  frame.prefix += label + "/";
  const float width =
      placed.field.GetWidth() / static_cast<float>(std::max<std::size_t>(1, items.size()));
  for (std::size_t i = 0; i < items.size(); ++i) {
    const float left = std::floor(placed.field.Min.x + width * static_cast<float>(i));
    const float right = i + 1 == items.size()
                            ? placed.field.Max.x
                            : std::floor(placed.field.Min.x + width * static_cast<float>(i + 1));
    const ImRect part({left, placed.field.Min.y}, {right, placed.field.Max.y});
    const ImGuiID id = ImGui::GetCurrentWindow()->GetID(items[i].c_str());
    frame.add_part(part, id);
    const Pressed pressed =
        frame.press(part, id, 0, one_of(placed.id, i == chosen, Arrows::kSideways));
    const bool is_chosen = i == chosen;
    if (is_chosen) {
      frame.fill(part, frame.shade(colours.accent_soft));
    } else if (pressed.is_hovered) {
      frame.fill(part, colours.hovered);
    }
    if (i > 0 && !is_chosen && i - 1 != chosen)
      frame.fill({{left, part.Min.y + frame.d(7)}, {left + 1.0F, part.Max.y - frame.d(7)}},
                 frame.shade(colours.line), 0.0);
    ImRect words = part;
    words.Expand({-std::min(frame.d(4), part.GetWidth() / 4.0F), 0.0F});
    frame.write_in(words, Frame::shown(items[i]), frame.state.fonts->text,
                   frame.shade(is_chosen ? colours.text : colours.muted), Align::kCentre);
    if (is_chosen) frame.frame(part, frame.shade(colours.accent));
    Control& control = frame.note(ControlKind::kChoice, items[i], part);
    control.is_selected = is_chosen;
    control.value = is_chosen ? "on" : "off";
    frame.explain(hint);
    if (pressed.was_clicked && !is_chosen) clicked = i;
  }
  frame.frame(placed.field, frame.shade(colours.line));
  if (chosen < items.size()) {
    const float left = std::floor(placed.field.Min.x + width * static_cast<float>(chosen));
    const float right =
        chosen + 1 == items.size()
            ? placed.field.Max.x
            : std::floor(placed.field.Min.x + width * static_cast<float>(chosen + 1));
    frame.frame({{left, placed.field.Min.y}, {right, placed.field.Max.y}},
                frame.shade(colours.accent));
  }
  frame.prefix.resize(length);
  ImGui::PopID();
  return clicked;
}

std::optional<std::size_t> Ui::radio(const std::string& label,
                                     std::span<const std::string> items,
                                     std::size_t chosen) {
  Frame& frame = *frame_;
  const Look& colours = frame.state.look;
  if (!Frame::shown(label).empty()) text(Frame::shown(label));
  const Scope inside = frame.push_scope(label, true);
  const ImGuiID group = ImGui::GetCurrentWindow()->GetID("##radio");
  std::optional<std::size_t> clicked;
  for (std::size_t i = 0; i < items.size(); ++i) {
    const std::string words = Frame::shown(items[i]);
    const float width =
        frame.d(24) + std::ceil(frame.text_size(words, frame.state.fonts->text).x) + 1.0F;
    const Placed placed = frame.place(items[i], {width, frame.d(28)}, 0.0F);
    const Pressed pressed = frame.press(placed, 0, one_of(group, i == chosen, Arrows::kAll));
    const bool is_chosen = i == chosen;
    const ImVec2 middle(placed.box.Min.x + frame.d(8), std::floor(placed.box.GetCenter().y));
    ImDrawList* const list = ImGui::GetWindowDrawList();
    list->AddCircleFilled(middle, frame.d(8),
                          frame.shade(is_chosen            ? colours.accent
                                      : pressed.is_hovered ? colours.hovered
                                                           : colours.raised));
    if (is_chosen) {
      list->AddCircleFilled(middle, frame.d(3), frame.shade(colours.on_accent));
    } else {
      list->AddCircle(middle, frame.d(8), frame.shade(colours.muted));
    }
    frame.write_in({{placed.box.Min.x + frame.d(24), placed.box.Min.y},
                    {placed.box.Max.x + 1.0F, placed.box.Max.y}},
                   words, frame.state.fonts->text, frame.shade(colours.text));
    Control& control = frame.note(ControlKind::kChoice, items[i], placed.box);
    control.is_selected = is_chosen;
    control.value = is_chosen ? "on" : "off";
    if (pressed.was_clicked && !is_chosen) clicked = i;
  }
  return clicked;
}

std::optional<std::size_t> Ui::combo(const std::string& label,
                                     std::span<const std::string> items,
                                     std::size_t chosen,
                                     const Hint& hint) {
  Frame& frame = *frame_;
  const Look& colours = frame.state.look;
  const Placed placed = frame.place_labelled(label, frame.d(28));
  const Pressed pressed = frame.press(placed, 0, {.opens_down = true});
  const bool was_opened = pressed.was_clicked || frame.arrow_steps(placed.id, Arrows::kUpDown) != 0;
  const ImGuiID popup = ImHashStr("##list", 0, placed.id);
  const bool is_open = ImGui::IsPopupOpen(popup, ImGuiPopupFlags_None);
  frame.draw_label(placed, label);
  frame.fill(placed.field,
             frame.shade(pressed.is_hovered || is_open ? colours.hovered : colours.raised));
  frame.frame(placed.field, frame.shade(is_open ? colours.accent : colours.line));
  ImRect words = placed.field;
  words.Min.x += frame.d(8);
  words.Max.x -= frame.d(24);
  frame.write_in(words, item_at(items, chosen), frame.state.fonts->text, frame.shade(colours.text));
  frame.write_icon({{placed.field.Max.x - frame.d(24), placed.field.Min.y}, placed.field.Max},
                   Icon::kCaretDown, frame.shade(colours.muted));
  Control& control = frame.note(ControlKind::kCombo, label, placed.field);
  control.value = item_at(items, chosen);
  control.label_rect = rect_of(placed.label);
  frame.explain(hint);
  if (was_opened && !is_open) ImGui::OpenPopupEx(popup, ImGuiPopupFlags_None);
  if (!is_open) return std::nullopt;
  std::optional<std::size_t> picked;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(frame.d(4), frame.d(4)));
  if (ImGui::BeginComboPopup(popup, placed.field, ImGuiComboFlags_HeightLarge)) {
    const std::size_t length = frame.prefix.size();
    frame.prefix += label + "/";
    for (std::size_t i = 0; i < items.size(); ++i) {
      ListRow row;
      row.is_selected = i == chosen;
      if (list_row(items[i], row)) {
        if (i != chosen) picked = i;
        ImGui::CloseCurrentPopup();
      }
    }
    frame.prefix.resize(length);
    ImGui::EndCombo();
  }
  ImGui::PopStyleVar();
  return picked;
}

std::optional<std::size_t> Ui::tabs(const std::string& name,
                                    std::span<const std::string> titles,
                                    std::size_t chosen) {
  Frame& frame = *frame_;
  const Look& colours = frame.state.look;
  const std::vector<ImRect> parts = tab_parts(frame, titles);
  const float height = parts.empty() ? frame.d(kTabHeight) : parts.back().Max.y;
  const Placed placed = frame.place(name, {frame.room_width(), height}, frame.d(8));
  const Scope inside = frame.push_scope(name, true);
  for (float y = frame.d(kTabHeight); y <= height; y += frame.d(kTabHeight)) {
    const float bottom = placed.box.Min.y + y;
    frame.fill({{placed.box.Min.x, bottom - 1.0F}, {placed.box.Max.x, bottom}}, colours.line, 0.0);
  }
  std::optional<std::size_t> clicked;
  for (std::size_t i = 0; i < titles.size(); ++i) {
    const std::string words = Frame::shown(titles[i]);
    ImRect part = parts[i];
    part.Translate(placed.box.Min);
    const ImGuiID id = ImGui::GetCurrentWindow()->GetID(titles[i].c_str());
    frame.add_part(part, id);
    const Pressed pressed =
        frame.press(part, id, 0, one_of(placed.id, i == chosen, Arrows::kSideways));
    const bool is_chosen = i == chosen;
    if (is_chosen)
      frame.fill({{part.Min.x, part.Max.y - frame.d(2)}, part.Max}, frame.shade(colours.accent),
                 0.0);
    ImRect room = part;
    room.Expand({-frame.d(4), 0.0F});
    const bool is_whole =
        frame.write_in(room, words, frame.state.fonts->text,
                       frame.shade(is_chosen || pressed.is_hovered ? colours.text : colours.muted),
                       Align::kCentre);
    frame.note(ControlKind::kTab, titles[i], part).is_selected = is_chosen;
    if (!is_whole) frame.explain({words, ""}, true);
    if (pressed.was_clicked && !is_chosen) clicked = i;
  }
  return clicked;
}

}  // namespace nadir::kit
