// SPDX-License-Identifier: Apache-2.0
// Walking through the controls with the keyboard.
#include "widgets/kit/ui_focus.h"

#include <algorithm>

#include "widgets/kit/ui_canvas.h"
#include "widgets/kit/ui_frame.h"

namespace nadir::kit {
namespace {

/// A frame two pixels wide along the box's edge, within a thinner one that parts it from what the control is filled with; on
/// what has the frame's own colour, in that of its words, with some of that colour around it.
void draw_ring(const UiContext::State& state, const Ui::Frame::Ring& ring) {
  const float wide = std::max(2.0F, std::floor(2.0F * narrow(state.scale)));
  const float radius = 4.0F * narrow(state.scale);
  ImRect outer = ring.box;
  outer.Expand(-wide * (ring.is_on_accent ? 1.5F : 0.5F));
  ImRect inner = ring.box;
  inner.Expand(-wide - 0.5F);
  ImDrawList& list = *ring.window->DrawList;
  list.PushClipRect(ring.clip.Min, ring.clip.Max);
  if (!ring.is_on_accent && inner.GetWidth() > 4.0F && inner.GetHeight() > 4.0F)
    list.AddRect(inner.Min, inner.Max, state.look.panel, radius, 0, 1.0F);
  list.AddRect(outer.Min, outer.Max, ring.is_on_accent ? state.look.on_accent : state.look.accent,
               radius, 0, wide);
  list.PopClipRect();
}

}  // namespace

void Ui::Frame::arrive_at(const PlacedStop& stop) {
  Focus& focus = state.focus;
  const bool is_same = focus.id == stop.id && state.draft.id == stop.id;
  focus.id = stop.id;
  focus.is_shown = focus.has_arrived = true;
  focus.stop = stop;
  if (is_same) return;
  state.focused_number = 0;
  if (state.draft.is_typing) ImGui::ClearActiveID();  // its own control sees that, and commits
}

void Ui::Frame::begin_focus() {
  move_focus();
  focus_before = state.focus.id;
}

void Ui::Frame::move_focus() {
  Focus& focus = state.focus;
  focus.has_arrived = focus.was_chosen = false;
  focus.took = Key::kNone;
  const auto& buttons = state.input.buttons;
  if (std::any_of(buttons.begin(), buttons.end(), [](bool is_down) { return is_down; })) {
    focus.is_shown = focus.wants_first = false;
    state.focused_number = 0;  // a click on a number gives it back to that
    for (auto& [layer, left] : focus.below) left.is_shown = false;
    return;
  }
  const Stops& stops = focus.stops;
  if (focus.wants_first && !stops.empty()) {
    focus.wants_first = false;
    const auto first = std::find_if(stops.begin(), stops.end(), [&stops](const PlacedStop& stop) {
      return stands_for_group(stops, stop);
    });
    if (focus.is_shown && place_of(stops, focus.id) == stops.size()) arrive_at(*first);
  }
  go_to_end();
  const Modifiers& held = state.input.modifiers;
  if (held.alt || held.super) return;
  if (went_down(Key::kTab, true)) return walk_by_tab(stops, held);
  if (ends_by_escape()) return;
  if (!focus.is_shown || held.ctrl || held.shift || state.draft.is_typing) return;
  const std::size_t here = place_of(stops, focus.id);
  if (here == stops.size() || walk_through_menus() || stops[here].group == 0) return;
  if (went_down(Key::kHome, false) || went_down(Key::kEnd, false)) {
    focus.to_end = went_down(Key::kHome, false) ? -1 : 1;
    focus.frames_to_end = 2;
    state.next_frame_within_s = 0.0;
  }
  const PlacedStop* const next = next_in_group(stops, stops[here]);
  if (next == nullptr || next->id == focus.id) return;
  arrive_at(*next);
  focus.was_chosen = next->is_chosen_by_arrows;
}

/// Home and End went to an end of what was in sight; in this frame the true end is there.
void Ui::Frame::go_to_end() {
  Focus& focus = state.focus;
  if (focus.frames_to_end == 0 || --focus.frames_to_end == 0) return;
  const std::size_t here = place_of(focus.stops, focus.id);
  if (!focus.is_shown || here == focus.stops.size() || focus.stops[here].group == 0) return;
  const PlacedStop& end = *end_of_group(focus.stops, focus.stops[here].group, focus.to_end > 0);
  if (end.id != focus.id) arrive_at(end);
}

/// Escape ends what is typed or stepped, or gives the keyboard back, and does nothing else then. Boxes close by it.
bool Ui::Frame::ends_by_escape() {
  Focus& focus = state.focus;
  if (focus.layer != 0 || !went_down(Key::kEscape, false)) return false;
  const Modifiers& held = state.input.modifiers;
  const bool gives_back = focus.is_shown && !state.draft.is_typing && !held.ctrl && !held.shift;
  if (!gives_back && !state.draft.is_typing && state.focused_number == 0) return false;
  focus.took = Key::kEscape;
  if (gives_back) focus.is_shown = false;
  return true;
}

void Ui::Frame::walk_by_tab(const Stops& stops, const Modifiers& held) {
  Focus& focus = state.focus;
  const bool is_typing = state.draft.is_typing;
  if (is_typing && state.draft.takes_tab && !held.shift && !held.ctrl) return;
  const bool is_inside =
      focus.is_shown || is_typing || state.focused_number != 0 || focus.layer > 0;
  if (!is_inside && !held.shift && !held.ctrl) return;  // a shortcut like any other
  focus.took = Key::kTab;
  const PlacedStop* next = nullptr;
  if (held.ctrl) {
    next = next_region(stops, focus, held.shift);
  } else if (!is_inside) {
    // Into the controls: to the one that the mouse used last.
    const std::size_t here = place_of(stops, focus.id);
    Focus from;
    next = here < stops.size() ? &stops[here] : next_stop(stops, from, false);
  } else {
    next = next_stop(stops, focus, held.shift);
  }
  if (next != nullptr) arrive_at(*next);
}

bool Ui::Frame::walk_through_menus() {
  Focus& focus = state.focus;
  const ImGuiContext& imgui = *ImGui::GetCurrentContext();
  const int depth = imgui.OpenPopupStack.Size;
  const int by = (went_down(Key::kRight, false) ? 1 : 0) - (went_down(Key::kLeft, false) ? 1 : 0);
  if (depth == 0 || by == 0 || goes_sideways(focus.stop.arrows)) return false;
  if (depth > 1 && by < 0) {
    focus.took = Key::kLeft;
    ImGui::ClosePopupToLevel(depth - 1, true);
    return true;
  }
  if (depth > 1 || focus.stop.opens_menu) return false;
  // The neighbour of the menu of a bar that this one hangs on.
  const auto left = focus.below.find(focus.layer - 1);
  if (left == focus.below.end()) return false;
  const std::size_t here = place_of(focus.lower, left->second.id);
  if (here == focus.lower.size() || focus.lower[here].group == 0 ||
      !goes_sideways(focus.lower[here].arrows))
    return false;
  std::vector<ImGuiID> bar;
  std::size_t at = 0;
  for (const PlacedStop& stop : focus.lower) {
    if (stop.group != focus.lower[here].group) continue;
    if (stop.id == left->second.id) at = bar.size();
    bar.push_back(stop.id);
  }
  focus.took = by > 0 ? Key::kRight : Key::kLeft;
  focus.wanted_menu = bar[(at + bar.size() + static_cast<std::size_t>(by + 1) - 1) % bar.size()];
  left->second.id = focus.wanted_menu;
  focus.id = 0;
  focus.wants_first = true;
  ImGui::ClosePopupToLevel(0, false);
  return true;
}

void Ui::Frame::add_stop(const ImRect& box, ImGuiID id, const Stop& stop) {
  constexpr ImGuiWindowFlags kUntouched = ImGuiWindowFlags_NoMouseInputs;
  ImGuiWindow* const window = ImGui::GetCurrentWindow();
  if (!stop.is_stop || is_disabled() || window->SkipItems || (window->Flags & kUntouched) != 0)
    return;
  if (!drawn_stops.empty() && drawn_stops.back().id == id) return;  // its typing begins
  PlacedStop placed;
  static_cast<Stop&>(placed) = stop;
  placed.id = id;
  placed.region = window->RootWindow->ID;
  placed.layer = kLayersOfABox * box_depth + ImGui::GetCurrentContext()->BeginPopupStack.Size;
  top_layer = std::max(top_layer, placed.layer);
  drawn_stops.push_back(placed);
  Focus& focus = state.focus;
  if (focus.id != id || !focus.is_shown) return;
  is_noting_focused = true;
  ring = Ring{window, box, window->ClipRect, false};
  if (!focus.has_arrived) return;
  // Its neighbours come into sight with it, so that lists which draw no more than that can be walked through.
  ImRect seen = box;
  seen.Expand({0.0F, box.GetHeight()});
  ImGui::ScrollToRect(window, seen, ImGuiScrollFlags_KeepVisibleEdgeY);
  state.next_frame_within_s = 0.0;
}

bool Ui::Frame::has_focus(ImGuiID id) const {
  return id != 0 && state.focus.is_shown && state.focus.id == id && !state.draft.is_typing &&
         !is_disabled();
}

bool Ui::Frame::has_arrived(ImGuiID id) const {
  return state.focus.has_arrived && state.focus.id == id;
}

bool Ui::Frame::is_pressed_by_key(ImGuiID id) const {
  if (!has_focus(id)) return false;
  if (state.focus.has_arrived) return state.focus.was_chosen;
  return state.input.modifiers == Modifiers{} &&
         (went_down(Key::kSpace, false) || went_down(Key::kEnter, false) ||
          went_down(Key::kPadEnter, false));
}

int Ui::Frame::arrow_steps(ImGuiID id, Arrows arrows) const {
  if (!has_focus(id) || state.focus.has_arrived || !is_plain(state.input.modifiers)) return 0;
  int steps = 0;
  if (goes_sideways(arrows))
    steps += (went_down(Key::kRight, true) ? 1 : 0) - (went_down(Key::kLeft, true) ? 1 : 0);
  if (goes_up_and_down(arrows))
    steps += (went_down(Key::kUp, true) ? 1 : 0) - (went_down(Key::kDown, true) ? 1 : 0);
  return steps;
}

bool Ui::Frame::takes_key(const Chord& chord) const {
  const Focus& focus = state.focus;
  if (chord.key != Key::kNone && chord.key == focus.took) return true;
  const bool is_number = state.focused_number != 0;
  if ((!focus.is_shown && !is_number) || !is_plain(chord.modifiers)) return false;
  const Stop& stop = focus.stop;
  // Among others of a group it goes by the arrows alone.
  const bool has_arrows = focus.is_shown && (stop.group == 0 || !chord.modifiers.shift);
  switch (chord.key) {
    case Key::kSpace:
    case Key::kEnter:
      return focus.is_shown && (stop.takes_press || stop.takes_digits) && !chord.modifiers.shift;
    case Key::kLeft:
    case Key::kRight:
      return has_arrows && goes_sideways(stop.arrows);
    case Key::kUp:
    case Key::kDown:
      return (focus.is_shown && stop.opens_down) || (has_arrows && goes_up_and_down(stop.arrows));
    case Key::kHome:
    case Key::kEnd:
      return has_arrows && stop.group != 0;
    case Key::kDelete:
      return stop.takes_delete;
    default:
      break;
  }
  const bool is_digit = chord.key >= Key::k0 && chord.key <= Key::k9 && !chord.modifiers.shift;
  const bool is_sign = chord.character == '-' || chord.character == '.';
  return (is_digit || is_sign) && (is_number || (focus.is_shown && stop.takes_digits));
}

/// What opened above has the keyboard from now on, and what lies below gets it back where it was.
void Ui::Frame::change_layer() {
  Focus& focus = state.focus;
  const int before = std::exchange(focus.layer, top_layer);
  const bool is_other_box = std::exchange(focus.box, top_box) != top_box && top_box != 0;
  if (focus.layer > before) focus.below[before] = {focus_before, focus.is_shown, focus.place};
  if (focus.layer > before || (focus.layer == before && is_other_box)) {
    if (focus.id == focus_before) focus.id = 0;  // else something above has taken it already
    focus.wants_first = true;
    focus.place = 0;
    state.focused_number = 0;
  } else if (focus.layer < before) {
    const auto left = focus.below.find(focus.layer);
    if (left != focus.below.end()) {
      focus.id = left->second.id;
      focus.is_shown = left->second.is_shown;
      focus.place = left->second.place;
    }
    std::erase_if(focus.below, [&](const auto& one) { return one.first >= focus.layer; });
    if (is_other_box) focus.wants_first = true;  // where that one is not in it
  }
}

void Ui::Frame::end_focus() {
  Focus& focus = state.focus;
  if (ring) draw_ring(state, *ring);
  change_layer();
  focus.stops.clear();
  focus.lower.clear();
  for (const PlacedStop& stop : drawn_stops)
    (stop.layer == focus.layer ? focus.stops : focus.lower).push_back(stop);
  focus.wanted_menu = 0;
  if (place_of(focus.stops, state.focused_number) == focus.stops.size()) state.focused_number = 0;
  const std::size_t place = place_of(focus.stops, focus.id);
  if (place < focus.stops.size()) {
    focus.place = place;
    focus.stop = focus.stops[place];
  } else if (!focus.wants_first) {
    focus.stop = {};
    focus.stop.takes_press = false;
    if (focus.is_shown) focus.id = 0;  // nothing takes keys again by coming back
  }
}

}  // namespace nadir::kit
