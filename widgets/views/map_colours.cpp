// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/map_colours.h"

#include <charconv>
#include <cmath>

namespace nadir {
namespace {

/// Relative luminance of WCAG 2.1, in [0, 1].
double luminance(Rgba colour) {
  const auto linear = [](std::uint8_t channel) {
    const double share = channel / 255.0;
    return share <= 0.04045 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(colour.red) + 0.7152 * linear(colour.green) + 0.0722 * linear(colour.blue);
}

double contrast_of(Rgba a, Rgba b) {
  const double first = luminance(a) + 0.05, second = luminance(b) + 0.05;
  return first > second ? first / second : second / first;
}

}  // namespace

Rgba faded(Rgba colour, double share) { return with_opacity(colour, share * colour.alpha / 255.0); }

std::optional<Rgba> colour_from_hex(const std::string& text) {
  if (text.size() != 7 || text.front() != '#') return std::nullopt;
  std::uint32_t value = 0;
  const char* const end = text.data() + text.size();
  const auto [stopped, error] = std::from_chars(text.data() + 1, end, value, 16);
  if (error != std::errc() || stopped != end) return std::nullopt;
  return Rgba{static_cast<std::uint8_t>(value >> 16U), static_cast<std::uint8_t>(value >> 8U),
              static_cast<std::uint8_t>(value)};
}

Rgba light_on_imagery(const Theme& theme) { return theme.truth_on_imagery; }

Rgba casing_over_imagery(const Theme& theme, Rgba line) {
  const Rgba light = light_on_imagery(theme);
  const bool is_dark = contrast_of(line, light) > contrast_of(line, theme.casing_on_imagery);
  return is_dark ? light : theme.casing_on_imagery;
}

}  // namespace nadir
