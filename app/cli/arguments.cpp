// SPDX-License-Identifier: Apache-2.0
#include "app/cli/arguments.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <system_error>

#include "app/cli/command.h"
#include "app/cli/help_page.h"
#include "app/cli/misuse.h"
#include "core/base/settings.h"

namespace nadir::cli {
namespace fs = std::filesystem;

namespace {

/// The whole text as a T, or nothing.
template <typename T>
std::optional<T> parsed(const std::string& text) {
  T value{};
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || rest != end) return std::nullopt;
  return value;
}

bool is_interval(const std::string& range) { return !range.empty() && range.front() == '['; }

/// "[1, 8]" as "1 to 8" and "[1, inf)" as "1 or more": square brackets are for units.
std::string range_words(const std::string& interval) {
  const std::size_t comma = interval.find(", ");
  const std::string least = interval.substr(1, comma - 1);
  const std::string most = interval.substr(comma + 2, interval.size() - comma - 3);
  return most == "inf" ? least + " or more" : least + " to " + most;
}

/// What stands for the value on the help page.
std::string value_name(const OptionText& option) {
  switch (option.kind) {
    case OptionKind::kBoolean:
      return "{true|false}";
    case OptionKind::kNumber:
      return "NUMBER";
    case OptionKind::kOwnText:
      return option.range;
    case OptionKind::kChoice:
      break;
  }
  std::string choices = option.range;
  for (std::size_t at = choices.find(", "); at != std::string::npos; at = choices.find(", ")) {
    choices.replace(at, 2, "|");
  }
  return "{" + choices + "}";
}

}  // namespace

std::optional<int> parse_arguments(CLI::App& app,
                                   std::span<const std::string> arguments,
                                   std::ostream& out,
                                   std::ostream& err) {
  const WordCheck words = check_words(app, arguments);
  if (words.asks_for_help) {
    out << help_page(*words.command);
    return kDone;
  }
  if (!words.complaint.empty()) {
    const auto report = words.is_value_wrong ? report_value_error : report_misuse;
    return report(err, full_name(*words.command), words.complaint);
  }
  try {
    app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
    return std::nullopt;
  } catch (const CLI::ParseError& error) {  // the words are fine, so it is one of the values
    return report_value_error(err, full_name(*words.command), error.what());
  }
}

int report_error(std::ostream& err, const Error& error) {
  err << "nadir: " << error.message << "\n";
  return kFailed;
}

namespace {

void complain(std::ostream& err, const std::string& command, const std::string& complaint) {
  err << command << ": " << complaint << "; see '" << command << " --help'\n";
}

}  // namespace

int report_misuse(std::ostream& err, const std::string& command, const std::string& complaint) {
  complain(err, command, complaint);
  return kMisused;
}

int report_value_error(std::ostream& err,
                       const std::string& command,
                       const std::string& complaint) {
  complain(err, command, complaint);
  return kFailed;
}

int report_flags_error(std::ostream& err, const std::string& command, const Error& error) {
  if (error.code != ErrorCode::kInvalidOptions) return report_error(err, error);
  return report_value_error(err, command, error.message);
}

Error blame_file(Error error) {
  if (error.code == ErrorCode::kInvalidOptions) error.code = ErrorCode::kMalformed;
  return error;
}

ValueCheck is_whole_number(std::int64_t minimum, std::int64_t maximum) {
  return [=](const std::string& text) -> std::string {
    const auto value = parsed<std::int64_t>(text);
    if (value && *value >= minimum && *value <= maximum) return {};
    const bool has_maximum = maximum < std::numeric_limits<std::int64_t>::max();
    return fmt::format("'{}' is not a whole number from {} {}", text, minimum,
                       has_maximum ? fmt::format("to {}", maximum) : "on");
  };
}

ValueCheck is_number() {
  return [](const std::string& text) -> std::string {
    const auto value = parsed<double>(text);
    if (value && std::isfinite(*value)) return {};
    return fmt::format("'{}' is not a number", text);
  };
}

ValueCheck is_one_of(std::vector<std::string> choices) {
  return [choices = std::move(choices)](const std::string& text) -> std::string {
    if (std::find(choices.begin(), choices.end(), text) != choices.end()) return {};
    // One letter is near to any other.
    const std::string nearest = text.size() > 2 ? nearest_word(text, choices) : std::string();
    return fmt::format("'{}' is not one of {}{}", text, fmt::join(choices, ", "),
                       nearest.empty() ? "" : fmt::format(" (did you mean {}?)", nearest));
  };
}

std::string choices_text(const std::vector<std::string>& choices) {
  return fmt::format("{{{}}}", fmt::join(choices, "|"));
}

void add_threads_flag(CLI::App& app, int& threads) {
  constexpr int kMostThreads = 1024;
  app.add_option("--threads", threads,
                 fmt::format("Threads to use, 0 to {}; 0 is all there are, the default. The result "
                             "does not depend on it",
                             kMostThreads))
      ->type_name("NUMBER")
      ->check(is_whole_number(0, kMostThreads));
}

void add_option_flags(CLI::App& app,
                      const std::string& heading,
                      const std::vector<OptionText>& options,
                      OptionFlags& values) {
  for (const OptionText& option : options) {
    std::string help = option.help;
    if (!option.unit.empty()) help += " [" + option.unit + "]";
    if (is_interval(option.range)) help += ", " + range_words(option.range);
    help += ", default " + option.value;
    app.add_option_function<std::string>(
           "--" + option.name,
           [&values, name = option.name](const std::string& text) { values[name] = text; }, help)
        ->type_name(value_name(option))
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

Result<Geodetic> parse_place(const std::string& flag, const std::string& text) {
  const auto numbers = parse_list(flag, text, 2);
  if (!numbers) return forward_error(numbers);
  const Geodetic place{(*numbers)[0], (*numbers)[1]};
  if (std::abs(place.latitude_deg) > 89.0 || std::abs(place.longitude_deg) > 180.0) {
    return fail(ErrorCode::kInvalidOptions,
                "{}: '{}' is not a latitude from -89 to 89 and a longitude from -180 to 180", flag,
                text);
  }
  return place;
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
