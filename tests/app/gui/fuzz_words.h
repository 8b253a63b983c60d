// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "core/session/action.h"

namespace nadir {

/// Words of a user without a plan: actions with sensible, borderline and senseless arguments, and texts to type. All of it
/// follows from the seed. Files are written by names without a folder only, so into the folder that the test works in.
class FuzzWords {
 public:
  /// @param paths  That may be opened.
  FuzzWords(std::uint64_t seed, std::vector<std::string> paths);

  /// In [0, count); count > 0.
  [[nodiscard]] std::size_t below(std::size_t count);
  [[nodiscard]] bool chance(double share);
  /// In [least, most).
  [[nodiscard]] double between(double least, double most);
  template <typename List>
  [[nodiscard]] const auto& one_of(const List& list) {
    return list[below(std::size(list))];
  }

  /// Any action, as a script has it; parse_action() may refuse it.
  [[nodiscard]] std::string action();
  /// One of this form.
  [[nodiscard]] std::string action_of(const ActionHelp& help);
  /// Anything that somebody could type or paste.
  [[nodiscard]] std::string text();

 private:
  [[nodiscard]] std::string argument(std::string_view action, std::string_view name);
  [[nodiscard]] std::string name_for(std::string_view action);
  [[nodiscard]] std::string file(std::string_view action);

  std::mt19937_64 random_;
  std::vector<ActionHelp> helps_ = action_helps();
  std::vector<std::string> paths_, options_;
  std::vector<std::string> tool_options_;
  int files_ = 0;
  std::string_view last_;  ///< Action.
};

}  // namespace nadir
