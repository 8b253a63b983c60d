// SPDX-License-Identifier: Apache-2.0
#include "core/base/measures.h"

#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <span>
#include <string>
#include <utility>

namespace nadir {
namespace {

struct MeasureUnit {
  std::string_view name;
  double factor;
};
constexpr std::array<MeasureUnit, 8> kLengthUnits{{{"", 1.0},
                                                   {"m", 1.0},
                                                   {"km", 1000.0},
                                                   {"cm", 0.01},
                                                   {"mm", 0.001},
                                                   {"ft", 0.3048},
                                                   {"in", 0.0254},
                                                   {"yd", 0.9144}}};
constexpr double kDegree = std::numbers::pi / 180.0;
constexpr std::array<MeasureUnit, 5> kAngleUnits{{{"", kDegree},
                                                  {"deg", kDegree},
                                                  {"\u00B0", kDegree},
                                                  {"rad", 1.0},
                                                  {"gon", std::numbers::pi / 200.0}}};

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kSpaces = " \t\r\n";
  const std::size_t begin = text.find_first_not_of(kSpaces);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kSpaces) - begin + 1);
}

std::string unit_names(std::span<const MeasureUnit> units) {
  std::string names;
  for (const MeasureUnit& unit : units) {
    if (unit.name.empty()) continue;
    names += names.empty() ? "" : ", ";
    names += unit.name;
  }
  return names;
}

Result<double> parse_measure(std::string_view typed,
                             const char* what,
                             std::span<const MeasureUnit> units) {
  const std::string_view text = trimmed(typed);
  const auto is_none = [&](const std::string& why) {
    return fail(ErrorCode::kInvalidOptions, "{}: is no {} ({})", text, what, why);
  };
  if (text.empty()) return fail(ErrorCode::kInvalidOptions, "nothing was typed for the {}", what);
  // As people write it, which std::from_chars does not take.
  const bool has_plus = text.size() > 1 && text[0] == '+' && text[1] != '-' && text[1] != '+';
  const char* const begin = text.data() + (has_plus ? 1 : 0);
  const char* const end = text.data() + text.size();
  double number = 0.0;
  const auto [rest, error] = std::from_chars(begin, end, number);
  if (error == std::errc::result_out_of_range)
    return is_none("the number is too large or too small");
  if (error != std::errc() || !std::isfinite(number)) return is_none("it begins with no number");
  const std::string_view unit = trimmed({rest, static_cast<std::size_t>(end - rest)});
  if (!unit.empty() && unit.front() == ',') return is_none("decimals come after a point");
  for (const MeasureUnit& known : units) {
    if (known.name != unit) continue;
    const double value = number * known.factor;
    if (!std::isfinite(value)) return is_none("the number is too large or too small");
    return value;
  }
  return is_none(fmt::format("{} is none of {}", unit, unit_names(units)));
}

}  // namespace

Result<double> parse_length_m(std::string_view text) {
  return parse_measure(text, "length", kLengthUnits);
}

Result<Angle> parse_angle(std::string_view text) {
  const auto radians = parse_measure(text, "angle", kAngleUnits);
  if (!radians) return forward_error(radians);
  return Angle::radians(*radians);
}

}  // namespace nadir
