// SPDX-License-Identifier: Apache-2.0
#include "core/flight/nearest_frame.h"

#include <gtest/gtest.h>

#include <cmath>

namespace nadir {
namespace nearest_frame_test {

TEST(NearestFrame, IsWithinATenthOfASecondAndHasWhatIsWanted) {
  FlightDescription flight;
  for (const double time_s : {1.0, 1.05, 1.5, 2.0}) {
    FlightFrame frame;
    frame.time_s = time_s;
    if (time_s != 1.05) frame.image = "image.png";
    flight.frames.push_back(frame);
  }
  const auto has_image = [](const FlightFrame& frame) { return frame.image.has_value(); };
  const auto any = [](const FlightFrame& /*frame*/) { return true; };
  EXPECT_EQ(nearest_frame(flight, 1.04, has_image), &flight.frames[0]);
  EXPECT_EQ(nearest_frame(flight, 1.04, any), &flight.frames[1]);
  EXPECT_EQ(nearest_frame(flight, 1.45, has_image), &flight.frames[2]);
  EXPECT_EQ(nearest_frame(flight, 1.75, has_image), nullptr);
  EXPECT_EQ(nearest_frame(flight, 2.09, has_image), &flight.frames[3]);
  EXPECT_EQ(nearest_frame(flight, 2.11, has_image), nullptr);
  EXPECT_EQ(nearest_frame({}, 1.0, any), nullptr);
}

TEST(NearestFrame, IsTheOneThatALookAtEveryFrameFinds) {
  FlightDescription flight;
  for (int i = 0; i < 200; ++i) {
    FlightFrame frame;
    frame.time_s = 1.7e9 + 0.04 * i + 0.03 * std::sin(1.3 * i);
    flight.frames.push_back(frame);
  }
  const auto any = [](const FlightFrame& /*frame*/) { return true; };
  for (int i = -20; i < 900; ++i) {
    const double time_s = 1.7e9 + 0.01 * i;
    const FlightFrame* expected = nullptr;
    for (const FlightFrame& frame : flight.frames) {
      const double away_s = std::abs(frame.time_s - time_s);
      if (away_s > 0.1) continue;
      if (expected == nullptr || away_s < std::abs(expected->time_s - time_s)) expected = &frame;
    }
    EXPECT_EQ(nearest_frame(flight, time_s, any), expected) << i;
  }
}

}  // namespace nearest_frame_test
}  // namespace nadir
