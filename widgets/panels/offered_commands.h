// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/session/commands.h"
#include "core/session/session.h"

namespace nadir {

/// A command as it can be offered now: what menus, palette and sheet of shortcuts have in common.
struct OfferedCommand {
  const Command* command = nullptr;  ///< Not null; of session_commands().
  std::string why_not = {};          ///< Empty: it can be done; else a few words for a tooltip.
  std::optional<bool> is_on = {};    ///< Of what is on or off, or chosen or not: a layer, a theme.
};

/// All of session_commands(), in their order.
[[nodiscard]] std::vector<OfferedCommand> offered_commands(const Session& session);

/// Whether what an action switches on, or chooses, is so already; nothing for actions that do neither.
[[nodiscard]] std::optional<bool> is_on(const Action& action,
                                        const ViewState& view,
                                        const Playback& playback);

}  // namespace nadir
