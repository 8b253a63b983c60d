// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace nadir {

/// A table of a TOML file (map.toml, flight.toml, routes, remaps, recipes) whose getters fail with
/// one clear sentence: "loop.toml: route.speed_mps is not a number". Keys may be dotted
/// ("camera.fx"). Numbers that are NaN or infinite are refused.
class Settings {
 public:
  /// @errors kNotFound, kIo, kMalformed (with line and column).
  [[nodiscard]] static Result<Settings> read(const std::filesystem::path& path);
  /// Parses text; `name` stands for the file in messages.
  [[nodiscard]] static Result<Settings> parse(std::string_view text, const std::string& name);

  /// File name and, inside a nested table, where in it: "flight.toml: camera".
  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] bool has(std::string_view dotted_key) const;
  [[nodiscard]] std::vector<std::string> keys() const;  ///< Of this table alone, sorted.

  /// A misspelt key that is passed over in silence is a setting that nobody notices is missing.
  /// @errors kMalformed: "loop.toml: sped_mps is no known key (did you mean speed_mps?)".
  [[nodiscard]] Result<void> refuse_unknown(const std::vector<std::string>& known) const;

  /// Each fails with kMalformed where the key is missing or of another type.
  [[nodiscard]] Result<double> number(std::string_view dotted_key) const;
  [[nodiscard]] Result<std::int64_t> integer(std::string_view dotted_key) const;
  [[nodiscard]] Result<bool> boolean(std::string_view dotted_key) const;
  [[nodiscard]] Result<std::string> text(std::string_view dotted_key) const;
  [[nodiscard]] Result<std::vector<double>> numbers(std::string_view dotted_key) const;
  [[nodiscard]] Result<std::vector<std::string>> texts(std::string_view dotted_key) const;
  [[nodiscard]] Result<Settings> table(std::string_view dotted_key) const;
  [[nodiscard]] Result<std::vector<Settings>> tables(std::string_view dotted_key) const;

  /// The fallback where the key is missing, but still an error where it has another type.
  [[nodiscard]] Result<double> number_or(std::string_view dotted_key, double fallback) const;
  [[nodiscard]] Result<std::string> text_or(std::string_view dotted_key,
                                            std::string fallback) const;

  /// A scalar of any type as text, the way it would be typed on a command line: "0.5", "true",
  /// "default".
  [[nodiscard]] Result<std::string> scalar_as_text(std::string_view dotted_key) const;

 private:
  struct Node;
  Settings(std::shared_ptr<const Node> node, std::string name)
      : node_(std::move(node)), name_(std::move(name)) {}

  std::shared_ptr<const Node> node_;
  std::string name_;
};

/// A TOML basic string with quotes and escapes. Text may be any bytes, as names of files are: those that are no UTF-8 are
/// written as utf8_of_bytes() has them, and what reads texts gives the same bytes again.
[[nodiscard]] std::string toml_quoted(std::string_view text);

/// The nearest of `known` to a misspelt `word` by edit distance, or empty where none is near.
[[nodiscard]] std::string nearest_word(std::string_view word,
                                       const std::vector<std::string>& known);

}  // namespace nadir
