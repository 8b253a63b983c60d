// SPDX-License-Identifier: Apache-2.0
#include "core/map/image_date.h"

#include <array>
#include <chrono>

#include "core/base/result.h"

namespace nadir {
namespace {

bool is_decimal_digit(char letter) { return letter >= '0' && letter <= '9'; }

bool are_digits(std::string_view text, std::size_t from, std::size_t count) {
  if (from + count > text.size()) return false;
  for (std::size_t i = from; i < from + count; ++i) {
    if (!is_decimal_digit(text[i])) return false;
  }
  return true;
}

int digits_as_number(std::string_view text, std::size_t from, std::size_t count) {
  int value = 0;
  for (const char letter : text.substr(from, count)) value = 10 * value + (letter - '0');
  return value;
}

struct FoundDay {
  std::string day;
  std::size_t length = 0;  ///< Letters that it takes.
};

/// The day that begins at `from`, with one of `separators` twice or none at all.
std::optional<FoundDay> day_at(std::string_view text,
                               std::size_t from,
                               std::string_view separators) {
  if (!are_digits(text, from, 4)) return std::nullopt;
  std::size_t month = from + 4, gap = 0;
  if (month < text.size() && separators.find(text[month]) != std::string_view::npos) gap = 1;
  month += gap;
  const std::size_t day = month + 2 + gap;
  if (!are_digits(text, month, 2) || !are_digits(text, day, 2)) return std::nullopt;
  if (gap == 1 && text[month + 2] != text[month - 1]) return std::nullopt;
  const int year = digits_as_number(text, from, 4);
  const std::chrono::year_month_day date(
      std::chrono::year(year),
      std::chrono::month(static_cast<unsigned>(digits_as_number(text, month, 2))),
      std::chrono::day(static_cast<unsigned>(digits_as_number(text, day, 2))));
  if (year < 1900 || year > 2099 || !date.ok()) return std::nullopt;
  return FoundDay{fmt::format("{:04}-{:02}-{:02}", year, static_cast<unsigned>(date.month()),
                              static_cast<unsigned>(date.day())),
                  day + 2 - from};
}

}  // namespace

std::optional<std::string> day_of(std::string_view text) {
  const auto found = day_at(text, 0, ":-/");
  if (!found || are_digits(text, found->length, 1)) return std::nullopt;
  return found->day;
}

std::optional<std::string> day_in_name(std::string_view file_name) {
  for (std::size_t from = 0; from + 8 <= file_name.size(); ++from) {
    if (from > 0 && is_decimal_digit(file_name[from - 1])) continue;
    const auto found = day_at(file_name, from, "-_.");
    if (found && !are_digits(file_name, from + found->length, 1)) return found->day;
  }
  return std::nullopt;
}

}  // namespace nadir
