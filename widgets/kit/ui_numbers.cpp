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

/// Where on its track a value lies, 0 to 1.
double share_of(double value, const NumberOptions& options) {
  if (options.is_logarithmic) {
    return std::clamp(std::log(std::max(value, options.least) / options.least) /
                          std::log(options.most / options.least),
                      0.0, 1.0);
  }
  return std::clamp((value - options.least) / (options.most - options.least), 0.0, 1.0);
}

double value_at(double share, const NumberOptions& options) {
  const double clamped = std::clamp(share, 0.0, 1.0);
  const double value = options.is_logarithmic
                           ? options.least * std::pow(options.most / options.least, clamped)
                           : options.least + clamped * (options.most - options.least);
  return kept_digits(value, options);
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

/// A track with its knob; drags set the value from where the mouse is.
Edit<double> Ui::Frame::drag_track(const ImRect& box,
                                   ImGuiID id,
                                   double value,
                                   const NumberOptions& options) {
  const Pressed pressed = press(box, id, ImGuiButtonFlags_PressedOnClick);
  const float knob = d(6);
  const float left = box.Min.x + knob;
  const float right = std::max(left + 1.0F, box.Max.x - knob);
  Edit<double> edit;
  edit.value = value;
  if (pressed.was_clicked) {
    Draft& begun = begin_draft(id);
    begun.number = begun.start_number = value;
  }
  Draft* const current = draft(id);
  const bool is_mine = current != nullptr && !current->is_typing;
  if (is_mine) {
    edit.value = pressed.is_held
                     ? value_at((ImGui::GetIO().MousePos.x - left) / (right - left), options)
                     : current->number;
    edit = finish_number(id, value, edit, !pressed.is_held);
  }
  const float middle = std::floor(box.GetCenter().y);
  const float half = d(2);
  const float at =
      left +
      (right - left) * narrow(std::isfinite(edit.value) ? share_of(edit.value, options) : 0.0);
  const Look& colours = state.look;
  fill({{left - half, middle - half}, {right + half, middle + half}}, shade(colours.line), 2.0);
  fill({{left - half, middle - half}, {at, middle + half}}, shade(colours.accent), 2.0);
  ImDrawList* const list = ImGui::GetWindowDrawList();
  const bool is_lit = pressed.is_hovered || edit.is_editing;
  list->AddCircleFilled({at, middle}, knob, colours.panel);
  list->AddCircleFilled({at, middle}, is_lit ? knob : knob - 1.0F,
                        shade(is_lit ? colours.accent_hovered : colours.accent));
  return edit;
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
  if (type_draft(box, id, label, state.fonts->numbers, ImGuiInputTextFlags_AutoSelectAll)) {
    edit.is_editing = true;
    const std::string complaint = number_complaint(draft(id)->text, options);
    frame(box, complaint.empty() ? state.look.accent : state.look.bad);
    if (!complaint.empty())
      tooltip = TooltipWish{label, {}, {}, {complaint}, ImVec2(box.Min.x, box.Max.y + d(4))};
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
  state.focused_number = was_escaped ? 0 : id;
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
      press(box, id, ImGuiButtonFlags_PressedOnClick | ImGuiButtonFlags_PressedOnDoubleClick);
  const ImGuiIO& io = ImGui::GetIO();
  const bool had_focus = state.focused_number == id;
  if (ImGui::IsMouseClicked(0) && !pressed.is_hovered && had_focus) state.focused_number = 0;
  Edit<double> edit;
  edit.value = value;
  const bool enters = had_focus && !is_disabled() && !ImGui::GetIO().WantTextInput &&
                      (ImGui::IsKeyPressed(static_cast<int>(Key::kEnter), false) ||
                       ImGui::IsKeyPressed(static_cast<int>(Key::kPadEnter), false));
  if ((pressed.was_clicked && (io.KeyCtrl || ImGui::IsMouseDoubleClicked(0))) || enters) {
    if (ImGui::GetCurrentContext()->ActiveId == id) ImGui::ClearActiveID();
    Draft& begun = begin_draft(id);
    begun.number = begun.start_number = value;
    begun.text = options.refused.empty() ? digits_text(value, options) : options.refused;
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
  } else if (had_focus && !is_disabled()) {
    const auto went_down = [](Key key) { return ImGui::IsKeyPressed(static_cast<int>(key), true); };
    const int steps = (went_down(Key::kRight) || went_down(Key::kUp) ? 1 : 0) -
                      (went_down(Key::kLeft) || went_down(Key::kDown) ? 1 : 0);
    if (went_down(Key::kEscape)) state.focused_number = 0;
    edit.value =
        steps == 0
            ? value
            : kept_digits(value + steps * step_of(options) * (io.KeyShift ? 10.0 : 1.0), options);
    edit.is_changed = edit.was_committed = steps != 0 && edit.value != value;
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

Edit<double> Ui::slider(const std::string& label, double value, const NumberOptions& options) {
  NADIR_REQUIRE(std::isfinite(options.least) && options.most > options.least &&
                (!options.is_logarithmic || options.least > 0.0));
  Frame& frame = *frame_;
  const Placed placed = frame.place_labelled(label, frame.d(28));
  const bool is_marked = options.reset && *options.reset != value;
  frame.draw_label(placed, label, is_marked);
  const float widest =
      std::max(frame.text_size(digits_text(options.least, options), frame.state.fonts->numbers).x,
               frame.text_size(digits_text(options.most, options), frame.state.fonts->numbers).x);
  const float unit = options.unit.empty()
                         ? 0.0F
                         : frame.text_size(options.unit, frame.state.fonts->text).x + frame.d(4);
  const float number_width =
      std::min(placed.field.GetWidth() / 2.0F, std::ceil(widest + unit) + 2.0F * frame.d(6) + 2.0F);
  const ImRect track(placed.field.Min,
                     {placed.field.Max.x - number_width - frame.d(8), placed.field.Max.y});
  Edit<double> dragged = frame.drag_track(track, placed.id, value, options);
  const bool is_track_hovered = frame.is_last_hovered;
  if (options.reset && is_marked && frame.reset_clicked(placed))
    dragged = {*options.reset, true, false, true, true};
  Control& control = frame.note(ControlKind::kSlider, label, track);
  control.label_rect = rect_of(placed.label);
  control.value = digits_text(dragged.value, options);
  frame.is_last_hovered = is_track_hovered || frame.is_label_hovered(placed);
  frame.explain(number_hint(options));
  ImGui::PushID(label.c_str());
  const ImRect field({placed.field.Max.x - number_width, placed.field.Min.y}, placed.field.Max);
  const ImGuiID field_id = ImGui::GetCurrentWindow()->GetID("##value");
  frame.add_part(field, field_id);
  const Edit<double> typed = frame.edit_number(field, field_id, "value", dragged.value, options);
  Control& value_control = frame.note(ControlKind::kNumber, label + "/value", field);
  value_control.label = "value";
  value_control.value = options.refused.empty() || typed.is_changed
                            ? digits_text(typed.value, options)
                            : options.refused;
  frame.explain(number_hint(options));
  ImGui::PopID();
  return dragged.is_changed || dragged.is_editing || dragged.was_ended || dragged.was_committed
             ? dragged
             : typed;
}

Edit<double> Ui::small_slider(const std::string& name, double value, const NumberOptions& options) {
  NADIR_REQUIRE(std::isfinite(options.least) && options.most > options.least &&
                (!options.is_logarithmic || options.least > 0.0));
  Frame& frame = *frame_;
  const float width = frame.next_width > 0.0F ? frame.next_width : frame.room_width();
  const Placed placed = frame.place(name, {width, frame.d(28)}, frame.d(4));
  Edit<double> edit = frame.drag_track(placed.box, placed.id, value, options);
  frame.note(ControlKind::kSlider, name, placed.box).value = digits_text(edit.value, options);
  Hint hint = number_hint(options);
  if (hint.text.empty()) hint.text = Frame::shown(name);
  hint.text += " " + digits_text(edit.value, options);
  frame.explain(hint);
  return edit;
}

}  // namespace nadir::kit
