// SPDX-License-Identifier: Apache-2.0
#include "core/base/utf8.h"

#include <array>
#include <cstdint>
#include <optional>

namespace nadir {
namespace {

constexpr std::string_view kHexDigits = "0123456789ABCDEF";

/// The byte that stands behind a mark.
std::optional<char> marked_byte(std::string_view digits) {
  if (digits.size() < 2) return std::nullopt;
  const std::size_t high = kHexDigits.find(digits[0]), low = kHexDigits.find(digits[1]);
  if (high == std::string_view::npos || low == std::string_view::npos) return std::nullopt;
  return static_cast<char>(high << 4U | low);
}

}  // namespace

std::size_t utf8_length(std::string_view text) {
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
  // Longer than need be, halves of pairs, beyond the last.
  constexpr std::array<std::uint32_t, 5> kLeast = {0, 0, 0x80, 0x800, 0x10000};
  const bool is_half = code >= 0xD800 && code < 0xE000;
  return code < kLeast.at(length) || is_half || code > 0x10FFFF ? 0 : length;
}

std::string utf8_of_bytes(std::string_view bytes) {
  std::string text;
  while (!bytes.empty()) {
    const std::size_t length = utf8_length(bytes);
    if (length > 0 && !bytes.starts_with(kByteMark)) {
      text += bytes.substr(0, length);
      bytes.remove_prefix(length);
      continue;
    }
    // A mark among the bytes is none of ours: it is written as its bytes, of which the first is done here.
    const auto byte = static_cast<unsigned char>(bytes.front());
    text += kByteMark;
    text += kHexDigits[byte >> 4U];
    text += kHexDigits[byte & 0xFU];
    bytes.remove_prefix(1);
  }
  return text;
}

std::string bytes_of_utf8(std::string_view text) {
  std::string bytes;
  while (!text.empty()) {
    if (text.starts_with(kByteMark)) {
      if (const auto byte = marked_byte(text.substr(kByteMark.size()))) {
        bytes += *byte;
        text.remove_prefix(kByteMark.size() + 2);
        continue;
      }
    }
    bytes += text.front();
    text.remove_prefix(1);
  }
  return bytes;
}

}  // namespace nadir
