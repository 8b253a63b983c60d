// SPDX-License-Identifier: Apache-2.0
#include "widgets/canvas/printable.h"

#include <algorithm>
#include <string_view>

#include "core/base/utf8.h"

namespace nadir {
namespace {

constexpr std::string_view kReplacement = "\xef\xbf\xbd";

/// Bytes of the character that a text begins with; 0 where it begins with none, or with one of the two that XML lacks.
std::size_t character_length(std::string_view text) {
  const bool is_none = text.starts_with("\xEF\xBF\xBE") || text.starts_with("\xEF\xBF\xBF");
  return is_none ? 0 : utf8_length(text);
}

}  // namespace

std::string printable(const std::string& text) {
  const auto is_plain = [](unsigned char letter) { return letter >= 0x20 && letter < 0x80; };
  if (std::all_of(text.begin(), text.end(), is_plain)) return text;
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
