// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <memory>
#include <ostream>
#include <stop_token>
#include <string>

#include "core/base/progress.h"

namespace nadir::cli {

/// The part of a larger piece of work that a smaller one is.
struct ProgressShare {
  double from = 0.0, to = 1.0;  ///< In [0, 1].
};

/// "progress 0.4300 drawing flight": a line that tells how far all of the work is. @param fraction  Of the share, in [0, 1].
[[nodiscard]] std::string progress_line(const ProgressShare& share,
                                        double fraction,
                                        const std::string& activity);

/// A bar with time left on a terminal; nothing where standard error is a file or a pipe, or where
/// it was told to be quiet. With NADIR_PROGRESS=lines in the environment, lines "progress 0.43 drawing flight" instead,
/// wherever they go: for programs that call this one. Those count all of the work, a bar only what is done now.
class ProgressBar {
 public:
  ProgressBar(std::ostream& err, bool is_quiet, const ProgressShare& share = {});
  ~ProgressBar();  ///< Wipes the bar.
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;
  /// Draws at most ten times a second.
  void show(double fraction, const std::string& activity);

 private:
  std::ostream& err_;
  bool is_shown_, writes_lines_;
  ProgressShare share_;
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
