// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "core/base/require.h"
#include "widgets/canvas/printable.h"
#include "widgets/kit/ui_canvas.h"
#include "widgets/kit/ui_frame.h"
#include "widgets/kit/wrapped_lines.h"

namespace nadir::kit {
namespace {

constexpr double kDelayS = 0.45;
constexpr double kFocusedForS = 4.0;  ///< What the keyboard came to; longer it would be in the way.
constexpr std::size_t kCharacters = 60, kCharactersMore = 12;  ///< Of a line.

/// All words of tooltips are wrapped here. @returns characters of the last line.
std::size_t write_words(const std::string& words, ImFont* font, ImU32 colour) {
  ImGui::PushFont(font);
  ImGui::PushStyleColor(ImGuiCol_Text, colour);
  std::size_t last = 0;
  for (const std::string& line : wrapped_lines(words, kCharacters)) {
    ImGui::TextUnformatted(printable(line).c_str());
    last = character_count(line);
  }
  ImGui::PopStyleColor();
  ImGui::PopFont();
  return last;
}

void write_hint(const Ui::Frame& frame, const TooltipWish& wish) {
  const Look& look = frame.state.look;
  const FontSet& fonts = *frame.state.fonts;
  const Hint& hint = wish.hint;
  std::size_t used = write_words(hint.text, fonts.text, look.text);
  // Unit and keys stand behind the last line, and may end somewhat farther.
  for (const std::string& words : {hint.unit, hint.shortcut}) {
    if (words.empty()) continue;
    const std::size_t length = character_count(words) + 2;
    const bool is_beside = used > 0 && used + length <= kCharacters + kCharactersMore;
    if (is_beside) ImGui::SameLine(0.0F, frame.d(8));
    used = (is_beside ? used : 0) + length;
    write_words(words, fonts.text, look.muted);
  }
  write_words(hint.source, fonts.text, look.muted);
  write_words(wish.because, fonts.text, look.warning);
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

/// Without what ends it: "Open…" and "open" say the same.
bool is_same_words(const std::string& first, const std::string& second) {
  const auto bare = [](const std::string& words) {
    std::string kept;
    for (const char sign : words) {
      if (sign >= 'A' && sign <= 'Z') kept += static_cast<char>(sign - 'A' + 'a');
      if (sign >= 'a' && sign <= 'z') kept += sign;
      if (sign >= '0' && sign <= '9') kept += sign;
    }
    return kept;
  };
  return !bare(first).empty() && bare(first) == bare(second);
}

/// Others have a name that only tests and scripts see.
bool shows_label(ControlKind kind) {
  return kind != ControlKind::kIconButton && kind != ControlKind::kEye &&
         kind != ControlKind::kMenu && kind != ControlKind::kArea &&
         kind != ControlKind::kSplitter && kind != ControlKind::kGrip;
}

}  // namespace

void Ui::Frame::explain(const Hint& said, bool was_cut) {
  NADIR_REQUIRE(!controls.empty());
  Control& control = controls.back();
  Hint hint = said;
  if (!was_cut && shows_label(control.kind) && is_same_words(hint.text, control.label)) {
    hint.text.clear();
  }
  std::string words = hint.text;
  if (!hint.unit.empty()) words += (words.empty() ? "" : " ") + ("[" + hint.unit + "]");
  if (!hint.source.empty()) words += (words.empty() ? "" : ", ") + hint.source;
  if (!hint.shortcut.empty()) words += (words.empty() ? "" : " ") + ("(" + hint.shortcut + ")");
  if (is_disabled() && !disabled_reasons.back().empty())
    words += (words.empty() ? "" : ". ") + disabled_reasons.back();
  control.tooltip = words;
  if (is_last_hovered && !words.empty()) wish_tooltip(control, hint);
  if (!control.is_focused || is_last_hovered || tooltip || words.empty()) return;
  wish_tooltip(control, hint);
  // Under it, or over it at the lower end of the window.
  const double below = control.rect.bottom() + d(6);
  const bool is_low = below + d(96) > state.input.size_px.y();
  tooltip->place = im({std::max(0.0, std::min(control.rect.left, state.input.size_px.x() - d(320))),
                       is_low ? control.rect.top - d(6) : below});
  tooltip->is_above = is_low;
}

void Ui::Frame::wish_tooltip(const Control& control, const Hint& hint) {
  tooltip = TooltipWish{control.path, hint, is_disabled() ? disabled_reasons.back() : std::string(),
                        {},           {},   false};
}

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
    if (tooltip->place && state.hovered_s > kFocusedForS) return;
    if (tooltip->place)
      state.next_frame_within_s =
          std::min(state.next_frame_within_s, kFocusedForS - state.hovered_s + 0.01);
  }
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(d(10), d(7)));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, d(4));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(d(8), d(2)));
  if (tooltip->place)
    ImGui::SetNextWindowPos(*tooltip->place, ImGuiCond_Always,
                            {0.0F, tooltip->is_above ? 1.0F : 0.0F});
  ImGui::BeginTooltip();
  if (is_immediate) {
    for (std::size_t i = 0; i < tooltip->lines.size(); ++i) {
      write_words(tooltip->lines[i], i == 0 ? state.fonts->semibold : state.fonts->numbers,
                  i == 0 ? state.look.text : state.look.muted);
    }
  } else {
    write_hint(*this, *tooltip);
  }
  ImGui::EndTooltip();
  ImGui::PopStyleVar(3);
  state.tooltip = one_line(*tooltip);
}

void Ui::mouse_tooltip(std::span<const std::string> lines) {
  frame_->tooltip = TooltipWish{"mouse", {}, {}, {lines.begin(), lines.end()}, {}, false};
}

void Ui::hint(const Hint& hint) { frame_->explain(hint); }

}  // namespace nadir::kit
