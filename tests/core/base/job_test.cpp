// SPDX-License-Identifier: Apache-2.0
#include "core/base/job.h"

#include <gmock/gmock.h>

#include <atomic>
#include <future>
#include <new>
#include <stdexcept>
#include <vector>

#include "tests/support/error_text.h"

namespace nadir {
namespace job_test {

using ::testing::HasSubstr;

template <typename AnyJob>
void wait_for(const AnyJob& job) {
  while (!job.is_done()) std::this_thread::yield();
}

/// Works until it is told to stop.
Result<void> stubborn(const WorkContext& context) {
  while (!context.is_stopped()) std::this_thread::yield();
  return fail(ErrorCode::kCancelled, "stopped");
}

TEST(Job, GivesItsNewestSnapshotAloneAndTheSameOneUntilThereIsANewer) {
  std::promise<void> is_published, may_go_on;
  Job<int> job(
      [&](const WorkContext& /*context*/, const Job<int>::Publish& publish) -> Result<void> {
        publish(std::make_shared<const int>(1));
        publish(std::make_shared<const int>(2));
        is_published.set_value();
        may_go_on.get_future().wait();
        publish(std::make_shared<const int>(3));
        return {};
      });
  is_published.get_future().wait();
  const auto second = job.latest();
  ASSERT_NE(second, nullptr);
  EXPECT_EQ(*second, 2);
  EXPECT_EQ(job.latest(), second);
  EXPECT_FALSE(job.is_done());
  EXPECT_EQ(job.outcome(), nullptr);
  may_go_on.set_value();
  wait_for(job);
  EXPECT_EQ(*job.latest(), 3);
  EXPECT_EQ(*second, 2);
  ASSERT_NE(job.outcome(), nullptr);
  EXPECT_TRUE(job.outcome()->has_value());
}

TEST(Job, HasNoSnapshotWhereNoneWasPublished) {
  Job<int> job([](const auto& /*context*/, const auto& /*publish*/) -> Result<void> { return {}; });
  wait_for(job);
  EXPECT_EQ(job.latest(), nullptr);
}

TEST(Job, LetsGoOfASnapshotOnceThereIsANewerOne) {
  std::weak_ptr<const int> first;
  Job<int> job([&](const auto& /*context*/, const auto& publish) -> Result<void> {
    auto snapshot = std::make_shared<const int>(1);
    first = snapshot;
    publish(std::move(snapshot));
    publish(std::make_shared<const int>(2));
    return {};
  });
  wait_for(job);
  EXPECT_TRUE(first.expired());
}

TEST(Job, HandsOutAValueThatCannotBeCopied) {
  Job<int, std::unique_ptr<int>> job(
      [](const auto& /*context*/, const auto& /*publish*/) -> Result<std::unique_ptr<int>> {
        return std::make_unique<int>(42);
      });
  wait_for(job);
  ASSERT_TRUE(job.outcome()->has_value());
  const std::unique_ptr<int> taken = std::move(**job.outcome());
  EXPECT_EQ(*taken, 42);
}

TEST(Job, PassesAnErrorOn) {
  const Job<int> job([](const auto& /*context*/, const auto& /*publish*/) -> Result<void> {
    return fail(ErrorCode::kNotFound, "R.nadir: does not exist");
  });
  wait_for(job);
  EXPECT_EQ(error_code(*job.outcome()), ErrorCode::kNotFound);
  EXPECT_EQ(error_text(*job.outcome()), "R.nadir: does not exist");
}

TEST(Job, TurnsExceptionsIntoErrors) {
  const auto outcome_of = [](void (*thrower)()) {
    Job<int, int> job([thrower](const auto& /*context*/, const auto& /*publish*/) -> Result<int> {
      thrower();
      return 1;
    });
    wait_for(job);
    return *job.outcome();
  };
  const auto said = outcome_of([] { throw std::runtime_error("the map has no cells"); });
  EXPECT_EQ(error_code(said), ErrorCode::kIo);
  EXPECT_EQ(error_text(said), "the work failed: the map has no cells");
  EXPECT_EQ(error_text(outcome_of([] { throw std::bad_alloc(); })), "there is not enough memory");
  EXPECT_THAT(error_text(outcome_of([] { throw 5; })), HasSubstr("did not say"));
}

TEST(Job, AsksTheBodyToStopAndWaitsForItWhenItGoes) {
  std::atomic<bool> has_ended = false;
  {
    Job<int> job([&](const WorkContext& context, const auto& /*publish*/) {
      auto outcome = stubborn(context);
      has_ended = true;
      return outcome;
    });
    EXPECT_FALSE(job.is_stop_requested());
  }
  EXPECT_TRUE(has_ended);
}

TEST(Job, CanBeAskedToStopAndThenPolled) {
  Job<int> job(
      [](const WorkContext& context, const auto& /*publish*/) { return stubborn(context); });
  job.request_stop();
  EXPECT_TRUE(job.is_stop_requested());
  wait_for(job);
  EXPECT_EQ(error_code(*job.outcome()), ErrorCode::kCancelled);
}

TEST(Job, TellsHowFarItIs) {
  std::promise<void> is_reported, may_go_on;
  Job<int> job([&](const WorkContext& context, const auto& /*publish*/) -> Result<void> {
    context.report(0.25, "Reading steps");
    is_reported.set_value();
    may_go_on.get_future().wait();
    return {};
  });
  is_reported.get_future().wait();
  const JobProgress progress = job.progress();
  EXPECT_EQ(progress.fraction, 0.25);
  EXPECT_EQ(progress.activity, "Reading steps");
  EXPECT_GE(job.progress().elapsed_s, progress.elapsed_s);
  may_go_on.set_value();
  wait_for(job);
  const double ended_after_s = job.progress().elapsed_s;
  EXPECT_GE(ended_after_s, progress.elapsed_s);
  EXPECT_EQ(job.progress().elapsed_s, ended_after_s);
}

TEST(JobProgress, TellsWhatIsLeftAtTheSpeedSoFar) {
  EXPECT_EQ((JobProgress{0.25, "", 10.0}.remaining_s()), 30.0);
  EXPECT_EQ((JobProgress{1.0, "", 10.0}.remaining_s()), 0.0);
  EXPECT_EQ((JobProgress{0.0, "", 10.0}.remaining_s()), std::nullopt);
}

TEST(Job, CanBeMovedWhileItWorks) {
  std::promise<void> may_go_on;
  Job<int> job([&](const auto& /*context*/, const auto& publish) -> Result<void> {
    may_go_on.get_future().wait();
    publish(std::make_shared<const int>(7));
    return {};
  });
  std::vector<Job<int>> jobs;
  jobs.push_back(std::move(job));
  may_go_on.set_value();
  wait_for(jobs.front());
  EXPECT_EQ(*jobs.front().latest(), 7);
}

TEST(Job, StopsWhenAnotherTakesItsPlace) {
  std::atomic<bool> has_ended = false;
  Job<int> job([&](const WorkContext& context, const auto& publish) {
    auto outcome = stubborn(context);
    publish(std::make_shared<const int>(1));
    has_ended = true;
    return outcome;
  });
  job = Job<int>([](const auto& /*context*/, const auto& publish) -> Result<void> {
    publish(std::make_shared<const int>(2));
    return {};
  });
  EXPECT_TRUE(has_ended);
  wait_for(job);
  EXPECT_EQ(*job.latest(), 2);
}

TEST(Job, TakesSnapshotsAndReportsFromSeveralThreadsWhileItIsPolled) {
  constexpr int kThreads = 4, kEach = 200;
  Job<int> job([](const WorkContext& context, const auto& publish) -> Result<void> {
    std::vector<std::jthread> threads;
    for (int t = 0; t < kThreads; ++t) {
      threads.emplace_back([&, t] {
        for (int i = 1; i <= kEach; ++i) {
          publish(std::make_shared<const int>(t * kEach + i));
          context.report(static_cast<double>(i) / kEach, "Counting");
        }
      });
    }
    return {};
  });
  while (!job.is_done()) {
    if (const auto snapshot = job.latest()) {
      EXPECT_GE(*snapshot, 1);
      EXPECT_LE(*snapshot, kThreads * kEach);
    }
    EXPECT_LE(job.progress().fraction, 1.0);
  }
  EXPECT_EQ(*job.latest() % kEach, 0) << "the last of one of the threads";
}

}  // namespace job_test
}  // namespace nadir
