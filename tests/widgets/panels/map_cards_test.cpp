// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/map_cards.h"

#include <gmock/gmock.h>

#include "tests/widgets/panels/made_moment.h"
#include "widgets/kit/headless_ui.h"

namespace nadir {
namespace map_cards_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const kit::Rect kMap{100.0, 50.0, 900.0, 600.0};

class MapCardsTest : public ::testing::Test {
 protected:
  auto cards() {
    return [this](kit::Ui& ui) { return draw_map_cards(ui, model, kMap); };
  }
  /// The whole map, whose menu opens at a place.
  auto menu() {
    return [this](kit::Ui& ui) {
      (void)ui.area("Ground");
      return draw_map_menu(ui, "Menu", model, place);
    };
  }
  MadeMoment made;
  MapViewModel model = made.map_view();
  Eigen::Vector2d place{12.5, 34.25};
  kit::HeadlessUi screen;
};

TEST_F(MapCardsTest, NothingIsSaidWhereNothingIsPickedOrMeasured) {
  screen.wait(2, cards());
  EXPECT_THAT(screen.controls(), IsEmpty());
}

TEST_F(MapCardsTest, AParticleIsSaidWithItsWeightAndItsWayFromTheTruth) {
  RunStep weighed = *made.step;
  weighed.particles->weight[5] = 3.0 / 400.0;
  model.step = std::make_shared<const RunStep>(weighed);
  model.selected_particle = 5;
  screen.wait(2, cards());
  EXPECT_EQ(screen.at("Particle/weight").value, "3 × mean");
  const double away_m =
      (weighed.particles->pose(5).translation_m() - weighed.truth_in_enu->translation_m()).norm();
  EXPECT_EQ(screen.at("Particle/from the truth").value, metres_text(away_m) + " m");
  EXPECT_TRUE(screen.shows("cells that misfit the map"));
  EXPECT_GE(screen.at("Particle/Close").rect.left, kMap.left);
  EXPECT_LE(screen.at("Particle/Close").rect.right(), kMap.right());
}

TEST_F(MapCardsTest, WithoutMapAndTruthAParticleIsSaidAllTheSame) {
  RunStep bare = *made.step;
  bare.truth_in_enu.reset();
  model.step = std::make_shared<const RunStep>(bare);
  model.map.reset();
  model.selected_particle = 0;
  screen.wait(2, cards());
  EXPECT_TRUE(screen.has("Particle/heading"));
  EXPECT_FALSE(screen.has("Particle/from the truth"));
  EXPECT_FALSE(screen.shows("cells that misfit"));
}

TEST_F(MapCardsTest, WhatIsMeasuredCanBeClearedAndPushesTheParticleDown) {
  model.selected_particle = 0;
  screen.wait(2, cards());
  const double above = screen.at("Particle/east").rect.top;
  model.look.measured_in_enu_m = {{0.0, 0.0}, {3.0, 4.0}};
  screen.wait(2, cards());
  EXPECT_EQ(screen.at("Measured/distance").value, "5.00 m");
  EXPECT_GT(screen.at("Particle/east").rect.top, above + 40.0);
  EXPECT_THAT(screen.click("Measured/Clear", cards()),
              ElementsAre(Action(actions::MeasurePoint{})));
}

TEST_F(MapCardsTest, TheMenuCopiesCoordinatesInEveryNotation) {
  const auto copied = [&](const std::string& item) {
    screen.right_click("Ground", menu());
    const Actions asked = screen.click("Menu/" + item, menu());
    return asked.size() == 1 ? std::get<actions::Copy>(asked[0]).text : "not one action";
  };
  const Geodetic there = model.plane->geodetic_from_enu(place);
  EXPECT_EQ(copied("Copy east and north"), "12.50 34.25");
  EXPECT_EQ(copied("Copy latitude and longitude"), geodetic_text(there));
  EXPECT_EQ(copied("Copy UTM"), utm_text(there));
  EXPECT_EQ(copied("Copy MGRS"), mgrs_text(there));
  model.plane.reset();
  screen.right_click("Ground", menu());
  screen.wait(1, menu());
  EXPECT_FALSE(screen.has("Menu/Copy MGRS"));
  EXPECT_TRUE(screen.has("Menu/Copy east and north"));
}

TEST_F(MapCardsTest, TheMenuCentresAndMeasuresFromWhereItWasOpened) {
  screen.right_click("Ground", menu());
  EXPECT_THAT(screen.click("Menu/Centre here", menu()),
              ElementsAre(Action(actions::LookAt{12.5, 34.25, {}})));
  screen.right_click("Ground", menu());
  EXPECT_THAT(
      screen.click("Menu/Measure from here", menu()),
      ElementsAre(Action(actions::MeasurePoint{}), Action(actions::MeasurePoint{12.5, 34.25}),
                  Action(actions::UseTool{MapTool::kMeasure})));
  model.look.tool = MapTool::kMeasure;
  screen.right_click("Ground", menu());
  EXPECT_EQ(screen.click("Menu/Measure from here", menu()).size(), 2U);
}

TEST_F(MapCardsTest, ToolsAreLeftOutOfAMapThatIsTooLowForThem) {
  double height = 600.0;
  const auto tools = [&](kit::Ui& ui) {
    return draw_map_tools(ui, model, {100.0, 50.0, 900.0, height});
  };
  screen.wait(2, tools);
  EXPECT_TRUE(screen.has("Tools/Measure"));
  screen.hover("Tools/Follow", tools);
  EXPECT_THAT(screen.tooltip(), HasSubstr("Keep the estimate in the middle"));
  height = 120.0;
  screen.wait(2, tools);
  EXPECT_FALSE(screen.has("Tools/Measure"));
}

TEST_F(MapCardsTest, TheCompassGoesBackToNorthFromAnyTurn) {
  const auto tools = [&](kit::Ui& ui) { return draw_map_tools(ui, model, kMap); };
  model.look.up = MapUp::kHeading;
  EXPECT_THAT(screen.click("Tools/Up", tools), ElementsAre(Action(actions::SetUp{MapUp::kNorth})));
  model.look.up = MapUp::kFree;
  EXPECT_THAT(screen.click("Tools/Up", tools), ElementsAre(Action(actions::SetUp{MapUp::kNorth})));
}

}  // namespace map_cards_test
}  // namespace nadir
