// SPDX-License-Identifier: Apache-2.0
// Where in time the mouse goes, on the ruler and on the strips.
#include <gmock/gmock.h>

#include <string>

#include "tests/widgets/panels/shown_timeline.h"

namespace nadir {
namespace timeline_scrub_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

TEST(TimelineScrubs, AClickGoesToThePixelsVeryTime) {
  ShownTimeline shown(timeline_of(made_document(1001)));
  const TimeAxis axis = shown.axis();
  for (const std::string path : {"Timeline/position-error", "Timeline/nees", "Timeline/streams"}) {
    for (const double at : {axis.left_px + 1.0, axis.left_px + 333.0, axis.right_px() - 1.0}) {
      const auto seeks = all_of<actions::Seek>(shown.click_x(path, at));
      ASSERT_THAT(seeks, SizeIs(1)) << path;
      EXPECT_DOUBLE_EQ(seeks[0].time_s, axis.time_s(at)) << path;
    }
  }
}

TEST(TimelineScrubs, AScrubSeeksAtEveryMoveAndEndsUnderTheMouse) {
  ShownTimeline shown(timeline_of(made_document(1001)));
  const TimeAxis axis = shown.axis();
  const auto seeks =
      all_of<actions::Seek>(shown.screen.drag("Timeline/agreement", 120.0, 0.0, shown.draw()));
  ASSERT_GE(seeks.size(), 3U);
  EXPECT_TRUE(std::is_sorted(seeks.begin(), seeks.end(),
                             [](const auto& a, const auto& b) { return a.time_s < b.time_s; }));
  const double start_px = shown.screen.at("Timeline/agreement").rect.centre().x();
  EXPECT_NEAR(seeks.front().time_s, axis.time_s(start_px), 1e-9);
  EXPECT_NEAR(seeks.back().time_s, axis.time_s(start_px + 120.0), 1e-9);
  EXPECT_FALSE(shown.state.is_scrubbing);
}

TEST(TimelineScrubs, AScrubBeyondTheEndsStaysInTheRun) {
  ShownTimeline shown(timeline_of(made_document(1001)));
  const auto right =
      all_of<actions::Seek>(shown.screen.drag("Timeline/agreement", 5000.0, 0.0, shown.draw()));
  EXPECT_DOUBLE_EQ(right.back().time_s, 100.0);
  const auto left =
      all_of<actions::Seek>(shown.screen.drag("Timeline/agreement", -5000.0, 0.0, shown.draw()));
  EXPECT_DOUBLE_EQ(left.back().time_s, 0.0);
}

TEST(TimelineScrubs, AClickOnANameGoesNowhere) {
  ShownTimeline shown(timeline_of(made_document(200)));
  EXPECT_THAT(all_of<actions::Seek>(shown.click_x("Timeline/nees", shown.axis().left_px - 20.0)),
              IsEmpty());
}

TEST(TimelineScrubs, MarksALoopWithShiftOrTheRightButton) {
  ShownTimeline shown(timeline_of(made_document(1001)));
  const TimeAxis axis = shown.axis();
  const double start_px = shown.screen.at("Timeline/Ruler").rect.centre().x();
  for (const bool is_shifted : {false, true}) {
    const auto asked =
        shown.screen.drag("Timeline/Ruler", -200.0, 0.0, shown.draw(),
                          is_shifted ? kit::MouseButton::kLeft : kit::MouseButton::kRight,
                          {.ctrl = false, .shift = is_shifted, .alt = false, .super = false});
    EXPECT_THAT(all_of<actions::Seek>(asked), IsEmpty());
    const auto loops = all_of<actions::SetLoop>(asked);
    ASSERT_FALSE(loops.empty());
    EXPECT_NEAR(loops.back().from_s.value(), axis.time_s(start_px - 200.0), 1e-9);
    EXPECT_NEAR(loops.back().to_s.value(), axis.time_s(start_px), 1e-9);
  }
  shown.model.loop_from_s = 10.0;
  shown.model.loop_to_s = 20.0;
  shown.screen.wait(2, shown.draw());
  EXPECT_TRUE(shown.screen.shows("00:10.0 – 00:20.0"));
  EXPECT_THAT(shown.screen.click("Timeline/Loop off", shown.draw()),
              ElementsAre(Action(actions::SetLoop{})));
}

TEST(TimelineScrubs, ALeftDragOnTheRulerScrubs) {
  ShownTimeline shown(timeline_of(made_document(1001)));
  const auto asked = shown.screen.drag("Timeline/Ruler", 100.0, 0.0, shown.draw());
  EXPECT_GE(all_of<actions::Seek>(asked).size(), 3U);
  EXPECT_THAT(all_of<actions::SetLoop>(asked), IsEmpty());
}

TEST(TimelineScrubs, MarksAreHitExactlyAndSayWhatTheyAre) {
  TimelineModel model = timeline_of(made_document(1001));
  WorstMoment moment;
  moment.time_s = 33.3;
  moment.kind = MomentKind::kLost;
  moment.words = "12 m off";
  model.moments = {moment};
  model.bookmarks = {Bookmark{66.6, "odd turn", {}}};
  ShownTimeline shown(model);
  const TimeAxis axis = shown.axis();
  EXPECT_THAT(shown.click_x("Timeline/Ruler", std::round(axis.x_px(33.3)) + 2.0),
              ElementsAre(Action(actions::GoToMoment{33.3})));
  EXPECT_THAT(shown.screen.tooltip(), HasSubstr("12 m off"));
  EXPECT_THAT(shown.click_x("Timeline/Ruler", std::round(axis.x_px(66.6)) - 2.0),
              ElementsAre(Action(actions::GoToMoment{66.6})));
  EXPECT_THAT(shown.screen.tooltip(), HasSubstr("odd turn"));
}

TEST(TimelineScrubs, AMarkIsHitInItsLaneOnlyAndNeverStopsAScrub) {
  ShownTimeline shown(timeline_of(made_document(1001)));
  WorstMoment moment;
  moment.kind = MomentKind::kLost;
  const kit::Rect ruler = shown.screen.at("Timeline/Ruler").rect;
  const double x = ruler.centre().x();
  moment.time_s = shown.axis().time_s(x - 3.0);
  shown.model.moments = {moment};
  const double from_left = x - ruler.left;
  EXPECT_THAT(
      all_of<actions::Seek>(shown.screen.click_at("Timeline/Ruler", from_left, 6.0, shown.draw())),
      ElementsAre(actions::Seek{shown.axis().time_s(x)}))
      << "above the marks";
  EXPECT_THAT(shown.screen.click_at("Timeline/Ruler", from_left, ruler.height - 6.0, shown.draw()),
              ElementsAre(Action(actions::GoToMoment{moment.time_s})));
  const auto asked = shown.screen.drag("Timeline/Ruler", 100.0, 0.0, shown.draw());
  ASSERT_FALSE(asked.empty());
  EXPECT_EQ(asked.front(), Action(actions::GoToMoment{moment.time_s})) << "it began on the mark";
  EXPECT_THAT(all_of<actions::GoToMoment>(asked), SizeIs(1)) << "what follows only seeks";
  const auto seeks = all_of<actions::Seek>(asked);
  ASSERT_GE(seeks.size(), 2U);
  EXPECT_NEAR(seeks.back().time_s, shown.axis().time_s(x + 100.0), 1e-9);
  EXPECT_FALSE(shown.state.is_scrubbing);
}

TEST(TimelineScrubs, TheRulersMenuIsAboutThePlaceWhereItWasOpened) {
  ShownTimeline shown(timeline_of(made_document(1001)));
  shown.model.time_s = 3.0;
  shown.screen.right_click("Timeline/Ruler", shown.draw());
  const double here_s = shown.axis().time_s(shown.screen.at("Timeline/Ruler").rect.centre().x());
  const auto loops = all_of<actions::SetLoop>(
      shown.screen.click("Timeline/Ruler menu/Play from here again and again", shown.draw()));
  ASSERT_THAT(loops, SizeIs(1));
  EXPECT_NEAR(loops[0].from_s.value(), here_s, 1e-9);
  EXPECT_NEAR(loops[0].to_s.value(), 100.0, 1e-9);
}

TEST(TimelineScrubs, TheWheelZoomsAroundTheMouse) {
  ShownTimeline shown(timeline_of(made_document(1001)));
  const double x = shown.screen.at("Timeline/Ruler").rect.centre().x();
  const double before_s = shown.axis().time_s(x);
  shown.screen.scroll("Timeline/Ruler", 3.0, shown.draw());
  ASSERT_TRUE(shown.state.zoomed_to);
  EXPECT_LT(shown.state.zoomed_to->to_s - shown.state.zoomed_to->from_s, 60.0);
  EXPECT_NEAR(shown.axis().time_s(x), before_s, 1e-6);
  shown.screen.scroll("Timeline/Ruler", -10.0, shown.draw());
  EXPECT_FALSE(shown.state.zoomed_to) << "all of it again";
}

TEST(TimelineScrubs, TurnsThePageWhenTheCursorLeavesWhatShows) {
  ShownTimeline shown(timeline_of(made_document(1001)));
  shown.state.zoomed_to = TimeSpan{10.0, 20.0};
  shown.model.time_s = 50.0;
  shown.screen.wait(1, shown.draw());
  EXPECT_NEAR(shown.state.zoomed_to->from_s, 49.0, 1e-9);
  EXPECT_NEAR(shown.state.zoomed_to->to_s, 59.0, 1e-9);
}

}  // namespace timeline_scrub_test
}  // namespace nadir
