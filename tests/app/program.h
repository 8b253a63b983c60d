// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sstream>
#include <string>
#include <vector>

#include "app/cli/command_line.h"

namespace nadir {

/// What a person at a shell would see.
struct ProgramOutput {
  int status = -1;
  std::string out, err;
};

/// Runs the program in this process: `run_program({"map", "info", "town"})`.
[[nodiscard]] inline ProgramOutput run_program(const std::vector<std::string>& arguments) {
  std::ostringstream out;
  std::ostringstream err;
  const int status = cli::run_command_line(arguments, out, err);
  return {status, out.str(), err.str()};
}

}  // namespace nadir
