// SPDX-License-Identifier: Apache-2.0
#include "core/session/step_cache.h"

#include <gmock/gmock.h>

#include <atomic>
#include <future>
#include <mutex>

#include "tests/core/run/recorded_run.h"
#include "tests/core/run/run_sql.h"
#include "tests/support/error_text.h"
#include "tests/support/scratch_folder.h"

namespace nadir {
namespace step_cache_test {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr std::chrono::seconds kPatience{60};

/// Frames at the times of example_step(), with pixels that tell their number; says what it was asked for.
class NumberedFlight final : public FlightRecording {
 public:
  explicit NumberedFlight(int frames, double offset_s = 0.0)
      : FlightRecording(described(frames, offset_s)) {}

  Result<SemanticFrame> load(std::size_t frame) const override {
    {
      const std::lock_guard lock(mutex_);
      loads_.push_back(frame);
    }
    if (frame == held_frame) {
      is_held.set_value();
      may_go_on.get_future().wait();
    }
    if (frame == broken_frame) return fail(ErrorCode::kMalformed, "labels.png: is damaged");
    SemanticFrame pixels;
    pixels.labels = Raster<ClassId>(8, 4, static_cast<ClassId>(frame % 5));
    pixels.depth_m = Raster<float>(8, 4, static_cast<float>(frame));
    return pixels;
  }
  [[nodiscard]] std::vector<std::size_t> loads() const {
    const std::lock_guard lock(mutex_);
    return loads_;
  }

  std::size_t held_frame = 1'000'000, broken_frame = 1'000'000;
  mutable std::promise<void> is_held, may_go_on;

 private:
  static FlightDescription described(int frames, double offset_s) {
    FlightDescription flight;
    for (int i = 0; i < frames; ++i) {
      FlightFrame frame;
      frame.time_s = 0.1 * i + offset_s;
      frame.labels = "labels.png";
      frame.depth = "depth.png";
      flight.frames.push_back(frame);
    }
    return flight;
  }

  mutable std::mutex mutex_;
  mutable std::vector<std::size_t> loads_;
};

class StepCacheOfARun : public ::testing::Test {
 protected:
  [[nodiscard]] std::filesystem::path path() const { return scratch_.path() / "R.nadir"; }
  [[nodiscard]] std::shared_ptr<const RunDocument> record(int steps, int particles) const {
    record_run(path(), steps, particles);
    return load();
  }
  [[nodiscard]] std::shared_ptr<const RunDocument> load() const {
    auto run = RunDocument::load(path());
    if (!run) throw std::runtime_error(run.error().message);
    return *run;
  }
  static std::vector<std::size_t> decoded(const StepCache& cache, std::size_t count) {
    std::vector<std::size_t> indices;
    for (std::size_t i = 0; i < count; ++i) {
      if (cache.step(i)) indices.push_back(i);
    }
    return indices;
  }
  static void settle(const StepCache& cache) { ASSERT_TRUE(cache.wait_until_idle(kPatience)); }

  ScratchFolder scratch_;
};

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

TEST_F(StepCacheOfARun, BringsTheCameraFrameOfAStep) {
  const auto flight = std::make_shared<NumberedFlight>(30);
  StepCache cache(record(30, 2), flight);
  cache.request({.index = 10});
  settle(cache);
  const auto moment = cache.camera(10);
  ASSERT_NE(moment, nullptr);
  EXPECT_EQ(moment->frame, 10U);
  EXPECT_NEAR(moment->clock_s, 1.0, 1e-12);
  EXPECT_EQ(moment->depth_m.at(3, 2), 10.0F);
  EXPECT_TRUE(moment->image.empty());
  EXPECT_EQ(flight->loads().front(), 10U) << "the one that is looked at comes first";
  EXPECT_THAT(flight->loads(), SizeIs(9)) << "and four on either side";
  EXPECT_EQ(cache.camera(20), nullptr);
}

TEST_F(StepCacheOfARun, LeavesCameraFramesThatNobodyShows) {
  const auto flight = std::make_shared<NumberedFlight>(30);
  StepCache cache(record(30, 2), flight);
  cache.request({.index = 10, .with_camera = false});
  settle(cache);
  EXPECT_THAT(flight->loads(), IsEmpty());
  cache.request({.index = 10, .with_camera = true});
  settle(cache);
  EXPECT_THAT(flight->loads(), SizeIs(9));
}

TEST_F(StepCacheOfARun, FindsFramesWithinATenthOfASecond) {
  StepCache cache(record(30, 2), std::make_shared<NumberedFlight>(10, 0.04));
  EXPECT_EQ(cache.frame_of(3), 3U);
  EXPECT_EQ(cache.frame_of(10), 9U) << "0.06 s before";
  EXPECT_EQ(cache.frame_of(11), std::nullopt);
  cache.set_flight(nullptr);
  EXPECT_EQ(cache.frame_of(3), std::nullopt);
}

TEST_F(StepCacheOfARun, TakesAFlightThatIsOpenedLater) {
  StepCache cache(record(10, 2));
  cache.request({.index = 3});
  settle(cache);
  EXPECT_EQ(cache.camera(3), nullptr);
  cache.set_flight(std::make_shared<NumberedFlight>(10));
  settle(cache);
  EXPECT_NE(cache.camera(3), nullptr);
}

TEST_F(StepCacheOfARun, TellsABrokenFrameOnce) {
  const auto flight = std::make_shared<NumberedFlight>(10);
  flight->broken_frame = 3;
  StepCache cache(record(10, 2), flight);
  cache.request({.index = 3});
  settle(cache);
  EXPECT_TRUE(cache.is_cursor_ready());
  EXPECT_EQ(cache.camera(3), nullptr);
  EXPECT_NE(cache.camera(4), nullptr);
  const auto errors = cache.take_errors();
  ASSERT_THAT(errors, SizeIs(1));
  EXPECT_EQ(errors[0].message, "labels.png: is damaged");
}

TEST_F(StepCacheOfARun, ServesTheNewestRequestAfterOneItemAtMost) {
  const auto flight = std::make_shared<NumberedFlight>(300);
  flight->held_frame = 10;
  StepCache cache(record(300, 2), flight);
  cache.request({.index = 10});
  flight->is_held.get_future().wait();
  for (std::size_t index = 11; index <= 200; ++index) cache.request({.index = index});  // a scrub
  EXPECT_FALSE(cache.is_cursor_ready());
  EXPECT_EQ(cache.step(200), nullptr);
  flight->may_go_on.set_value();
  settle(cache);
  const auto loads = flight->loads();
  ASSERT_GE(loads.size(), 2U);
  EXPECT_EQ(loads[0], 10U);
  EXPECT_EQ(loads[1], 200U) << "nothing in between";
  EXPECT_EQ(cache.step(105), nullptr);
  EXPECT_NE(cache.step(200), nullptr);
}

TEST_F(StepCacheOfARun, GivesFramesHalfOfTheBudget) {
  const auto flight = std::make_shared<NumberedFlight>(300);
  StepCache cache(record(300, 100), flight, 40'000);
  cache.request({.index = 150});
  settle(cache);
  EXPECT_LE(cache.used_bytes(), 40'000U);
  EXPECT_NE(cache.camera(150), nullptr);
  const std::size_t with_frames = decoded(cache, 300).size();
  cache.request({.index = 150, .with_camera = false});
  settle(cache);
  EXPECT_LE(cache.used_bytes(), 40'000U);
  EXPECT_GT(decoded(cache, 300).size(), with_frames);
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
