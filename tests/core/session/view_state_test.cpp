// SPDX-License-Identifier: Apache-2.0
#include "core/session/view_state.h"

#include <gmock/gmock.h>

#include <cmath>

namespace nadir {
namespace view_state_test {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

TEST(ViewState, IsValidAsItBegins) {
  EXPECT_EQ(repaired(default_view_state()), default_view_state());
  EXPECT_THAT(default_map_look().order, SizeIs(kLayerCount));
  EXPECT_THAT(default_layout().strips, SizeIs(kStripCount));
  EXPECT_TRUE(default_layout().shows(default_layout().left_tab));
  EXPECT_TRUE(default_layout().shows(default_layout().right_tab));
}

TEST(ViewState, IsRepairedOnlyOnce) {
  ViewState view = default_view_state();
  view.map.order = {Layer::kTruth, Layer::kTruth, Layer::kPicture};
  view.layout.strips = {{Strip::kNees, true, 1e9}};
  view.layout.is_shown.fill(false);
  view.runs = {{"a", true, -5}, {"a", true, 0}, {"", true, 0}, {"b", true, 1}};
  view.active_run = 7;
  const ViewState once = repaired(view);
  EXPECT_EQ(repaired(once), once);
  EXPECT_THAT(once.runs, SizeIs(2));
  EXPECT_EQ(once.runs[0].colour, 0);
  EXPECT_EQ(once.active_run, 2);
}

TEST(ViewState, HasEveryLayerAndStripOnceHoweverItWasRead) {
  ViewState view = default_view_state();
  view.map.order = {Layer::kLegend, Layer::kTruth, Layer::kPicture};
  view.layout.strips = {{Strip::kStreams, true, 50.0}};
  view = repaired(view);
  EXPECT_THAT(view.map.order, SizeIs(kLayerCount));
  EXPECT_EQ(view.map.order[0], Layer::kTruth);
  EXPECT_EQ(view.map.order[1], Layer::kPicture);
  EXPECT_EQ(view.map.order[2], Layer::kLabels) << "what is missing follows in its usual order";
  EXPECT_EQ(view.map.order.back(), Layer::kLegend) << "which nothing lies on";
  EXPECT_EQ(view.layout.strips[0].strip, Strip::kStreams);
  EXPECT_THAT(view.layout.strips, SizeIs(kStripCount));
}

TEST(ViewState, TakesNumbersThatAreNoneAsTheyUsuallyAre) {
  ViewState view = default_view_state();
  view.map.centre_in_enu_m = {std::nan(""), 1.0};
  view.map.width_m = -INFINITY;
  view.map.up_rad = std::nan("");
  view.map.layers[0].opacity = std::nan("");
  view.map.layers[1].opacity = 17.0;
  view.map.layers[2].colour = "blue";
  view.map.measured_in_enu_m = {{1.0, 2.0}, {std::nan(""), 0.0}};
  view.layout.left_pt = std::nan("");
  view.layout.right_pt = 1e9;
  view.appearance.scale = 17.0;
  view.selected_particle = -3;
  view = repaired(view);
  EXPECT_EQ(view.map.centre_in_enu_m, Eigen::Vector2d(0.0, 0.0));
  EXPECT_EQ(view.map.width_m, 0.0);
  EXPECT_EQ(view.map.up_rad, MapLook().up_rad);
  EXPECT_EQ(view.map.layers[0].opacity, 1.0);
  EXPECT_EQ(view.map.layers[1].opacity, 1.0);
  EXPECT_FALSE(view.map.layers[2].colour);
  EXPECT_THAT(view.map.measured_in_enu_m, SizeIs(1));
  EXPECT_EQ(view.layout.left_pt, WindowLayout().left_pt);
  EXPECT_EQ(view.layout.right_pt, kMostColumnPt);
  EXPECT_EQ(view.appearance.scale, kMostScale);
  EXPECT_FALSE(view.selected_particle);
}

TEST(ViewState, ShowsInEachColumnATabThatIsThere) {
  WindowLayout layout = default_layout();
  layout.is_shown.fill(false);
  layout.is_shown[static_cast<std::size_t>(Panel::kRuns)] = true;
  layout.is_shown[static_cast<std::size_t>(Panel::kWhy)] = true;
  layout.left_tab = Panel::kMoment;
  layout.right_tab = Panel::kLog;
  layout = repaired(layout);
  EXPECT_EQ(layout.left_tab, Panel::kRuns);
  EXPECT_EQ(layout.right_tab, Panel::kWhy);
}

TEST(ViewState, HasAnActiveRunWhereverThereIsOne) {
  ViewState view = default_view_state();
  view.active_run = 3;
  EXPECT_EQ(repaired(view).active_run, 0);
  view.runs = {{"a", true, 0}};
  view.active_run = 0;
  EXPECT_EQ(repaired(view).active_run, 1);
  view.map.is_split = true;
  EXPECT_FALSE(repaired(view).map.is_split) << "of one run";
}

TEST(ColourText, HasSixDigits) {
  EXPECT_TRUE(is_colour_text("#12aBcF"));
  for (const char* text : {"", "#12345", "#1234567", "123456#", "#12345g", "blue"}) {
    EXPECT_FALSE(is_colour_text(text)) << text;
  }
}

TEST(Switch, MakesOnOffOrTheOther) {
  EXPECT_TRUE(switched(false, Switch::kToggle));
  EXPECT_FALSE(switched(true, Switch::kToggle));
  EXPECT_TRUE(switched(true, Switch::kOn));
  EXPECT_FALSE(switched(true, Switch::kOff));
}

TEST(PanelColumns, AreThoseOfTheWindow) {
  EXPECT_EQ(column_of(Panel::kBookmarks), Column::kLeft);
  EXPECT_EQ(column_of(Panel::kLog), Column::kLeft);
  EXPECT_EQ(column_of(Panel::kSettings), Column::kRight);
  EXPECT_FALSE(column_of(Panel::kTimeline));
}

}  // namespace view_state_test
}  // namespace nadir
