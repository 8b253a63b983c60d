// SPDX-License-Identifier: Apache-2.0
#include "core/base/log.h"

#include <cstdio>
#include <mutex>
#include <utility>

namespace nadir {
namespace {

void write_to_standard_error(LogLevel level, const std::string& line) {
  // In one piece, so that lines of two threads do not mix.
  const std::string text = (level == LogLevel::kError ? "error: " : "warning: ") + line + "\n";
  std::fwrite(text.data(), 1, text.size(), stderr);
}

struct SharedSink {
  std::mutex mutex;
  LogSink sink;
};

/// Never destroyed: libraries speak up to the end of the process.
SharedSink& shared_sink() {
  static auto& shared = *new SharedSink;
  return shared;
}

std::string in_one_line(std::string_view message) {
  constexpr std::size_t kLongest = 1'000;
  std::string line;
  for (const char letter : message) {
    const bool is_space = letter == '\n' || letter == '\r' || letter == '\t' || letter == ' ';
    if (!is_space) {
      line += letter;
    } else if (!line.empty() && line.back() != ' ') {
      line += ' ';
    }
  }
  while (!line.empty() && line.back() == ' ') line.pop_back();
  if (line.size() <= kLongest) return line;
  std::size_t end = kLongest;
  // Not in the middle of a letter of several bytes.
  while (end > 0 && (static_cast<unsigned char>(line[end]) & 0xC0U) == 0x80U) --end;
  return line.substr(0, end) + " ...";
}

}  // namespace

void write_log(LogLevel level, std::string_view message) {
  LogSink sink;
  {
    SharedSink& shared = shared_sink();
    const std::lock_guard lock(shared.mutex);
    sink = shared.sink;
  }
  // Called without the lock, so that a sink may log or be replaced meanwhile.
  const std::string line = in_one_line(message);
  if (sink) {
    sink(level, line);
  } else {
    write_to_standard_error(level, line);
  }
}

LogSink set_log_sink(LogSink sink) {
  SharedSink& shared = shared_sink();
  const std::lock_guard lock(shared.mutex);
  return std::exchange(shared.sink, std::move(sink));
}

}  // namespace nadir
