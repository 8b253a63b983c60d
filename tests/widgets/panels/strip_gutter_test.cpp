// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/strip_gutter.h"

#include <gmock/gmock.h>

#include "tests/widgets/panels/timeline_run.h"

namespace nadir {
namespace strip_gutter_test {

using ::testing::ElementsAre;
using ::testing::SizeIs;

/// Letters of 8 pixels, small ones of 6.
GutterRoom room_of(double width) {
  GutterRoom room;
  room.width = width;
  room.swatch = 8.0;
  room.gap = 9.0;
  room.width_of = [](const std::string& text, bool is_small) {
    return static_cast<double>(text.size()) * (is_small ? 6.0 : 8.0);
  };
  return room;
}

double width_of(const GutterValues& shown, const GutterRoom& room) {
  double width = 0.0;
  for (const GutterValues::Value& value : shown.values) {
    width += (width > 0.0 ? room.gap : 0.0) + (shown.values.size() > 1 ? room.swatch : 0.0) +
             room.width_of(value.text, shown.is_small);
  }
  return width;
}

std::vector<TimelineRun> runs_of(int count) {
  std::vector<TimelineRun> runs;
  for (int i = count; i >= 1; --i) runs.push_back(timeline_run(made_document(50), i == 1, i));
  return runs;
}

std::vector<std::string> texts_of(const GutterValues& shown) {
  std::vector<std::string> texts;
  for (const auto& value : shown.values) texts.push_back(value.text);
  return texts;
}

TEST(GutterValues, OfOneRunHasAllOfIt) {
  const GutterValues shown = gutter_values(Strip::kSigma, runs_of(1), 1.0, room_of(150.0));
  EXPECT_THAT(texts_of(shown), ElementsAre("0.50 0.50"));
  EXPECT_FALSE(shown.is_small);
}

TEST(GutterValues, OfThreeRunsGiveWayUntilTheyFit) {
  const auto runs = runs_of(3);
  // 9 letters of sigma are 72, with marks and gaps 258 for three; 4 letters 138; small 114.
  const GutterValues whole = gutter_values(Strip::kSigma, runs, 1.0, room_of(260.0));
  EXPECT_THAT(texts_of(whole), ElementsAre("0.50 0.50", "0.50 0.50", "0.50 0.50"));
  const GutterValues main = gutter_values(Strip::kSigma, runs, 1.0, room_of(140.0));
  EXPECT_THAT(texts_of(main), ElementsAre("0.50", "0.50", "0.50"));
  EXPECT_FALSE(main.is_small);
  const GutterValues small = gutter_values(Strip::kSigma, runs, 1.0, room_of(120.0));
  EXPECT_THAT(texts_of(small), ElementsAre("0.50", "0.50", "0.50"));
  EXPECT_TRUE(small.is_small);
  const GutterValues few = gutter_values(Strip::kSigma, runs, 1.0, room_of(100.0));
  EXPECT_THAT(few.values, SizeIs(2));
  EXPECT_EQ(few.left_out, 1U);
}

TEST(GutterValues, NeverTakeMoreThanTheRoom) {
  for (int count = 2; count <= 6; ++count) {
    const auto runs = runs_of(count);
    for (const Strip strip : {Strip::kPositionError, Strip::kSigma, Strip::kSampleSize}) {
      for (double width = 60.0; width < 400.0; width += 20.0) {
        const GutterRoom room = room_of(width);
        const GutterValues shown = gutter_values(strip, runs, 1.0, room);
        EXPECT_LE(width_of(shown, room), width) << count << enum_name(strip);
        EXPECT_EQ(shown.values.size() + shown.left_out, static_cast<std::size_t>(count));
      }
    }
  }
}

TEST(GutterValues, KeepTheActiveRunFirstAndEveryonesColour) {
  const auto runs = runs_of(4);
  const GutterValues shown = gutter_values(Strip::kAgreement, runs, 1.0, room_of(400.0));
  ASSERT_THAT(shown.values, SizeIs(4));
  for (int i = 0; i < 4; ++i) EXPECT_EQ(shown.values[static_cast<std::size_t>(i)].colour, i);
  EXPECT_EQ(gutter_values(Strip::kAgreement, runs, 1.0, room_of(1.0)).values[0].colour, 0);
}

TEST(ShortStripValue, IsTheMainOneAlone) {
  const TimelineRun run = timeline_run(made_document(50));
  EXPECT_EQ(short_strip_value(Strip::kSigma, run, 1.0), "0.50");
  EXPECT_EQ(short_strip_value(Strip::kSampleSize, run, 1.0), "500");
  EXPECT_EQ(short_strip_value(Strip::kPositionError, run, 1.0),
            strip_value(Strip::kPositionError, run, 1.0));
  EXPECT_EQ(short_strip_value(Strip::kSigma, run, 99.0), "–");
}

}  // namespace strip_gutter_test
}  // namespace nadir
