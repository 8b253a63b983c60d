// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace nadir::kit {

/// Words in as few lines of at most `most` characters as they need, the lines about equally long. They part at spaces, but not
/// between a number and its unit ("12 m"), and at the line breaks that are there; what has no spaces, such as a path, after a
/// slash or, if it must be, anywhere. No line for no words.
[[nodiscard]] std::vector<std::string> wrapped_lines(std::string_view words, std::size_t most);

/// Characters of UTF-8.
[[nodiscard]] std::size_t character_count(std::string_view text);

}  // namespace nadir::kit
