// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/timeline.h"

#include <gmock/gmock.h>

#include <string>

#include "tests/widgets/panels/shown_timeline.h"

namespace nadir {
namespace timeline_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

TEST(Timeline, AsksForNothingUntouched) {
  ShownTimeline shown(timeline_of(made_document(200)));
  EXPECT_THAT(shown.asked, IsEmpty());
}

TEST(Timeline, TransportAsksForItsActions) {
  ShownTimeline shown(timeline_of(made_document(200)));
  const auto click = [&](const std::string& name) {
    return shown.screen.click("Timeline/" + name, shown.draw());
  };
  EXPECT_THAT(click("Play"), ElementsAre(Action(actions::Play{Switch::kToggle})));
  EXPECT_THAT(click("Step on"), ElementsAre(Action(actions::StepBy{1})));
  EXPECT_THAT(click("Step back"), ElementsAre(Action(actions::StepBy{-1})));
  EXPECT_THAT(click("First"), ElementsAre(Action(actions::GoTo{Moment::kStart})));
  EXPECT_THAT(click("Last"), ElementsAre(Action(actions::GoTo{Moment::kEnd})));
  EXPECT_THAT(click("Previous worst moment"),
              ElementsAre(Action(actions::GoTo{Moment::kPreviousWorst})));
  EXPECT_THAT(click("Next worst moment"), ElementsAre(Action(actions::GoTo{Moment::kNextWorst})));
  EXPECT_THAT(click("Bookmark"), ElementsAre(Action(actions::ShowOverlay{Overlay::kBookmark})));
}

TEST(Timeline, SpeedHasStepsAndKeepsOneBetweenThem) {
  ShownTimeline shown(timeline_of(made_document(200)));
  shown.screen.click("Timeline/##Speed", shown.draw());
  EXPECT_THAT(shown.screen.click("Timeline/##Speed/20×", shown.draw()),
              ElementsAre(Action(actions::SetSpeed{20.0})));
  shown.model.speed = 3.0;
  shown.screen.wait(2, shown.draw());
  EXPECT_EQ(shown.screen.at("Timeline/##Speed").value, "3×");
}

TEST(Timeline, TakesATypedTimeAndHoldsItInTheRun) {
  ShownTimeline shown(timeline_of(made_document(201)));
  shown.model.time_s = 7.25;
  shown.screen.wait(2, shown.draw());
  EXPECT_TRUE(shown.screen.shows("/ 00:20.0")) << shown.screen.words();
  EXPECT_THAT(all_of<actions::Seek>(shown.screen.type("Timeline/##Time", "0:12.5", shown.draw())),
              testing::Contains(actions::Seek{12.5}));
  EXPECT_THAT(all_of<actions::Seek>(shown.screen.type("Timeline/##Time", "500", shown.draw())),
              testing::Contains(actions::Seek{20.0}));
  EXPECT_EQ(shown.state.fault, "");
  EXPECT_THAT(all_of<actions::Seek>(shown.screen.type("Timeline/##Time", "soon", shown.draw())),
              IsEmpty());
  EXPECT_EQ(
      shown.state.fault,
      "'soon' is no time: type seconds, such as 62.5, or minutes and seconds, such as 1:02.5");
  shown.state.fault.clear();
  shown.screen.type("Timeline/##Time", "", shown.draw());
  EXPECT_EQ(shown.state.fault, "") << "nothing was typed";
}

TEST(Timeline, OfTwoRunsOfDifferentLengthShowsBothAndSeeksInTheActiveOne) {
  TimelineModel model = timeline_of(made_document(501));
  model.runs.insert(model.runs.begin(), timeline_run(made_document(1001), false, 2));
  ShownTimeline shown(model);
  const TimeAxis axis = shown.axis();
  EXPECT_NEAR(axis.to_s, 100.0, 1e-9);
  const auto seeks = all_of<actions::Seek>(shown.click_x("Timeline/nees", axis.x_px(80.0)));
  EXPECT_THAT(seeks, ElementsAre(actions::Seek{50.0}));
  shown.screen.hover("Timeline/agreement", shown.draw());
  EXPECT_THAT(shown.screen.tooltip(), HasSubstr("made"));
  EXPECT_THAT(shown.screen.tooltip(), HasSubstr("other"));
}

TEST(Timeline, OfOneStepOrNoneOrWithoutTruthIsDrawn) {
  for (const int steps : {0, 1}) {
    ShownTimeline shown(timeline_of(made_document(steps)));
    EXPECT_TRUE(shown.screen.has("Timeline/nees"));
    for (const auto& seek :
         all_of<actions::Seek>(shown.click_x("Timeline/nees", shown.axis().left_px + 300.0)))
      EXPECT_EQ(seek.time_s, 0.0);
  }
  ShownTimeline blind(
      timeline_of(made_document(100, [](RunStep& step) { step.truth_in_enu.reset(); })));
  blind.screen.hover("Timeline/position-error", blind.draw());
  EXPECT_THAT(blind.screen.tooltip(), HasSubstr("–"));
}

TEST(Timeline, TheMarksHaveAKeyLeftOfTheRuler) {
  ShownTimeline shown(timeline_of(made_document(200)));
  const kit::Rect ruler = shown.screen.at("Timeline/Ruler").rect;
  shown.screen.input().mouse_px = Eigen::Vector2d(ruler.left + 40.0, ruler.centre().y());
  shown.screen.wait(3, shown.draw());
  EXPECT_THAT(shown.screen.tooltip(),
              HasSubstr("full red diamond, wrong: largest error, high NEES, lost"));
  EXPECT_THAT(shown.screen.tooltip(), HasSubstr("blue flag: your bookmark"));
}

TEST(Timeline, ARunThatWasStoppedShowsWhereAndWhatIsMissing) {
  RunDocument made = made_run(501);
  made.is_complete = false;
  TimelineModel model = timeline_of(RunDocument::from_steps(made));
  model.runs[0].is_incomplete = true;
  model.runs.insert(model.runs.begin(), timeline_run(made_document(1001), false, 2));
  ShownTimeline shown(model);
  const TimeAxis axis = shown.axis();
  const auto hover_x = [&](const std::string& path, double x) {
    const kit::Rect rect = shown.screen.at(path).rect;
    shown.screen.input().mouse_px = Eigen::Vector2d(x, rect.centre().y());
    shown.screen.wait(2, shown.draw());
    return shown.screen.tooltip();
  };
  EXPECT_THAT(hover_x("Timeline/Ruler", std::round(axis.x_px(50.0))),
              HasSubstr("made is incomplete · stopped at 00:50.0, after 501 steps"));
  EXPECT_THAT(hover_x("Timeline/agreement", axis.x_px(70.0)),
              HasSubstr("made  stopped at 00:50.0, after 501 steps"));
  EXPECT_THAT(hover_x("Timeline/agreement", axis.x_px(30.0)), testing::Not(HasSubstr("stopped")));
}

TEST(Timeline, WithoutARunOffersTheDemo) {
  ShownTimeline shown(TimelineModel{});
  EXPECT_FALSE(shown.screen.has("Timeline/Ruler"));
  EXPECT_THAT(shown.screen.click("Timeline/Open the demo", shown.draw()),
              ElementsAre(Action(actions::OpenDemo{})));
  shown.model.reading = "loop";
  shown.screen.wait(2, shown.draw());
  EXPECT_TRUE(shown.screen.shows("loop is being read")) << shown.screen.words();
}

TEST(Timeline, KeepsWhatItsLineHasNoRoomForInAMenu) {
  ShownTimeline shown(timeline_of(made_document(200)), 2.5);
  EXPECT_FALSE(shown.screen.has("Timeline/Next worst moment"));
  EXPECT_GE(shown.screen.at("Timeline/More").rect.left,
            shown.screen.at("Timeline/##Time").rect.right());
  EXPECT_THAT(shown.screen.click("Timeline/More/Next worst moment", shown.draw()),
              ElementsAre(Action(actions::GoTo{Moment::kNextWorst})));
  EXPECT_THAT(shown.screen.click("Timeline/More/Bookmark this moment", shown.draw()),
              ElementsAre(Action(actions::ShowOverlay{Overlay::kBookmark})));
}

TEST(Timeline, GrowsWithTheScale) {
  ShownTimeline shown(timeline_of(made_document(1001)), 1.5);
  shown.screen_scale = 1.5;
  const TimeAxis axis = shown.axis();
  const auto seeks = all_of<actions::Seek>(shown.click_x("Timeline/sigma", axis.left_px + 100.0));
  ASSERT_THAT(seeks, SizeIs(1));
  EXPECT_NEAR(seeks[0].time_s, axis.time_s(axis.left_px + 100.0), 0.5 / axis.px_per_s());
}

}  // namespace timeline_test
}  // namespace nadir
