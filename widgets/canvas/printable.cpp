// SPDX-License-Identifier: Apache-2.0
#include "widgets/canvas/printable.h"

#include <array>
#include <cstdint>
#include <string_view>

namespace nadir {
namespace {

constexpr std::string_view kReplacement = "\xef\xbf\xbd";

/// Bytes of the character that a text begins with; 0 where it begins with none (Unicode 15, table 3-7).
std::size_t character_length(std::string_view text) {
  const auto byte = [text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(0);
  if (first < 0x80) return 1;
  std::size_t length = 0;
  if (first >= 0xC2 && first < 0xE0) length = 2;
  if (first >= 0xE0 && first < 0xF0) length = 3;
  if (first >= 0xF0 && first < 0xF5) length = 4;
  if (length == 0 || text.size() < length) return 0;
  std::uint32_t code = first & (0x7FU >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0U) != 0x80U) return 0;
    code = (code << 6U) | (byte(i) & 0x3FU);
  }
  // Longer than need be, halves of pairs, beyond the last, and the two that are no characters.
  constexpr std::array<std::uint32_t, 5> kLeast = {0, 0, 0x80, 0x800, 0x10000};
  const bool is_half = code >= 0xD800 && code < 0xE000;
  if (code < kLeast.at(length) || is_half || code > 0x10FFFF || code == 0xFFFE || code == 0xFFFF) {
    return 0;
  }
  return length;
}

}  // namespace

std::string printable(const std::string& text) {
  std::string out;
  for (std::string_view left = text; !left.empty();) {
    const std::size_t length = character_length(left);
    const auto first = static_cast<unsigned char>(left.front());
    if (length == 0) {
      out += kReplacement;
    } else if (length > 1 || first >= 0x20 || first == '\n' || first == '\t') {
      out += left.substr(0, length);
    }
    left.remove_prefix(length == 0 ? 1 : length);
  }
  return out;
}

std::string markup_text(const std::string& text) {
  std::string out;
  for (const char letter : printable(text)) {
    switch (letter) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += letter;
    }
  }
  return out;
}

}  // namespace nadir
