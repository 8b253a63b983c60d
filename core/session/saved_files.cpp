// SPDX-License-Identifier: Apache-2.0
#include "core/session/saved_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "core/base/staged_output.h"

namespace nadir {
namespace fs = std::filesystem;
namespace {

bool holds(const std::vector<std::string>& list, const std::string& text) {
  return std::find(list.begin(), list.end(), text) != list.end();
}

/// Lists with the newest first: what this session has put in front of its own is put in front, what it took out goes.
std::vector<std::string> merged_list(const std::vector<std::string>& there,
                                     const std::vector<std::string>& before,
                                     const std::vector<std::string>& now,
                                     std::size_t most) {
  if (now == before) return there;
  std::vector<std::string> merged = now;
  for (std::size_t count = 0; count <= now.size(); ++count) {
    // So many came in front where the others still stand as they did.
    merged.assign(now.begin(), now.begin() + static_cast<std::ptrdiff_t>(count));
    std::vector<std::string> as_before;
    for (const std::string& text : before) {
      if (!holds(merged, text) && holds(now, text)) as_before.push_back(text);
    }
    if (std::equal(now.begin() + static_cast<std::ptrdiff_t>(count), now.end(), as_before.begin(),
                   as_before.end())) {
      break;
    }
  }
  for (const std::string& text : there) {
    const bool was_taken_out = holds(before, text) && !holds(now, text);
    if (!was_taken_out && !holds(merged, text)) merged.push_back(text);
  }
  if (merged.size() > most) merged.resize(most);
  return merged;
}

/// Lists whose order says nothing.
std::vector<std::string> merged_set(std::vector<std::string> there,
                                    const std::vector<std::string>& before,
                                    const std::vector<std::string>& now) {
  if (now == before) return there;
  std::erase_if(there,
                [&](const std::string& text) { return holds(before, text) && !holds(now, text); });
  for (const std::string& text : now) {
    if (!holds(before, text) && !holds(there, text)) there.push_back(text);
  }
  return there;
}

std::map<std::string, WindowLayout> merged_layouts(
    std::map<std::string, WindowLayout> there,
    const std::map<std::string, WindowLayout>& before,
    const std::map<std::string, WindowLayout>& now) {
  for (const auto& [name, layout] : before) {
    if (!now.contains(name)) there.erase(name);
  }
  for (const auto& [name, layout] : now) {
    const auto earlier = before.find(name);
    if (earlier == before.end() || !(earlier->second == layout)) there[name] = layout;
  }
  return there;
}

/// @param read_again  What reading the text gives: one that could not be read must not take the place of one that can.
template <typename Read>
Result<void> write_if_readable(const fs::path& file,
                               const std::string& text,
                               const Result<Read>& read_again) {
  if (read_again) return write_text_file(file, text);
  return fail(ErrorCode::kIo, "{}; what it held before stays", read_again.error().message);
}

Result<void> save_session(const fs::path& file, const std::string& text) {
  const auto there = text_if_there(file);
  if (there && *there) {
    const auto parsed = parse_view_text(**there, file.string());
    if (!parsed && parsed.error().code == ErrorCode::kUnsupported) return {};
  }
  return write_if_readable(file, text, parse_view_text(text, file.string()));
}

Result<void> save_preferences(const fs::path& file,
                              const Preferences& before,
                              const Preferences& now) {
  Preferences there = before;  // of a file that is gone or damaged nothing is to be kept
  const auto text = text_if_there(file);
  if (text && *text) {
    auto parsed = parse_preferences(**text, file.string());
    if (!parsed && parsed.error().code == ErrorCode::kUnsupported) return {};
    if (parsed) there = std::move(*parsed);
  }
  const std::string merged = preferences_text(merged_preferences(there, before, now));
  return write_if_readable(file, merged, parse_preferences(merged, file.string()));
}

}  // namespace

Preferences merged_preferences(const Preferences& there,
                               const Preferences& before,
                               const Preferences& now) {
  Preferences merged = there;
  const auto take = [](const auto& earlier, const auto& later, auto& into) {
    if (!(earlier == later)) into = later;
  };
  take(before.appearance.theme, now.appearance.theme, merged.appearance.theme);
  take(before.appearance.scale, now.appearance.scale, merged.appearance.scale);
  take(before.appearance.is_motion_reduced, now.appearance.is_motion_reduced,
       merged.appearance.is_motion_reduced);
  take(before.memory_megabytes, now.memory_megabytes, merged.memory_megabytes);
  merged.recents = merged_list(there.recents, before.recents, now.recents, kMostRecents);
  merged.recent_commands = merged_list(there.recent_commands, before.recent_commands,
                                       now.recent_commands, kMostRecentCommands);
  merged.layouts = merged_layouts(there.layouts, before.layouts, now.layouts);
  merged.turned_sections =
      merged_set(there.turned_sections, before.turned_sections, now.turned_sections);
  return merged;
}

Result<void> save_files(const fs::path& folder, const Savings& savings) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) return fail(ErrorCode::kIo, "{}: {}", folder.string(), error.message());
  if (savings.session) {
    auto saved = save_session(folder / kSessionFile, *savings.session);
    if (!saved) return saved;
  }
  if (!savings.preferences) return {};
  return save_preferences(folder / kPreferencesFile, savings.before, *savings.preferences);
}

Result<std::optional<std::string>> text_if_there(const fs::path& file) {
  std::error_code error;
  if (!fs::exists(file, error)) return std::optional<std::string>();
  constexpr std::uintmax_t kMostBytes = 4U << 20U;
  auto text = read_text_file(file, kMostBytes);
  if (!text) return forward_error(text);
  return std::optional(std::move(*text));
}

fs::path set_aside(const fs::path& file) {
  constexpr int kMostAside = 100;
  std::error_code error;
  for (int number = 1; number <= kMostAside; ++number) {
    const fs::path aside = number == 1 ? file.string() + ".damaged"
                                       : fmt::format("{}.damaged-{}", file.string(), number);
    if (fs::exists(fs::symlink_status(aside, error))) continue;
    fs::rename(file, aside, error);
    return error ? fs::path() : aside;
  }
  return {};
}

}  // namespace nadir
