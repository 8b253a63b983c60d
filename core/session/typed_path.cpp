// SPDX-License-Identifier: Apache-2.0
#include "core/session/typed_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace nadir {
namespace fs = std::filesystem;

TypedPath read_typed_path(std::string_view typed, const fs::path& folder, const std::string& home) {
  const bool begins_at_home = typed == "~" || typed.substr(0, 2) == "~/";
  const std::size_t slash = typed.rfind('/');
  TypedPath read;
  read.is_path = slash != std::string_view::npos || begins_at_home;
  if (!read.is_path) {
    read.folder = folder;
    read.last = typed;
    return read;
  }
  std::string before(slash == std::string_view::npos ? std::string_view("~")
                                                     : typed.substr(0, slash + 1));
  read.last = slash == std::string_view::npos ? std::string_view() : typed.substr(slash + 1);
  if (begins_at_home && !home.empty()) before.replace(0, 1, home);
  fs::path whole = (folder / before / "").lexically_normal();
  // Without the '/' at its end, as folders are called elsewhere.
  if (!whole.has_filename() && whole != whole.root_path()) whole = whole.parent_path();
  read.folder = whole;
  return read;
}

std::string completed_name(std::string_view begun, const std::vector<std::string>& names) {
  std::string common;
  bool is_first = true;
  for (const std::string& name : names) {
    if (name.compare(0, begun.size(), begun) != 0) continue;
    if (is_first) {
      common = name;
      is_first = false;
      continue;
    }
    const auto differs = std::mismatch(common.begin(), common.end(), name.begin(), name.end());
    common.erase(differs.first, common.end());
  }
  return is_first ? std::string(begun) : common;
}

std::string free_name(const std::string& wanted, const std::vector<std::string>& taken) {
  const auto is_taken = [&taken](const std::string& name) {
    return std::find(taken.begin(), taken.end(), name) != taken.end();
  };
  const fs::path path(wanted);
  std::string name = wanted;
  for (int number = 2; is_taken(name); ++number) {
    name = fmt::format("{}-{}{}", path.stem().string(), number, path.extension().string());
  }
  return name;
}

std::string as_file_name(std::string_view words) {
  std::string name;
  for (const char letter : words) {
    const auto byte = static_cast<unsigned char>(letter);
    const bool stays =
        byte >= 0x80U || std::isalnum(byte) != 0 || letter == '.' || letter == '-' || letter == '_';
    if (stays) {
      name += letter;
    } else if (!name.empty() && name.back() != '-') {
      name += '-';
    }
  }
  while (!name.empty() && name.back() == '-') name.pop_back();
  return name;
}

}  // namespace nadir
