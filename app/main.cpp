// SPDX-License-Identifier: Apache-2.0
#include <iostream>
#include <string>
#include <vector>

#include "app/cli/command_line.h"

int main(int count, char** words) {
  const std::vector<std::string> arguments(words + 1, words + count);
  return nadir::cli::run_command_line(arguments, std::cout, std::cerr);
}
