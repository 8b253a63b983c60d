// SPDX-License-Identifier: Apache-2.0
// Tools and menus over a map, and what they say.
#include <gmock/gmock.h>

#include "tests/widgets/panels/shown_map.h"
#include "widgets/panels/map_cards.h"

namespace nadir {
namespace map_tools_test {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

using MapTools = ShownMap;

TEST_F(MapTools, ToolsAskForWhatTheyAreCalled) {
  const auto draw = [this](kit::Ui& ui) { return draw_map_view(ui, model, state); };
  EXPECT_THAT(screen.click("Map/Tools/Measure", draw),
              ElementsAre(Action(actions::UseTool{MapTool::kMeasure})));
  EXPECT_THAT(screen.click("Map/Tools/Pick", draw),
              ElementsAre(Action(actions::UseTool{MapTool::kPick})));
  EXPECT_THAT(screen.click("Map/Tools/Pan", draw),
              ElementsAre(Action(actions::UseTool{MapTool::kPan})));
  EXPECT_THAT(screen.click("Map/Tools/Zoom in", draw),
              ElementsAre(Action(actions::Zoom{1.5, {}, {}})));
  EXPECT_THAT(screen.click("Map/Tools/Fit", draw),
              ElementsAre(Action(actions::Fit{FitTo::kFlight})));
  EXPECT_THAT(screen.click("Map/Tools/Follow", draw),
              ElementsAre(Action(actions::Follow{Switch::kToggle})));
  EXPECT_THAT(screen.click("Map/Tools/Up", draw),
              ElementsAre(Action(actions::SetUp{MapUp::kHeading})));
  model.look.up = MapUp::kFree;
  EXPECT_THAT(screen.click("Map/Tools/Up", draw),
              ElementsAre(Action(actions::SetUp{MapUp::kNorth})));
  model.runs.clear();
  EXPECT_THAT(screen.click("Map/Tools/Fit", draw), ElementsAre(Action(actions::Fit{FitTo::kMap})));
  EXPECT_FALSE(screen.at("Map/Tools/Follow").is_enabled);
}

TEST_F(MapTools, ToolsThatALowMapHasNoRoomForAreInAMenu) {
  kit::HeadlessUi low(ThemeName::kDark, 1.5, {900.0, 300.0});
  low.wait(3, drawing());
  EXPECT_TRUE(low.has("Map/Tools/Pan"));
  EXPECT_FALSE(low.has("Map/Tools/Follow"));
  EXPECT_LT(low.at("Map/Tools/More").rect.bottom(), 260.0) << "the scale bar lies below";
  EXPECT_THAT(low.click("Map/Tools/More/Follow", drawing()),
              Contains(Action(actions::Follow{Switch::kToggle})));
}

TEST_F(MapTools, LeaveTheRestOfTheMapToNoticesAlsoWhereItIsSplit) {
  kit::Rect map, free;
  for (const bool is_split : {false, true}) {
    model.look.is_split = is_split;
    screen.wait(2, [&](kit::Ui& ui) {
      map = ui.room();
      free = beside_map_tools(ui, map);
      return draw_map_view(ui, model, state);
    });
    const kit::Rect tool = screen.at("Map/Tools/Pan").rect;
    EXPECT_GE(free.left, tool.right());
    EXPECT_LT(free.left, tool.right() + 20.0) << "once";
    EXPECT_EQ(free.right(), map.right());
    EXPECT_EQ(free.height, map.height);
  }
}

TEST_F(MapTools, TheMenuCopiesThePlaceWhereItWasOpened) {
  screen.right_click(kGround, drawing());
  const Eigen::Vector2d place = state.menu_in_enu_m;
  const Actions asked = screen.click("Map/Menu/Copy east and north", drawing());
  EXPECT_THAT(
      asked,
      ElementsAre(Action(actions::Copy{metres_text(place.x()) + " " + metres_text(place.y())})));
}

TEST_F(MapTools, EachOfTwoMapsHasAMenuOfItsOwn) {
  MapRun other = model.runs[0];
  other.number = 2;
  other.is_active = false;
  model.runs.insert(model.runs.begin(), other);
  model.look.is_split = true;
  screen.wait(2, drawing());
  screen.right_click("Map/Second ground", drawing());
  const Eigen::Vector2d place = state.menu_in_enu_m;
  EXPECT_FALSE(screen.has("Map/Menu/Copy east and north"));
  const Actions asked = screen.click("Map/Second menu/Copy east and north", drawing());
  EXPECT_THAT(
      asked,
      ElementsAre(Action(actions::Copy{metres_text(place.x()) + " " + metres_text(place.y())})));
  screen.right_click(kGround, drawing());
  EXPECT_TRUE(screen.has("Map/Menu/Copy east and north"));
  EXPECT_FALSE(screen.has("Map/Second menu/Copy east and north"));
}

TEST_F(MapTools, SaysWhatAClickWillDoAndWhatItWouldMeasure) {
  show();
  EXPECT_FALSE(screen.shows("Click the first point"));
  apply(actions::UseTool{MapTool::kMeasure});
  show();
  EXPECT_TRUE(screen.shows("Click the first point"));
  screen.hover(kGround, drawing());
  EXPECT_EQ(screen.tooltip(), "") << "nothing is measured yet";
  screen.click_at(kGround, 400.0, 500.0, drawing());
  screen.wait(40, drawing());
  EXPECT_TRUE(screen.shows("Click the next point"));
  const kit::Rect area = screen.at(kGround).rect;
  screen.input().mouse_px = Eigen::Vector2d(area.left + 500.0, area.top + 500.0);  // 100 px east
  show();
  EXPECT_EQ(screen.tooltip(), distance_text(100.0 * 40.0 / area.width) + "  090.0°");
  EXPECT_THAT(model.look.measured_in_enu_m, SizeIs(1)) << "only a click adds a point";
}

TEST_F(MapTools, EscapeLetsGoOfAParticleAndThenOfPicking) {
  apply(actions::UseTool{MapTool::kPick});
  show();
  EXPECT_TRUE(screen.shows("Click a particle"));
  model.selected_particle = 3;
  EXPECT_THAT(screen.press("Escape", drawing()), ElementsAre(Action(actions::SelectParticle{})));
  EXPECT_THAT(screen.press("Escape", drawing()),
              ElementsAre(Action(actions::UseTool{MapTool::kPan})));
  EXPECT_THAT(screen.press("Escape", drawing()), IsEmpty());
}

}  // namespace map_tools_test
}  // namespace nadir
