// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "widgets/kit/ui_canvas.h"
#include "widgets/kit/ui_frame.h"

namespace nadir::kit {
namespace {

constexpr double kDelayS = 0.45;
constexpr double kWidth = 340.0;

void write_words(const std::string& words, ImFont* font, ImU32 colour) {
  ImGui::PushFont(font);
  ImGui::PushStyleColor(ImGuiCol_Text, colour);
  ImGui::TextUnformatted(words.c_str());
  ImGui::PopStyleColor();
  ImGui::PopFont();
}

void write_hint(const Ui::Frame& frame, const TooltipWish& wish) {
  const Look& look = frame.state.look;
  const FontSet& fonts = *frame.state.fonts;
  const Hint& hint = wish.hint;
  const auto beside = [&frame] { ImGui::SameLine(0.0F, frame.d(8)); };
  if (!hint.text.empty()) write_words(hint.text, fonts.text, look.text);
  if (!hint.unit.empty()) {
    if (!hint.text.empty()) beside();
    write_words(hint.unit, fonts.text, look.muted);
  }
  if (!hint.shortcut.empty()) {
    if (!hint.text.empty() || !hint.unit.empty()) beside();
    write_words(hint.shortcut, fonts.text, look.muted);
  }
  if (!hint.source.empty()) write_words(hint.source, fonts.text, look.muted);
  if (!wish.because.empty()) write_words(wish.because, fonts.text, look.warning);
}

std::string one_line(const TooltipWish& wish) {
  std::string all;
  const auto add = [&all](const std::string& words) {
    if (words.empty()) return;
    if (!all.empty()) all += " · ";
    all += words;
  };
  add(wish.hint.text);
  add(wish.hint.unit);
  add(wish.hint.shortcut);
  add(wish.hint.source);
  add(wish.because);
  for (const std::string& line : wish.lines) add(line);
  return all;
}

}  // namespace

void Ui::Frame::show_tooltip() {
  state.tooltip.clear();
  const std::string path = tooltip ? tooltip->path : std::string();
  if (path != state.hover_path) {
    state.hover_path = path;
    state.hovered_s = 0.0;
  } else {
    state.hovered_s += state.input.delta_s;
  }
  if (!tooltip) return;
  const bool is_immediate = !tooltip->lines.empty();
  if (!is_immediate) {
    if (std::any_of(state.input.buttons.begin(), state.input.buttons.end(),
                    [](bool is_down) { return is_down; }))
      return;
    if (state.hovered_s < kDelayS) {
      state.next_frame_within_s =
          std::min(state.next_frame_within_s, kDelayS - state.hovered_s + 0.01);
      return;
    }
  }
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(d(10), d(7)));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, d(4));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(d(8), d(2)));
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(narrow(kWidth * state.scale));
  if (is_immediate) {
    for (std::size_t i = 0; i < tooltip->lines.size(); ++i) {
      write_words(tooltip->lines[i], i == 0 ? state.fonts->semibold : state.fonts->numbers,
                  i == 0 ? state.look.text : state.look.muted);
    }
  } else {
    write_hint(*this, *tooltip);
  }
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
  ImGui::PopStyleVar(3);
  state.tooltip = one_line(*tooltip);
}

void Ui::mouse_tooltip(std::span<const std::string> lines) {
  frame_->tooltip = TooltipWish{"mouse", {}, {}, {lines.begin(), lines.end()}};
}

void Ui::hint(const Hint& hint) { frame_->explain(hint); }

}  // namespace nadir::kit
