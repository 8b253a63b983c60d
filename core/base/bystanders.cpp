// SPDX-License-Identifier: Apache-2.0
#include "core/base/bystanders.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <optional>
#include <string>
#include <system_error>

#include "core/base/require.h"

namespace nadir {
namespace fs = std::filesystem;
namespace {

/// The process id that a name ends with, or that is followed by a number from 2 on; nothing where
/// it ends otherwise.
std::optional<pid_t> process_of(std::string_view name, std::string_view prefix) {
  if (!name.starts_with(prefix)) return std::nullopt;
  name.remove_prefix(prefix.size());
  pid_t process = 0;
  const char* const last = name.data() + name.size();
  const auto [end, error] = std::from_chars(name.data(), last, process);
  if (error != std::errc() || process <= 0) return std::nullopt;
  if (end == last) return process;
  int number = 0;
  const auto [number_end, number_error] = std::from_chars(end + 1, last, number);
  const bool is_numbered = *end == '-' && number_error == std::errc() && number_end == last;
  return is_numbered && number >= 2 ? std::optional(process) : std::nullopt;
}

bool is_gone(pid_t process) { return ::kill(process, 0) != 0 && errno == ESRCH; }

}  // namespace

fs::path bystander_of(const fs::path& target, std::string_view infix, int number) {
  NADIR_REQUIRE(number >= 1);
  fs::path name = target;
  name += infix;
  name += std::to_string(::getpid());
  if (number > 1) name += "-" + std::to_string(number);
  return name;
}

std::vector<fs::path> abandoned_bystanders(const fs::path& target, std::string_view infix) {
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  const std::string prefix = target.filename().string() + std::string(infix);
  std::vector<fs::path> abandoned;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    const auto process = process_of(entry->path().filename().string(), prefix);
    if (process && is_gone(*process)) abandoned.push_back(entry->path());
  }
  std::sort(abandoned.begin(), abandoned.end());
  return abandoned;
}

}  // namespace nadir
