// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "widgets/kit/ui.h"
#include "widgets/panels/command_palette.h"
#include "widgets/panels/offered_commands.h"

namespace nadir {

/// All keys and what they do; a click on a line does it.
struct ShortcutSheetModel {
  bool is_open = false;
  std::vector<OfferedCommand> commands;
};

struct ShortcutSheetState {
  std::string typed = {};  ///< What is looked for.
  bool is_open = false;
};

[[nodiscard]] ShortcutSheetModel shortcut_sheet_model(const Session& session);

/// Lies over the window where the model says so; call it in every frame.
/// @param palette  Where commands that ask for arguments begin.
[[nodiscard]] Actions draw_shortcut_sheet(kit::Ui& ui,
                                          const ShortcutSheetModel& model,
                                          ShortcutSheetState& state,
                                          PaletteState& palette);

}  // namespace nadir
