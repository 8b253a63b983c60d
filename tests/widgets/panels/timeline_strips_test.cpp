// SPDX-License-Identifier: Apache-2.0
// The strips: which, how high, in which order, and what they say.
#include <gmock/gmock.h>

#include <string>

#include "tests/widgets/panels/shown_timeline.h"

namespace nadir {
namespace timeline_strips_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(TimelineStrips, HasAStripForEachThatIsChosenAndNoOther) {
  TimelineModel model = timeline_of(made_document(200));
  model.strips[1].is_visible = false;
  ShownTimeline shown(model);
  for (const StripLook& look : model.strips) {
    EXPECT_EQ(shown.screen.has("Timeline/" + std::string(enum_name(look.strip))), look.is_visible)
        << shown.screen.words();
  }
}

TEST(TimelineStrips, HoverSaysTimeAndValue) {
  ShownTimeline shown(timeline_of(made_document(1001)));
  shown.screen.hover("Timeline/update-time", shown.draw());
  EXPECT_THAT(shown.screen.tooltip(), HasSubstr("10.0 ms"));
  const double x = shown.screen.at("Timeline/update-time").rect.centre().x();
  EXPECT_THAT(shown.screen.tooltip(), HasSubstr(clock_text(shown.axis().time_s(x))));
}

TEST(TimelineStrips, StripsAreChosenByTheMenuAndByTheirOwn) {
  ShownTimeline shown(timeline_of(made_document(200)));
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

TEST(TimelineStrips, AStripIsResizedByItsLowerEdge) {
  ShownTimeline shown(timeline_of(made_document(200)));
  const double before_pt = shown.model.strips[0].height_pt;
  const auto asked = shown.screen.drag("Timeline/position-error height", 0.0, 25.0, shown.draw());
  const auto heights = all_of<actions::SetStripHeight>(asked);
  ASSERT_FALSE(heights.empty());
  EXPECT_EQ(heights.back().strip, Strip::kPositionError);
  EXPECT_DOUBLE_EQ(heights.back().height_pt, before_pt + 25.0);
}

TEST(TimelineStrips, AStripIsMovedByItsName) {
  ShownTimeline shown(timeline_of(made_document(200)));
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

TEST(TimelineStrips, ThinsOnlyWhenRunsOrWidthChange) {
  ShownTimeline shown(timeline_of(made_document(1001)));
  const double* const kept = shown.state.plots[0]->curves[0].line.x.data();
  shown.model.time_s = 5.0;
  shown.screen.wait(3, shown.draw());
  EXPECT_EQ(shown.state.plots[0]->curves[0].line.x.data(), kept);
  shown.model.runs[0].document = made_document(1002);
  shown.screen.wait(1, shown.draw());
  EXPECT_GT(shown.state.plots[0]->curves[0].line.x.back(), 100.05) << "a live run has grown";
}

TEST(TimelineStrips, LeftOfAStripItsTooltipSaysWhatMayBeCutThere) {
  TimelineModel model = timeline_of(made_document(501));
  model.runs.insert(model.runs.begin(), timeline_run(made_document(501), false, 2));
  ShownTimeline shown(model);
  const kit::Rect strip = shown.screen.at("Timeline/sigma").rect;
  shown.screen.input().mouse_px = Eigen::Vector2d(strip.left + 40.0, strip.centre().y());
  shown.screen.wait(3, shown.draw());
  EXPECT_THAT(shown.screen.tooltip(), HasSubstr("Standard deviation [m]"));
  EXPECT_THAT(shown.screen.tooltip(), HasSubstr("made  0.50 0.50"));
  EXPECT_THAT(shown.screen.tooltip(), HasSubstr("other  0.50 0.50"));
}

TEST(TimelineStrips, OfWhichThreeAreWholeInTheUsualHeightAtAllScales) {
  for (const double scale : {0.75, 1.0, 1.1, 1.25, 1.5, 2.0, 3.0}) {
    TimelineModel model = timeline_of(made_document(200));
    model.strips = default_layout().strips;
    kit::HeadlessUi screen(ThemeName::kDark, scale, {1280.0 * scale, 700.0 * scale});
    screen.leave_out_region();
    TimelineState state;
    double bottom = 0.0;
    screen.wait(3, [&](kit::Ui& ui) {
      bottom = ui.px(default_layout().timeline_pt);
      const auto region = ui.region("Bottom", {0.0, 0.0, ui.px(1280.0), bottom},
                                    {.padding = ui.px(kTimelinePadding), .has_border = true});
      return draw_timeline(ui, model, state);
    });
    int shown = 0;
    for (const StripLook& look : model.strips) {
      if (!look.is_visible || shown == 3) continue;
      const std::string path = "Bottom/Timeline/" + std::string(enum_name(look.strip));
      EXPECT_LE(screen.at(path + " height").rect.bottom(), bottom - 1.0) << path << ", " << scale;
      EXPECT_GE(screen.at(path).rect.height, std::floor(34.0 * scale)) << "values have room";
      ++shown;
    }
    EXPECT_EQ(shown, 3);
  }
}

}  // namespace timeline_strips_test
}  // namespace nadir
