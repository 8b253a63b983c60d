// SPDX-License-Identifier: Apache-2.0
#include <charconv>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>

#include "core/base/settings.h"
#include "core/session/action.h"

namespace nadir {
namespace {

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

/// One argument of a form: "[FROM TO]" are two that come together or not at all.
struct FormArgument {
  std::string_view name;  ///< "SECONDS", "{on|off|toggle}".
  bool begins_group = false;
};

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

// ---- From an action to its words.

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

template <typename T>
void append_argument(std::string& text, const T& value) {
  if constexpr (ArgumentType<T>::kIsOptional) {
    if (value) text += " " + argument_text(*value);
  } else {
    text += " " + argument_text(value);
  }
}

// ---- From words to an action.

/// What is left of a line, and how to complain about it.
struct ArgumentReader {
  std::string_view name, form;
  std::string_view rest;

  [[nodiscard]] tl::unexpected<Error> wrong(std::string_view given, const std::string& why) const {
    const std::string what = given.empty() ? std::string(name) : fmt::format("{} {}", name, given);
    return fail(ErrorCode::kInvalidOptions, "{}: {} ({})", what, why, form);
  }

  /// The next word, or what stands in quotes. @param is_last  Without quotes all that is left is one text.
  Result<std::string> next(bool is_last_text, std::string_view argument) {
    rest = without_blanks(rest);
    if (rest.empty() || rest.front() != '"') {
      const std::string_view word = is_last_text ? rest : first_word(rest);
      rest.remove_prefix(word.size());
      return std::string(word);
    }
    std::string text;
    for (std::size_t i = 1; i < rest.size(); ++i) {
      char letter = rest[i];
      if (letter == '"') {
        rest.remove_prefix(i + 1);
        if (!rest.empty() && !is_blank(rest.front())) {
          return wrong(rest, fmt::format("{} goes on after its quotes", argument));
        }
        return text;
      }
      if (letter == '\\' && i + 1 < rest.size()) {
        letter = rest[++i];
        if (letter == 'n') letter = '\n';
      }
      text += letter;
    }
    return wrong(rest, fmt::format("the quotes of {} do not end", argument));
  }
};

template <typename Number>
std::optional<Number> number_from(std::string_view word) {
  Number value{};
  const char* const end = word.data() + word.size();
  const auto [at, error] = std::from_chars(word.data(), end, value);
  if (word.empty() || error != std::errc() || at != end) return std::nullopt;
  return value;
}

template <typename Enum>
Result<void> read_choice(const ArgumentReader& reader, std::string_view word, Enum& into) {
  const auto& names = EnumNames<Enum>::kNames;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i] != word) continue;
    into = static_cast<Enum>(i);
    return {};
  }
  const std::string nearest = nearest_word(word, {names.begin(), names.end()});
  std::string list;
  for (const std::string_view name : names) list += (list.empty() ? "" : ", ") + std::string(name);
  return reader.wrong(
      word, fmt::format("'{}' is none of {}{}", word, list,
                        nearest.empty() ? "" : fmt::format("; did you mean {}?", nearest)));
}

template <typename T>
Result<void> read_value(const ArgumentReader& reader,
                        const FormArgument& argument,
                        std::string word,
                        T& into) {
  if constexpr (std::is_same_v<T, std::string>) {
    into = std::move(word);
  } else if constexpr (std::is_enum_v<T>) {
    return read_choice(reader, word, into);
  } else if constexpr (std::is_integral_v<T>) {
    const auto value = number_from<T>(word);
    if (!value) {
      return reader.wrong(word, fmt::format("{} is not a whole number", argument.name));
    }
    into = *value;
  } else {
    const auto value = number_from<T>(word);
    if (!value || !std::isfinite(*value)) {
      return reader.wrong(word, fmt::format("{} is not a number", argument.name));
    }
    into = *value;
  }
  return {};
}

/// @param was_given  Of the argument before, for a group that is not whole.
template <typename T>
Result<void> read_argument(
    ArgumentReader& reader, const FormArgument& argument, bool is_last, bool& was_given, T& into) {
  using Value = typename ArgumentType<T>::Value;
  reader.rest = without_blanks(reader.rest);
  const bool had_one_before = was_given;
  was_given = !reader.rest.empty();
  if (!was_given) {
    const bool is_group_whole = argument.begins_group || !had_one_before;
    if (ArgumentType<T>::kIsOptional && is_group_whole) return {};
    if (std::is_same_v<Value, Switch>) return {};  // which then toggles
    return reader.wrong("", fmt::format("{} is missing", argument.name));
  }
  auto word = reader.next(is_last && std::is_same_v<Value, std::string>, argument.name);
  if (!word) return forward_error(word);
  if constexpr (ArgumentType<T>::kIsOptional) {
    return read_value(reader, argument, std::move(*word), into.emplace());
  } else {
    return read_value(reader, argument, std::move(*word), into);
  }
}

template <typename A>
Result<Action> read_action(std::string_view rest) {
  A action;
  const std::vector<FormArgument> arguments = form_arguments(A::kForm);
  ArgumentReader reader{first_word(A::kForm), A::kForm, rest};
  Result<void> outcome;
  std::apply(
      [&](auto&... fields) {
        std::size_t i = 0;
        bool was_given = true;
        ((outcome = outcome ? read_argument(reader, arguments.at(i), i + 1 == arguments.size(),
                                            was_given, fields)
                            : outcome,
          ++i),
         ...);
        static_cast<void>(i);
        static_cast<void>(was_given);
      },
      action.fields());
  if (!outcome) return forward_error(outcome);
  reader.rest = without_blanks(reader.rest);
  if (!reader.rest.empty()) {
    return reader.wrong("", fmt::format("'{}' is too much", reader.rest));
  }
  return Action(std::move(action));
}

/// What there is to know about one kind of action.
struct ActionKind {
  ActionHelp help;
  Result<Action> (*read)(std::string_view rest);
};

template <std::size_t... I>
std::vector<ActionKind> all_kinds(std::index_sequence<I...> /*all*/) {
  return {ActionKind{
      {first_word(std::variant_alternative_t<I, Action>::kForm),
       std::variant_alternative_t<I, Action>::kForm, std::variant_alternative_t<I, Action>::kHelp},
      read_action<std::variant_alternative_t<I, Action>>}...};
}

const std::vector<ActionKind>& action_kinds() {
  static const std::vector<ActionKind> kinds =
      all_kinds(std::make_index_sequence<std::variant_size_v<Action>>());
  return kinds;
}

}  // namespace

std::string action_text(const Action& action) {
  return std::visit(
      [](const auto& one) {
        std::string text(first_word(one.kForm));
        std::apply([&text](const auto&... fields) { (append_argument(text, fields), ...); },
                   one.fields());
        return text;
      },
      action);
}

Result<Action> parse_action(std::string_view text) {
  text = without_blanks(text);
  const std::string_view name = first_word(text);
  if (name.empty()) return fail(ErrorCode::kInvalidOptions, "no action is named");
  std::vector<std::string> names;
  for (const ActionKind& kind : action_kinds()) {
    if (kind.help.name == name) return kind.read(text.substr(name.size()));
    names.emplace_back(kind.help.name);
  }
  const std::string nearest = nearest_word(name, names);
  return fail(ErrorCode::kInvalidOptions, "{}: no such action{}", name,
              nearest.empty() ? std::string() : fmt::format(" (did you mean {}?)", nearest));
}

std::vector<ActionHelp> action_helps() {
  std::vector<ActionHelp> helps;
  for (const ActionKind& kind : action_kinds()) helps.push_back(kind.help);
  return helps;
}

std::string_view action_name(const Action& action) {
  return action_kinds()[action.index()].help.name;
}

}  // namespace nadir
