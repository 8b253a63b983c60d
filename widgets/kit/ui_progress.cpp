// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "widgets/kit/number_text.h"
#include "widgets/kit/ui_canvas.h"
#include "widgets/kit/ui_frame.h"

namespace nadir::kit {
namespace {

constexpr double kMotionS = 1.0 / 30.0;
constexpr double kSweepS = 1.6;

}  // namespace

bool Ui::progress(const std::string& name,
                  double share,
                  const std::string& words,
                  bool can_cancel) {
  Frame& frame = *frame_;
  const Look& colours = frame.state.look;
  const Placed placed = frame.place(name, {frame.room_width(), frame.d(40)}, frame.d(4));
  frame.is_last_hovered = ImGui::IsItemHovered();
  const float button_side = can_cancel ? frame.d(28) : 0.0F;
  ImRect words_box({placed.box.Min.x, placed.box.Min.y},
                   {placed.box.Max.x - button_side, placed.box.Min.y + frame.d(28)});
  const std::string percent =
      std::isnan(share) ? std::string()
                        : fmt::format("{:.0f} %", std::floor(100.0 * std::clamp(share, 0.0, 1.0)));
  if (!percent.empty()) {
    frame.write_in(words_box, percent, frame.state.fonts->numbers, frame.shade(colours.text),
                   Align::kRight);
    words_box.Max.x -= frame.text_size(percent, frame.state.fonts->numbers).x + frame.d(8);
  }
  const std::string title = Frame::shown(name);
  frame.write_in(words_box, title, frame.state.fonts->text, frame.shade(colours.text));
  const float title_width =
      title.empty() ? 0.0F : frame.text_size(title, frame.state.fonts->text).x + frame.d(8);
  words_box.Min.x = std::min(words_box.Max.x - 1.0F, words_box.Min.x + title_width);
  if (!words.empty())
    frame.write_in(words_box, words, frame.state.fonts->text, frame.shade(colours.muted));
  const ImRect track({placed.box.Min.x, placed.box.Max.y - frame.d(8)},
                     {placed.box.Max.x, placed.box.Max.y - frame.d(4)});
  frame.fill(track, frame.shade(colours.line), 2.0);
  ImRect done = track;
  if (std::isnan(share)) {
    const double phase =
        is_motion_reduced() ? 0.35 : std::fmod(ImGui::GetTime(), kSweepS) / kSweepS;
    const float length = track.GetWidth() * 0.3F;
    done.Min.x =
        std::max(track.Min.x, track.Min.x + narrow(phase) * (track.GetWidth() + length) - length);
    done.Max.x = std::min(track.Max.x, track.Min.x + narrow(phase) * (track.GetWidth() + length));
    if (!is_motion_reduced())
      frame.state.next_frame_within_s = std::min(frame.state.next_frame_within_s, kMotionS);
  } else {
    done.Max.x = track.Min.x + track.GetWidth() * narrow(std::clamp(share, 0.0, 1.0));
  }
  if (done.GetWidth() > 0.0F) frame.fill(done, frame.shade(colours.accent), 2.0);
  Control& control = frame.note(ControlKind::kProgress, name, placed.box);
  control.value = percent.empty() ? words : words.empty() ? percent : percent + ", " + words;
  if (!can_cancel) return false;
  ImGui::PushID(name.c_str());
  const ImRect cancel({placed.box.Max.x - frame.d(24), placed.box.Min.y + frame.d(2)},
                      {placed.box.Max.x, placed.box.Min.y + frame.d(26)});
  const ImGuiID id = ImGui::GetCurrentWindow()->GetID("Cancel");
  frame.add_part(cancel, id);
  const Pressed pressed = frame.press(cancel, id);
  if (pressed.is_hovered) frame.fill(cancel, colours.hovered);
  frame.write_icon(cancel, Icon::kClose,
                   frame.shade(pressed.is_hovered ? colours.text : colours.muted));
  frame.note(ControlKind::kIconButton, name + "/Cancel", cancel).label = "Cancel";
  frame.explain({"Cancel", ""});
  ImGui::PopID();
  return pressed.was_clicked;
}

Edit<std::size_t> Ui::grip(const std::string& name,
                           std::size_t place,
                           std::size_t count,
                           double row_height) {
  Frame& frame = *frame_;
  const Placed placed = frame.place(name, {frame.d(16), frame.d(28)}, 0.0F);
  const Pressed pressed = frame.press(placed, ImGuiButtonFlags_PressedOnClick,
                                      {.takes_press = false, .arrows = Arrows::kUpDown});
  Edit<std::size_t> edit;
  edit.value = place;
  const int up = frame.arrow_steps(placed.id, Arrows::kUpDown);
  if (up > 0 ? place > 0 : up < 0 && place + 1 < count) {
    edit.value = up > 0 ? place - 1 : place + 1;
    edit.is_changed = edit.was_committed = true;
  }
  const float mouse = ImGui::GetIO().MousePos.y;
  if (pressed.was_clicked) {
    Draft& begun = frame.begin_draft(placed.id);
    begun.start_number = static_cast<double>(place);
    begun.number = mouse;
    begun.text = std::to_string(place);
  }
  if (Draft* const current = frame.draft(placed.id)) {
    const double rows = std::round((mouse - current->number) / std::max(1.0, row_height));
    edit.value = static_cast<std::size_t>(
        std::clamp(current->start_number + rows, 0.0,
                   static_cast<double>(std::max<std::size_t>(1, count) - 1)));
    edit.is_changed = current->text != std::to_string(edit.value);
    current->text = std::to_string(edit.value);
    edit.is_editing = pressed.is_held;
    if (!pressed.is_held) {
      edit.was_committed = static_cast<double>(edit.value) != current->start_number;
      frame.end_draft();
    }
  }
  if (pressed.is_hovered || pressed.is_held) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeNS);
  const bool is_lit = pressed.is_hovered || pressed.is_held;
  const ImVec2 middle = placed.box.GetCenter();
  for (int row = -1; row <= 1; ++row) {
    for (int column = 0; column < 2; ++column) {
      const ImVec2 at(std::floor(middle.x) + (column == 0 ? -frame.d(2) : frame.d(2)),
                      std::floor(middle.y) + static_cast<float>(row) * frame.d(4));
      ImGui::GetWindowDrawList()->AddCircleFilled(
          at, 1.2F * narrow(frame.state.scale),
          frame.shade(is_lit ? frame.state.look.text : frame.state.look.muted), 8);
    }
  }
  frame.note(ControlKind::kGrip, name, placed.box).value = std::to_string(edit.value);
  frame.explain({"Drag to move", ""});
  return edit;
}

}  // namespace nadir::kit
