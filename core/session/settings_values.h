// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/field.h"
#include "core/base/settings.h"
#include "core/session/view_state.h"

namespace nadir::detail {

/// Takes values out of a table one after another; what is missing leaves its default, and the first fault is kept.
class SettingsValues {
 public:
  explicit SettingsValues(const Settings& settings) : settings_(settings) {}

  void take(std::string_view key, double& into) { take_by(key, into, &Settings::number); }
  void take(std::string_view key, bool& into) { take_by(key, into, &Settings::boolean); }
  void take(std::string_view key, std::string& into) { take_by(key, into, &Settings::text); }
  void take(std::string_view key, std::vector<std::string>& into) {
    take_by(key, into, &Settings::texts);
  }
  void take(std::string_view key, int& into);
  void take(std::string_view key, std::optional<int>& into);
  void take(std::string_view key, std::optional<double>& into);
  void take(std::string_view key, std::optional<std::string>& into);
  void take(std::string_view key, Eigen::Vector2d& into);
  /// @returns whether it is there and one that this version knows; else the value stays as it is, which is no fault: a later
  /// version may know more.
  template <typename Enum>
  requires std::is_enum_v<Enum>
  bool take(std::string_view key, Enum& into) {
    std::string word;
    take(key, word);
    return outcome_ && take_word(word, into);
  }
  /// Several of such values, those that this version knows.
  template <typename Enum>
  requires std::is_enum_v<Enum>
  void take(std::string_view key, std::vector<Enum>& into) {
    std::vector<std::string> words;
    take(key, words);
    for (const std::string& word : words) {
      Enum value{};
      if (take_word(word, value)) into.push_back(value);
    }
  }

  [[nodiscard]] const Settings& settings() const { return settings_; }
  void say(tl::unexpected<Error> fault) {
    if (outcome_) outcome_ = std::move(fault);
  }
  [[nodiscard]] const Result<void>& outcome() const { return outcome_; }

 private:
  template <typename Enum>
  static bool take_word(const std::string& word, Enum& into) {
    const auto& names = EnumNames<Enum>::kNames;
    const auto found = std::find(names.begin(), names.end(), word);
    if (found == names.end()) return false;
    into = static_cast<Enum>(found - names.begin());
    return true;
  }
  template <typename T>
  void take_by(std::string_view key,
               T& into,
               Result<T> (Settings::*getter)(std::string_view) const) {
    if (!outcome_ || !settings_.has(key)) return;
    auto value = (settings_.*getter)(key);
    if (value) {
      into = std::move(*value);
    } else {
      outcome_ = forward_error(value);
    }
  }

  const Settings& settings_;
  Result<void> outcome_;
};

/// Calls `take` with every table of a list; nothing where there is no such list. @errors the first that `take` met.
template <typename Take>
Result<void> each_table(const Settings& settings, const char* key, const Take& take) {
  if (!settings.has(key)) return {};
  const auto tables = settings.tables(key);
  if (!tables) return forward_error(tables);
  for (const Settings& table : *tables) {
    SettingsValues values(table);
    take(values);
    if (!values.outcome()) return values.outcome();
  }
  return {};
}

/// The same with one table.
template <typename Take>
Result<void> one_table(const Settings& settings, const char* key, const Take& take) {
  if (!settings.has(key)) return {};
  const auto table = settings.table(key);
  if (!table) return forward_error(table);
  SettingsValues values(*table);
  take(values);
  return values.outcome();
}

/// A line "key = value" of TOML.
[[nodiscard]] std::string toml_line(std::string_view key, double value);
[[nodiscard]] std::string toml_line(std::string_view key, bool value);
[[nodiscard]] std::string toml_line(std::string_view key, int value);
[[nodiscard]] std::string toml_line(std::string_view key, std::string_view value);
[[nodiscard]] std::string toml_line(std::string_view key, const char* value);
[[nodiscard]] std::string toml_line(std::string_view key, const std::vector<std::string>& values);
[[nodiscard]] std::string toml_line(std::string_view key, const Eigen::Vector2d& value);

/// A window layout as the lines of a table of this name, with its strips, and back.
[[nodiscard]] std::string layout_lines(const std::string& table, const WindowLayout& layout);
void take_layout(SettingsValues& values, WindowLayout& into);
/// The same of an appearance.
[[nodiscard]] std::string appearance_lines(const Appearance& appearance);
void take_appearance(SettingsValues& values, Appearance& into);

/// @errors kMalformed, kUnsupported: no version, or a newer one than this program writes.
[[nodiscard]] Result<void> check_version(const Settings& settings);
inline constexpr int kTextVersion = 1;

}  // namespace nadir::detail
