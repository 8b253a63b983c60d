// SPDX-License-Identifier: Apache-2.0
#include "core/geo/number_lines.h"

#include <charconv>
#include <cmath>
#include <system_error>
#include <utility>

namespace nadir {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
constexpr std::string_view kBlanks = " \t\r\v\f";

/// A word as a message can show it: short, and without bytes that would upset a terminal.
std::string shown(std::string_view word) {
  constexpr std::size_t kMaxLetters = 24;
  std::string text(word.substr(0, kMaxLetters));
  for (char& letter : text) {
    const auto code = static_cast<unsigned char>(letter);
    if (code < 0x20U || code > 0x7EU) letter = '?';
  }
  return word.size() > kMaxLetters ? text + "..." : text;
}

}  // namespace

NumberLines::NumberLines(std::string_view text, std::string name)
    : rest_(text), name_(std::move(name)) {
  if (rest_.substr(0, kByteOrderMark.size()) == kByteOrderMark) {
    rest_.remove_prefix(kByteOrderMark.size());
  }
}

std::string NumberLines::where(std::size_t line) const {
  return fmt::format("{}: line {}", name_, line);
}

Result<std::optional<NumberLine>> NumberLines::next() {
  while (!rest_.empty()) {
    const std::size_t end = rest_.find('\n');
    std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    ++line_;
    line = line.substr(0, line.find('#'));
    if (const auto read = read_values(line); !read) return forward_error(read);
    if (!values_.empty()) return NumberLine{line_, values_};
  }
  return std::nullopt;
}

Result<void> NumberLines::read_values(std::string_view line) {
  values_.clear();
  while (true) {
    const std::size_t begin = line.find_first_not_of(kBlanks);
    if (begin == std::string_view::npos) return {};
    line.remove_prefix(begin);
    const std::string_view word = line.substr(0, line.find_first_of(kBlanks));
    line.remove_prefix(word.size());

    // std::from_chars knows no plus sign, which other programs write.
    const bool has_plus = word.size() > 1 && word[0] == '+' && word[1] != '-';
    const char* const end = word.data() + word.size();
    double value = 0.0;
    const auto [rest, error] = std::from_chars(word.data() + (has_plus ? 1 : 0), end, value);
    if (error == std::errc::invalid_argument || rest != end) {
      return fail(ErrorCode::kMalformed, "{}: '{}' is not a number", where(line_), shown(word));
    }
    if (error != std::errc() || !std::isfinite(value)) {
      return fail(ErrorCode::kMalformed, "{}: '{}' is not a finite number that a double can hold",
                  where(line_), shown(word));
    }
    values_.push_back(value);
  }
}

}  // namespace nadir
