// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "core/base/require.h"
#include "widgets/kit/number_text.h"
#include "widgets/kit/ui_canvas.h"
#include "widgets/kit/ui_frame.h"

namespace nadir::kit {
namespace {

constexpr float kDragThreshold = 3.0F;
constexpr int kManySteps = 10;  ///< Of an arrow with Shift.

Stop number_stop(const NumberOptions& options) {
  return {.takes_press = false,
          .arrows = Arrows::kAll,
          .takes_delete = options.reset.has_value(),
          .takes_digits = true};
}

/// What is typed over a number that has the keyboard takes its place.
bool is_begin_of_number(const FrameInput& input) {
  return !input.characters.empty() &&
         input.characters.find_first_not_of("0123456789.-") == std::string::npos;
}

double per_pixel(const NumberOptions& options) {
  if (options.per_pixel > 0.0) return options.per_pixel;
  const double range = options.most - options.least;
  const double step = step_of(options);
  return std::isfinite(range) ? std::max(step / 10.0, range / 300.0) : step;
}

}  // namespace

/// The common end of all numbers: what the draft says, what was committed, what a double click on the label resets.
Edit<double> Ui::Frame::finish_number(ImGuiID id, double value, Edit<double> edit, bool is_done) {
  if (const Draft* const current = draft(id)) {
    edit.is_changed = edit.value != current->number;
    state.draft.number = edit.value;
    edit.is_editing = !is_done;
    edit.was_ended = is_done;
    if (is_done) {
      edit.was_committed = edit.value != current->start_number;
      end_draft();
    }
  } else {
    edit.is_changed = edit.value != value;
  }
  return edit;
}

bool Ui::Frame::is_label_hovered(const Placed& placed) const {
  return placed.label.GetWidth() > 0.0F &&
         ImGui::IsMouseHoveringRect(placed.label.Min, placed.label.Max) && ImGui::IsWindowHovered();
}

bool Ui::Frame::reset_clicked(const Placed& placed) const {
  return !is_disabled() && ImGui::IsMouseDoubleClicked(0) && is_label_hovered(placed);
}

/// The field's own typing: Enter, or a click elsewhere, commits what can be read.
Edit<double> Ui::Frame::type_number(const ImRect& box,
                                    ImGuiID id,
                                    const std::string& label,
                                    double value,
                                    const NumberOptions& options) {
  Edit<double> edit;
  edit.value = draft(id)->number;
  is_last_hovered = false;  // the tooltip of a text that is being typed says what is wrong with it
  add_stop(box, id, number_stop(options));
  const bool begins_at_end = std::exchange(draft(id)->begins_at_end, false);
  const bool has_keyboard =
      type_draft(box, id, label, state.fonts->numbers, ImGuiInputTextFlags_AutoSelectAll);
  if (begins_at_end) put_caret_at_end(id);
  if (has_keyboard) {
    edit.is_editing = true;
    const std::string complaint = number_complaint(draft(id)->text, options);
    frame(box, complaint.empty() ? state.look.accent : state.look.bad);
    if (!complaint.empty()) tooltip = TooltipWish{label, {}, {}, {complaint}, box, false};
    return edit;
  }
  const Draft& current = *draft(id);
  const bool was_escaped = ImGui::IsKeyPressed(static_cast<int>(Key::kEscape), false);
  const auto read = was_escaped       ? std::nullopt
                    : options.refuses ? read_number_within(current.text, options)
                                      : read_number(current.text, options);
  edit.value = read.value_or(current.start_number);
  if (!read && !was_escaped && options.refuses) edit.refused = current.text;
  // What was not touched is not rounded to its digits.
  if (current.text == digits_text(current.start_number, options)) {
    edit.value = current.start_number;
    edit.refused.clear();
  }
  const bool has_gone_on = state.focus.has_arrived && state.focus.id != id;
  const auto& buttons = state.input.buttons;
  const bool was_left =
      std::any_of(buttons.begin(), buttons.end(), [](bool is_down) { return is_down; });
  if (!has_gone_on) state.focused_number = was_escaped || was_left ? 0 : id;
  return finish_number(id, value, edit, true);
}

/// A field with a number in it that is dragged sideways, stepped and typed into.
Edit<double> Ui::Frame::edit_number(const ImRect& box,
                                    ImGuiID id,
                                    const std::string& label,
                                    double value,
                                    const NumberOptions& options) {
  if (const Draft* const current = draft(id); current != nullptr && current->is_typing)
    return type_number(box, id, label, value, options);
  if (const auto left = take_abandoned(id)) {
    const bool is_untouched = left->text == digits_text(left->start_number, options);
    const auto read = options.refuses ? read_number_within(left->text, options)
                                      : read_number(left->text, options);
    const double typed = is_untouched ? left->start_number : read.value_or(value);
    Edit<double> edit{typed, typed != value, false, typed != left->start_number, false};
    edit.was_ended = true;
    if (!is_untouched && !read && options.refuses) edit.refused = left->text;
    return edit;
  }
  const Pressed pressed =
      press(box, id, ImGuiButtonFlags_PressedOnClick | ImGuiButtonFlags_PressedOnDoubleClick,
            number_stop(options));
  const ImGuiIO& io = ImGui::GetIO();
  if (has_focus(id)) state.focused_number = id;
  const bool has_keys = state.focused_number == id && !is_disabled() && !io.WantTextInput &&
                        is_plain(state.input.modifiers);
  Edit<double> edit;
  edit.value = value;
  // Space is the window's, but for what has the keyboard's frame.
  const bool enters =
      has_keys && (went_down(Key::kEnter, false) || went_down(Key::kPadEnter, false) ||
                   (has_focus(id) && !io.KeyShift && went_down(Key::kSpace, false)));
  const std::string typed =
      has_keys && is_begin_of_number(state.input) ? state.input.characters : std::string();
  if ((pressed.was_clicked && (io.KeyCtrl || ImGui::IsMouseDoubleClicked(0))) || enters ||
      !typed.empty()) {
    if (ImGui::GetCurrentContext()->ActiveId == id) ImGui::ClearActiveID();
    Draft& begun = begin_draft(id);
    begun.number = begun.start_number = value;
    begun.text = !typed.empty()            ? typed
                 : options.refused.empty() ? digits_text(value, options)
                                           : options.refused;
    begun.begins_at_end = !typed.empty();
    begun.is_typing = true;
    return type_number(box, id, label, value, options);
  }
  if (pressed.was_clicked) {
    Draft& begun = begin_draft(id);
    begun.number = begun.start_number = value;
  }
  if (Draft* const current = draft(id)) {
    const float moved = io.MousePos.x - io.MouseClickedPos[0].x;
    if (std::abs(moved) >= kDragThreshold) current->was_dragged = true;
    edit.value = current->number;
    if (pressed.is_held && current->was_dragged) {
      const double speed = per_pixel(options) * (io.KeyShift ? 10.0 : io.KeyAlt ? 0.1 : 1.0);
      edit.value = kept_digits(current->start_number + moved * speed / state.scale, options);
    }
    if (!pressed.is_held && !current->was_dragged) state.focused_number = id;
    edit = finish_number(id, value, edit, !pressed.is_held);
  } else if (has_keys) {
    const int steps = (went_down(Key::kRight, true) || went_down(Key::kUp, true) ? 1 : 0) -
                      (went_down(Key::kLeft, true) || went_down(Key::kDown, true) ? 1 : 0);
    if (went_down(Key::kEscape, true)) state.focused_number = 0;
    if (steps != 0)
      edit.value =
          kept_digits(value + steps * step_of(options) * (io.KeyShift ? kManySteps : 1.0), options);
    if (options.reset && went_down(Key::kDelete, false)) edit.value = *options.reset;
    edit.is_changed = edit.was_committed = edit.value != value;
  }
  if (pressed.is_hovered && !is_disabled()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  const Look& colours = state.look;
  fill(box, shade(pressed.is_hovered || pressed.is_held ? colours.hovered : colours.raised));
  const bool is_refused = !options.refused.empty() && !edit.is_changed;
  frame(box, shade(state.focused_number == id || pressed.is_held ? colours.accent
                   : is_refused                                  ? colours.bad
                                                                 : colours.line));
  ImRect inside = box;
  inside.Expand({-d(6), 0.0F});
  if (!options.unit.empty()) {
    const float unit = text_size(options.unit, state.fonts->text).x;
    write_in({{std::max(inside.Min.x, inside.Max.x - unit), inside.Min.y},
              {inside.Max.x + 1.0F, inside.Max.y}},
             options.unit, state.fonts->text, shade(colours.muted));
    inside.Max.x -= unit + d(4);
  }
  write_in(inside, is_refused ? options.refused : digits_text(edit.value, options),
           state.fonts->numbers, shade(is_refused ? colours.bad : colours.text), Align::kRight);
  return edit;
}

Edit<double> Ui::number_input(const std::string& label,
                              double value,
                              const NumberOptions& options) {
  Frame& frame = *frame_;
  const Placed placed = frame.place_labelled(label, frame.d(28));
  const bool is_marked = options.reset && *options.reset != value;
  frame.draw_label(placed, label, is_marked);
  Edit<double> edit = frame.edit_number(placed.field, placed.id, label, value, options);
  if (options.reset && is_marked && frame.reset_clicked(placed)) {
    edit = {*options.reset, true, false, true, true};
  }
  Control& control = frame.note(ControlKind::kNumber, label, placed.field);
  control.label_rect = rect_of(placed.label);
  control.value = options.refused.empty() || edit.is_changed ? digits_text(edit.value, options)
                                                             : options.refused;
  frame.is_last_hovered = frame.is_last_hovered || frame.is_label_hovered(placed);
  frame.explain(number_hint(options));
  return edit;
}

}  // namespace nadir::kit
