// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mutex>
#include <string>
#include <vector>

#include "core/base/log.h"

namespace nadir {

/// While it lives, messages of the log are kept here instead of being printed.
class CollectedLog {
 public:
  CollectedLog()
      : before_(set_log_sink([this](LogLevel level, const std::string& line) {
          const std::lock_guard lock(mutex_);
          lines_.push_back((level == LogLevel::kError ? "error: " : "warning: ") + line);
        })) {}
  ~CollectedLog() { set_log_sink(before_); }
  CollectedLog(const CollectedLog&) = delete;
  CollectedLog& operator=(const CollectedLog&) = delete;

  [[nodiscard]] std::vector<std::string> lines() const {
    const std::lock_guard lock(mutex_);
    return lines_;
  }

 private:
  mutable std::mutex mutex_;
  std::vector<std::string> lines_;
  LogSink before_;
};

}  // namespace nadir
