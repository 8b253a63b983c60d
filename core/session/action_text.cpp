// SPDX-License-Identifier: Apache-2.0
// From an action to its words.
#include <type_traits>

#include "core/base/field.h"
#include "core/session/action.h"
#include "core/session/action_form.h"

namespace nadir {
namespace detail {

bool is_blank(char letter) { return letter == ' ' || letter == '\t' || letter == '\n'; }

std::string_view without_blanks(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

std::string_view first_word(std::string_view text) {
  std::size_t end = 0;
  while (end < text.size() && !is_blank(text[end])) ++end;
  return text.substr(0, end);
}

std::vector<FormArgument> form_arguments(std::string_view form) {
  std::vector<FormArgument> arguments;
  form.remove_prefix(first_word(form).size());
  for (form = without_blanks(form); !form.empty(); form = without_blanks(form)) {
    std::string_view word = first_word(form);
    form.remove_prefix(word.size());
    const bool begins_group = word.front() == '[';
    if (begins_group) word.remove_prefix(1);
    if (word.back() == ']') word.remove_suffix(1);
    arguments.push_back({word, begins_group});
  }
  return arguments;
}

}  // namespace detail

namespace {

using detail::is_blank;

bool needs_quotes(std::string_view text) {
  if (text.empty() || text.front() == '"') return true;
  for (const char letter : text) {
    if (is_blank(letter) || static_cast<unsigned char>(letter) < 0x20U) return true;
  }
  return false;
}

std::string quoted_argument(std::string_view text) {
  if (!needs_quotes(text)) return std::string(text);
  std::string quoted = "\"";
  for (const char letter : text) {
    if (letter == '\n') {
      quoted += "\\n";
      continue;
    }
    if (letter == '"' || letter == '\\') quoted += '\\';
    quoted += letter;
  }
  return quoted + '"';
}

template <typename T>
std::string argument_text(const T& value) {
  if constexpr (std::is_enum_v<T>) {
    return std::string(enum_name(value));
  } else if constexpr (std::is_same_v<T, std::string>) {
    return quoted_argument(value);
  } else {
    return fmt::format("{}", value);
  }
}

void append_list(std::string& text, const PlaceList& list) {
  for (const Eigen::Vector2d& place : list.in_enu_m) {
    text += fmt::format(" {},{}", place.x(), place.y());
  }
}

void append_list(std::string& text, const NumberList& list) {
  for (const std::int64_t number : list.numbers) text += fmt::format(" {}", number);
}

template <typename T>
void append_argument(std::string& text, const void* field) {
  const T& value = *static_cast<const T*>(field);
  if constexpr (std::is_same_v<T, PlaceList> || std::is_same_v<T, NumberList>) {
    append_list(text, value);
  } else if constexpr (detail::ArgumentType<T>::kIsOptional) {
    if (value) text += " " + argument_text(*value);
  } else {
    text += " " + argument_text(value);
  }
}

/// One field of an action, whatever its type: a hundred actions are then compiled as a few types of fields.
struct FieldToWrite {
  const void* field;
  void (*append)(std::string&, const void*);
};

std::string fields_text(std::string_view form, const std::vector<FieldToWrite>& fields) {
  std::string text(detail::first_word(form));
  for (const FieldToWrite& field : fields) field.append(text, field.field);
  return text;
}

}  // namespace

std::string action_text(const Action& action) {
  return std::visit(
      [](const auto& one) {
        return std::apply(
            [](const auto&... fields) {
              using A = std::decay_t<decltype(one)>;
              return fields_text(
                  A::kForm,
                  {FieldToWrite{&fields, append_argument<std::decay_t<decltype(fields)>>}...});
            },
            one.fields());
      },
      action);
}

}  // namespace nadir
