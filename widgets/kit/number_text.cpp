// SPDX-License-Identifier: Apache-2.0
#include "widgets/kit/number_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace nadir::kit {

std::string digits_text(double value, const NumberOptions& options) {
  if (std::isnan(value)) return "–";
  const double scale = std::pow(10.0, options.decimals);
  const double shown = std::abs(value) < 0.5 / scale ? 0.0 : value;
  return fmt::format("{:.{}f}", shown, options.decimals);
}

double kept_digits(double value, const NumberOptions& options) {
  const double scale = std::pow(10.0, options.decimals);
  const double rounded = std::abs(value) < 1e15 / scale ? std::round(value * scale) / scale : value;
  return std::clamp(rounded + 0.0, options.least, options.most);
}

std::optional<double> read_number(const std::string& text, const NumberOptions& options) {
  std::string digits = text;
  std::replace(digits.begin(), digits.end(), ',', '.');
  const std::size_t first = digits.find_first_not_of(" +");
  if (first == std::string::npos) return std::nullopt;
  double value = 0.0;
  const char* const begin = digits.data() + first;
  const auto [end, error] = std::from_chars(begin, digits.data() + digits.size(), value);
  if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
  std::string rest(end, static_cast<const char*>(digits.data() + digits.size()));
  rest.erase(0, std::min(rest.size(), rest.find_first_not_of(' ')));
  while (!rest.empty() && rest.back() == ' ') rest.pop_back();
  if (!rest.empty() && rest != options.unit) return std::nullopt;
  return std::clamp(value, options.least, options.most);
}

std::optional<double> read_number_within(const std::string& text, const NumberOptions& options) {
  NumberOptions open = options;
  open.least = -std::numeric_limits<double>::infinity();
  open.most = std::numeric_limits<double>::infinity();
  const auto value = read_number(text, open);
  if (!value || *value < options.least || *value > options.most) return std::nullopt;
  return value;
}

std::string number_complaint(const std::string& text, const NumberOptions& options) {
  if (text.find_first_not_of(" +-.,") == std::string::npos) return {};
  NumberOptions unbounded = options;
  unbounded.least = -std::numeric_limits<double>::infinity();
  unbounded.most = std::numeric_limits<double>::infinity();
  const auto value = read_number(text, unbounded);
  if (!value) return options.unit.empty() ? "not a number" : "not a number in " + options.unit;
  const std::string unit = options.unit.empty() ? "" : " " + options.unit;
  if (*value < options.least) return "at least " + digits_text(options.least, options) + unit;
  if (*value > options.most) return "at most " + digits_text(options.most, options) + unit;
  return {};
}

double step_of(const NumberOptions& options) {
  return options.step > 0.0 ? options.step : std::pow(10.0, -options.decimals);
}

Hint number_hint(const NumberOptions& options) {
  Hint hint = options.hint;
  if (hint.unit.empty()) hint.unit = options.unit;
  if (options.reset) {
    const std::string standard = "default " + digits_text(*options.reset, options);
    hint.source = hint.source.empty() ? standard : hint.source + ", " + standard;
  }
  return hint;
}

}  // namespace nadir::kit
