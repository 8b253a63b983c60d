// SPDX-License-Identifier: Apache-2.0
#include "app/cli/misuse.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <optional>
#include <set>
#include <vector>

#include "core/base/settings.h"

namespace nadir::cli {
namespace {

std::string did_you_mean(const std::string& nearest) {
  return nearest.empty() ? std::string() : fmt::format(" (did you mean {}?)", nearest);
}

/// "A", "A and B", "A, B and C".
std::string enumerated(const std::vector<std::string>& words, std::string_view last_joint) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) text += i + 1 == words.size() ? fmt::format(" {} ", last_joint) : ", ";
    text += words[i];
  }
  return text;
}

bool is_value_taken(const CLI::Option& option) { return option.get_items_expected_max() > 0; }

/// Reads the words in order and keeps what was given.
class Scan {
 public:
  explicit Scan(const CLI::App& app) { check_.command = &app; }

  WordCheck run(std::span<const std::string> words) {
    bool are_flags_over = false;
    for (std::size_t i = 0; i < words.size(); ++i) {
      const std::string& word = words[i];
      if (!are_flags_over && word == "--") {
        are_flags_over = true;
      } else if (!are_flags_over && word.size() > 1 && word.front() == '-') {
        const bool takes_next = read_flag(word, i + 1 < words.size() ? &words[i + 1] : nullptr);
        i += takes_next ? 1 : 0;
      } else {
        read_argument(word);
      }
    }
    look_for_missing();
    look_for_discord();
    return check_;
  }

 private:
  /// Only the first fault is told; the next ones often follow from it.
  void complain(const std::string& complaint, bool is_value_wrong = false) {
    if (!check_.complaint.empty()) return;
    check_.complaint = complaint;
    check_.is_value_wrong = is_value_wrong;
  }

  /// Returns whether the next word is the flag's value.
  bool read_flag(const std::string& word, const std::string* next) {
    const std::size_t equals = word.find('=');
    const std::string name = word.substr(0, equals);
    const CLI::Option* option = check_.command->get_option_no_throw(name);
    if (option == nullptr && !inner_commands().empty()) {
      complain(name + ": a flag stands after the command, which is " +
               enumerated(inner_commands(), "or"));
      is_command_wrong_ = true;
      return false;
    }
    if (option == nullptr) {
      complain(name + ": no such flag" + did_you_mean(nearest_flag(name)));
      return false;
    }
    if (option == check_.command->get_help_ptr()) {
      check_.asks_for_help = true;
      return false;
    }
    const bool is_first = given_.insert(option).second;
    if (!is_first && option->get_items_expected_max() <= 1) complain(name + ": is given twice");
    if (!is_value_taken(*option)) {
      if (equals != std::string::npos) complain(name + ": takes no value");
      return false;
    }
    std::optional<std::string> value;
    if (equals != std::string::npos) {
      value = word.substr(equals + 1);
    } else if (next != nullptr && next->rfind("--", 0) != 0) {
      value = *next;
    }
    if (!value) {
      complain(fmt::format("{0}: its value is missing ({0} {1})", name, option->get_type_name()));
    } else if (value->empty()) {
      complain(name + ": its value is empty", true);
    }
    return value && equals == std::string::npos;
  }

  [[nodiscard]] std::string nearest_flag(const std::string& name) const {
    std::vector<std::string> flags;
    for (const CLI::Option* option : check_.command->get_options()) {
      for (const std::string& flag : option->get_lnames()) flags.push_back(flag);
    }
    const std::string nearest = nearest_word(name.substr(name.find_first_not_of('-')), flags);
    return nearest.empty() ? nearest : "--" + nearest;
  }

  void read_argument(const std::string& word) {
    const auto commands = check_.command->get_subcommands([](const CLI::App*) { return true; });
    if (!commands.empty()) {
      read_command(word, commands);
      return;
    }
    int most = 0;
    const CLI::Option* last = nullptr;
    for (const CLI::Option* option : check_.command->get_options()) {
      if (!option->get_positional()) continue;
      most += option->get_items_expected_max();
      last = option;
    }
    if (++arguments_ > most) complain(fmt::format("'{}' is one argument too many", word));
    if (word.empty() && last != nullptr) complain(last->get_name() + ": is empty", true);
  }

  void read_command(const std::string& word, const std::vector<const CLI::App*>& commands) {
    for (const CLI::App* command : commands) {
      if (command->get_name() != word) continue;
      check_.command = command;
      return;
    }
    is_command_wrong_ = true;
    complain(fmt::format("'{}' is not one of its commands{}", word,
                         did_you_mean(nearest_word(word, inner_commands()))));
  }

  [[nodiscard]] std::vector<std::string> inner_commands() const {
    std::vector<std::string> names;
    for (const CLI::App* command :
         check_.command->get_subcommands([](const CLI::App*) { return true; })) {
      names.push_back(command->get_name());
    }
    return names;
  }

  void look_for_missing() {
    const std::vector<std::string> commands = inner_commands();
    if (!commands.empty() && !is_command_wrong_) {
      complain("a command is missing: " + enumerated(commands, "or"));
    }
    std::vector<std::string> missing;
    int arguments_left = arguments_;
    for (const CLI::Option* option : check_.command->get_options()) {
      const bool is_given =
          option->get_positional() ? arguments_left-- > 0 : given_.count(option) > 0;
      if (option->get_required() && !is_given) missing.push_back(option->get_name());
    }
    if (missing.empty()) return;
    complain(enumerated(missing, "and") + (missing.size() > 1 ? " are missing" : " is missing"));
  }

  void look_for_discord() {
    for (const CLI::Option* option : check_.command->get_options()) {
      if (given_.count(option) == 0) continue;
      for (const CLI::Option* other : option->get_excludes()) {
        if (given_.count(other) == 0) continue;
        complain(option->get_name() + " and " + other->get_name() + " exclude each other");
      }
      for (const CLI::Option* other : option->get_needs()) {
        if (given_.count(other) > 0) continue;
        complain(option->get_name() + ": goes only with " + other->get_name());
      }
    }
  }

  WordCheck check_;
  std::set<const CLI::Option*> given_;
  int arguments_ = 0;
  bool is_command_wrong_ = false;
};

}  // namespace

WordCheck check_words(const CLI::App& app, std::span<const std::string> words) {
  return Scan(app).run(words);
}

std::string full_name(const CLI::App& command) {
  const CLI::App* parent = command.get_parent();
  return parent == nullptr ? command.get_name() : full_name(*parent) + " " + command.get_name();
}

}  // namespace nadir::cli
