// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/menu_bar.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "widgets/panels/panel_text.h"
#include "widgets/panels/settings_panel.h"
#include "widgets/panels/shortcut_hint.h"

namespace nadir {
namespace {

constexpr double kPaletteButtonWidth = 104.0, kBarMargin = 8.0, kLineHeight = 28.0;
constexpr std::array<const char*, 7> kMenus = {"File", "Edit",  "View", "Go",
                                               "Run",  "Label", "Help"};

void append_to(Actions& all, Actions more) {
  for (Action& action : more) all.push_back(std::move(action));
}

/// Commands of which many differ in their first argument only: they have a menu within the menu.
struct CommandGroup {
  std::string_view name;
  const char* title;
};
constexpr std::array<CommandGroup, 12> kGroups = {{{"layer", "Layers"},
                                                   {"panel", "Panels"},
                                                   {"strip", "Strips of the timeline"},
                                                   {"layout", "Layouts"},
                                                   {"speed", "Speed"},
                                                   {"lay-at", "Topview"},
                                                   {"tool", "Tool"},
                                                   {"scale", "Interface scale"},
                                                   {"theme", "Theme"},
                                                   {"label-option tool", "Tools"},
                                                   {"label-option class", "Classes"},
                                                   {"export-labels", "Export"}}};
constexpr std::size_t kLeastOfGroup = 3;

/// "layout" of "save-layout" too.
[[nodiscard]] std::string_view group_name_of(const Command& command) {
  const std::size_t blank = command.text.find(' ');
  const std::string_view name = command.text.substr(0, blank);
  if (name == "label-option") return command.text.substr(0, command.text.find(' ', blank + 1));
  if (command.menu == kLabelMenu) return name;
  constexpr std::string_view kSave = "save-";
  return name.substr(0, kSave.size()) == kSave ? name.substr(kSave.size()) : name;
}

/// Lines are drawn between those of different first words.
[[nodiscard]] std::string_view family_of(const Command& command) {
  return command.text.substr(0, command.text.find_first_of(" -"));
}

[[nodiscard]] Actions draw_recents(kit::Ui& ui, const MenuBarModel& model) {
  Actions asked;
  const auto menu = ui.menu("Open recent");
  if (!menu) return asked;
  if (model.recents.empty()) {
    (void)ui.menu_item("Nothing yet", {.disabled_because = "nothing has been opened yet"});
  }
  for (const std::string& path : model.recents) {
    const std::string shown = shortened(path, 56);
    const kit::MenuItem item{.hint = shown == path ? std::string() : path};
    if (ui.menu_item(label_of(shown, path), item)) asked.emplace_back(actions::OpenFile{path});
  }
  return asked;
}

[[nodiscard]] Actions draw_menu_line(kit::Ui& ui,
                                     const OfferedCommand& offered,
                                     const MenuBarModel& model,
                                     PaletteState& palette) {
  const Command& command = *offered.command;
  const kit::MenuItem item{.shortcut = std::string(command.shortcut),
                           .is_checked = offered.is_on.value_or(false),
                           .disabled_because = offered.why_not};
  if (ui.menu_item(menu_title_of(command, model), item)) return begin_command(command, palette);
  return {};
}

[[nodiscard]] Actions draw_group(kit::Ui& ui,
                                 const std::string& title,
                                 const Command& first,
                                 const MenuBarModel& model,
                                 PaletteState& palette) {
  Actions asked;
  const auto menu = ui.menu(title);
  if (!menu) return asked;
  for (const OfferedCommand& offered : model.commands) {
    if (offered.command->menu == first.menu &&
        group_name_of(*offered.command) == group_name_of(first)) {
      append_to(asked, draw_menu_line(ui, offered, model, palette));
    }
  }
  return asked;
}

[[nodiscard]] Actions draw_menu(kit::Ui& ui,
                                const char* name,
                                const MenuBarModel& model,
                                PaletteState& palette) {
  Actions asked;
  const auto menu = ui.menu(name);
  if (!menu) return asked;
  std::vector<const OfferedCommand*> lines;
  for (const OfferedCommand& offered : model.commands) {
    if (offered.command->menu == name) lines.push_back(&offered);
  }
  std::set<std::string> groups;
  bool is_family_long = false;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const Command& command = *lines[i]->command;
    const bool goes_on = i > 0 && family_of(*lines[i - 1]->command) == family_of(command);
    const bool begins =
        i + 1 < lines.size() && family_of(*lines[i + 1]->command) == family_of(command);
    const std::string group = menu_group_of(command, model.commands);
    const bool is_group_new = !group.empty() && groups.insert(group).second;
    if (i > 0 && !goes_on && (is_family_long || (begins && group.empty()))) ui.menu_line();
    is_family_long = goes_on && group.empty();
    if (group.empty()) {
      append_to(asked, draw_menu_line(ui, *lines[i], model, palette));
    } else if (is_group_new) {
      append_to(asked, draw_group(ui, group, command, model, palette));
    }
    if (command.text == "open") append_to(asked, draw_recents(ui, model));
  }
  return asked;
}

void draw_open_names(kit::Ui& ui, const MenuBarModel& model, double room) {
  const std::string arrow = "  ›  ";
  std::size_t most = 40;
  std::string shown;
  do {  // names give way evenly
    shown.clear();
    for (const std::string& name : model.open_names) {
      shown += (shown.empty() ? "" : arrow) + shortened(name, most);
    }
    most -= 4;
  } while (ui.text_width(shown) > room && most >= 8);
  if (shown.empty() || ui.text_width(shown) > room) return;
  ui.same_line();
  ui.right_align(ui.text_width(shown) + ui.px(kPaletteButtonWidth + kBarMargin + 16.0));
  ui.text(shown, kit::TextLook::kMuted);
  std::string whole;
  for (const std::string& name : model.open_names) whole += (whole.empty() ? "" : arrow) + name;
  ui.hint({.text = "Open: " + whole,
           .shortcut = {},
           .source = "map, run and settings of the next run"});
}

}  // namespace

std::string menu_group_of(const Command& command, const std::vector<OfferedCommand>& commands) {
  const auto group = std::find_if(kGroups.begin(), kGroups.end(), [&](const CommandGroup& one) {
    return one.name == group_name_of(command);
  });
  if (group == kGroups.end()) return {};
  const auto alike =
      std::count_if(commands.begin(), commands.end(), [&](const OfferedCommand& one) {
        return one.command->menu == command.menu && group_name_of(*one.command) == group->name;
      });
  return static_cast<std::size_t>(alike) >= kLeastOfGroup ? group->title : "";
}

std::string menu_title_of(const Command& command, const MenuBarModel& model) {
  std::string what;
  if (command.text == "undo") what = model.undo_title;
  if (command.text == "redo") what = model.redo_title;
  if (what.empty()) {
    // "Layer: particles" stands below "Layers" as "Particles".
    const std::size_t colon = command.title.find(": ");
    if (colon == std::string_view::npos || menu_group_of(command, model.commands).empty()) {
      return std::string(command.title);
    }
    std::string title(command.title.substr(colon + 2));
    if (title[0] >= 'a' && title[0] <= 'z') title[0] = static_cast<char>(title[0] - 'a' + 'A');
    return title;
  }
  return label_of(fmt::format("{}: {}", command.title, shortened(what, 40)), command.text);
}

MenuBarModel menu_bar_model(const Session& session) {
  MenuBarModel model;
  model.commands = offered_commands(session);
  model.undo_title = session.undo_title().value_or("");
  model.redo_title = session.redo_title().value_or("");
  for (const std::string& path : session.recents()) {
    if (model.recents.size() == MenuBarModel::kMostRecents) break;
    model.recents.push_back(path);
  }
  if (const OpenMap* const map = session.map()) {
    const std::string& name = map->provenance.name;
    model.open_names.push_back(name.empty() ? name_of(map->path) : name);
  }
  const ViewState& view = session.view();
  if (const OpenRun* const run = session.active_run()) {
    model.open_names.push_back(run->name);
  } else if (!view.flight_path.empty()) {
    model.open_names.push_back(name_of(view.flight_path));
  }
  if (model.open_names.size() == 2) {
    const std::string of_run = view.runs.empty() ? "default" : "as the active run";
    const std::size_t changed = changed_options(session);
    model.open_names.push_back(
        (view.draft.preset == kOptionsOfRun ? of_run : name_of(view.draft.preset)) +
        (changed == 0 ? std::string() : fmt::format(", {} changed", changed)));
  }
  return model;
}

Actions draw_menu_bar(kit::Ui& ui, const MenuBarModel& model, PaletteState& palette) {
  const auto scope = ui.scope("Menu");
  Actions asked;
  const kit::Rect room = ui.room();
  const double bar_height = std::min(room.height, ui.px(kMenuBarHeight));
  if (bar_height > ui.px(kLineHeight)) ui.space((bar_height - ui.px(kLineHeight)) / 2.0);
  ui.right_align(room.width - ui.px(kBarMargin));
  {
    const auto bar = ui.menu_bar();
    for (const char* const name : kMenus) append_to(asked, draw_menu(ui, name, model, palette));
  }
  ui.same_line();
  const double left = ui.room().width;
  draw_open_names(ui, model, left - ui.px(kPaletteButtonWidth + kBarMargin + 40.0));
  ui.same_line();
  const Action palette_action = actions::ShowOverlay{Overlay::kPalette};
  const kit::Hint hint = hint_for("Find any command", palette_action);
  ui.right_align(ui.px(kPaletteButtonWidth + kBarMargin));
  ui.next_width(ui.px(kPaletteButtonWidth));
  if (ui.button(label_of(hint.shortcut.empty() ? "Commands" : hint.shortcut, "palette"),
                kit::ButtonLook::kQuiet, hint, kit::Icon::kSearch)) {
    asked.push_back(palette_action);
  }
  return asked;
}

}  // namespace nadir
