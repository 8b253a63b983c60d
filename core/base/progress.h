// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <stop_token>
#include <string>

namespace nadir {

/// How long work tells its caller how far it is and is told to stop. Both may be left empty.
/// The work does not know its thread; it asks `stop` at every step and then returns kCancelled.
struct WorkContext {
  std::stop_token stop;
  /// `fraction` done in [0, 1], and what is being done now, in a few words.
  std::function<void(double fraction, const std::string& activity)> progress;

  [[nodiscard]] bool is_stopped() const { return stop.stop_requested(); }
  void report(double fraction, const std::string& activity) const {
    if (progress) progress(fraction, activity);
  }
};

}  // namespace nadir
