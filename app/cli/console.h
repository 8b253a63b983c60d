// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <memory>
#include <ostream>
#include <stop_token>
#include <string>

#include "core/base/progress.h"

namespace nadir::cli {

/// A bar with time left on a terminal; nothing where standard error is a file or a pipe, or where
/// it was told to be quiet. With NADIR_PROGRESS=lines in the environment, lines "progress 0.43 drawing flight" instead,
/// wherever they go: for programs that call this one.
class ProgressBar {
 public:
  ProgressBar(std::ostream& err, bool is_quiet);
  ~ProgressBar();  ///< Wipes the bar.
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;
  /// Draws at most ten times a second.
  void show(double fraction, const std::string& activity);

 private:
  std::ostream& err_;
  bool is_shown_, writes_lines_;
  std::string activity_;
  std::chrono::steady_clock::time_point began_, drawn_;
};

/// While it lives, the first Ctrl+C (or SIGTERM) asks the work to stop, and the second ends the
/// program at once.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;
  [[nodiscard]] std::stop_token token() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace nadir::cli
