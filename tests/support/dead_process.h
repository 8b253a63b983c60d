// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <stdexcept>

namespace nadir {

/// The number of a process that has just ended and that nobody waits for any more.
[[nodiscard]] inline pid_t dead_process() {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(0);
  if (child < 0 || ::waitpid(child, nullptr, 0) != child) {
    throw std::runtime_error("no process for a test");
  }
  return child;
}

}  // namespace nadir
