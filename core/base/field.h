// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/base/settings.h"

namespace nadir {

/// What there is to know about one option beside its value. A struct of options lists its fields
/// once, in a function `visit_fields(options, visitor)`; flags, recipe files, controls and
/// validate() all come from that list.
struct Field {
  std::string_view name;  ///< As on the command line without dashes: "particle-count".
  std::string_view unit;  ///< "m", "rad/m" or empty.
  std::string_view help;
  double minimum = -std::numeric_limits<double>::infinity();
  double maximum = std::numeric_limits<double>::infinity();
};

/// Names of an enum's values in order, first value 0; specialise it for an enum that is an option.
template <typename Enum>
struct EnumNames;  // static constexpr std::array<std::string_view, N> kNames

template <typename Enum>
[[nodiscard]] std::string_view enum_name(Enum value) {
  return EnumNames<Enum>::kNames[static_cast<std::size_t>(value)];
}

/// A value that is neither number nor boolean nor choice and has a text of its own ("1600x1000"): kForm names what the
/// text looks like, from_text() reads it and check() asks for its range. Their errors follow the option's name.
template <typename T>
concept OwnText = requires(const T& value, std::string_view text) {
  { T::kForm } -> std::convertible_to<std::string_view>;
  { T::from_text(text) } -> std::same_as<Result<T>>;
  { value.text() } -> std::same_as<std::string>;
  { value.check() } -> std::same_as<Result<void>>;
};

enum class OptionKind { kNumber, kBoolean, kChoice, kOwnText };

/// One option as text, for help pages, recipes and the run file.
struct OptionText {
  std::string name, value, unit, help, range;
  OptionKind kind = OptionKind::kNumber;
};

namespace detail {
[[nodiscard]] Result<void> check_range(const Field& field, double value);
[[nodiscard]] Result<double> parse_number(const Field& field, std::string_view text);
[[nodiscard]] Result<std::uint64_t> parse_whole(const Field& field, std::string_view text);
[[nodiscard]] Result<bool> parse_boolean(const Field& field, std::string_view text);
[[nodiscard]] Result<std::size_t> parse_choice(const Field& field,
                                               std::string_view text,
                                               const std::string_view* names,
                                               std::size_t count);
[[nodiscard]] std::string range_text(const Field& field);
[[nodiscard]] std::string choices_text(const std::string_view* names, std::size_t count);

template <typename T>
Result<void> parse_into(T& value, const Field& field, std::string_view text) {
  if constexpr (std::is_same_v<T, bool>) {
    const auto parsed = parse_boolean(field, text);
    if (!parsed) return forward_error(parsed);
    value = *parsed;
  } else if constexpr (std::is_enum_v<T>) {
    const auto& names = EnumNames<T>::kNames;
    const auto parsed = parse_choice(field, text, names.data(), names.size());
    if (!parsed) return forward_error(parsed);
    value = static_cast<T>(*parsed);
  } else if constexpr (OwnText<T>) {
    auto parsed = T::from_text(text);
    if (!parsed) return forward_error(parsed, fmt::format("--{}", field.name));
    if (const auto valid = parsed->check(); !valid) {
      return forward_error(valid, fmt::format("--{}", field.name));
    }
    value = std::move(*parsed);
  } else if constexpr (std::is_integral_v<T>) {
    const auto parsed = parse_whole(field, text);
    if (!parsed) return forward_error(parsed);
    if (!std::in_range<T>(*parsed)) {
      return fail(ErrorCode::kInvalidOptions, "--{}: {} is not in [{}, {}]", field.name, *parsed,
                  field.minimum, std::numeric_limits<T>::max());
    }
    value = static_cast<T>(*parsed);
  } else {
    const auto parsed = parse_number(field, text);
    if (!parsed) return forward_error(parsed);
    value = *parsed;
  }
  return {};
}

template <typename T>
std::string value_text(const T& value) {
  if constexpr (std::is_same_v<T, bool>) {
    return value ? "true" : "false";
  } else if constexpr (std::is_enum_v<T>) {
    return std::string(enum_name(value));
  } else if constexpr (OwnText<T>) {
    return value.text();
  } else {
    return fmt::format("{}", value);
  }
}

template <typename T>
constexpr OptionKind option_kind() {
  if (std::is_same_v<T, bool>) return OptionKind::kBoolean;
  if (std::is_enum_v<T>) return OptionKind::kChoice;
  return OwnText<T> ? OptionKind::kOwnText : OptionKind::kNumber;
}
}  // namespace detail

/// Checks every field against its range. NaN is refused. "--particle-count: 0 is not in [1,
/// 1000000]"
/// @errors kInvalidOptions.
template <typename Options>
[[nodiscard]] Result<void> validate(const Options& options) {
  Result<void> outcome;
  visit_fields(options, [&](const auto& value, const Field& field) {
    using T = std::decay_t<decltype(value)>;
    if constexpr (OwnText<T>) {
      if (const auto valid = value.check(); outcome && !valid) {
        outcome = forward_error(valid, fmt::format("--{}", field.name));
      }
    } else if constexpr (!std::is_same_v<T, bool> && !std::is_enum_v<T>) {
      if (outcome) outcome = detail::check_range(field, static_cast<double>(value));
    }
  });
  return outcome;
}

/// All options as text, in the order of the list.
template <typename Options>
[[nodiscard]] std::vector<OptionText> option_texts(const Options& options) {
  std::vector<OptionText> texts;
  visit_fields(options, [&](const auto& value, const Field& field) {
    using T = std::decay_t<decltype(value)>;
    std::string range;
    if constexpr (std::is_enum_v<T>) {
      range = detail::choices_text(EnumNames<T>::kNames.data(), EnumNames<T>::kNames.size());
    } else if constexpr (OwnText<T>) {
      range = T::kForm;
    } else if constexpr (!std::is_same_v<T, bool>) {
      range = detail::range_text(field);
    }
    texts.push_back({std::string(field.name), detail::value_text(value), std::string(field.unit),
                     std::string(field.help), std::move(range), detail::option_kind<T>()});
  });
  return texts;
}

/// Sets one option from text, as a command line or a recipe gives it; the range is checked too.
/// @errors kInvalidOptions: no such option (names the nearest), or the text is not a value of its
/// type or range.
template <typename Options>
[[nodiscard]] Result<void> set_option(Options& options,
                                      std::string_view name,
                                      std::string_view text) {
  bool is_known = false;
  Result<void> outcome;
  std::vector<std::string> names;
  visit_fields(options, [&](auto& value, const Field& field) {
    names.emplace_back(field.name);
    if (field.name != name) return;
    is_known = true;
    outcome = detail::parse_into(value, field, text);
  });
  if (is_known) return outcome;
  const std::string nearest = nearest_word(name, names);
  return fail(ErrorCode::kInvalidOptions, "{}: no such option{}", name,
              nearest.empty() ? std::string() : fmt::format(" (did you mean {}?)", nearest));
}

}  // namespace nadir
