// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "widgets/kit/ui.h"
#include "widgets/panels/offered_commands.h"

namespace nadir {

/// Every command by a few of its letters, and every action by its words with arguments ("seek 12.5").
struct CommandPaletteModel {
  bool is_open = false;
  std::vector<OfferedCommand> commands;
  std::vector<std::string> recents;               ///< Paths, newest first; offered for "open".
  std::vector<std::string> recent_commands = {};  ///< Their words, newest first; they come first.
  std::vector<std::string> layout_names;          ///< Offered for "layout".
  std::string home = {};                          ///< The user's, to be written '~'; may be empty.
};

/// What is being typed into it. Kept by the caller; empties itself whenever the palette opens.
struct PaletteState {
  std::string typed = {};      ///< What is looked for.
  std::string begun = {};      ///< "export": a command that asks for arguments; empty: none yet.
  std::string arguments = {};  ///< Typed for that.
  std::size_t highlighted = 0, first_shown = 0;  ///< Row that Enter takes, and uppermost row.
  std::size_t rows_shown = 13;                   ///< Of those, in the last frame.
  bool has_moved = false;  ///< The arrows were used since something was typed.
  bool is_open = false;    ///< As in the last frame.
  std::string chosen =
      {};  ///< Command that was chosen in this frame, to be remembered by the caller.
};

[[nodiscard]] CommandPaletteModel command_palette_model(const Session& session);

/// Lies over the window where the model says that it is open. Call it in every frame, so that it notices being closed.
[[nodiscard]] Actions draw_command_palette(kit::Ui& ui,
                                           const CommandPaletteModel& model,
                                           PaletteState& state);

/// What choosing a command asks for: its action; where arguments are missing, the box or the palette that asks for them.
[[nodiscard]] Actions begin_command(const Command& command, PaletteState& palette);

/// The action that a begun command and the arguments typed make. A text with blanks needs no quotes where it is the only
/// argument. @errors as parse_action.
[[nodiscard]] Result<Action> finish_command(const std::string& begun, const std::string& arguments);

/// Form and help of the action that a text begins with; nothing where its first word is none.
[[nodiscard]] std::optional<ActionHelp> help_of(std::string_view text);

/// What could be typed as a begun command's arguments: recent files, layouts, or the words of its form.
[[nodiscard]] std::vector<std::string> offered_arguments(const std::string& begun,
                                                         const CommandPaletteModel& model);

}  // namespace nadir
