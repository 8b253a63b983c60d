// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/shortcuts.h"

#include <algorithm>
#include <array>

namespace nadir {

namespace {

std::string_view verb_of(const Command& command) {
  return command.text.substr(0, command.text.find(' '));
}

/// Goes along a flight, which is not in front while labels are drawn.
bool goes_along_flight(const Command& command) {
  const std::string_view name = verb_of(command);
  return name == "play" || name == "step" || name == "go";
}

}  // namespace

const Command* command_of(const kit::Chord& chord) {
  for (const Command& command : session_commands()) {
    if (command.menu == kLabelMenu) continue;
    if (!command.shortcut.empty() && kit::parse_chord(command.shortcut) == chord) return &command;
  }
  return nullptr;
}

bool repeats_while_held(const Command& command) {
  constexpr std::array<std::string_view, 6> kRepeating = {"step", "zoom", "rotate",
                                                          "go",   "undo", "redo"};
  return std::find(kRepeating.begin(), kRepeating.end(), verb_of(command)) != kRepeating.end();
}

const Command* pressed_command(const kit::Ui& ui, bool is_overlay_open, bool draws_labels) {
  const Command* other = nullptr;
  for (const Command& command : session_commands()) {
    if (command.shortcut.empty()) continue;
    if (is_overlay_open && command.text.substr(0, 5) != "show ") continue;
    const bool is_on_labels = command.menu == kLabelMenu;
    if (is_on_labels && !draws_labels) continue;
    if (goes_along_flight(command) && draws_labels) continue;
    if (!ui.is_pressed(command.shortcut, repeats_while_held(command))) continue;
    if (is_on_labels || !draws_labels) return &command;
    if (other == nullptr) other = &command;
  }
  return other;
}

}  // namespace nadir
