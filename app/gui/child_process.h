// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/result.h"

namespace nadir {

/// A program that works beside this one: what it says on standard error is collected, its standard output is dropped.
class ChildProcess {
 public:
  /// Starts it at once, with this process's environment and more. @param variables  Names and values.
  /// @errors kIo: it cannot be started.
  [[nodiscard]] static Result<ChildProcess> start(
      const std::filesystem::path& program,
      const std::vector<std::string>& arguments,
      const std::vector<std::pair<std::string, std::string>>& variables = {});
  ChildProcess(ChildProcess&& other) noexcept;
  ChildProcess& operator=(ChildProcess&&) = delete;
  /// Asks it to stop, and ends it where it does not within two seconds.
  ~ChildProcess();

  /// Takes in what it has said; never waits. @returns its exit status once it is over, 128 and the signal where one ended
  /// it; nothing while it works.
  [[nodiscard]] std::optional<int> poll();
  /// SIGTERM: our own programs then leave nothing half-written. The first call counts.
  void ask_to_stop();
  /// Of the process; 0 once it is over.
  [[nodiscard]] pid_t id() const { return process_; }
  [[nodiscard]] bool was_asked_to_stop() const { return was_asked_; }
  /// All lines of standard error so far that are whole, without line breaks.
  [[nodiscard]] const std::vector<std::string>& lines() const { return lines_; }

 private:
  ChildProcess(pid_t process, int pipe) : process_(process), pipe_(pipe) {}
  void read();

  pid_t process_;  ///< 0: over.
  int pipe_;       ///< -1: closed.
  int status_ = 0;
  bool was_asked_ = false;
  std::string rest_;  ///< After the last line break.
  std::vector<std::string> lines_;
};

/// The program that runs now.
[[nodiscard]] std::filesystem::path own_program();

}  // namespace nadir
