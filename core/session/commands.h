// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/session/action.h"

namespace nadir {

class Session;

/// A line of a menu, the palette or the sheet of shortcuts: an action with its arguments, or the beginning of one.
struct Command {
  std::string_view text;  ///< "theme dark"; parse_action() takes it where is_whole.
  std::string_view
      title;  ///< "Dark theme", as menus have it; "..." at the end where more input follows.
  std::string_view menu;  ///< "File", "Edit", "View", "Run", "Go", "Label", "Help".
  std::string_view
      shortcut;  ///< "Ctrl+Shift+P", "Space", "["; empty: none. Names of keys as in look.md.
  bool is_whole = true;        ///< False: arguments are asked for, "export" by a file name.
  std::string_view also = {};  ///< Other words by which people look for it.
};

/// Commands on labels. Their shortcuts count only while labels are drawn, and there before those of others.
inline constexpr std::string_view kLabelMenu = "Label";

/// All, in the order of the menus; each shortcut stands for one command only, but for those on labels.
[[nodiscard]] std::span<const Command> session_commands();

/// Whether it can be done now; else why not, in a few words for a tooltip ("open a run first").
[[nodiscard]] std::string why_not(const Command& command, const Session& session);

/// The best first. What was typed fits a title (or the words in `also`, or the command's own) as a whole, as its beginning,
/// as beginnings of its words, as their initials run together ("fitpar"), as a part of a word, or by letters in the order of
/// one word; each of these comes before the next. Among equals those chosen lately come first, then menu order.
/// Every command for an empty text.
/// @param recent  Texts of commands, newest first.
[[nodiscard]] std::vector<const Command*> matching_commands(
    std::string_view typed, std::span<const std::string> recent = {});

}  // namespace nadir
