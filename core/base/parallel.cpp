// SPDX-License-Identifier: Apache-2.0
#include "core/base/parallel.h"

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <thread>

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
  tbb::parallel_for(std::size_t{0}, chunks, run_chunk);
}

}  // namespace nadir
