// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <utility>

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

/// A piece of a tooltip: a line of its own, or behind the one before.
struct Piece {
  std::string words;
  ImFont* font = nullptr;
  ImU32 colour = 0;
  bool is_behind = false;
};

/// All words of tooltips are wrapped here. @returns characters of the last line.
std::size_t add_words(std::vector<Piece>& pieces,
                      const std::string& words,
                      ImFont* font,
                      ImU32 colour,
                      bool is_behind = false) {
  std::size_t last = 0;
  for (const std::string& line : wrapped_lines(words, kCharacters)) {
    pieces.push_back({printable(line), font, colour, std::exchange(is_behind, false)});
    last = character_count(line);
  }
  return last;
}

std::vector<Piece> pieces_of(const Ui::Frame& frame, const TooltipWish& wish) {
  const Look& look = frame.state.look;
  const FontSet& fonts = *frame.state.fonts;
  std::vector<Piece> pieces;
  for (const std::string& line : wish.lines) {
    const bool is_first = pieces.empty();
    add_words(pieces, line, is_first ? fonts.semibold : fonts.numbers,
              is_first ? look.text : look.muted);
  }
  if (!wish.lines.empty()) return pieces;
  const Hint& hint = wish.hint;
  std::size_t used = add_words(pieces, hint.text, fonts.text, look.text);
  // Unit and keys stand behind the last line, and may end somewhat farther.
  for (const std::string& words : {hint.unit, hint.shortcut}) {
    if (words.empty()) continue;
    const std::size_t length = character_count(words) + 2;
    const bool is_beside = used > 0 && used + length <= kCharacters + kCharactersMore;
    used = (is_beside ? used : 0) + length;
    add_words(pieces, words, fonts.text, look.muted, is_beside);
  }
  add_words(pieces, hint.source, fonts.text, look.muted);
  add_words(pieces, wish.because, fonts.text, look.warning);
  return pieces;
}

// Of the design: around the words, and between them.
constexpr double kAcross = 10.0, kDown = 7.0, kBehind = 8.0, kBetweenLines = 2.0;

/// Of the tooltip's window, before that is drawn.
ImVec2 size_of(const Ui::Frame& frame, const std::vector<Piece>& pieces) {
  ImVec2 size(0.0F, 0.0F);
  float line = 0.0F;
  for (const Piece& piece : pieces) {
    const float width = std::ceil(frame.text_size(piece.words, piece.font).x);
    line = piece.is_behind ? line + frame.d(kBehind) + width : width;
    if (!piece.is_behind) size.y += piece.font->FontSize + frame.d(kBetweenLines);
    size.x = std::max(size.x, line);
  }
  return {size.x + 2.0F * frame.d(kAcross), size.y + 2.0F * frame.d(kDown)};
}

void write_pieces(const Ui::Frame& frame, const std::vector<Piece>& pieces) {
  for (const Piece& piece : pieces) {
    if (piece.is_behind) ImGui::SameLine(0.0F, frame.d(kBehind));
    ImGui::PushFont(piece.font);
    ImGui::PushStyleColor(ImGuiCol_Text, piece.colour);
    ImGui::TextUnformatted(piece.words.c_str());
    ImGui::PopStyleColor();
    ImGui::PopFont();
  }
}

/// Where a tooltip stands wholly in the window and covers nothing of what it explains: under it, else over it, else beside
/// it; where there is no room at all, at the end of the window.
ImVec2 place_beside(const Ui::Frame& frame,
                    const ImRect& box,
                    const ImVec2& size,
                    float wanted_left) {
  const ImVec2 screen = im(frame.state.input.size_px);
  const float gap = frame.d(6);
  const float most_left = std::max(0.0F, screen.x - size.x), most_top = screen.y - size.y;
  const float left = std::clamp(wanted_left, 0.0F, most_left);
  if (box.Max.y + gap <= most_top) return {left, box.Max.y + gap};
  if (box.Min.y - gap - size.y >= 0.0F) return {left, box.Min.y - gap - size.y};
  const float top = std::clamp(box.Min.y, 0.0F, std::max(0.0F, most_top));
  if (box.Max.x + gap <= most_left) return {box.Max.x + gap, top};
  if (box.Min.x - gap - size.x >= 0.0F) return {box.Min.x - gap - size.x, top};
  return {left, std::max(0.0F, most_top)};
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
  tooltip->beside = box_of(control.rect);
  tooltip->is_by_mouse = false;
}

void Ui::Frame::wish_tooltip(const Control& control, const Hint& hint) {
  constexpr double kMostBeside =
      96.0;  // of the design: of what is higher the end is far from the mouse
  tooltip = TooltipWish{control.path, hint, is_disabled() ? disabled_reasons.back() : std::string(),
                        {},           {},   true};
  if (control.rect.height <= d(kMostBeside)) tooltip->beside = box_of(control.rect);
}

void Ui::Frame::keep_tooltip_clear_of(TextLook look) {
  const bool is_message = look == TextLook::kBad || look == TextLook::kWarning;
  if (!is_message || !tooltip || !tooltip->beside) return;
  const ImRect message = box_of(controls.back().rect);
  const float below = message.Min.y - tooltip->beside->Max.y;
  if (below >= -1.0F && below <= d(12)) tooltip->beside->Max.y = message.Max.y;
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
    const bool is_by_keyboard = tooltip->beside && !tooltip->is_by_mouse;
    if (is_by_keyboard && state.hovered_s > kFocusedForS) return;
    if (is_by_keyboard)
      state.next_frame_within_s =
          std::min(state.next_frame_within_s, kFocusedForS - state.hovered_s + 0.01);
  }
  const std::vector<Piece> pieces = pieces_of(*this, *tooltip);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(d(kAcross), d(kDown)));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, d(4));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(d(kBehind), d(kBetweenLines)));
  if (tooltip->beside) {
    const float left =
        tooltip->is_by_mouse ? ImGui::GetIO().MousePos.x + d(12) : tooltip->beside->Min.x;
    ImGui::SetNextWindowPos(place_beside(*this, *tooltip->beside, size_of(*this, pieces), left));
  }
  ImGui::BeginTooltip();
  write_pieces(*this, pieces);
  ImGui::EndTooltip();
  ImGui::PopStyleVar(3);
  state.tooltip = one_line(*tooltip);
}

void Ui::mouse_tooltip(std::span<const std::string> lines) {
  frame_->tooltip = TooltipWish{"mouse", {}, {}, {lines.begin(), lines.end()}, {}, false};
}

void Ui::hint(const Hint& hint) { frame_->explain(hint); }

}  // namespace nadir::kit
