// SPDX-License-Identifier: Apache-2.0
#include "core/base/parallel.h"

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "core/base/require.h"

namespace nadir {

struct ThreadLimit::Implementation {
  // Built in place: a copy of a tbb::global_control compiles but limits nothing.
  explicit Implementation(std::size_t threads)
      : control(tbb::global_control::max_allowed_parallelism, threads) {}
  tbb::global_control control;
};

ThreadLimit::ThreadLimit(int threads) {
  NADIR_REQUIRE(threads >= 0);
  const auto allowed =
      threads > 0 ? static_cast<std::size_t>(threads)
                  : static_cast<std::size_t>(std::max(1U, std::thread::hardware_concurrency()));
  implementation_ = std::make_unique<Implementation>(allowed);
}

ThreadLimit::~ThreadLimit() = default;

int thread_count() {
  return static_cast<int>(
      tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
}

namespace {

#if defined(__SANITIZE_THREAD__)
/// TBB's library is not instrumented, so ThreadSanitizer takes its hand-overs for races. Under it plain threads share the
/// chunks out, and what it then reports are races of ours.
void hand_out(std::size_t chunks, const std::function<void(std::size_t)>& run_chunk) {
  std::atomic<std::size_t> next = 0;
  std::exception_ptr failure;
  std::mutex failure_mutex;
  const auto work = [&] {
    for (std::size_t chunk = next++; chunk < chunks; chunk = next++) {
      try {
        run_chunk(chunk);
      } catch (...) {
        const std::lock_guard lock(failure_mutex);
        if (!failure) failure = std::current_exception();
        next = chunks;
      }
    }
  };
  {
    std::vector<std::jthread> helpers;
    for (int i = 1; i < thread_count(); ++i) helpers.emplace_back(work);
    work();
  }
  if (failure) std::rethrow_exception(failure);
}
#else
void hand_out(std::size_t chunks, const std::function<void(std::size_t)>& run_chunk) {
  tbb::parallel_for(std::size_t{0}, chunks, run_chunk);
}
#endif

}  // namespace

void parallel_for(std::size_t count,
                  std::size_t chunk_size,
                  const std::function<void(std::size_t begin, std::size_t end)>& body) {
  NADIR_REQUIRE(chunk_size > 0);
  const std::size_t chunks = (count + chunk_size - 1) / chunk_size;
  const auto run_chunk = [&](std::size_t chunk) {
    body(chunk * chunk_size, std::min(count, (chunk + 1) * chunk_size));
  };
  if (chunks <= 1) {
    if (chunks == 1) run_chunk(0);
    return;
  }
  hand_out(chunks, run_chunk);
}

}  // namespace nadir
