// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/time_axis.h"

#include <gmock/gmock.h>

#include <cmath>

namespace nadir {
namespace time_axis_test {

using ::testing::ElementsAre;
using ::testing::Eq;
using ::testing::Optional;

TimeAxis axis_over(double from_s, double to_s, double width_px = 1000.0) {
  TimeAxis axis;
  axis.from_s = axis.first_s = from_s;
  axis.to_s = axis.last_s = to_s;
  axis.left_px = 200.0;
  axis.width_px = width_px;
  return axis;
}

std::vector<std::string> labels(const TimeAxis& axis, double least_px = 80.0) {
  std::vector<std::string> found;
  for (const TimeTick& tick : time_ticks(axis, least_px)) {
    if (!tick.label.empty()) found.push_back(tick.label);
  }
  return found;
}

TEST(TimeAxis, MapsEveryPixelToItsTimeAndBack) {
  const TimeAxis axis = axis_over(0.0, 250.0);
  EXPECT_DOUBLE_EQ(axis.time_s(200.0), 0.0);
  EXPECT_DOUBLE_EQ(axis.time_s(1200.0), 250.0);
  EXPECT_DOUBLE_EQ(axis.time_s(701.0), 125.25);
  for (int x = 200; x <= 1200; ++x) EXPECT_NEAR(axis.x_px(axis.time_s(x)), x, 1e-9);
}

TEST(TimeAxis, GoesNoFartherThanTheActiveRun) {
  TimeAxis axis = axis_over(-10.0, 90.0);
  axis.first_s = 0.0;
  axis.last_s = 50.0;
  EXPECT_DOUBLE_EQ(axis.seek_s(200.0), 0.0);
  EXPECT_DOUBLE_EQ(axis.seek_s(400.0), 10.0);
  EXPECT_DOUBLE_EQ(axis.seek_s(1100.0), 50.0);
  EXPECT_DOUBLE_EQ(axis.seek_s(-1e9), 0.0);
}

TEST(TimeTicks, StandAtRoundTimes) {
  EXPECT_THAT(labels(axis_over(0.0, 150.0)),
              ElementsAre("0:00", "0:15", "0:30", "0:45", "1:00", "1:15", "1:30", "1:45", "2:00",
                          "2:15", "2:30"));
  EXPECT_THAT(labels(axis_over(0.0, 2.0), 240.0),
              ElementsAre("0:00.0", "0:00.5", "0:01.0", "0:01.5", "0:02.0"));
  EXPECT_THAT(labels(axis_over(-20.0, 20.0), 240.0),
              ElementsAre("-0:20", "-0:10", "0:00", "0:10", "0:20"));
}

TEST(TimeTicks, AreNeverNearerThanAskedAndNeverOutside) {
  for (const double span_s : {0.3, 1.0, 7.0, 61.0, 470.0, 3601.0, 90'000.0}) {
    const TimeAxis axis = axis_over(3.3, 3.3 + span_s);
    double last_px = -1e9;
    for (const TimeTick& tick : time_ticks(axis, 80.0)) {
      EXPECT_GE(tick.time_s, axis.from_s - 1e-6 * span_s);
      EXPECT_LE(tick.time_s, axis.to_s + 1e-6 * span_s);
      if (tick.label.empty()) continue;
      EXPECT_GE(axis.x_px(tick.time_s) - last_px, 80.0 - 1e-6) << span_s;
      last_px = axis.x_px(tick.time_s);
    }
    EXPECT_GT(last_px, 0.0) << "no label over " << span_s << " s";
  }
}

TEST(ClockText, HasMinutesSecondsAndTenths) {
  EXPECT_EQ(clock_text(0.0), "00:00.0");
  EXPECT_EQ(clock_text(42.34), "00:42.3");
  EXPECT_EQ(clock_text(59.96), "01:00.0");
  EXPECT_EQ(clock_text(4503.0), "75:03.0");
  EXPECT_EQ(clock_text(-3.2), "-00:03.2");
  EXPECT_EQ(clock_text(-0.01), "00:00.0");
  EXPECT_EQ(clock_text(std::nan("")), "--:--.-");
}

TEST(ParseClock, ReadsWhatClockTextWritesAndPlainSeconds) {
  for (const double moment_s : {0.0, 0.1, 42.3, 60.0, 4503.7, -3.2}) {
    EXPECT_THAT(parse_clock(clock_text(moment_s)), Optional(moment_s));
  }
  EXPECT_THAT(parse_clock("62.5"), Optional(62.5));
  EXPECT_THAT(parse_clock(" 62.5 s "), Optional(62.5));
  EXPECT_THAT(parse_clock("1:02"), Optional(62.0));
  EXPECT_THAT(parse_clock("1:02:03.5"), Optional(3723.5));
}

TEST(ParseClock, RefusesWhatIsNoTime) {
  for (const char* text :
       {"", " ", "abc", "1:", ":5", "1:2:3:4", "1e3", "nan", "--1", "1.2.3", "1 2", "s"}) {
    EXPECT_THAT(parse_clock(text), Eq(std::nullopt)) << text;
  }
}

}  // namespace time_axis_test
}  // namespace nadir
