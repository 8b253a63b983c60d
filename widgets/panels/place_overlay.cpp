// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/place_overlay.h"

#include <fmt/format.h>

#include "core/session/place_text.h"
#include "widgets/panels/empty_state.h"
#include "widgets/panels/map_view.h"

namespace nadir {
namespace {

/// Nothing typed: how places are written, by the example of the view's middle. Else the place in those ways, or why not.
void draw_place_found(kit::Ui& ui,
                      const PlaceModel& model,
                      bool is_typed,
                      const Result<Eigen::Vector2d>& place) {
  ui.space(ui.px(4.0));
  if (is_typed && !place) {
    ui.wrapped(place.error().message, kit::TextLook::kBad);
    return;
  }
  const Eigen::Vector2d shown = is_typed ? *place : model.here_in_enu_m;
  const Geodetic position = model.plane->geodetic_from_enu(shown);
  ui.text(is_typed ? "This place" : "The middle of the view, in each way that is understood",
          kit::TextLook::kMuted);
  ui.space(ui.px(4.0));
  ui.read_out("Metres east and north", fmt::format("{:.1f} {:.1f}", shown.x(), shown.y()));
  ui.read_out("Latitude, longitude",
              fmt::format("{:.6f}, {:.6f}", position.latitude_deg, position.longitude_deg));
  ui.read_out("UTM", utm_text(position));
  ui.read_out("MGRS", mgrs_text(position));
}

}  // namespace

PlaceModel place_model(const Session& session) {
  PlaceModel model;
  model.is_open = session.overlay() == Overlay::kPlace;
  if (!model.is_open) return model;
  model.plane = plane_of(session);
  if (!model.plane) return model;
  model.here_in_enu_m = session.resolved_map_look().centre_in_enu_m;
  return model;
}

Actions draw_place_overlay(kit::Ui& ui, const PlaceModel& model, PlaceState& state) {
  if (!model.is_open || !state.is_open) state = {.is_open = model.is_open};
  if (!model.is_open) return {};
  const auto overlay =
      ui.overlay("Go to a place", {.width = ui.px(480.0), .place = kit::OverlayPlace::kUpperThird});
  if (!overlay) return {};
  const Actions closed = {actions::ShowOverlay{Overlay::kNone}};
  if (!model.plane) {
    Actions asked = draw_empty_state(ui, {kit::Icon::kMap,
                                          "No map and no run is open",
                                          "Open one of them to go to places on it.",
                                          "Open the demo",
                                          {},
                                          actions::OpenDemo{}});
    if (!asked.empty()) asked.insert(asked.begin(), closed.front());
    return overlay.wants_close() ? closed : asked;
  }
  ui.heading("Go to a place");
  const kit::TextEdit edit =
      ui.text_input("##Coordinates", state.typed,
                    {.placeholder = "Coordinates, in any of these ways", .takes_focus = true});
  state.typed = edit.value;
  const bool is_typed = state.typed.find_first_not_of(' ') != std::string::npos;
  const Result<Eigen::Vector2d> place = parse_place_text(state.typed, *model.plane);
  draw_place_found(ui, model, is_typed, place);
  ui.space();
  ui.right_align(ui.px(96.0));
  std::string why_not;
  if (!is_typed) why_not = "type coordinates first";
  if (is_typed && !place) why_not = "this is no place";
  const auto pale = ui.disabled(!why_not.empty(), why_not);
  ui.next_width(ui.px(96.0));
  const bool is_clicked =
      ui.button("Go", kit::ButtonLook::kPrimary, {.text = "Show this place", .shortcut = "Enter"});
  if ((is_clicked || edit.was_entered) && place) {
    return {closed.front(), actions::GoToPlace{state.typed}};
  }
  return edit.was_cancelled || overlay.wants_close() ? closed : Actions{};
}

}  // namespace nadir
