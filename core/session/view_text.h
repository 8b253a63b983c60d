// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/session/label_view.h"
#include "core/session/open_run.h"
#include "core/session/view_state.h"

namespace nadir {

/// Everything that one start of the program leaves to the next, and what copy-view puts on the clipboard.
struct SavedView {
  ViewState view = default_view_state();
  Playback playback;  ///< Never playing.
  LabelView label = {};
};

/// TOML with a version; paths as they are. parse_view_text() gives the same again.
[[nodiscard]] std::string view_text(const SavedView& saved);
/// @param name  Stands for the file in messages.
/// @errors kMalformed: no TOML, no such text, a value of another type; kUnsupported: a newer version.
/// Values out of range are brought into it; a word that this version does not know leaves what it stands for as it begins.
[[nodiscard]] Result<SavedView> parse_view_text(std::string_view text, const std::string& name);

inline constexpr std::size_t kMostRecents = 20, kMostRecentCommands = 8;

/// What a user keeps from one session to all others.
struct Preferences {
  Appearance appearance;
  int memory_megabytes = 256;
  std::vector<std::string> recents;          ///< Newest first.
  std::vector<std::string> recent_commands;  ///< Likewise.
  std::map<std::string, WindowLayout> layouts;
  std::vector<std::string> turned_sections = {};  ///< Of panels; by path.
  friend bool operator==(const Preferences&, const Preferences&) = default;
};
[[nodiscard]] std::string preferences_text(const Preferences& preferences);
/// @errors as parse_view_text.
[[nodiscard]] Result<Preferences> parse_preferences(std::string_view text, const std::string& name);

}  // namespace nadir
