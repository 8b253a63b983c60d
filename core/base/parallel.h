// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <memory>

namespace nadir {

/// Calls `body(begin, end)` for [0, count) cut into chunks of `chunk_size`, on as many threads as
/// there are.
///
/// The chunks depend on the arguments alone, never on the number of threads: a body that writes
/// only to its own range, or one partial sum a chunk (chunk number begin / chunk_size) that is
/// added up in order afterwards, gives the same bits on any machine. An exception in the body is
/// thrown again here.
void parallel_for(std::size_t count,
                  std::size_t chunk_size,
                  const std::function<void(std::size_t begin, std::size_t end)>& body);

/// While it lives, parallel_for uses at most `threads` threads (0: as many as the machine has).
class ThreadLimit {
 public:
  explicit ThreadLimit(int threads);
  ~ThreadLimit();
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// Threads that parallel_for would use now.
[[nodiscard]] int thread_count();

}  // namespace nadir
