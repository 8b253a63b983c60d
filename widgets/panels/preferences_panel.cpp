// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/preferences_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "widgets/panels/panel_text.h"

namespace nadir {
namespace {

constexpr double kLeastMegabytes = 64.0, kMostMegabytes = 8192.0;

/// A slider of a number that says at itself why what was typed is not taken.
[[nodiscard]] std::optional<double> committed_number(kit::Ui& ui,
                                                     const std::string& label,
                                                     double value,
                                                     kit::NumberOptions options,
                                                     std::string& refused) {
  options.refuses = true;
  options.refused = refused;
  const auto edit = ui.slider(label, value, options);
  if (!edit.refused.empty()) {
    refused = edit.refused;
  } else if (edit.was_ended || edit.was_committed) {
    refused.clear();
  }
  if (!refused.empty()) {
    ui.wrapped(fmt::format("{} is not in [{:g}, {:g}] {}", refused, options.least, options.most,
                           options.unit),
               kit::TextLook::kBad);
  }
  return edit.was_committed ? std::optional(edit.value) : std::nullopt;
}

void draw_look_preferences(kit::Ui& ui,
                           const PreferencesModel& model,
                           PreferencesState& state,
                           Actions& asked) {
  const auto scope = ui.scope("Look");
  ui.text("Look", kit::TextLook::kMuted);
  const std::array<std::string, 2> themes = {"Light", "Dark"};
  const auto theme = ui.choice("Theme", themes, static_cast<std::size_t>(model.appearance.theme),
                               {.text = "Colours of the window", .shortcut = {}});
  if (theme) asked.emplace_back(actions::SetTheme{static_cast<LightOrDark>(*theme)});

  const bool is_own = model.appearance.scale == 0.0;
  const double shown = is_own ? ui.scale() : model.appearance.scale;
  const auto own =
      ui.checkbox("Size as the screen asks for", is_own,
                  {.text = "Text and controls in the size that the screen's own settings ask for",
                   .shortcut = {}});
  if (own) asked.emplace_back(actions::SetScale{*own ? 0.0 : std::round(shown * 20.0) / 20.0});
  {
    const auto pale = ui.disabled(is_own, "the screen decides; switch that off first");
    const auto size = committed_number(ui, "Size", shown,
                                       {.least = kLeastScale,
                                        .most = kMostScale,
                                        .decimals = 2,
                                        .unit = "×",
                                        .step = 0.05,
                                        .reset = 1.0,
                                        .hint = {.text = "Size of text and controls"}},
                                       state.refused_size);
    if (size) asked.emplace_back(actions::SetScale{*size});
  }
  const auto calm = ui.checkbox("Reduced motion", model.appearance.is_motion_reduced,
                                {.text = "Nothing moves that you do not move", .shortcut = {}});
  if (calm) asked.emplace_back(actions::ReduceMotion{*calm ? Switch::kOn : Switch::kOff});
}

void draw_memory_preferences(kit::Ui& ui,
                             const PreferencesModel& model,
                             PreferencesState& state,
                             Actions& asked) {
  const auto scope = ui.scope("Memory");
  ui.text("Memory", kit::TextLook::kMuted);
  const auto most = committed_number(
      ui, "At most", model.memory_megabytes,
      {.least = kLeastMegabytes,
       .most = kMostMegabytes,
       .decimals = 0,
       .unit = "MB",
       .step = 64.0,
       .reset = 256.0,
       .is_logarithmic = true,
       .hint = {.text = "Most memory for what is decoded of runs and flights; more makes going to "
                        "and fro smoother"}},
      state.refused_memory);
  if (most) asked.emplace_back(actions::SetMemory{static_cast<int>(std::lround(*most))});
  ui.read_out("Used now", fmt::format("{:.0f}", static_cast<double>(model.memory_used_bytes) / 1e6),
              "MB");
}

void draw_layout_preferences(kit::Ui& ui,
                             const PreferencesModel& model,
                             PreferencesState& state,
                             Actions& asked) {
  const auto scope = ui.scope("Layouts");
  ui.text("Layouts", kit::TextLook::kMuted);
  ui.wrapped("Panels, splitters and strips under a name; a click arranges the window so.",
             kit::TextLook::kMuted);
  ui.space(ui.px(4.0));
  {
    const double row = ui.px(28.0);
    const auto shown = std::clamp<std::size_t>(model.layout_names.size(), 1, 4);
    const auto scroll = ui.scroll_area("Names", static_cast<double>(shown) * row + ui.px(4.0));
    ui.clipped_rows(model.layout_names.size(), row, [&](std::size_t i) {
      const std::string& name = model.layout_names[i];
      if (ui.list_row(label_of(name, name), {.icon = kit::Icon::kSplit})) {
        asked.emplace_back(actions::UseLayout{name});
      }
    });
  }
  const double button = ui.px(120.0);
  ui.next_width(ui.room().width - button - ui.px(8.0));
  const kit::TextEdit edit = ui.text_input("##Name", state.layout_name,
                                           {.placeholder = "Name for the window as it is now",
                                            .width = ui.room().width - button - ui.px(8.0)});
  state.layout_name = edit.value;
  const bool is_named = state.layout_name.find_first_not_of(' ') != std::string::npos;
  const bool is_default = state.layout_name == "default";
  ui.same_line();
  const auto pale = ui.disabled(!is_named || is_default,
                                is_default ? "'default' is always there" : "give it a name first");
  ui.next_width(button);
  const bool is_clicked =
      ui.button("Keep", kit::ButtonLook::kNormal,
                {.text = "Keep the window's arrangement under this name", .shortcut = {}});
  if ((is_clicked || edit.was_entered) && is_named && !is_default) {
    asked.emplace_back(actions::SaveLayout{state.layout_name});
    state.layout_name.clear();
  }
}

}  // namespace

PreferencesModel preferences_model(const Session& session) {
  PreferencesModel model;
  model.is_open = session.overlay() == Overlay::kPreferences;
  if (!model.is_open) return model;
  model.appearance = session.view().appearance;
  model.memory_megabytes = session.memory_budget_megabytes();
  model.memory_used_bytes = session.memory_used_bytes();
  model.layout_names = session.layout_names();
  return model;
}

Actions draw_preferences(kit::Ui& ui, const PreferencesModel& model, PreferencesState& state) {
  if (!model.is_open || !state.is_open) state = {.is_open = model.is_open};
  if (!model.is_open) return {};
  const auto overlay = ui.overlay("Preferences", {.width = ui.px(520.0)});
  if (!overlay) return {};
  Actions asked;
  ui.heading("Preferences");
  ui.space();
  draw_look_preferences(ui, model, state, asked);
  ui.space();
  ui.line();
  draw_memory_preferences(ui, model, state, asked);
  ui.space();
  ui.line();
  draw_layout_preferences(ui, model, state, asked);
  ui.space();
  ui.line();
  ui.text("Everything takes effect at once and is kept.", kit::TextLook::kMuted);
  ui.same_line();
  ui.right_align(ui.px(96.0));
  ui.next_width(ui.px(96.0));
  const bool is_done =
      ui.button("Done", kit::ButtonLook::kPrimary, {.text = "Close", .shortcut = "Escape"});
  if (is_done || (asked.empty() && overlay.wants_close())) {
    asked.emplace_back(actions::ShowOverlay{Overlay::kNone});
  }
  return asked;
}

}  // namespace nadir
