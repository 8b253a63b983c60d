// SPDX-License-Identifier: Apache-2.0
#include "app/cli/help_page.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <sstream>
#include <vector>

#include "app/cli/misuse.h"

namespace nadir::cli {
namespace {

constexpr std::size_t kTextColumn = 26;

/// Text from `column` on, broken between words; the first line is already `used` columns long.
std::string wrapped(const std::string& text, std::size_t used, std::size_t column) {
  std::istringstream words(text);
  std::string page;
  std::size_t at = used;
  for (std::string word; words >> word;) {
    const std::size_t gap = at > column ? 1 : 0;
    if (at > column && at + gap + word.size() > kHelpWidth) {
      page += '\n';
      at = 0;
    }
    if (at < column) {
      page += std::string(column - at, ' ');
      at = column;
    } else if (at > column) {
      page += ' ';
      ++at;
    }
    page += word;
    at += word.size();
  }
  return page + "\n";
}

/// A name and what it means; a name that is too long for its column has a line of its own.
std::string entry(const std::string& name, const std::string& meaning) {
  const std::string start = "  " + name;
  if (start.size() + 2 > kTextColumn) {
    return wrapped(name, 0, 2) + wrapped(meaning, 0, kTextColumn);
  }
  return start + wrapped(meaning, start.size(), kTextColumn);
}

std::string joined_names(const std::set<CLI::Option*>& options) {
  std::vector<std::string> names;
  names.reserve(options.size());
  for (const CLI::Option* option : options) names.push_back(option->get_name());
  std::sort(names.begin(), names.end());  // the set is ordered by address
  return fmt::format("{}", fmt::join(names, ", "));
}

bool is_repeated(const CLI::Option& option) { return option.get_items_expected_max() > 1; }

std::string left_of(const CLI::App& command, const CLI::Option& option) {
  if (&option == command.get_help_ptr()) return "-h, --help";
  if (option.get_positional()) return option.get_name() + (is_repeated(option) ? "..." : "");
  const std::string name = option.get_name();
  return option.get_items_expected_max() > 0 ? name + " " + option.get_type_name() : name;
}

std::string right_of(const CLI::App& command, const CLI::Option& option) {
  if (&option == command.get_help_ptr()) return "Print this page";
  std::string text = option.get_description();
  if (!option.get_excludes().empty()) text += "; not with " + joined_names(option.get_excludes());
  if (!option.get_needs().empty()) text += "; only with " + joined_names(option.get_needs());
  if (option.get_required() && !option.get_positional()) text += "; required";
  return text;
}

std::string usage(const CLI::App& command) {
  std::string text = "Usage: " + full_name(command);
  if (!command.get_subcommands([](const CLI::App*) { return true; }).empty()) {
    return text + " COMMAND [ARGUMENTS]\n";
  }
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_positional()) text += " " + left_of(command, *option);
  }
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_required() && !option->get_positional())
      text += " " + left_of(command, *option);
  }
  return text + " [FLAGS]\n";
}

}  // namespace

std::string help_page(const CLI::App& command) {
  std::string page = command.get_description() + "\n\n" + usage(command);
  std::string section;
  for (const CLI::App* inner : command.get_subcommands([](const CLI::App*) { return true; })) {
    section += entry(inner->get_name(), inner->get_description());
  }
  if (!section.empty()) {
    page += fmt::format("\nCommands ('{} COMMAND --help' explains one):\n{}", full_name(command),
                        section);
  }
  section.clear();
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_positional())
      section += entry(left_of(command, *option), right_of(command, *option));
  }
  if (!section.empty()) page += "\nArguments:\n" + section;
  for (const std::string& group : command.get_groups()) {
    section.clear();
    for (const CLI::Option* option : command.get_options()) {
      if (option->get_positional() || option->get_group() != group) continue;
      section += entry(left_of(command, *option), right_of(command, *option));
    }
    if (!section.empty()) {
      page += fmt::format("\n{}:\n{}", group == "Options" ? "Flags" : group, section);
    }
  }
  if (!command.get_footer().empty()) page += "\n" + command.get_footer() + "\n";
  return page;
}

}  // namespace nadir::cli
