// SPDX-License-Identifier: Apache-2.0
#include "tests/core/session/session_fixture.h"

namespace nadir {
namespace session_layout_test {

using testing::ElementsAre;
using testing::HasSubstr;

class SessionLayoutTest : public SessionTest {
 protected:
  [[nodiscard]] const WindowLayout& layout() const { return session_->view().layout; }
  [[nodiscard]] std::size_t place_of(Strip strip) const {
    std::size_t i = 0;
    while (layout().strips.at(i).strip != strip) ++i;
    return i;
  }
};

TEST_F(SessionLayoutTest, BringsAPanelForwardBeforeItsKeyHidesIt) {
  EXPECT_EQ(layout().right_tab, Panel::kMoment);
  act("panel why");
  EXPECT_TRUE(layout().shows(Panel::kWhy));
  EXPECT_EQ(layout().right_tab, Panel::kWhy) << "it was behind another tab";
  act("panel why");
  EXPECT_FALSE(layout().shows(Panel::kWhy));
  EXPECT_EQ(layout().right_tab, Panel::kMoment) << "the first of those that are left";
  act("panel why");
  EXPECT_TRUE(layout().shows(Panel::kWhy));
  EXPECT_EQ(layout().right_tab, Panel::kWhy);
}

TEST_F(SessionLayoutTest, LooksAtAnotherTabWithoutAStepOfUndo) {
  act("theme light");
  act("panel why on");
  act("panel runs on");
  EXPECT_EQ(layout().right_tab, Panel::kWhy);
  EXPECT_EQ(session_->undo_title(), "Light theme");
  act("undo");
  EXPECT_EQ(session_->view().appearance.theme, LightOrDark::kDark);
  EXPECT_EQ(layout().right_tab, Panel::kWhy) << "who takes back a colour still looks at the tab";
  EXPECT_EQ(layout().left_tab, Panel::kRuns);
  act("panel moment on");
  EXPECT_EQ(session_->redo_title(), "Light theme") << "nor is what was taken back lost";
  act("redo");
  EXPECT_EQ(session_->view().appearance.theme, LightOrDark::kLight);
  EXPECT_EQ(layout().right_tab, Panel::kMoment);
}

TEST_F(SessionLayoutTest, TakesHidingAPanelBackWithItsTab) {
  act("panel why on");
  act("panel why off");
  EXPECT_EQ(session_->undo_title(), "Hide panel why");
  EXPECT_NE(layout().right_tab, Panel::kWhy);
  act("undo");
  EXPECT_TRUE(layout().shows(Panel::kWhy));
  EXPECT_EQ(layout().right_tab, Panel::kWhy) << "it was in front";
}

TEST_F(SessionLayoutTest, StillTakesSplittersAndFillingTheWindowBack) {
  act("splitter left 300");
  act("map-only on");
  EXPECT_EQ(session_->undo_title(), "Map only");
  act("undo");
  EXPECT_EQ(session_->undo_title(), "Move splitter");
  act("undo");
  EXPECT_EQ(layout().left_pt, default_layout().left_pt);
}

TEST_F(SessionLayoutTest, ShowsAPanelOverAMapThatFillsTheWindow) {
  act("map-only on");
  act("panel timeline");
  EXPECT_TRUE(layout().shows(Panel::kTimeline));
  EXPECT_FALSE(layout().is_map_only);
  act("panel timeline");
  EXPECT_FALSE(layout().shows(Panel::kTimeline));
}

TEST_F(SessionLayoutTest, HidesEveryPanelOfAColumn) {
  for (const char* panel : {"layers", "runs", "bookmarks"})
    act(std::string("panel ") + panel + " off");
  EXPECT_FALSE(layout().shows(Panel::kLayers) || layout().shows(Panel::kRuns));
  act("panel bookmarks on");
  EXPECT_EQ(layout().left_tab, Panel::kBookmarks);
}

TEST_F(SessionLayoutTest, MovesSplittersWithinTheirRange) {
  act("splitter left 300");
  act("splitter right 400");
  act("splitter timeline 100");
  EXPECT_EQ(layout().left_pt, 300.0);
  EXPECT_EQ(layout().right_pt, 400.0);
  EXPECT_EQ(layout().timeline_pt, 100.0);
  EXPECT_THAT(refused("splitter left 10"), HasSubstr("a size of 10 points is not in [160, 1200]"));
  EXPECT_THAT(refused("splitter timeline 10"), HasSubstr("[60, 900]"));
}

TEST_F(SessionLayoutTest, KeepsLayoutsByName) {
  act("splitter left 444");
  act("save-layout wide");
  act("layout default");
  EXPECT_EQ(layout(), default_layout());
  act("layout wide");
  EXPECT_EQ(layout().left_pt, 444.0);
  EXPECT_THAT(session_->layout_names(), ElementsAre("default", "wide"));
  EXPECT_THAT(refused("layout wid"), HasSubstr("there is no layout 'wid'; did you mean wide?"));
  EXPECT_THAT(refused("save-layout default"), HasSubstr("'default' is always as it is"));
  EXPECT_THAT(refused("save-layout \"\""), HasSubstr("a layout needs a name"));
}

TEST_F(SessionLayoutTest, LogsOnceThatWhatLiesOverTheWindowWasClosed) {
  act("show about");
  act("show none");  // Escape asks the overlay to close
  act("show none");  // and is a shortcut as well
  EXPECT_THAT(session_->log(), ElementsAre("show about", "show none"));
}

TEST_F(SessionLayoutTest, ChoosesAndOrdersStrips) {
  act("strip nees off");
  act("strip streams on");
  act("strip-height streams 99");
  EXPECT_FALSE(layout().strips[place_of(Strip::kNees)].is_visible);
  EXPECT_TRUE(layout().strips[place_of(Strip::kStreams)].is_visible);
  EXPECT_EQ(layout().strips[place_of(Strip::kStreams)].height_pt, 99.0);
  const std::size_t before = place_of(Strip::kNees);
  act("strip-move nees 2");
  EXPECT_EQ(place_of(Strip::kNees), before - 2) << "up is towards the first";
  act("strip-move nees 99");
  EXPECT_EQ(place_of(Strip::kNees), 0U);
  act("strip-move nees -99");
  EXPECT_EQ(place_of(Strip::kNees), kStripCount - 1);
  EXPECT_EQ(layout().strips.size(), kStripCount);
  EXPECT_THAT(refused("strip-height nees 1"), HasSubstr("a size of 1 points is not in [16, 400]"));
}

TEST_F(SessionLayoutTest, ChangesTheAppearance) {
  act("theme light");
  act("scale 1.25");
  act("reduced-motion on");
  const Appearance expected{LightOrDark::kLight, 1.25, true};
  EXPECT_EQ(session_->view().appearance, expected);
  act("scale 0");
  EXPECT_EQ(session_->view().appearance.scale, 0.0) << "the screen's own";
  EXPECT_THAT(refused("scale 9"), HasSubstr("a scale of 9 is not in [0.75, 3]"));
}

TEST_F(SessionLayoutTest, SplitsTheViewForTwoRuns) {
  EXPECT_THAT(refused("split-view on"), HasSubstr("open a second one first"));
  open_run();
  act("open " + copy_run("second.nadir").string());
  settle();
  act("split-view");
  EXPECT_TRUE(session_->view().map.is_split);
  act("close-run 1");
  EXPECT_FALSE(session_->view().map.is_split) << "one run is left";
}

TEST_F(SessionLayoutTest, OpensAndClosesWhatLiesOverTheWindow) {
  for (const char* name : {"palette", "shortcuts", "preferences", "about", "place", "bookmark"}) {
    act(std::string("show ") + name);
    EXPECT_EQ(enum_name(session_->overlay()), name);
  }
  act("show none");
  EXPECT_EQ(session_->overlay(), Overlay::kNone);
  EXPECT_EQ(session_->view(), default_view_state());
}

}  // namespace session_layout_test
}  // namespace nadir
