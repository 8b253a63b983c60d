// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/command_palette.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "widgets/panels/empty_state.h"
#include "widgets/panels/panel_text.h"

namespace nadir {
namespace {

constexpr double kPaletteRow = 28.0, kLineBelow = 24.0;  // of the design

/// Whole rows that have room here, above a line that tells how many there are more.
[[nodiscard]] std::size_t rows_with_room(const kit::Ui& ui) {
  const double room = ui.room().height - ui.px(kLineBelow);
  return static_cast<std::size_t>(std::max(1.0, std::floor(room / ui.px(kPaletteRow))));
}

/// A line of the list: what it shows, and what it does.
struct PaletteRow {
  std::string label;
  kit::ListRow look;
  std::string why_not;
  std::optional<Action> action;      ///< Or else
  const Command* command = nullptr;  ///< what is begun.
};

/// The palette closed and then the action, which may open something else over the window.
[[nodiscard]] Actions closed_for(Action action) {
  return {actions::ShowOverlay{Overlay::kNone}, std::move(action)};
}

/// Whether an action takes any text at its end: then what is typed may as well be words of a command's title.
[[nodiscard]] bool takes_any_text(const ActionHelp& help) {
  constexpr std::array<std::string_view, 6> kTexts = {"PATH", "FILE", "FOLDER",
                                                      "TEXT", "NAME", "NOTE"};
  return std::any_of(kTexts.begin(), kTexts.end(), [&](std::string_view text) {
    return help.form.find(text) != std::string_view::npos;
  });
}

[[nodiscard]] std::vector<PaletteRow> command_rows(const CommandPaletteModel& model,
                                                   const std::string& typed) {
  std::vector<PaletteRow> rows, as_typed;
  const std::optional<ActionHelp> help = help_of(typed);
  if (help && typed.find(' ') != std::string::npos) {
    if (auto action = parse_action(typed)) {
      PaletteRow row{label_of(action_text(*action), "typed"), {}, {}, std::move(*action)};
      row.look.detail = help->help;
      (takes_any_text(*help) ? as_typed : rows).push_back(std::move(row));
    }
  }
  for (const Command* const command : matching_commands(typed, model.recent_commands)) {
    const auto offered =
        std::find_if(model.commands.begin(), model.commands.end(),
                     [&](const OfferedCommand& one) { return one.command == command; });
    if (offered == model.commands.end()) continue;
    PaletteRow row{label_of(command->title, command->text), {}, offered->why_not, {}, command};
    row.look.detail = command->shortcut;
    row.look.is_detail_number = true;
    row.look.hint = {std::string(command->title), std::string(command->shortcut)};
    if (const auto told = help_of(command->text)) row.look.hint.text = told->help;
    const bool is_recent = typed.empty() && rows.size() < model.recent_commands.size();
    if (is_recent) row.look.icon = kit::Icon::kClock;
    if (offered->is_on.value_or(false)) row.look.icon = kit::Icon::kCheck;
    if (!row.why_not.empty()) {
      row.look.look = kit::TextLook::kMuted;
      row.look.detail = row.why_not;
      row.look.is_detail_number = false;
    }
    rows.push_back(std::move(row));
  }
  rows.insert(rows.end(), as_typed.begin(), as_typed.end());
  return rows;
}

[[nodiscard]] std::vector<PaletteRow> argument_rows(const CommandPaletteModel& model,
                                                    const PaletteState& state) {
  std::vector<PaletteRow> rows;
  for (const std::string& offered : offered_arguments(state.begun, model)) {
    if (!has_words(offered, state.arguments)) continue;
    auto action = finish_command(state.begun, offered);
    if (!action) continue;
    const bool is_file = state.begun == "open";
    PaletteRow row{
        label_of(is_file ? name_of(offered) : offered, offered), {}, {}, std::move(*action)};
    if (is_file) row.look.detail = shortened(folder_of(offered, model.home), 48);
    row.look.hint.text = is_file ? offered : std::string();
    rows.push_back(std::move(row));
  }
  return rows;
}

/// What choosing a row asks for; nothing where it cannot be done now.
[[nodiscard]] Actions chosen(const PaletteRow& row, PaletteState& state) {
  if (!row.why_not.empty()) return {};
  if (row.action) return closed_for(*row.action);
  state.chosen = row.command->text;
  Actions asked = begin_command(*row.command, state);
  if (!row.command->is_whole) {
    state.highlighted = state.first_shown = 0;
    state.has_moved = false;
    const auto* const shows = std::get_if<actions::ShowOverlay>(&asked.front());
    return shows != nullptr && shows->overlay == Overlay::kPalette ? Actions{} : asked;
  }
  asked.insert(asked.begin(), actions::ShowOverlay{Overlay::kNone});
  return asked;
}

void move_highlight(const kit::Ui& ui, std::size_t count, PaletteState& state) {
  if (count == 0) return;
  const std::size_t before = state.highlighted;
  const bool is_first_move = !state.has_moved && !state.begun.empty();
  const auto go = [&](std::size_t place) {
    state.highlighted = is_first_move ? 0 : place;
    state.has_moved = true;
  };
  if (ui.is_pressed("Down", true)) go((before + 1) % count);
  if (ui.is_pressed("Up", true)) go((before + count - 1) % count);
  const std::size_t shown = state.rows_shown;
  if (ui.is_pressed("Page Down", true)) go(std::min(before + shown, count - 1));
  if (ui.is_pressed("Page Up", true)) go(before - std::min(before, shown));
  state.highlighted = std::min(state.highlighted, count - 1);
}

/// The rows in sight. While arguments are typed none is highlighted before the arrows were used: Enter takes what was typed.
[[nodiscard]] Actions draw_rows(kit::Ui& ui,
                                const std::vector<PaletteRow>& rows,
                                PaletteState& state) {
  Actions asked;
  state.rows_shown = rows_with_room(ui);
  state.first_shown = std::min(state.first_shown, state.highlighted);
  if (state.highlighted >= state.first_shown + state.rows_shown) {
    state.first_shown = state.highlighted + 1 - state.rows_shown;
  }
  const std::size_t end = std::min(rows.size(), state.first_shown + state.rows_shown);
  for (std::size_t i = std::min(state.first_shown, end); i < end; ++i) {
    kit::ListRow look = rows[i].look;
    look.is_stop = false;  // the highlight is moved while words are typed
    look.is_selected = i == state.highlighted && (state.begun.empty() || state.has_moved);
    const auto pale = ui.disabled(!rows[i].why_not.empty(), rows[i].why_not);
    if (ui.list_row(rows[i].label, look)) asked = chosen(rows[i], state);
  }
  if (end < rows.size()) {
    ui.text(fmt::format("{} more: type on, or go down", rows.size() - end), kit::TextLook::kMuted);
  }
  return asked;
}

[[nodiscard]] Actions draw_search(kit::Ui& ui,
                                  const CommandPaletteModel& model,
                                  PaletteState& state,
                                  bool& is_left) {
  const kit::TextEdit edit = ui.search_input(
      "Command", state.typed,
      {.placeholder = "What would you like to do? The beginnings of its words are enough",
       .takes_focus = true});
  if (edit.value != state.typed) {
    state.typed = edit.value;
    state.highlighted = state.first_shown = 0;
  }
  is_left = edit.was_cancelled;
  ui.space();
  const std::vector<PaletteRow> rows = command_rows(model, state.typed);
  move_highlight(ui, rows.size(), state);
  if (edit.was_entered && state.highlighted < rows.size()) {
    return chosen(rows[state.highlighted], state);
  }
  if (!rows.empty()) return draw_rows(ui, rows, state);
  if (const auto help = help_of(state.typed)) {
    ui.text(std::string(help->form), kit::TextLook::kNumber);
    ui.wrapped(std::string(help->help), kit::TextLook::kMuted);
    if (const auto action = parse_action(state.typed); !action) {
      ui.wrapped(action.error().message, kit::TextLook::kBad);
    }
    return {};
  }
  return draw_empty_state(ui, no_match_state(state.typed));
}

[[nodiscard]] Actions draw_arguments(kit::Ui& ui,
                                     const CommandPaletteModel& model,
                                     PaletteState& state,
                                     bool& is_left) {
  const std::string begun = state.begun;
  const std::optional<ActionHelp> help = help_of(begun);
  if (help) ui.wrapped(std::string(help->help), kit::TextLook::kMuted);
  ui.space();
  const kit::TextEdit edit = ui.text_input("##Arguments", state.arguments,
                                           {.placeholder = begun + " …", .takes_focus = true});
  if (edit.value != state.arguments) {
    state.arguments = edit.value;
    state.highlighted = state.first_shown = 0;
    state.has_moved = false;
  }
  is_left = edit.was_cancelled;
  ui.space(ui.px(4.0));
  const std::vector<PaletteRow> rows = argument_rows(model, state);
  move_highlight(ui, rows.size(), state);
  const Result<Action> action = finish_command(begun, state.arguments);
  if (edit.was_entered) {
    if (state.has_moved && state.highlighted < rows.size()) {
      return chosen(rows[state.highlighted], state);
    }
    if (action) return closed_for(*action);
  }
  if (action) {
    ui.text("Enter does it", kit::TextLook::kGood);
  } else if (!state.arguments.empty()) {
    ui.wrapped(action.error().message, kit::TextLook::kBad);
  } else if (help) {
    ui.text(std::string(help->form), kit::TextLook::kMutedNumber);
  }
  ui.space();
  return draw_rows(ui, rows, state);
}

}  // namespace

CommandPaletteModel command_palette_model(const Session& session) {
  CommandPaletteModel model;
  model.is_open = session.overlay() == Overlay::kPalette;
  if (!model.is_open) return model;
  model.commands = offered_commands(session);
  model.recents.assign(session.recents().begin(), session.recents().end());
  model.recent_commands.assign(session.recent_commands().begin(), session.recent_commands().end());
  model.layout_names = session.layout_names();
  model.home = home_folder();
  return model;
}

Actions draw_command_palette(kit::Ui& ui, const CommandPaletteModel& model, PaletteState& state) {
  if (!model.is_open) {
    if (state.is_open) state = {};
    return {};
  }
  if (!state.is_open) state = {.begun = state.begun, .is_open = true};
  const auto overlay = ui.overlay(
      "Palette",
      {.width = ui.px(640.0), .height = ui.px(484.0), .place = kit::OverlayPlace::kUpperThird});
  if (!overlay) return {};
  bool is_left = false;
  Actions asked = state.begun.empty() ? draw_search(ui, model, state, is_left)
                                      : draw_arguments(ui, model, state, is_left);
  if (asked.empty() && (is_left || overlay.wants_close())) {
    return {actions::ShowOverlay{Overlay::kNone}};
  }
  return asked;
}

}  // namespace nadir
