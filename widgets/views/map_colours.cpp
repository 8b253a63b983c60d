// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/map_colours.h"

#include <charconv>

namespace nadir {

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

}  // namespace nadir
