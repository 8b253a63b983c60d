// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace nadir::cli {

/// Columns of a help page: what a terminal has if nobody ever changed it.
inline constexpr std::size_t kHelpWidth = 80;

/// The help page of a command: purpose, usage, arguments, flags by group, footer. No line is longer than kHelpWidth unless
/// a single word is.
[[nodiscard]] std::string help_page(const CLI::App& command);

}  // namespace nadir::cli
