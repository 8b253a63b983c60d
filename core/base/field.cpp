// SPDX-License-Identifier: Apache-2.0
#include "core/base/field.h"

#include <charconv>
#include <cmath>
#include <system_error>

namespace nadir::detail {
namespace {

/// The whole text as a T, or nothing: trailing letters and spaces are refused, as is the empty
/// text.
template <typename T>
bool parse_all(std::string_view text, T& value) {
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  return error == std::errc() && rest == end;
}

}  // namespace

Result<void> check_range(const Field& field, double value) {
  if (!(field.minimum <= value && value <= field.maximum) || !std::isfinite(value)) {
    return fail(ErrorCode::kInvalidOptions, "--{}: {} is not in {}", field.name, value,
                range_text(field));
  }
  return {};
}

Result<double> parse_number(const Field& field, std::string_view text) {
  double value = 0.0;
  if (!parse_all(text, value)) {
    return fail(ErrorCode::kInvalidOptions, "--{}: '{}' is not a number", field.name, text);
  }
  if (const auto range = check_range(field, value); !range) return forward_error(range);
  return value;
}

Result<std::uint64_t> parse_whole(const Field& field, std::string_view text) {
  std::uint64_t value = 0;
  if (!parse_all(text, value)) {
    return fail(ErrorCode::kInvalidOptions, "--{}: '{}' is not a whole number in {}", field.name,
                text, range_text(field));
  }
  if (const auto range = check_range(field, static_cast<double>(value)); !range) {
    return forward_error(range);
  }
  return value;
}

Result<bool> parse_boolean(const Field& field, std::string_view text) {
  if (text == "true" || text == "yes" || text == "1") return true;
  if (text == "false" || text == "no" || text == "0") return false;
  return fail(ErrorCode::kInvalidOptions, "--{}: '{}' is not true or false", field.name, text);
}

Result<std::size_t> parse_choice(const Field& field,
                                 std::string_view text,
                                 const std::string_view* names,
                                 std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    if (names[i] == text) return i;
  }
  return fail(ErrorCode::kInvalidOptions, "--{}: '{}' is not one of {}", field.name, text,
              choices_text(names, count));
}

std::string range_text(const Field& field) {
  const bool has_maximum = std::isfinite(field.maximum);
  if (!std::isfinite(field.minimum)) {
    return has_maximum ? fmt::format("(-inf, {}]", field.maximum) : "any number";
  }
  return has_maximum ? fmt::format("[{}, {}]", field.minimum, field.maximum)
                     : fmt::format("[{}, inf)", field.minimum);
}

std::string choices_text(const std::string_view* names, std::size_t count) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0) text += ", ";
    text += names[i];
  }
  return text;
}

}  // namespace nadir::detail
