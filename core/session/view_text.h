// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/session/open_run.h"
#include "core/session/view_state.h"

namespace nadir {

/// Everything that one start of the program leaves to the next, and what copy-view puts on the clipboard.
struct SavedView {
  ViewState view = default_view_state();
  Playback playback;                 ///< Never playing.
  std::vector<std::string> writing;  ///< Runs that were being written; empty in what is copied.
};

/// TOML with a version; paths as they are. parse_view_text() gives the same again.
[[nodiscard]] std::string view_text(const SavedView& saved);
/// @param name  Stands for the file in messages.
/// @errors kMalformed: no TOML, no such text, a value of another type or of no such choice; kUnsupported: a newer version.
/// Values out of range are brought into it.
[[nodiscard]] Result<SavedView> parse_view_text(std::string_view text, const std::string& name);

/// What a user keeps from one session to all others.
struct Preferences {
  Appearance appearance;
  int memory_megabytes = 256;
  std::vector<std::string> recents;  ///< Newest first.
  std::map<std::string, WindowLayout> layouts;
};
[[nodiscard]] std::string preferences_text(const Preferences& preferences);
/// @errors as parse_view_text.
[[nodiscard]] Result<Preferences> parse_preferences(std::string_view text, const std::string& name);

}  // namespace nadir
