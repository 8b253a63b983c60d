// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

namespace CLI {
class App;
}

namespace nadir::cli {

/// What the words of a command line say before any value is read.
struct WordCheck {
  const CLI::App* command = nullptr;  ///< The command, or the command of a command, that is meant.
  bool asks_for_help = false;         ///< Wins over every complaint.
  std::string complaint;              ///< Half a sentence about the first fault; empty without one.
  bool is_value_wrong = false;        ///< It is about a value, which is empty, and not about words.
};

/// Looks for unknown and repeated flags, missing values and arguments, words too many and flags that do not go together;
/// and for values that are empty, which are values that cannot be.
/// The library that reads the values would find these too, but tells of the consequence ("--map is required") where the
/// cause is a slip ("--mpa: no such flag").
[[nodiscard]] WordCheck check_words(const CLI::App& app, std::span<const std::string> words);

/// "nadir map import": the name of a command with those around it.
[[nodiscard]] std::string full_name(const CLI::App& command);

}  // namespace nadir::cli
