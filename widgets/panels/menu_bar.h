// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "widgets/kit/ui.h"
#include "widgets/panels/command_palette.h"
#include "widgets/panels/offered_commands.h"

namespace nadir {

/// Menus of all commands at the left, what is open at the right.
struct MenuBarModel {
  std::vector<OfferedCommand> commands;  ///< In the order of the menus.
  std::string undo_title, redo_title;    ///< What would be taken back; empty: nothing.
  std::vector<std::string> recents;      ///< Paths, newest first, at most kMostRecents.
  std::vector<std::string> open_names;   ///< Map, run or flight, preset: what all panels speak of.
  static constexpr std::size_t kMostRecents = 12;
};

/// Height of the design.
inline constexpr double kMenuBarHeight = 36.0;

[[nodiscard]] MenuBarModel menu_bar_model(const Session& session);

/// Title of the menu within its menu that holds a command, where several of its kind are held together ("Layers"); else
/// empty.
[[nodiscard]] std::string menu_group_of(const Command& command,
                                        const std::vector<OfferedCommand>& commands);
/// Label of a command's line; of undo and redo with what they would do.
[[nodiscard]] std::string menu_title_of(const Command& command, const MenuBarModel& model);

/// In a region as high as kMenuBarHeight. @param palette  Where commands that ask for arguments begin.
[[nodiscard]] Actions draw_menu_bar(kit::Ui& ui, const MenuBarModel& model, PaletteState& palette);

}  // namespace nadir
