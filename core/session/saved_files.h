// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/session/view_text.h"

namespace nadir {

inline constexpr const char* kSessionFile = "session.toml";
inline constexpr const char* kPreferencesFile = "preferences.toml";

/// What is to be written into the user's folder.
struct Savings {
  std::optional<std::string> session;      ///< Text of the whole file.
  std::optional<Preferences> preferences;  ///< This session's.
  Preferences before;                      ///< The same as they were last read or written.
  [[nodiscard]] bool is_empty() const { return !session && !preferences; }
};

/// Writes what there is, each file whole or not at all. Of the preferences only what differs from before, for another window
/// may have written since. A file that a newer version of Nadir wrote is left as it is, and nothing that could not be read
/// again takes the place of a file. @errors kIo.
[[nodiscard]] Result<void> save_files(const std::filesystem::path& folder, const Savings& savings);

/// What one session has changed, done to what another one has written.
/// @param there  In the file. @param before, now  Of this session, when it last read or wrote them and now.
[[nodiscard]] Preferences merged_preferences(const Preferences& there,
                                             const Preferences& before,
                                             const Preferences& now);

/// Nothing where there is no such file. @errors as read_text_file.
[[nodiscard]] Result<std::optional<std::string>> text_if_there(const std::filesystem::path& file);

/// Renames a damaged file, never over an earlier one. @returns its new name; empty where that cannot be done.
[[nodiscard]] std::filesystem::path set_aside(const std::filesystem::path& file);

}  // namespace nadir
