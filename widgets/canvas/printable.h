// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace nadir {

/// The text as every kind of page can write it: UTF-8, with U+FFFD for bytes that are none (after an error Cairo draws
/// nothing more, and no browser opens the SVG), and without the control characters that XML 1.0 lacks.
[[nodiscard]] std::string printable(const std::string& text);

/// The same for the text and the attributes of XML and HTML, with &, <, > and " escaped.
[[nodiscard]] std::string markup_text(const std::string& text);

}  // namespace nadir
