// SPDX-License-Identifier: Apache-2.0
#include "core/base/parallel.h"

#include <gmock/gmock.h>

#include <atomic>
#include <cmath>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

namespace nadir {
namespace parallel_test {

using testing::ElementsAre;
using Range = std::pair<std::size_t, std::size_t>;

std::set<Range> chunks_of(std::size_t count, std::size_t chunk_size) {
  std::mutex mutex;
  std::set<Range> ranges;
  parallel_for(count, chunk_size, [&](std::size_t begin, std::size_t end) {
    const std::scoped_lock lock(mutex);
    EXPECT_TRUE(ranges.insert({begin, end}).second) << "chunk at " << begin << " came twice";
  });
  return ranges;
}

TEST(ParallelFor, CutsTheRangeIntoFixedChunks) {
  EXPECT_THAT(chunks_of(10, 4), ElementsAre(Range{0, 4}, Range{4, 8}, Range{8, 10}));
  EXPECT_THAT(chunks_of(8, 4), ElementsAre(Range{0, 4}, Range{4, 8}));
  EXPECT_THAT(chunks_of(3, 100), ElementsAre(Range{0, 3}));
}

TEST(ParallelFor, AnEmptyRangeCallsNothing) { EXPECT_TRUE(chunks_of(0, 4).empty()); }

TEST(ParallelFor, AChunkOfNothingIsABugOfTheCaller) {
  EXPECT_THROW(parallel_for(10, 0, [](std::size_t, std::size_t) {}), std::logic_error);
}

TEST(ParallelFor, VisitsEveryElementOnce) {
  constexpr std::size_t kCount = 100'003;
  std::vector<int> visits(kCount);
  parallel_for(kCount, 97, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) ++visits[i];
  });
  EXPECT_EQ(visits, std::vector<int>(kCount, 1));
}

TEST(ParallelFor, SumsOfChunksAreTheSameBitsOnAnyNumberOfThreads) {
  constexpr std::size_t kCount = 50'000;
  constexpr std::size_t kChunk = 128;
  const auto sum_on = [](int threads) {
    const ThreadLimit limit(threads);
    std::vector<double> partial((kCount + kChunk - 1) / kChunk);
    parallel_for(kCount, kChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        partial[begin / kChunk] += std::sin(static_cast<double>(i)) * 1e10;
      }
    });
    double sum = 0.0;
    for (const double part : partial) sum += part;
    return sum;
  };
  const double alone = sum_on(1);
  for (const int threads : {2, 3, 8}) EXPECT_EQ(sum_on(threads), alone);
}

TEST(ParallelFor, AnExceptionOfTheBodyReachesTheCaller) {
  for (const std::size_t count : {std::size_t{1}, std::size_t{1000}}) {
    try {
      parallel_for(count, 10, [](std::size_t begin, std::size_t) {
        if (begin == 0) throw std::runtime_error("chunk failed");
      });
      FAIL() << "nothing was thrown";
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "chunk failed");
    }
  }
}

TEST(ParallelFor, WorksAgainAfterAnException) {
  EXPECT_THROW(parallel_for(100, 1, [](std::size_t, std::size_t) { throw std::logic_error("x"); }),
               std::logic_error);
  EXPECT_EQ(chunks_of(100, 1).size(), 100U);
}

TEST(ParallelFor, MayBeNested) {
  std::atomic<int> visits = 0;
  parallel_for(10, 1, [&](std::size_t, std::size_t) {
    parallel_for(10, 1, [&](std::size_t, std::size_t) { ++visits; });
  });
  EXPECT_EQ(visits, 100);
}

TEST(ThreadLimit, HoldsAsLongAsItLives) {
  const int before = thread_count();
  {
    const ThreadLimit limit(1);
    EXPECT_EQ(thread_count(), 1);
    std::mutex mutex;
    std::set<std::thread::id> threads;
    parallel_for(1000, 1, [&](std::size_t, std::size_t) {
      const std::scoped_lock lock(mutex);
      threads.insert(std::this_thread::get_id());
    });
    EXPECT_EQ(threads, std::set<std::thread::id>{std::this_thread::get_id()});
  }
  EXPECT_EQ(thread_count(), before);
}

TEST(ThreadLimit, ZeroMeansAllThreadsOfTheMachine) {
  const ThreadLimit limit(0);
  EXPECT_EQ(thread_count(), static_cast<int>(std::max(1U, std::thread::hardware_concurrency())));
}

TEST(ThreadLimit, ANegativeNumberIsABugOfTheCaller) {
  EXPECT_THROW(ThreadLimit(-1), std::logic_error);
}

}  // namespace parallel_test
}  // namespace nadir
