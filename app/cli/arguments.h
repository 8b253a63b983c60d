// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <ostream>
#include <span>
#include <string>
#include <vector>

#include "core/base/field.h"
#include "core/base/result.h"
#include "core/geo/project_plane.h"

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

/// Prints an error about files or data as the program's one sentence. Returns kFailed.
int report_error(std::ostream& err, const Error& error);

/// Prints what is wrong with the command line of `command` ("nadir map info") and where help is. Returns kMisused.
int report_misuse(std::ostream& err, const std::string& command, const std::string& complaint);

/// The same of a command line that is well formed but gives a flag a value that it cannot have, be it empty, of another
/// kind or out of its range. Returns kFailed.
int report_value_error(std::ostream& err, const std::string& command, const std::string& complaint);

/// Of what was made of flags: kInvalidOptions is a value error of the command line, anything else (a file that a flag
/// names) is the file's. What a file says must therefore not come here as kInvalidOptions; see blame_file(). Returns kFailed.
int report_flags_error(std::ostream& err, const std::string& command, const Error& error);

/// The same error where a file and not the command line is at fault.
[[nodiscard]] Error blame_file(Error error);

/// Checks of single values for CLI::Option::check(): empty where the text is fine, else the complaint that follows the
/// flag's name: "'abc' is not a whole number from 1 on".
using ValueCheck = std::function<std::string(const std::string&)>;
[[nodiscard]] ValueCheck is_whole_number(
    std::int64_t minimum, std::int64_t maximum = std::numeric_limits<std::int64_t>::max());
[[nodiscard]] ValueCheck is_number();
[[nodiscard]] ValueCheck is_one_of(std::vector<std::string> choices);

/// "{easy|medium|hard}", as help pages show choices.
[[nodiscard]] std::string choices_text(const std::vector<std::string>& choices);

/// --threads, the same for every command that has it.
void add_threads_flag(CLI::App& app, int& threads);

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

/// "LAT,LON" in degrees, north and east positive, where a project plane may lie: not at the poles. @errors kInvalidOptions,
/// naming the flag.
[[nodiscard]] Result<Geodetic> parse_place(const std::string& flag, const std::string& text);

/// A path that is there, or what the program brings along: "maps/proving-ground", or a map by its name alone.
[[nodiscard]] std::filesystem::path find_bundled(const std::filesystem::path& path);

/// How the user calls this program: "nadir" where the shell finds it by that name, else its path.
[[nodiscard]] std::string program_name();

}  // namespace nadir::cli
