// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <ostream>
#include <span>
#include <string>
#include <vector>

#include "core/base/field.h"
#include "core/base/result.h"

namespace CLI {
class App;
}

namespace nadir::cli {

/// Parses the arguments of one command. Nothing where the command should go on; else the exit
/// status, with help (to `out`) or the complaint (to `err`) already printed.
[[nodiscard]] std::optional<int> parse_arguments(CLI::App& app,
                                                 std::span<const std::string> arguments,
                                                 std::ostream& out,
                                                 std::ostream& err);

/// Prints an error as the program's one sentence. Returns the exit status of a failure.
int report_error(std::ostream& err, const Error& error);

/// Flags that set options by name, as text that set_option() reads after parsing.
using OptionFlags = std::map<std::string, std::string>;
/// Adds one flag an option, with unit, range and default in its help.
/// @param heading  Of these flags on the help page.
void add_option_flags(CLI::App& app,
                      const std::string& heading,
                      const std::vector<OptionText>& options,
                      OptionFlags& values);

/// Three numbers "E,N,YAW" and the like. @errors kInvalidOptions, naming the flag.
[[nodiscard]] Result<std::vector<double>> parse_list(const std::string& flag,
                                                     const std::string& text,
                                                     std::size_t count);

/// A path that is there, or what the program brings along: "maps/proving-ground", or a map by its name alone.
[[nodiscard]] std::filesystem::path find_bundled(const std::filesystem::path& path);

/// How the user calls this program: "nadir" where the shell finds it by that name, else its path.
[[nodiscard]] std::string program_name();

}  // namespace nadir::cli
