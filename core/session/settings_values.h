// SPDX-License-Identifier: Apache-2.0
#pragma once

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
  template <typename Enum>
  requires std::is_enum_v<Enum>
  void take(std::string_view key, Enum& into) {
    std::string word;
    take(key, word);
    if (!outcome_ || word.empty()) return;
    const auto& names = EnumNames<Enum>::kNames;
    const auto found = std::find(names.begin(), names.end(), word);
    if (found != names.end()) {
      into = static_cast<Enum>(found - names.begin());
    } else {
      say(fail(ErrorCode::kMalformed, "{}: {} is none that this version knows: {}",
               settings_.name(), key, word));
    }
  }

  [[nodiscard]] const Settings& settings() const { return settings_; }
  void say(tl::unexpected<Error> fault) {
    if (outcome_) outcome_ = std::move(fault);
  }
  [[nodiscard]] const Result<void>& outcome() const { return outcome_; }

 private:
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
