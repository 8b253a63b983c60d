// SPDX-License-Identifier: Apache-2.0
#include "widgets/kit/ui.h"

#include <algorithm>

#include "widgets/kit/ui_canvas.h"
#include "widgets/kit/ui_frame.h"

namespace nadir::kit {
namespace {

bool is_arrow(Key key) {
  return key == Key::kLeft || key == Key::kRight || key == Key::kUp || key == Key::kDown;
}

bool is_up_or_down(Key key) {
  return key == Key::kUp || key == Key::kDown || key == Key::kPageUp || key == Key::kPageDown;
}

/// While text is typed, these still mean what they mean everywhere.
bool is_never_text(const Chord& chord) {
  if (chord.key >= Key::kF1 && chord.key <= Key::kF12) return true;
  if (chord.key == Key::kEscape) return true;
  // A list below an input is walked through while a text is typed into it.
  if (chord.key == Key::kUp || chord.key == Key::kDown || chord.key == Key::kPageUp ||
      chord.key == Key::kPageDown)
    return !chord.modifiers.ctrl && !chord.modifiers.shift;
  if (chord.modifiers.alt) return true;
  const bool is_one_line =
      (ImGui::GetCurrentContext()->InputTextState.Flags & ImGuiInputTextFlags_Multiline) == 0;
  if (is_one_line && is_up_or_down(chord.key))
    return true;  // lists under a search are gone through with them
  if (!chord.modifiers.ctrl) return false;
  switch (chord.key) {  // these edit the text
    case Key::kUp:
    case Key::kDown:
    case Key::kA:
    case Key::kC:
    case Key::kV:
    case Key::kX:
    case Key::kY:
    case Key::kZ:
    case Key::kLeft:
    case Key::kRight:
    case Key::kHome:
    case Key::kEnd:
    case Key::kBackspace:
    case Key::kDelete:
      return false;
    default:
      return true;
  }
}

}  // namespace

Ui::Ui(UiContext& context) : frame_(std::make_unique<Frame>(context)) {}
Ui::~Ui() = default;

Scope Ui::scope(const std::string& name) { return frame_->push_scope(name, true); }

Scope Ui::disabled(bool is_disabled, const std::string& because) {
  if (!is_disabled) return {true, nullptr};
  Frame& frame = *frame_;
  frame.disabled_reasons.push_back(because);
  ImGui::BeginDisabled();
  return {true, [&frame] {
            ImGui::EndDisabled();
            frame.disabled_reasons.pop_back();
          }};
}

const Theme& Ui::theme() const { return nadir::theme(frame_->state.theme); }
ThemeName Ui::theme_name() const { return frame_->state.theme; }
double Ui::px(double design_length) const {
  return std::floor(design_length * frame_->state.scale + 0.5);
}
double Ui::scale() const { return frame_->state.scale; }
bool Ui::is_motion_reduced() const { return frame_->state.is_motion_reduced; }

Rect Ui::screen() const {
  const Eigen::Vector2d& size = frame_->state.input.size_px;
  return {0.0, 0.0, size.x(), size.y()};
}

bool Ui::is_pressed(const Chord& chord, bool with_repeats) const {
  const FrameInput& input = frame_->state.input;
  if (wants_text() && !is_never_text(chord)) return false;
  const bool is_popup_open = ImGui::GetCurrentContext()->OpenPopupStack.Size > 0;
  if (is_popup_open) return false;
  if (frame_->state.focused_number != 0 && is_plain(chord.modifiers) &&
      (is_arrow(chord.key) || chord.key == Key::kEnter || chord.key == Key::kEscape))
    return false;
  if (frame_->takes_key(chord)) return false;
  if (chord.character != 0 && !chord.modifiers.ctrl && !chord.modifiers.alt) {
    // Whatever was held down for it: on many keyboards "[" is typed with the right Alt.
    return input.characters.find(chord.character) != std::string::npos;
  }
  Key key = chord.key;
  if (chord.character != 0)
    key = chord.character == '+' ? Key::kEqual : static_cast<Key>(chord.character);
  Modifiers held = input.modifiers;
  if (chord.character == '+') held.shift = chord.modifiers.shift;
  return key != Key::kNone && held == chord.modifiers &&
         ImGui::IsKeyPressed(static_cast<int>(key), with_repeats);
}

bool Ui::is_pressed(std::string_view chord, bool with_repeats) const {
  const auto parsed = parse_chord(chord);
  return parsed && is_pressed(*parsed, with_repeats);
}

bool Ui::wants_text() const {
  return ImGui::GetIO().WantTextInput || frame_->state.draft.is_typing;
}

bool Ui::wants_mouse() const {
  const ImGuiContext& imgui = *ImGui::GetCurrentContext();
  if (frame_->state.area_press.id != 0) return false;
  return imgui.ActiveId != 0 || imgui.OpenPopupStack.Size > 0 ||
         (imgui.HoveredIdPreviousFrame != 0 &&
          imgui.HoveredIdPreviousFrame != frame_->state.hovered_area);
}

std::vector<std::string> Ui::turned_sections() const {
  const std::set<std::string>& turned = frame_->state.turned_sections;
  return {turned.begin(), turned.end()};
}

void Ui::set_turned_sections(std::span<const std::string> paths) {
  frame_->state.turned_sections = {paths.begin(), paths.end()};
}

std::string Ui::clipboard() const {
  const char* const text = ImGui::GetClipboardText();
  return text == nullptr ? std::string() : text;
}

bool Ui::is_holding() const {
  const auto& buttons = frame_->state.input.buttons;
  return ImGui::GetCurrentContext()->ActiveId != 0 ||
         std::any_of(buttons.begin(), buttons.end(), [](bool is_down) { return is_down; });
}

Modifiers Ui::modifiers() const { return frame_->state.input.modifiers; }

const std::vector<Control>& Ui::controls() const { return frame_->controls; }

}  // namespace nadir::kit
