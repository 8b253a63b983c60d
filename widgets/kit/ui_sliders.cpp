// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "core/base/require.h"
#include "widgets/kit/number_text.h"
#include "widgets/kit/ui_canvas.h"
#include "widgets/kit/ui_frame.h"

namespace nadir::kit {
namespace {

constexpr double kTrackStep = 0.02;  ///< Of the whole track, by an arrow.
constexpr int kManyTrackSteps = 10;  ///< With Shift.

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

}  // namespace

/// What arrows and Delete make of a slider's value.
std::optional<double> Ui::Frame::number_by_keys(ImGuiID id,
                                                double value,
                                                const NumberOptions& options) const {
  if (!has_focus(id) || !is_plain(state.input.modifiers)) return std::nullopt;
  if (options.reset && went_down(Key::kDelete, false)) return options.reset;
  const int steps = arrow_steps(id, Arrows::kAll) * (ImGui::GetIO().KeyShift ? kManyTrackSteps : 1);
  if (steps == 0) return std::nullopt;
  if (options.step <= 0.0 && options.is_logarithmic)
    return value_at(share_of(value, options) + steps * kTrackStep, options);
  const double step = options.step > 0.0
                          ? options.step
                          : std::max(step_of(options), kTrackStep * (options.most - options.least));
  return kept_digits(value + steps * step, options);
}

/// A track with its knob; drags set the value from where the mouse is.
Edit<double> Ui::Frame::drag_track(const ImRect& box,
                                   ImGuiID id,
                                   double value,
                                   const NumberOptions& options) {
  const Stop stop{
      .takes_press = false, .arrows = Arrows::kAll, .takes_delete = options.reset.has_value()};
  const Pressed pressed = press(box, id, ImGuiButtonFlags_PressedOnClick, stop);
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
  } else if (const auto wanted = number_by_keys(id, value, options)) {
    edit.value = *wanted;
    edit.is_changed = edit.was_committed = edit.value != value;
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
