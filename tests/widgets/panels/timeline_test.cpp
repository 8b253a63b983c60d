// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/timeline.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <string>

#include "tests/widgets/panels/timeline_run.h"
#include "widgets/kit/headless_ui.h"
#include "widgets/panels/time_axis.h"

namespace nadir {
namespace timeline_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// A timeline on a screen, driven by hand; the model is the test's.
struct Shown {
  explicit Shown(TimelineModel shown, double scale = 1.0)
      : model(std::move(shown)), screen(ThemeName::kDark, scale, {1280.0, 700.0}) {
    asked = screen.wait(3, draw());
  }
  [[nodiscard]] std::function<Actions(kit::Ui&)> draw() {
    return [this](kit::Ui& ui) { return draw_timeline(ui, model, state); };
  }
  /// The axis as its own drawing has it: the ruler's area without the names and the margin.
  [[nodiscard]] TimeAxis axis() const {
    const kit::Rect ruler = screen.at("Timeline/Ruler").rect;
    TimeAxis found;
    const auto extent = model.extent();
    found.from_s = state.zoomed_to ? state.zoomed_to->from_s : extent.from_s;
    found.to_s = state.zoomed_to ? state.zoomed_to->to_s : extent.to_s;
    found.last_s = extent.last_s;
    const double scale = screen_scale;
    found.left_px = std::floor(ruler.left + std::floor(192.0 * scale + 0.5));
    found.width_px = std::floor(ruler.right() - std::floor(16.0 * scale + 0.5)) - found.left_px;
    return found;
  }
  /// Clicks at a pixel of the window's x in an area.
  Actions click_x(const std::string& path, double window_x) {
    const kit::Rect rect = screen.at(path).rect;
    return screen.click_at(path, window_x - rect.left, rect.height / 2.0, draw());
  }

  TimelineModel model;
  TimelineState state;
  kit::HeadlessUi screen;
  Actions asked;
  double screen_scale = 1.0;
};

TEST(Timeline, AsksForNothingUntouched) {
  Shown shown(timeline_of(made_document(200)));
  EXPECT_THAT(shown.asked, IsEmpty());
}

TEST(Timeline, HasAStripForEachThatIsChosenAndNoOther) {
  TimelineModel model = timeline_of(made_document(200));
  model.strips[1].is_visible = false;
  Shown shown(model);
  for (const StripLook& look : model.strips) {
    EXPECT_EQ(shown.screen.has("Timeline/" + std::string(enum_name(look.strip))), look.is_visible)
        << shown.screen.words();
  }
}

TEST(Timeline, TransportAsksForItsActions) {
  Shown shown(timeline_of(made_document(200)));
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
  Shown shown(timeline_of(made_document(200)));
  shown.screen.click("Timeline/##Speed", shown.draw());
  EXPECT_THAT(shown.screen.click("Timeline/##Speed/20×", shown.draw()),
              ElementsAre(Action(actions::SetSpeed{20.0})));
  shown.model.speed = 3.0;
  shown.screen.wait(2, shown.draw());
  EXPECT_EQ(shown.screen.at("Timeline/##Speed").value, "3×");
}

TEST(Timeline, TakesATypedTimeAndHoldsItInTheRun) {
  Shown shown(timeline_of(made_document(201)));
  shown.model.time_s = 7.25;
  shown.screen.wait(2, shown.draw());
  EXPECT_TRUE(shown.screen.shows("/ 00:20.0")) << shown.screen.words();
  EXPECT_THAT(all_of<actions::Seek>(shown.screen.type("Timeline/##Time", "0:12.5", shown.draw())),
              testing::Contains(actions::Seek{12.5}));
  EXPECT_THAT(all_of<actions::Seek>(shown.screen.type("Timeline/##Time", "500", shown.draw())),
              testing::Contains(actions::Seek{20.0}));
  EXPECT_THAT(all_of<actions::Seek>(shown.screen.type("Timeline/##Time", "soon", shown.draw())),
              IsEmpty());
}

TEST(Timeline, AClickGoesToThePixelsVeryTime) {
  Shown shown(timeline_of(made_document(1001)));
  const TimeAxis axis = shown.axis();
  for (const std::string path : {"Timeline/position-error", "Timeline/nees", "Timeline/streams"}) {
    for (const double at : {axis.left_px + 1.0, axis.left_px + 333.0, axis.right_px() - 1.0}) {
      const auto seeks = all_of<actions::Seek>(shown.click_x(path, at));
      ASSERT_THAT(seeks, SizeIs(1)) << path;
      EXPECT_DOUBLE_EQ(seeks[0].time_s, axis.time_s(at)) << path;
    }
  }
}

TEST(Timeline, AScrubSeeksAtEveryMoveAndEndsUnderTheMouse) {
  Shown shown(timeline_of(made_document(1001)));
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

TEST(Timeline, AScrubBeyondTheEndsStaysInTheRun) {
  Shown shown(timeline_of(made_document(1001)));
  const auto right =
      all_of<actions::Seek>(shown.screen.drag("Timeline/agreement", 5000.0, 0.0, shown.draw()));
  EXPECT_DOUBLE_EQ(right.back().time_s, 100.0);
  const auto left =
      all_of<actions::Seek>(shown.screen.drag("Timeline/agreement", -5000.0, 0.0, shown.draw()));
  EXPECT_DOUBLE_EQ(left.back().time_s, 0.0);
}

TEST(Timeline, AClickOnANameGoesNowhere) {
  Shown shown(timeline_of(made_document(200)));
  EXPECT_THAT(all_of<actions::Seek>(shown.click_x("Timeline/nees", shown.axis().left_px - 20.0)),
              IsEmpty());
}

TEST(Timeline, MarksALoopWithShiftOrTheRightButton) {
  Shown shown(timeline_of(made_document(1001)));
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

TEST(Timeline, ALeftDragOnTheRulerScrubs) {
  Shown shown(timeline_of(made_document(1001)));
  const auto asked = shown.screen.drag("Timeline/Ruler", 100.0, 0.0, shown.draw());
  EXPECT_GE(all_of<actions::Seek>(asked).size(), 3U);
  EXPECT_THAT(all_of<actions::SetLoop>(asked), IsEmpty());
}

TEST(Timeline, MarksAreHitExactlyAndSayWhatTheyAre) {
  TimelineModel model = timeline_of(made_document(1001));
  WorstMoment moment;
  moment.time_s = 33.3;
  moment.kind = MomentKind::kLost;
  moment.words = "12 m off";
  model.moments = {moment};
  model.bookmarks = {Bookmark{66.6, "odd turn", {}}};
  Shown shown(model);
  const TimeAxis axis = shown.axis();
  EXPECT_THAT(
      all_of<actions::Seek>(shown.click_x("Timeline/Ruler", std::round(axis.x_px(33.3)) + 2.0)),
      ElementsAre(actions::Seek{33.3}));
  EXPECT_THAT(shown.screen.tooltip(), HasSubstr("12 m off"));
  EXPECT_THAT(
      all_of<actions::Seek>(shown.click_x("Timeline/Ruler", std::round(axis.x_px(66.6)) - 2.0)),
      ElementsAre(actions::Seek{66.6}));
  EXPECT_THAT(shown.screen.tooltip(), HasSubstr("odd turn"));
}

TEST(Timeline, AMarkIsHitInItsLaneOnlyAndNeverStopsAScrub) {
  Shown shown(timeline_of(made_document(1001)));
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
  EXPECT_THAT(all_of<actions::Seek>(shown.screen.click_at("Timeline/Ruler", from_left,
                                                          ruler.height - 6.0, shown.draw())),
              ElementsAre(actions::Seek{moment.time_s}));
  const auto seeks =
      all_of<actions::Seek>(shown.screen.drag("Timeline/Ruler", 100.0, 0.0, shown.draw()));
  ASSERT_GE(seeks.size(), 3U);
  EXPECT_EQ(seeks.front(), actions::Seek{moment.time_s}) << "it began on the mark";
  EXPECT_NEAR(seeks.back().time_s, shown.axis().time_s(x + 100.0), 1e-9);
  EXPECT_FALSE(shown.state.is_scrubbing);
}

TEST(Timeline, TheRulersMenuIsAboutThePlaceWhereItWasOpened) {
  Shown shown(timeline_of(made_document(1001)));
  shown.model.time_s = 3.0;
  shown.screen.right_click("Timeline/Ruler", shown.draw());
  const double here_s = shown.axis().time_s(shown.screen.at("Timeline/Ruler").rect.centre().x());
  const auto loops = all_of<actions::SetLoop>(
      shown.screen.click("Timeline/Ruler menu/Play from here again and again", shown.draw()));
  ASSERT_THAT(loops, SizeIs(1));
  EXPECT_NEAR(loops[0].from_s.value(), here_s, 1e-9);
  EXPECT_NEAR(loops[0].to_s.value(), 100.0, 1e-9);
}

TEST(Timeline, HoverSaysTimeAndValue) {
  Shown shown(timeline_of(made_document(1001)));
  shown.screen.hover("Timeline/update-time", shown.draw());
  EXPECT_THAT(shown.screen.tooltip(), HasSubstr("10.0 ms"));
  const double x = shown.screen.at("Timeline/update-time").rect.centre().x();
  EXPECT_THAT(shown.screen.tooltip(), HasSubstr(clock_text(shown.axis().time_s(x))));
}

TEST(Timeline, StripsAreChosenByTheMenuAndByTheirOwn) {
  Shown shown(timeline_of(made_document(200)));
  shown.screen.click("Timeline/Strips", shown.draw());
  EXPECT_THAT(shown.screen.click("Timeline/Strips/NEES", shown.draw()),
              ElementsAre(Action(actions::ShowStrip{Strip::kNees, Switch::kToggle})));
  shown.screen.right_click("Timeline/agreement", shown.draw());
  EXPECT_THAT(shown.screen.click("Timeline/agreement menu/Hide", shown.draw()),
              ElementsAre(Action(actions::ShowStrip{Strip::kAgreement, Switch::kOff})));
  shown.screen.right_click("Timeline/agreement", shown.draw());
  EXPECT_THAT(shown.screen.click("Timeline/agreement menu/Move up", shown.draw()),
              ElementsAre(Action(actions::MoveStrip{Strip::kAgreement, -1})));
}

TEST(Timeline, AStripIsResizedByItsLowerEdge) {
  Shown shown(timeline_of(made_document(200)));
  const double before_pt = shown.model.strips[0].height_pt;
  const auto asked = shown.screen.drag("Timeline/position-error height", 0.0, 25.0, shown.draw());
  const auto heights = all_of<actions::SetStripHeight>(asked);
  ASSERT_FALSE(heights.empty());
  EXPECT_EQ(heights.back().strip, Strip::kPositionError);
  EXPECT_DOUBLE_EQ(heights.back().height_pt, before_pt + 25.0);
}

TEST(Timeline, AStripIsMovedByItsName) {
  Shown shown(timeline_of(made_document(200)));
  const kit::Rect from = shown.screen.at("Timeline/position-error").rect;
  const kit::Rect to = shown.screen.at("Timeline/sigma").rect;
  kit::FrameInput& input = shown.screen.input();
  const auto draw = shown.draw();
  Actions asked;
  const auto frame = [&] {
    for (Action& action : shown.screen.frame(draw)) asked.push_back(std::move(action));
  };
  input.mouse_px = Eigen::Vector2d(from.left + 30.0, from.centre().y());
  frame();
  input.buttons[0] = true;
  frame();
  input.mouse_px = Eigen::Vector2d(from.left + 30.0, to.centre().y());
  frame();
  frame();
  input.buttons[0] = false;
  frame();
  EXPECT_THAT(asked, ElementsAre(Action(actions::MoveStrip{Strip::kPositionError, 2})));
}

TEST(Timeline, TheWheelZoomsAroundTheMouse) {
  Shown shown(timeline_of(made_document(1001)));
  const double x = shown.screen.at("Timeline/Ruler").rect.centre().x();
  const double before_s = shown.axis().time_s(x);
  shown.screen.scroll("Timeline/Ruler", 3.0, shown.draw());
  ASSERT_TRUE(shown.state.zoomed_to);
  EXPECT_LT(shown.state.zoomed_to->to_s - shown.state.zoomed_to->from_s, 60.0);
  EXPECT_NEAR(shown.axis().time_s(x), before_s, 1e-6);
  shown.screen.scroll("Timeline/Ruler", -10.0, shown.draw());
  EXPECT_FALSE(shown.state.zoomed_to) << "all of it again";
}

TEST(Timeline, TurnsThePageWhenTheCursorLeavesWhatShows) {
  Shown shown(timeline_of(made_document(1001)));
  shown.state.zoomed_to = TimeSpan{10.0, 20.0};
  shown.model.time_s = 50.0;
  shown.screen.wait(1, shown.draw());
  EXPECT_NEAR(shown.state.zoomed_to->from_s, 49.0, 1e-9);
  EXPECT_NEAR(shown.state.zoomed_to->to_s, 59.0, 1e-9);
}

TEST(Timeline, ThinsOnlyWhenRunsOrWidthChange) {
  Shown shown(timeline_of(made_document(1001)));
  const double* const kept = shown.state.plots[0]->curves[0].line.x.data();
  shown.model.time_s = 5.0;
  shown.screen.wait(3, shown.draw());
  EXPECT_EQ(shown.state.plots[0]->curves[0].line.x.data(), kept);
  shown.model.runs[0].document = made_document(1002);
  shown.screen.wait(1, shown.draw());
  EXPECT_GT(shown.state.plots[0]->curves[0].line.x.back(), 100.05) << "a live run has grown";
}

TEST(Timeline, OfTwoRunsOfDifferentLengthShowsBothAndSeeksInTheActiveOne) {
  TimelineModel model = timeline_of(made_document(501));
  model.runs.insert(model.runs.begin(), timeline_run(made_document(1001), false, 2));
  Shown shown(model);
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
    Shown shown(timeline_of(made_document(steps)));
    EXPECT_TRUE(shown.screen.has("Timeline/nees"));
    for (const auto& seek :
         all_of<actions::Seek>(shown.click_x("Timeline/nees", shown.axis().left_px + 300.0)))
      EXPECT_EQ(seek.time_s, 0.0);
  }
  Shown blind(timeline_of(made_document(100, [](RunStep& step) { step.truth_in_enu.reset(); })));
  blind.screen.hover("Timeline/position-error", blind.draw());
  EXPECT_THAT(blind.screen.tooltip(), HasSubstr("–"));
}

TEST(Timeline, TheMarksHaveAKeyLeftOfTheRuler) {
  Shown shown(timeline_of(made_document(200)));
  const kit::Rect ruler = shown.screen.at("Timeline/Ruler").rect;
  shown.screen.input().mouse_px = Eigen::Vector2d(ruler.left + 40.0, ruler.centre().y());
  shown.screen.wait(3, shown.draw());
  EXPECT_THAT(shown.screen.tooltip(),
              HasSubstr("full red diamond: largest error, high NEES, lost"));
  EXPECT_THAT(shown.screen.tooltip(), HasSubstr("blue flag: your bookmark"));
}

TEST(Timeline, LeftOfAStripItsTooltipSaysWhatMayBeCutThere) {
  TimelineModel model = timeline_of(made_document(501));
  model.runs.insert(model.runs.begin(), timeline_run(made_document(501), false, 2));
  Shown shown(model);
  const kit::Rect strip = shown.screen.at("Timeline/sigma").rect;
  shown.screen.input().mouse_px = Eigen::Vector2d(strip.left + 40.0, strip.centre().y());
  shown.screen.wait(3, shown.draw());
  EXPECT_THAT(shown.screen.tooltip(), HasSubstr("Standard deviation [m]"));
  EXPECT_THAT(shown.screen.tooltip(), HasSubstr("made  0.50 0.50"));
  EXPECT_THAT(shown.screen.tooltip(), HasSubstr("other  0.50 0.50"));
}

TEST(Timeline, ARunThatWasStoppedShowsWhereAndWhatIsMissing) {
  RunDocument made = made_run(501);
  made.is_complete = false;
  TimelineModel model = timeline_of(RunDocument::from_steps(made));
  model.runs[0].is_incomplete = true;
  model.runs.insert(model.runs.begin(), timeline_run(made_document(1001), false, 2));
  Shown shown(model);
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
  Shown shown(TimelineModel{});
  EXPECT_FALSE(shown.screen.has("Timeline/Ruler"));
  EXPECT_THAT(shown.screen.click("Timeline/Open the demo", shown.draw()),
              ElementsAre(Action(actions::OpenDemo{})));
  shown.model.reading = "loop";
  shown.screen.wait(2, shown.draw());
  EXPECT_TRUE(shown.screen.shows("loop is being read")) << shown.screen.words();
}

TEST(Timeline, KeepsWhatItsLineHasNoRoomForInAMenu) {
  Shown shown(timeline_of(made_document(200)), 2.5);
  EXPECT_FALSE(shown.screen.has("Timeline/Next worst moment"));
  EXPECT_GE(shown.screen.at("Timeline/More").rect.left,
            shown.screen.at("Timeline/##Time").rect.right());
  EXPECT_THAT(shown.screen.click("Timeline/More/Next worst moment", shown.draw()),
              ElementsAre(Action(actions::GoTo{Moment::kNextWorst})));
  EXPECT_THAT(shown.screen.click("Timeline/More/Bookmark this moment", shown.draw()),
              ElementsAre(Action(actions::ShowOverlay{Overlay::kBookmark})));
}

TEST(Timeline, GrowsWithTheScale) {
  Shown shown(timeline_of(made_document(1001)), 1.5);
  shown.screen_scale = 1.5;
  const TimeAxis axis = shown.axis();
  const auto seeks = all_of<actions::Seek>(shown.click_x("Timeline/sigma", axis.left_px + 100.0));
  ASSERT_THAT(seeks, SizeIs(1));
  EXPECT_NEAR(seeks[0].time_s, axis.time_s(axis.left_px + 100.0), 0.5 / axis.px_per_s());
}

}  // namespace timeline_test
}  // namespace nadir
