// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace nadir {

/// Bytes of the character that a text begins with in UTF-8 (Unicode 15, table 3-7); 0 where it begins with none.
/// @param text  Not empty.
[[nodiscard]] std::size_t utf8_length(std::string_view text);

/// Any bytes as UTF-8, for files that can hold nothing else, such as TOML: names of files are bytes. Text in UTF-8 stays as it
/// is; each byte that belongs to no character becomes U+FFFF, which is none and stands in no text, and two hexadecimal digits:
/// "caf\xE9" is "caf", U+FFFF, "E9". bytes_of_utf8() gives the same bytes again, also where U+FFFF was among them.
[[nodiscard]] std::string utf8_of_bytes(std::string_view bytes);
[[nodiscard]] std::string bytes_of_utf8(std::string_view text);

/// U+FFFF in UTF-8.
inline constexpr std::string_view kByteMark = "\xEF\xBF\xBF";

}  // namespace nadir
