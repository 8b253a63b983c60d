// SPDX-License-Identifier: Apache-2.0
#include "app/cli/arguments.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <system_error>

#include "app/cli/command.h"

namespace nadir::cli {
namespace fs = std::filesystem;

std::optional<int> parse_arguments(CLI::App& app,
                                   std::span<const std::string> arguments,
                                   std::ostream& out,
                                   std::ostream& err) {
  try {
    app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
    return std::nullopt;
  } catch (const CLI::CallForHelp&) {
    out << app.help();
    return kDone;
  } catch (const CLI::ParseError& error) {
    err << app.get_name() << ": " << error.what() << "; see '" << app.get_name() << " --help'\n";
    return kMisused;
  }
}

int report_error(std::ostream& err, const Error& error) {
  err << "nadir: " << error.message << "\n";
  return kFailed;
}

void add_option_flags(CLI::App& app,
                      const std::string& heading,
                      const std::vector<OptionText>& options,
                      OptionFlags& values) {
  for (const OptionText& option : options) {
    std::string help = option.help;
    if (!option.unit.empty()) help += " [" + option.unit + "]";
    if (!option.range.empty()) help += ", " + option.range;
    help += ", default " + option.value;
    app.add_option_function<std::string>(
           "--" + option.name,
           [&values, name = option.name](const std::string& text) { values[name] = text; }, help)
        ->type_name("")
        ->group(heading);
  }
}

Result<std::vector<double>> parse_list(const std::string& flag,
                                       const std::string& text,
                                       std::size_t count) {
  std::vector<double> numbers;
  const char* begin = text.data();
  const char* const end = text.data() + text.size();
  while (begin <= end) {
    const char* const comma = std::find(begin, end, ',');
    double number = 0.0;
    const auto [rest, error] = std::from_chars(begin, comma, number);
    if (error != std::errc() || rest != comma || !std::isfinite(number)) break;
    numbers.push_back(number);
    begin = comma + 1;
  }
  if (numbers.size() != count || begin <= end) {
    return fail(ErrorCode::kInvalidOptions, "{}: '{}' is not {} numbers with commas between them",
                flag, text, count);
  }
  return numbers;
}

fs::path find_bundled(const fs::path& path) {
  std::error_code error;
  if (path.is_absolute() || fs::exists(path, error)) return path;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  const bool is_installed = program.string().rfind(NADIR_BUILD_DIR "/", 0) != 0;
  const fs::path root = is_installed ? program.parent_path().parent_path() / "share" / "nadir"
                                     : fs::path(NADIR_SOURCE_DIR);
  for (const fs::path& candidate : {root / path, root / "maps" / path}) {
    if (fs::exists(candidate, error)) return candidate;
  }
  return path;
}

std::string program_name() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  const char* folders =
      std::getenv("PATH");  // NOLINT(concurrency-mt-unsafe): nobody sets variables
  std::istringstream stream(folders != nullptr ? folders : "");
  for (std::string folder; std::getline(stream, folder, ':');) {
    if (fs::equivalent(fs::path(folder) / "nadir", program, error)) return "nadir";
  }
  const fs::path nearby = fs::relative(program, error);
  return error || nearby.empty() ? program.string() : nearby.string();
}

}  // namespace nadir::cli
