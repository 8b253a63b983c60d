// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>
#include <vector>

/// How an action's form is written, "seek SECONDS": shared by what reads and what writes its words.
namespace nadir::detail {

template <typename T>
struct ArgumentType {
  using Value = T;
  static constexpr bool kIsOptional = false;
};
template <typename T>
struct ArgumentType<std::optional<T>> {
  using Value = T;
  static constexpr bool kIsOptional = true;
};

[[nodiscard]] bool is_blank(char letter);
[[nodiscard]] std::string_view without_blanks(std::string_view text);
/// Up to the first blank.
[[nodiscard]] std::string_view first_word(std::string_view text);

/// One argument of a form: "[FROM TO]" are two that come together or not at all.
struct FormArgument {
  std::string_view name;  ///< "SECONDS", "{on|off|toggle}".
  bool begins_group = false;
};
[[nodiscard]] std::vector<FormArgument> form_arguments(std::string_view form);

}  // namespace nadir::detail
