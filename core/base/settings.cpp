// SPDX-License-Identifier: Apache-2.0
#include "core/base/settings.h"

#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <type_traits>

#include "core/base/staged_output.h"
#include "core/base/utf8.h"

namespace nadir {

struct Settings::Node {
  toml::table table;
};

namespace {

constexpr std::uintmax_t kMaxBytes = 16U << 20U;

std::string at_line(const toml::node& node) {
  const auto line = node.source().begin.line;
  return line > 0 ? fmt::format(" (line {})", line) : std::string();
}

/// A value of just this type; a whole number is a number too. The conversions of toml++ itself
/// would take 1 for true, and casting 1e73 to an integer is undefined.
template <typename T, typename TomlNode>
std::optional<T> exact_value(const TomlNode& node) {
  if constexpr (std::is_same_v<T, double>) {
    if (const auto whole = node.template value_exact<std::int64_t>()) {
      return static_cast<double>(*whole);
    }
  }
  if constexpr (std::is_same_v<T, std::string>) {
    const auto text = node.template value_exact<std::string>();
    return text ? std::optional(bytes_of_utf8(*text)) : std::nullopt;
  } else {
    return node.template value_exact<T>();
  }
}

template <typename T>
Result<T> value_at(const toml::table& table,
                   std::string_view key,
                   const std::string& name,
                   std::string_view kind) {
  const auto node = table.at_path(key);
  if (!node) return fail(ErrorCode::kMalformed, "{}: {} is missing", name, key);
  const std::optional<T> value = exact_value<T>(node);
  if (!value) {
    return fail(ErrorCode::kMalformed, "{}: {} is not {}{}", name, key, kind,
                at_line(*node.node()));
  }
  return *value;
}

template <typename T>
Result<std::vector<T>> values_at(const toml::table& table,
                                 std::string_view key,
                                 const std::string& name,
                                 std::string_view kind) {
  const auto node = table.at_path(key);
  if (!node) return fail(ErrorCode::kMalformed, "{}: {} is missing", name, key);
  const toml::array* array = node.as_array();
  std::vector<T> values;
  if (array != nullptr) {
    for (const toml::node& element : *array) {
      const std::optional<T> value = exact_value<T>(element);
      if (!value) break;
      values.push_back(*value);
    }
  }
  if (array == nullptr || values.size() != array->size()) {
    return fail(ErrorCode::kMalformed, "{}: {} is not a list of {}{}", name, key, kind,
                at_line(*node.node()));
  }
  return values;
}

}  // namespace

Result<Settings> Settings::read(const std::filesystem::path& path) {
  const auto text = read_text_file(path, kMaxBytes);
  if (!text) return forward_error(text);
  return parse(*text, path.string());
}

Result<Settings> Settings::parse(std::string_view text, const std::string& name) {
  try {
    return Settings(std::make_shared<const Node>(Node{toml::parse(text)}), name);
  } catch (const toml::parse_error& error) {
    return fail(ErrorCode::kMalformed, "{}: line {}, column {}: {}", name,
                error.source().begin.line, error.source().begin.column, error.description());
  }
}

bool Settings::has(std::string_view key) const {
  return static_cast<bool>(node_->table.at_path(key));
}

std::vector<std::string> Settings::keys() const {
  std::vector<std::string> names;
  for (const auto& [key, value] : node_->table) names.emplace_back(key.str());
  std::sort(names.begin(), names.end());
  return names;
}

Result<void> Settings::refuse_unknown(const std::vector<std::string>& known) const {
  for (const std::string& key : keys()) {
    if (std::find(known.begin(), known.end(), key) != known.end()) continue;
    const std::string nearest = nearest_word(key, known);
    return fail(ErrorCode::kMalformed, "{}: {} is no known key{}", name_, key,
                nearest.empty() ? std::string() : fmt::format(" (did you mean {}?)", nearest));
  }
  return {};
}

Result<double> Settings::number(std::string_view key) const {
  auto value = value_at<double>(node_->table, key, name_, "a number");
  if (value && !std::isfinite(*value)) {
    return fail(ErrorCode::kMalformed, "{}: {} is {}, not a finite number", name_, key, *value);
  }
  return value;
}

Result<std::int64_t> Settings::integer(std::string_view key) const {
  return value_at<std::int64_t>(node_->table, key, name_, "a whole number");
}

Result<bool> Settings::boolean(std::string_view key) const {
  return value_at<bool>(node_->table, key, name_, "true or false");
}

Result<std::string> Settings::text(std::string_view key) const {
  return value_at<std::string>(node_->table, key, name_, "a text in quotes");
}

Result<std::vector<double>> Settings::numbers(std::string_view key) const {
  auto values = values_at<double>(node_->table, key, name_, "numbers");
  if (values &&
      !std::all_of(values->begin(), values->end(), [](double v) { return std::isfinite(v); })) {
    return fail(ErrorCode::kMalformed, "{}: {} holds a number that is not finite", name_, key);
  }
  return values;
}

Result<std::vector<std::string>> Settings::texts(std::string_view key) const {
  return values_at<std::string>(node_->table, key, name_, "texts in quotes");
}

Result<Settings> Settings::table(std::string_view key) const {
  const auto node = node_->table.at_path(key);
  const std::string where = fmt::format("{}: {}", name_, key);
  if (!node) return fail(ErrorCode::kMalformed, "{} is missing", where);
  if (!node.is_table()) return fail(ErrorCode::kMalformed, "{} is not a table", where);
  return Settings(std::make_shared<const Node>(Node{*node.as_table()}), where);
}

Result<std::vector<Settings>> Settings::tables(std::string_view key) const {
  const auto node = node_->table.at_path(key);
  if (!node) return fail(ErrorCode::kMalformed, "{}: {} is missing", name_, key);
  const toml::array* array = node.as_array();
  std::vector<Settings> result;
  if (array != nullptr) {
    for (const toml::node& element : *array) {
      if (!element.is_table()) break;
      result.push_back(Settings(std::make_shared<const Node>(Node{*element.as_table()}),
                                fmt::format("{}: {}[{}]", name_, key, result.size())));
    }
  }
  if (array == nullptr || result.size() != array->size()) {
    return fail(ErrorCode::kMalformed, "{}: {} is not a list of tables", name_, key);
  }
  return result;
}

Result<double> Settings::number_or(std::string_view key, double fallback) const {
  return has(key) ? number(key) : Result<double>(fallback);
}

Result<std::string> Settings::text_or(std::string_view key, std::string fallback) const {
  return has(key) ? text(key) : Result<std::string>(std::move(fallback));
}

Result<std::string> Settings::scalar_as_text(std::string_view key) const {
  const auto node = node_->table.at_path(key);
  if (!node) return fail(ErrorCode::kMalformed, "{}: {} is missing", name_, key);
  if (node.is_string()) return bytes_of_utf8(*node.value<std::string>());
  if (node.is_boolean()) return std::string(*node.value<bool>() ? "true" : "false");
  if (node.is_integer()) return fmt::format("{}", *node.value<std::int64_t>());
  if (node.is_floating_point()) return fmt::format("{}", *node.value<double>());
  return fail(ErrorCode::kMalformed, "{}: {} is not a single value", name_, key);
}

std::string toml_quoted(std::string_view text) {
  const std::string whole = utf8_of_bytes(text);
  std::string quoted = "\"";
  for (std::size_t i = 0; i < whole.size(); ++i) {
    const char letter = whole[i];
    if (whole.compare(i, kByteMark.size(), kByteMark) == 0) {
      quoted += "\\uFFFF";  // which an editor shows
      i += kByteMark.size() - 1;
    } else if (letter == '"' || letter == '\\') {
      quoted += '\\';
      quoted += letter;
    } else if (static_cast<unsigned char>(letter) < 0x20U || letter == 0x7F) {
      quoted += fmt::format("\\u{:04X}", static_cast<unsigned>(letter));
    } else {
      quoted += letter;
    }
  }
  return quoted + '"';
}

std::string nearest_word(std::string_view word, const std::vector<std::string>& known) {
  std::string nearest;
  std::size_t nearest_distance = std::max<std::size_t>(1, (word.size() + 1) / 3) + 1;
  for (const std::string& candidate : known) {
    // Optimal string alignment: Levenshtein's edits, and two letters that have changed places.
    const std::size_t width = candidate.size() + 1;
    std::vector<std::size_t> distance((word.size() + 1) * width);
    const auto at = [&](std::size_t i, std::size_t j) -> std::size_t& {
      return distance[i * width + j];
    };
    for (std::size_t i = 0; i <= word.size(); ++i) {
      for (std::size_t j = 0; j < width; ++j) {
        if (i == 0 || j == 0) {
          at(i, j) = i + j;
          continue;
        }
        const std::size_t replaced = at(i - 1, j - 1) + (word[i - 1] == candidate[j - 1] ? 0 : 1);
        at(i, j) = std::min({replaced, at(i - 1, j) + 1, at(i, j - 1) + 1});
        const bool is_swapped =
            i > 1 && j > 1 && word[i - 1] == candidate[j - 2] && word[i - 2] == candidate[j - 1];
        if (is_swapped) at(i, j) = std::min(at(i, j), at(i - 2, j - 2) + 1);
      }
    }
    // A word that was not written to its end is near.
    const bool is_begun = word.size() > 2 && candidate.compare(0, word.size(), word) == 0;
    const std::size_t found = is_begun ? 1 : distance.back();
    if (found < nearest_distance) {
      nearest_distance = found;
      nearest = candidate;
    }
  }
  return nearest;
}

}  // namespace nadir
