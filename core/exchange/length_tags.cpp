// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include "core/exchange/import_rules.h"

namespace nadir {
namespace {

/// The number that a text begins with, which is taken off it.
std::optional<double> take_number(std::string_view& text) {
  double value = 0.0;
  const auto [end, error] =
      std::from_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed);
  if (error != std::errc()) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return value;
}

std::string_view without_spaces(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

/// Feet, and inches where there are any: what follows the feet of 12'6".
std::optional<double> with_inches(double feet, std::string_view inches) {
  constexpr double kFootM = 0.3048;
  inches = without_spaces(inches);
  if (inches.empty()) return feet * kFootM;
  const auto number = take_number(inches);
  if (!number || (inches != "\"" && inches != "''" && inches != "in")) return std::nullopt;
  return (feet + *number / 12.0) * kFootM;
}

std::optional<double> any_metres(std::string_view text) {
  std::string with_point(without_spaces(text));
  if (std::count(with_point.begin(), with_point.end(), ',') == 1) {
    std::replace(with_point.begin(), with_point.end(), ',', '.');
  }
  std::string_view rest = with_point;
  const auto number = take_number(rest);
  if (!number) return std::nullopt;
  const std::string_view unit = without_spaces(rest);
  if (!unit.empty() && unit.front() == '\'') return with_inches(*number, unit.substr(1));
  if (unit.rfind("ft", 0) == 0) return with_inches(*number, unit.substr(2));
  constexpr std::array<std::pair<std::string_view, double>, 9> kUnits{{{"", 1.0},
                                                                       {"m", 1.0},
                                                                       {"metre", 1.0},
                                                                       {"metres", 1.0},
                                                                       {"cm", 0.01},
                                                                       {"mm", 0.001},
                                                                       {"km", 1000.0},
                                                                       {"mi", 1609.344},
                                                                       {"feet", 0.3048}}};
  for (const auto& [name, metres] : kUnits) {
    if (unit == name) return *number * metres;
  }
  return std::nullopt;
}

}  // namespace

std::optional<double> metres_from_tag(std::string_view text) {
  const auto metres = any_metres(text);
  if (metres && *metres > 0.0 && *metres <= kMostObjectWidthM) return metres;
  return std::nullopt;
}

}  // namespace nadir
