// SPDX-License-Identifier: Apache-2.0
// From words to an action.
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <utility>

#include "core/base/settings.h"
#include "core/session/action.h"
#include "core/session/action_form.h"

namespace nadir {
namespace {

using detail::ArgumentType;
using detail::first_word;
using detail::form_arguments;
using detail::FormArgument;
using detail::is_blank;
using detail::without_blanks;

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

Result<std::size_t> place_in_choice(const ArgumentReader& reader,
                                    std::string_view word,
                                    std::span<const std::string_view> names) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i] == word) return i;
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
    const auto place = place_in_choice(reader, word, EnumNames<T>::kNames);
    if (!place) return forward_error(place);
    into = static_cast<T>(*place);
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

template <typename T>
inline constexpr bool kIsList = std::is_same_v<T, PlaceList> || std::is_same_v<T, NumberList>;

/// One of a list's things.
Result<void> read_item(const ArgumentReader& reader, std::string_view word, PlaceList& into) {
  const std::size_t comma = word.find(',');
  const auto east_m = number_from<double>(word.substr(0, comma));
  const auto north_m =
      comma == std::string_view::npos ? std::nullopt : number_from<double>(word.substr(comma + 1));
  if (!east_m || !north_m || !std::isfinite(*east_m) || !std::isfinite(*north_m)) {
    return reader.wrong(word, fmt::format("'{}' is no place: write EAST,NORTH", word));
  }
  into.in_enu_m.emplace_back(*east_m, *north_m);
  return {};
}

Result<void> read_item(const ArgumentReader& reader, std::string_view word, NumberList& into) {
  const auto number = number_from<std::int64_t>(word);
  if (!number) return reader.wrong(word, fmt::format("'{}' is not a whole number", word));
  into.numbers.push_back(*number);
  return {};
}

/// All that is left of a line, which may be nothing.
template <typename List>
Result<void> read_list(ArgumentReader& reader,
                       const FormArgument& /*argument*/,
                       bool /*is_last*/,
                       bool& /*was_given*/,
                       void* field) {
  List& into = *static_cast<List*>(field);
  into = {};
  reader.rest = without_blanks(reader.rest);
  for (; !reader.rest.empty(); reader.rest = without_blanks(reader.rest)) {
    const std::string_view word = first_word(reader.rest);
    if (auto read = read_item(reader, word, into); !read) return read;
    reader.rest.remove_prefix(word.size());
  }
  return {};
}

/// @param was_given  Of the argument before, for a group that is not whole.
template <typename T>
Result<void> read_argument(ArgumentReader& reader,
                           const FormArgument& argument,
                           bool is_last,
                           bool& was_given,
                           void* field) {
  using Value = typename ArgumentType<T>::Value;
  T& into = *static_cast<T*>(field);
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

/// How a field of an action is read.
template <typename T>
constexpr auto reader_of() {
  if constexpr (kIsList<T>) {
    return &read_list<T>;
  } else {
    return &read_argument<T>;
  }
}

/// One field of an action, whatever its type: a hundred actions are then compiled as a few types of fields.
struct FieldToRead {
  void* field;
  Result<void> (*read)(ArgumentReader&, const FormArgument&, bool, bool&, void*);
};

Result<void> read_fields(std::string_view form,
                         std::string_view rest,
                         const std::vector<FieldToRead>& fields) {
  const std::vector<FormArgument> arguments = form_arguments(form);
  ArgumentReader reader{first_word(form), form, rest};
  bool was_given = true;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const bool is_last = i + 1 == arguments.size();
    auto read = fields[i].read(reader, arguments.at(i), is_last, was_given, fields[i].field);
    if (!read) return read;
  }
  reader.rest = without_blanks(reader.rest);
  if (reader.rest.empty()) return {};
  return reader.wrong("", fmt::format("'{}' is too much", reader.rest));
}

template <typename A>
Result<void> read_action(std::string_view rest, Action& into) {
  return std::apply(
      [rest](auto&... fields) {
        return read_fields(
            A::kForm, rest,
            {FieldToRead{&fields, reader_of<std::remove_reference_t<decltype(fields)>>()}...});
      },
      into.emplace<A>().fields());
}

/// What there is to know about one kind of action.
struct ActionKind {
  ActionHelp help;
  Result<void> (*read)(std::string_view rest, Action& into);
};

template <std::size_t... I>
std::vector<ActionKind> all_kinds(std::index_sequence<I...> /*all*/) {
  return {ActionKind{{first_word(std::variant_alternative_t<I, AnyAction>::kForm),
                      std::variant_alternative_t<I, AnyAction>::kForm,
                      std::variant_alternative_t<I, AnyAction>::kHelp},
                     read_action<std::variant_alternative_t<I, AnyAction>>}...};
}

const std::vector<ActionKind>& action_kinds() {
  static const std::vector<ActionKind> kinds =
      all_kinds(std::make_index_sequence<std::variant_size_v<AnyAction>>());
  return kinds;
}

}  // namespace

Result<Action> parse_action(std::string_view text) {
  text = without_blanks(text);
  const std::string_view name = first_word(text);
  if (name.empty()) return fail(ErrorCode::kInvalidOptions, "no action is named");
  std::vector<std::string> names;
  for (const ActionKind& kind : action_kinds()) {
    if (kind.help.name == name) {
      Action action;
      const auto read = kind.read(text.substr(name.size()), action);
      return read ? Result<Action>(std::move(action)) : forward_error(read);
    }
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
