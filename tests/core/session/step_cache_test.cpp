// SPDX-License-Identifier: Apache-2.0
#include "core/session/step_cache.h"

#include "tests/core/run/run_sql.h"
#include "tests/core/session/cached_run.h"

namespace nadir {
namespace step_cache_test {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

TEST_F(StepCacheOfARun, DecodesTheStepAtTheCursorAndThoseAround) {
  StepCache cache(record(30, 50));
  EXPECT_EQ(cache.step(10), nullptr) << "nobody has asked";
  cache.request({.index = 10});
  settle(cache);
  EXPECT_TRUE(cache.is_cursor_ready());
  const auto reader = RunReader::open(path());
  for (int i = 0; i < 30; ++i) {
    const auto step = cache.step(static_cast<std::size_t>(i));
    ASSERT_NE(step, nullptr) << i;
    EXPECT_EQ(step->step, i);
    EXPECT_EQ(step->particles, reader->step(i)->particles);
    EXPECT_EQ(step->topview, reader->step(i)->topview);
  }
  EXPECT_EQ(cache.step(30), nullptr);
  EXPECT_THAT(cache.take_errors(), IsEmpty());
}

TEST_F(StepCacheOfARun, StaysWithinItsBudgetAndKeepsWhatIsNear) {
  StepCache cache(record(101, 1000));
  cache.request({.index = 0});
  settle(cache);
  const std::size_t one = cache.used_bytes() / decoded(cache, 101).size();
  EXPECT_GT(one, 1000 * 4 * sizeof(double));
  cache.set_budget_bytes(9 * one + one / 2);
  EXPECT_EQ(cache.budget_bytes(), 9 * one + one / 2);
  EXPECT_LE(cache.used_bytes(), cache.budget_bytes());
  cache.request({.index = 50});
  settle(cache);
  EXPECT_LE(cache.used_bytes(), cache.budget_bytes());
  EXPECT_EQ(decoded(cache, 101), (std::vector<std::size_t>{46, 47, 48, 49, 50, 51, 52, 53, 54}));
  cache.request({.index = 50, .direction = 1, .is_playing = true});
  settle(cache);
  EXPECT_EQ(decoded(cache, 101), (std::vector<std::size_t>{48, 49, 50, 51, 52, 53, 54, 55, 56}))
      << "two behind are as far as six ahead";
}

TEST_F(StepCacheOfARun, PrefetchesInTheDirectionOfPlay) {
  StepCache cache(record(400, 2));
  cache.request({.index = 100, .direction = 1, .is_playing = true});
  settle(cache);
  EXPECT_NE(cache.step(340), nullptr);
  EXPECT_EQ(cache.step(341), nullptr);
  EXPECT_NE(cache.step(80), nullptr);
  EXPECT_EQ(cache.step(79), nullptr);
  StepCache backwards(load());
  backwards.request({.index = 300, .direction = -1, .is_playing = true});
  settle(backwards);
  EXPECT_NE(backwards.step(60), nullptr);
  EXPECT_EQ(backwards.step(59), nullptr);
  EXPECT_EQ(backwards.step(321), nullptr);
}

TEST_F(StepCacheOfARun, KeepsTheStepAtTheCursorHoweverLarge) {
  StepCache cache(record(5, 1000), nullptr, 1);
  cache.request({.index = 3});
  settle(cache);
  EXPECT_NE(cache.step(3), nullptr);
  EXPECT_GT(cache.used_bytes(), cache.budget_bytes());
  cache.request({.index = 1});
  settle(cache);
  EXPECT_EQ(decoded(cache, 5), std::vector<std::size_t>{1});
}

TEST_F(StepCacheOfARun, ShowsTheNearestUntilTheRightOneIsThere) {
  StepCache cache(record(300, 2));
  cache.request({.index = 100});
  settle(cache);
  ASSERT_EQ(cache.step(195), nullptr);
  EXPECT_EQ(cache.nearest_step(195)->step, 190);
  EXPECT_EQ(cache.nearest_step(195, 4), nullptr);
}

TEST_F(StepCacheOfARun, TakesACursorPastTheEndForTheLastStep) {
  StepCache cache(record(5, 2));
  cache.request({.index = 99});
  settle(cache);
  EXPECT_NE(cache.step(4), nullptr);
  EXPECT_TRUE(cache.is_cursor_ready());
}

TEST_F(StepCacheOfARun, HasNothingToDoForARunWithoutSteps) {
  StepCache cache(record(0, 0));
  cache.request({.index = 0});
  settle(cache);
  EXPECT_TRUE(cache.is_cursor_ready());
  EXPECT_EQ(cache.nearest_step(0), nullptr);
  EXPECT_EQ(cache.used_bytes(), 0U);
}

TEST_F(StepCacheOfARun, TellsABrokenStepOnceAndGoesOn) {
  const auto run = record(20, 10);
  run_sql(path(), "UPDATE particles SET data = x'00ff' WHERE step = 7");
  StepCache cache(run);
  cache.request({.index = 7});
  settle(cache);
  EXPECT_TRUE(cache.is_cursor_ready()) << "there is nothing to wait for";
  EXPECT_EQ(cache.step(7), nullptr);
  EXPECT_THAT(decoded(cache, 20), SizeIs(19));
  const auto errors = cache.take_errors();
  ASSERT_THAT(errors, SizeIs(1));
  EXPECT_THAT(errors[0].message, HasSubstr("particles of step 7"));
  cache.request({.index = 8});
  cache.request({.index = 7});
  settle(cache);
  EXPECT_THAT(cache.take_errors(), IsEmpty());
}

TEST_F(StepCacheOfARun, TellsAMissingFileOnce) {
  const auto run = record(20, 10);
  std::filesystem::remove(path());
  StepCache cache(run);
  cache.request({.index = 7});
  settle(cache);
  const auto errors = cache.take_errors();
  ASSERT_THAT(errors, SizeIs(1));
  EXPECT_EQ(errors[0].code, ErrorCode::kNotFound);
}

TEST_F(StepCacheOfARun, NoticesThatAnotherRunHasTakenItsName) {
  const auto run = record(20, 10);
  std::filesystem::remove(path());
  record_run(path(), 20, 10);
  run_sql(path(), "UPDATE step SET time_s = time_s + 1");
  StepCache cache(run);
  cache.request({.index = 7});
  settle(cache);
  EXPECT_THAT(decoded(cache, 20), IsEmpty());
  const auto errors = cache.take_errors();
  ASSERT_THAT(errors, SizeIs(1));
  EXPECT_THAT(errors[0].message, HasSubstr("has changed since it was opened"));
  cache.set_document(load());
  settle(cache);
  EXPECT_THAT(decoded(cache, 20), SizeIs(20));
}

TEST_F(StepCacheOfARun, KeepsWhatItHasWhenTheRunGrows) {
  auto writer = RunWriter::create(path(), example_header());
  ASSERT_TRUE(writer);
  for (int i = 0; i < 5; ++i) ASSERT_TRUE(writer->write(example_step(i, 10)));
  const auto run = load();
  StepCache cache(run);
  cache.request({.index = 4});
  settle(cache);
  const auto before = cache.step(2);
  for (int i = 5; i < 9; ++i) ASSERT_TRUE(writer->write(example_step(i, 10)));
  const auto grown = RunDocument::grown(run);
  ASSERT_TRUE(grown);
  cache.set_document(*grown);
  settle(cache);
  EXPECT_EQ(cache.step(2), before);
  ASSERT_NE(cache.step(8), nullptr);
  EXPECT_EQ(cache.step(8)->particles->size(), 10U);
}

TEST_F(StepCacheOfARun, ForgetsTheRunBefore) {
  const auto run = record(20, 10);
  StepCache cache(run);
  cache.request({.index = 7});
  settle(cache);
  record_run(path(), 4, 3);
  cache.set_document(load());
  settle(cache);
  EXPECT_THAT(decoded(cache, 20), SizeIs(4));
  EXPECT_EQ(cache.step(2)->particles->size(), 3U);
}

TEST_F(StepCacheOfARun, MayGoWhileItWorksAndMayBeMoved) {
  const auto run = record(300, 200);
  for (int i = 0; i < 5; ++i) {
    StepCache cache(run);
    cache.request({.index = 100});
    StepCache moved = std::move(cache);
    moved.request({.index = 200});
    cache = StepCache(run);
    cache.request({.index = 3});
  }
  StepCache cache(run);
  cache.request({.index = 299});
  settle(cache);
  EXPECT_NE(cache.step(299), nullptr);
}

TEST_F(StepCacheOfARun, CountsTheSameRequestOnce) {
  StepCache cache(record(10, 2));
  cache.request({.index = 3});
  settle(cache);
  cache.request({.index = 3});
  EXPECT_TRUE(cache.is_idle());
}

}  // namespace step_cache_test
}  // namespace nadir
