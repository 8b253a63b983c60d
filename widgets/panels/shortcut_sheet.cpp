// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/shortcut_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "widgets/panels/empty_state.h"
#include "widgets/panels/panel_text.h"

namespace nadir {
namespace {

/// What no command stands for.
struct InputHabit {
  const char* title;
  const char* gesture;
};
constexpr std::array<InputHabit, 8> kKeyboardHabits = {{
    {"From the map into the panels", "Shift+Tab"},
    {"Next, previous control", "Tab, Shift+Tab"},
    {"Next, previous part of the window", "Ctrl+Tab, Ctrl+Shift+Tab"},
    {"Press, open, type", "Space, Enter"},
    {"Change a value or choice", "arrows"},
    {"Reset a number", "Delete"},
    {"Menu of a control", "Shift+F10"},
    {"Back to the map", "Escape"},
}};
constexpr std::array<InputHabit, 6> kMouseHabits = {{
    {"Move the map", "drag"},
    {"Zoom around the pointer", "wheel"},
    {"Go to a moment", "drag on the timeline"},
    {"Change a number", "drag it sideways"},
    {"Type a number", "double click"},
    {"Reset a number", "double click its label"},
}};

/// Lines of one menu, or where `commands` is empty of keyboard or mouse.
struct SheetGroup {
  std::string title;
  std::vector<const OfferedCommand*> commands;
  std::vector<InputHabit> habits;
  [[nodiscard]] std::size_t lines() const { return 2 + commands.size() + habits.size(); }
};

void add_habits(const std::string& title,
                std::span<const InputHabit> habits,
                const std::string& typed,
                std::vector<SheetGroup>& groups) {
  SheetGroup group{title, {}, {}};
  for (const InputHabit& habit : habits) {
    if (has_words(fmt::format("{} {} {}", habit.title, habit.gesture, title), typed)) {
      group.habits.push_back(habit);
    }
  }
  if (!group.habits.empty()) groups.push_back(std::move(group));
}

[[nodiscard]] std::vector<SheetGroup> groups_of(const ShortcutSheetModel& model,
                                                const std::string& typed) {
  std::vector<SheetGroup> groups;
  for (const OfferedCommand& offered : model.commands) {
    const Command& command = *offered.command;
    if (command.shortcut.empty()) continue;
    const std::string words =
        fmt::format("{} {} {} {}", command.title, command.text, command.shortcut, command.menu);
    if (!has_words(words, typed)) continue;
    const auto group = std::find_if(groups.begin(), groups.end(), [&](const SheetGroup& one) {
      return one.title == command.menu;
    });
    if (group == groups.end()) {
      groups.push_back({std::string(command.menu), {&offered}, {}});
    } else {
      group->commands.push_back(&offered);
    }
  }
  add_habits("Keyboard", kKeyboardHabits, typed, groups);
  add_habits("Mouse", kMouseHabits, typed, groups);
  return groups;
}

[[nodiscard]] Actions draw_sheet_group(kit::Ui& ui,
                                       const SheetGroup& group,
                                       PaletteState& palette) {
  Actions asked;
  const auto scope = ui.scope(group.title);
  ui.heading(group.title);
  for (const OfferedCommand* const offered : group.commands) {
    const Command& command = *offered->command;
    const auto pale = ui.disabled(!offered->why_not.empty(), offered->why_not);
    const kit::ListRow look{.detail = std::string(command.shortcut), .is_detail_number = true};
    if (ui.list_row(label_of(command.title, command.text), look)) {
      asked = begin_command(command, palette);
      asked.insert(asked.begin(), actions::ShowOverlay{Overlay::kNone});
    }
  }
  for (const InputHabit& habit : group.habits) {
    ui.read_out(habit.title, habit.gesture, {}, {}, kit::TextLook::kMuted);
  }
  ui.space(ui.px(12.0));
  return asked;
}

[[nodiscard]] Actions draw_sheet_columns(kit::Ui& ui,
                                         const std::vector<SheetGroup>& groups,
                                         PaletteState& palette) {
  std::size_t all = 0;
  for (const SheetGroup& group : groups) all += group.lines();
  Actions asked;
  const auto columns = ui.columns("Sheet", {1.0, 1.0});
  std::size_t lines = 0;
  bool is_right = false;
  for (const SheetGroup& group : groups) {
    // A group goes where its middle lies.
    if (!is_right && lines > 0 && 2 * lines + group.lines() > all) {
      ui.next_column();
      is_right = true;
    }
    lines += group.lines();
    const Actions more = draw_sheet_group(ui, group, palette);
    asked.insert(asked.end(), more.begin(), more.end());
  }
  return asked;
}

}  // namespace

ShortcutSheetModel shortcut_sheet_model(const Session& session) {
  ShortcutSheetModel model;
  model.is_open = session.overlay() == Overlay::kShortcuts;
  if (model.is_open) model.commands = offered_commands(session);
  return model;
}

Actions draw_shortcut_sheet(kit::Ui& ui,
                            const ShortcutSheetModel& model,
                            ShortcutSheetState& state,
                            PaletteState& palette) {
  if (!model.is_open || !state.is_open) state = {.is_open = model.is_open};
  if (!model.is_open) return {};
  const kit::Rect screen = ui.screen();
  const auto overlay =
      ui.overlay("Shortcuts", {.width = std::min(ui.px(880.0), screen.width - ui.px(48.0)),
                               .height = std::min(ui.px(640.0), screen.height - ui.px(48.0))});
  if (!overlay) return {};
  ui.heading("Shortcuts");
  const kit::TextEdit edit = ui.search_input(
      "Search", state.typed, {.placeholder = "Search by name or key", .takes_focus = true});
  state.typed = edit.value;
  ui.space();
  Actions asked;
  const std::vector<SheetGroup> groups = groups_of(model, state.typed);
  if (groups.empty()) {
    asked = draw_empty_state(ui, no_match_state(state.typed));
  } else {
    const auto scroll = ui.scroll_area("Keys");
    asked = draw_sheet_columns(ui, groups, palette);
  }
  if (asked.empty() && (overlay.wants_close() || edit.was_cancelled)) {
    return {actions::ShowOverlay{Overlay::kNone}};
  }
  return asked;
}

}  // namespace nadir
