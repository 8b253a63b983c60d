// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/panel_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

namespace nadir {
namespace {

[[nodiscard]] char lower_ascii(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

[[nodiscard]] bool is_continued(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

[[nodiscard]] bool has_word(std::string_view words, std::string_view word) {
  return std::search(words.begin(), words.end(), word.begin(), word.end(), [](char a, char b) {
           return lower_ascii(a) == lower_ascii(b);
         }) != words.end();
}

}  // namespace

std::string name_of(const std::filesystem::path& path) {
  const std::filesystem::path plain = path.has_filename() ? path : path.parent_path();
  if (plain.extension() == ".nadir" && plain.has_stem()) return plain.stem().string();
  const std::string name = plain.filename().string();
  return name.empty() ? path.string() : name;
}

std::string folder_of(const std::filesystem::path& path, const std::string& home) {
  const std::filesystem::path plain = path.has_filename() ? path : path.parent_path();
  std::string folder = plain.parent_path().string();
  if (!home.empty() && folder.compare(0, home.size(), home) == 0 &&
      (folder.size() == home.size() || folder[home.size()] == '/')) {
    return "~" + folder.substr(home.size());
  }
  return folder;
}

std::string home_folder() {
  const char* const home = std::getenv("HOME");  // NOLINT(concurrency-mt-unsafe): nobody sets any
  return home == nullptr ? std::string() : std::string(home);
}

std::string shortened(std::string_view text, std::size_t most_characters) {
  std::vector<std::size_t> starts;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (i == 0 || !is_continued(text[i])) starts.push_back(i);
  }
  if (starts.size() <= most_characters) return std::string(text);
  const std::size_t kept = most_characters - 1;
  const std::size_t at_end = kept - kept / 3;  // the name at the end says more than the root
  const std::size_t at_start = kept - at_end;
  return fmt::format("{}…{}", text.substr(0, starts[at_start]),
                     text.substr(starts[starts.size() - at_end]));
}

std::string memory_text(std::size_t bytes) {
  const double megabytes = static_cast<double>(bytes) / 1e6;
  if (megabytes < 999.5) return fmt::format("{:.0f} MB", megabytes);
  return fmt::format("{:.1f} GB", megabytes / 1e3);
}

std::string file_size_text(std::uintmax_t bytes) {
  const auto size = static_cast<double>(bytes);
  if (bytes < 1000) return fmt::format("{} B", bytes);
  if (size < 999.5e3) return fmt::format("{:.0f} kB", size / 1e3);
  return memory_text(static_cast<std::size_t>(bytes));
}

std::string left_text(double left_s) {
  if (!std::isfinite(left_s)) return {};
  if (left_s < 4.5) return "a few seconds left";
  if (left_s < 99.5) return fmt::format("{:.0f} s left", left_s);
  if (left_s < 5970.0) return fmt::format("{:.0f} min left", left_s / 60.0);
  return fmt::format("{:.0f} h left", left_s / 3600.0);
}

bool has_words(std::string_view words, std::string_view typed) {
  while (true) {
    const std::size_t start = typed.find_first_not_of(' ');
    if (start == std::string_view::npos) return true;
    typed.remove_prefix(start);
    const std::size_t end = std::min(typed.find(' '), typed.size());
    if (!has_word(words, typed.substr(0, end))) return false;
    typed.remove_prefix(end);
  }
}

std::string label_of(std::string_view shown, std::string_view told_apart_by) {
  return fmt::format("{}##{}", shown, told_apart_by);
}

}  // namespace nadir
