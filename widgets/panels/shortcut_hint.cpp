// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/shortcut_hint.h"

#include <algorithm>

#include "core/session/commands.h"
#include "core/session/session.h"

namespace nadir {
namespace {

const Command* command_of(const Action& action) {
  const std::string text = action_text(action);
  const auto commands = session_commands();
  const auto found = std::find_if(commands.begin(), commands.end(),
                                  [&](const Command& command) { return command.text == text; });
  return found == commands.end() ? nullptr : &*found;
}

}  // namespace

kit::Hint hint_for(const std::string& text, const Action& action) {
  const Command* const command = command_of(action);
  return {text, command != nullptr ? std::string(command->shortcut) : std::string()};
}

std::string why_not_now(const Action& action, const Session& session) {
  const Command* const command = command_of(action);
  return command != nullptr ? why_not(*command, session) : std::string();
}

}  // namespace nadir
