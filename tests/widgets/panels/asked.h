// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/session/commands.h"
#include "widgets/panels/offered_commands.h"

namespace nadir {

/// What was asked for, by its words.
[[nodiscard]] inline std::vector<std::string> texts(const Actions& asked) {
  std::vector<std::string> all;
  for (const Action& action : asked) all.push_back(action_text(action));
  return all;
}

/// Every command of the program, all of them possible.
[[nodiscard]] inline std::vector<OfferedCommand> all_offered() {
  std::vector<OfferedCommand> offered;
  for (const Command& command : session_commands()) {
    OfferedCommand one;
    one.command = &command;
    offered.push_back(one);
  }
  return offered;
}

/// The command of this text, to be changed by a test.
[[nodiscard]] inline OfferedCommand& offered_as(std::vector<OfferedCommand>& offered,
                                                std::string_view text) {
  const auto found = std::find_if(offered.begin(), offered.end(), [&](const OfferedCommand& one) {
    return one.command->text == text;
  });
  if (found == offered.end()) throw std::logic_error("no command '" + std::string(text) + "'");
  return *found;
}

/// "title##text", as palette and sheet call their lines.
[[nodiscard]] inline std::string line_of(std::string_view text) {
  std::vector<OfferedCommand> offered = all_offered();
  const Command& command = *offered_as(offered, text).command;
  return std::string(command.title) + "##" + std::string(command.text);
}

}  // namespace nadir
