// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>
#include <span>
#include <string>

#include "app/cli/command.h"

namespace nadir::cli {

/// Every command of the program, in the order of its help page.
[[nodiscard]] std::span<const Command> commands();

/// Runs the program on its arguments (without its own name): finds the command, runs it, and turns
/// an exception, which is a bug of ours, into one sentence. Returns the exit status: 0 done, 1
/// failed, 2 misused.
int run_command_line(std::span<const std::string> arguments, std::ostream& out, std::ostream& err);

}  // namespace nadir::cli
