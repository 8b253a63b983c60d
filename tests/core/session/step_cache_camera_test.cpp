// SPDX-License-Identifier: Apache-2.0
#include <atomic>
#include <future>
#include <mutex>

#include "tests/core/session/cached_run.h"

namespace nadir {
namespace step_cache_camera_test {

using testing::IsEmpty;
using testing::SizeIs;

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

class StepCacheCamera : public StepCacheOfARun {};

TEST_F(StepCacheCamera, BringsTheCameraFrameOfAStep) {
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

TEST_F(StepCacheCamera, LeavesCameraFramesThatNobodyShows) {
  const auto flight = std::make_shared<NumberedFlight>(30);
  StepCache cache(record(30, 2), flight);
  cache.request({.index = 10, .with_camera = false});
  settle(cache);
  EXPECT_THAT(flight->loads(), IsEmpty());
  cache.request({.index = 10, .with_camera = true});
  settle(cache);
  EXPECT_THAT(flight->loads(), SizeIs(9));
}

TEST_F(StepCacheCamera, FindsFramesWithinATenthOfASecond) {
  StepCache cache(record(30, 2), std::make_shared<NumberedFlight>(10, 0.04));
  EXPECT_EQ(cache.frame_of(3), 3U);
  EXPECT_EQ(cache.frame_of(10), 9U) << "0.06 s before";
  EXPECT_EQ(cache.frame_of(11), std::nullopt);
  cache.set_flight(nullptr);
  EXPECT_EQ(cache.frame_of(3), std::nullopt);
}

TEST_F(StepCacheCamera, TakesAFlightThatIsOpenedLater) {
  StepCache cache(record(10, 2));
  cache.request({.index = 3});
  settle(cache);
  EXPECT_EQ(cache.camera(3), nullptr);
  cache.set_flight(std::make_shared<NumberedFlight>(10));
  settle(cache);
  EXPECT_NE(cache.camera(3), nullptr);
}

TEST_F(StepCacheCamera, TellsABrokenFrameOnce) {
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

TEST_F(StepCacheCamera, ServesTheNewestRequestAfterOneItemAtMost) {
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

TEST_F(StepCacheCamera, GivesFramesHalfOfTheBudget) {
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

}  // namespace step_cache_camera_test
}  // namespace nadir
