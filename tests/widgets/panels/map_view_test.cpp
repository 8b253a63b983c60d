// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/map_view.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "core/base/angle.h"
#include "tests/widgets/panels/made_moment.h"
#include "widgets/kit/headless_ui.h"
#include "widgets/panels/map_cards.h"
#include "widgets/panels/map_lines.h"

namespace nadir {
namespace map_view_test {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;

constexpr const char* kGround = "Map/Ground";

/// The view with somebody who does what it asks for, as Session would.
class MapViewTest : public ::testing::Test {
 protected:
  MapViewTest() { model.look.layer(Layer::kLegend).is_visible = false; }

  auto drawing() {
    return [this](kit::Ui& ui) {
      Actions asked = draw_map_view(ui, model, state);
      for (const Action& action : asked) apply(action);
      return asked;
    };
  }
  void apply(const Action& action) {
    MapLook& look = model.look;
    if (const auto* at = std::get_if<actions::LookAt>(&action)) {
      look.centre_in_enu_m = {at->east_m, at->north_m};
      if (at->width_m) look.width_m = *at->width_m;
      look.is_following = false;
    } else if (const auto* zoom = std::get_if<actions::Zoom>(&action)) {
      if (zoom->east_m) {
        const Eigen::Vector2d stays(*zoom->east_m, *zoom->north_m);
        look.centre_in_enu_m = stays + (look.centre_in_enu_m - stays) / zoom->factor;
      }
      look.width_m /= zoom->factor;
    } else if (const auto* turn = std::get_if<actions::Rotate>(&action)) {
      look.up_rad = wrap_rad(look.up_rad - Angle::degrees(turn->angle_deg).radians());
      look.up = MapUp::kFree;
    } else if (const auto* point = std::get_if<actions::MeasurePoint>(&action)) {
      if (point->east_m) {
        look.measured_in_enu_m.emplace_back(*point->east_m, *point->north_m);
      } else {
        look.measured_in_enu_m.clear();
      }
    } else if (const auto* tool = std::get_if<actions::UseTool>(&action)) {
      look.tool = tool->tool;
    } else if (const auto* particle = std::get_if<actions::SelectParticle>(&action)) {
      model.selected_particle = particle->index;
    }
  }
  /// Place of the ground at a point of the area, counted from its upper left corner.
  Eigen::Vector2d ground_at(double x, double y) {
    return state.camera.enu_from_page({x, screen.at(kGround).rect.height - y}, state.where);
  }
  void show() { screen.wait(2, drawing()); }

  MadeMoment made;
  MapViewModel model = made.map_view();
  MapViewState state;
  kit::HeadlessUi screen;
};

TEST_F(MapViewTest, DraggingCarriesTheGroundWithTheMouse) {
  for (const double up_rad : {std::numbers::pi / 2.0, 0.4, -2.0}) {
    model.look.up_rad = up_rad;
    show();
    const kit::Rect area = screen.at(kGround).rect;
    const Eigen::Vector2d held = ground_at(area.width / 2.0, area.height / 2.0);
    screen.drag(kGround, 150.0, -60.0, drawing());
    show();
    EXPECT_LT((ground_at(area.width / 2.0 + 150.0, area.height / 2.0 - 60.0) - held).norm(), 1e-6);
    EXPECT_DOUBLE_EQ(model.look.width_m, 40.0);
  }
}

TEST_F(MapViewTest, ALostFrameDoesNotMakeADragDrift) {
  show();
  const kit::Rect area = screen.at(kGround).rect;
  const Eigen::Vector2d held = ground_at(area.width / 2.0, area.height / 2.0);
  int frame = 0;
  screen.drag(kGround, 90.0, 40.0, [&](kit::Ui& ui) {
    Actions asked = draw_map_view(ui, model, state);
    if (++frame % 2 == 0) {  // every other wish is not carried out
      for (const Action& action : asked) apply(action);
    }
    return asked;
  });
  const auto last = screen.drag(kGround, 0.0, 0.0, drawing());
  show();
  const Eigen::Vector2d now = ground_at(area.width / 2.0 + 90.0, area.height / 2.0 + 40.0);
  EXPECT_LT((now - held).norm(),
            90.0 * state.camera.metres_per_px);  // within the last move, which may be lost
}

TEST_F(MapViewTest, TheWheelZoomsToWhatIsUnderTheMouse) {
  model.look.up_rad = 0.8;
  show();
  const kit::Rect area = screen.at(kGround).rect;
  screen.hover(kGround, drawing());
  screen.input().mouse_px = Eigen::Vector2d(area.left + 300.0, area.top + 500.0);
  show();
  const Eigen::Vector2d stays = ground_at(300.0, 500.0);
  screen.input().wheel = {0.0, 2.0};
  const Actions asked = screen.frame(drawing());
  screen.input().wheel = {0.0, 0.0};
  show();
  ASSERT_THAT(asked, SizeIs(1));
  EXPECT_NEAR(std::get<actions::Zoom>(asked[0]).factor, 1.5625, 1e-9);
  EXPECT_LT((ground_at(300.0, 500.0) - stays).norm(), 1e-6);
  EXPECT_NEAR(model.look.width_m, 40.0 / 1.5625, 1e-9);
}

TEST_F(MapViewTest, WhileItFollowsTheWheelKeepsTheMiddle) {
  model.look.is_following = true;
  const Actions asked = screen.scroll(kGround, 1.0, drawing());
  ASSERT_THAT(asked, SizeIs(1));
  EXPECT_FALSE(std::get<actions::Zoom>(asked[0]).east_m);
}

TEST_F(MapViewTest, TheRightButtonTurnsTheMapWithTheMouse) {
  show();
  const kit::Rect area = screen.at(kGround).rect;
  const Eigen::Vector2d middle = state.camera.centre_in_enu_m;
  const Eigen::Vector2d right = ground_at(area.width / 2.0 + 200.0, area.height / 2.0);
  // Pressed right of the middle, moved to above it.
  const auto draw = drawing();
  auto& input = screen.input();
  const auto to = [&](double x, double y) {
    input.mouse_px = area.centre() + Eigen::Vector2d(x, y);
    screen.frame(draw);
  };
  to(200.0, 0.0);
  to(200.0, 0.0);
  input.buttons[1] = true;
  to(200.0, 0.0);
  for (int deg = 10; deg <= 90; deg += 10) {
    to(200.0 * std::cos(deg * std::numbers::pi / 180.0),
       -200.0 * std::sin(deg * std::numbers::pi / 180.0));
  }
  input.buttons[1] = false;
  screen.frame(draw);
  show();
  EXPECT_LT((ground_at(area.width / 2.0, area.height / 2.0 - 200.0) - right).norm(), 0.02);
  EXPECT_LT((state.camera.centre_in_enu_m - middle).norm(), 1e-9);
  EXPECT_FALSE(screen.has("Map/Menu/Centre here"));
}

TEST_F(MapViewTest, RTurnsAndADoubleClickCentres) {
  screen.hover(kGround, drawing());
  const Actions turned = screen.press("R", drawing());
  ASSERT_THAT(turned, Contains(Action(actions::Rotate{15.0})));
  model.look.up_rad = std::numbers::pi / 2.0;
  show();
  const Eigen::Vector2d middle =
      ground_at(screen.at(kGround).rect.width / 2.0, screen.at(kGround).rect.height / 2.0);
  const Actions asked = screen.double_click(kGround, drawing());
  ASSERT_THAT(asked, SizeIs(1));
  EXPECT_NEAR(std::get<actions::LookAt>(asked[0]).east_m, middle.x(), 1e-6);
}

TEST_F(MapViewTest, HoveringReadsThePlaceUnderTheMouse) {
  model.look.up_rad = 1.1;
  show();
  EXPECT_FALSE(state.readout);
  screen.hover(kGround, drawing());
  const kit::Rect area = screen.at(kGround).rect;
  ASSERT_TRUE(state.readout);
  const Eigen::Vector2d place =
      ground_at(screen.input().mouse_px->x() - area.left, screen.input().mouse_px->y() - area.top);
  EXPECT_LT((state.readout->in_enu_m - place).norm(), 1e-6);
  EXPECT_EQ(state.readout->class_id, made.map->map().class_at(place));
  EXPECT_EQ(state.readout->geodetic,
            geodetic_text(made.map->map().plane.geodetic_from_enu(state.readout->in_enu_m)));
  screen.leave();
  show();
  EXPECT_FALSE(state.readout);
}

TEST_F(MapViewTest, MeasuresByClicksUntilEscape) {
  apply(actions::UseTool{MapTool::kMeasure});
  show();
  const kit::Rect area = screen.at(kGround).rect;
  const double metres_per_px = 40.0 / area.width;
  screen.click_at(kGround, 400.0, 500.0, drawing());
  screen.wait(40, drawing());
  screen.click_at(kGround, 400.0, 300.0, drawing());  // 200 px north
  screen.wait(40, drawing());
  EXPECT_EQ(screen.at("Map/Measured/distance").value, distance_text(200.0 * metres_per_px));
  EXPECT_EQ(screen.at("Map/Measured/bearing").value, "000.0°");
  EXPECT_FALSE(screen.has("Map/Measured/area"));
  screen.click_at(kGround, 550.0, 300.0, drawing());  // 150 px east
  show();
  EXPECT_EQ(screen.at("Map/Measured/distance").value, distance_text(350.0 * metres_per_px));
  EXPECT_EQ(screen.at("Map/Measured/bearing").value, "090.0°");
  EXPECT_EQ(screen.at("Map/Measured/area").value,
            area_text(200.0 * 150.0 / 2.0 * metres_per_px * metres_per_px));
  EXPECT_THAT(screen.press("Escape", drawing()),
              ElementsAre(Action(actions::UseTool{MapTool::kPan})));
  EXPECT_THAT(screen.press("Escape", drawing()), ElementsAre(Action(actions::MeasurePoint{})));
  EXPECT_THAT(screen.press("Escape", drawing()), IsEmpty());
}

TEST_F(MapViewTest, ADragWhileMeasuringMovesTheMapAndAddsNoPoint) {
  apply(actions::UseTool{MapTool::kMeasure});
  const Actions asked = screen.drag(kGround, 80.0, 0.0, drawing());
  EXPECT_THAT(model.look.measured_in_enu_m, IsEmpty());
  EXPECT_TRUE(std::holds_alternative<actions::LookAt>(asked.at(0)));
}

TEST_F(MapViewTest, AClickPicksTheNearestParticleAndACardSaysWhatItIs) {
  apply(actions::UseTool{MapTool::kPick});
  show();
  const std::size_t wanted = 137;
  const Rigid2 pose = made.step->particles->pose(wanted);
  const Eigen::Vector2d at = state.camera.page_from_enu(pose.translation_m(), state.where);
  screen.click_at(kGround, at.x() + 0.4, screen.at(kGround).rect.height - at.y() - 0.4, drawing());
  EXPECT_EQ(model.selected_particle, 137);
  show();
  EXPECT_EQ(screen.at("Map/Particle/east").value, metres_text(pose.x_m) + " m");
  EXPECT_EQ(screen.at("Map/Particle/north").value, metres_text(pose.y_m) + " m");
  EXPECT_EQ(screen.at("Map/Particle/heading").value, "090.0°");
  EXPECT_EQ(screen.at("Map/Particle/weight").value, "1 × mean");
  EXPECT_TRUE(screen.shows("cells that misfit the map"));
  EXPECT_THAT(screen.click("Map/Particle/Close", drawing()),
              ElementsAre(Action(actions::SelectParticle{})));
  model.selected_particle = 137;
  show();
  screen.click_at(kGround, 300.0, 40.0, drawing());  // far from all
  EXPECT_FALSE(model.selected_particle);
}

TEST_F(MapViewTest, AParticleThatASmallerStepDoesNotHaveIsNotShown) {
  model.selected_particle = 400;
  show();
  EXPECT_FALSE(screen.has("Map/Particle/east"));
  EXPECT_FALSE(selected_particle(model));
}

TEST_F(MapViewTest, ToolsAskForWhatTheyAreCalled) {
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

TEST_F(MapViewTest, ToolsThatALowMapHasNoRoomForAreInAMenu) {
  kit::HeadlessUi low(ThemeName::kDark, 1.5, {900.0, 300.0});
  low.wait(3, drawing());
  EXPECT_TRUE(low.has("Map/Tools/Pan"));
  EXPECT_FALSE(low.has("Map/Tools/Follow"));
  EXPECT_LT(low.at("Map/Tools/More").rect.bottom(), 260.0) << "the scale bar lies below";
  EXPECT_THAT(low.click("Map/Tools/More/Follow", drawing()),
              Contains(Action(actions::Follow{Switch::kToggle})));
}

TEST_F(MapViewTest, TheMenuCopiesThePlaceWhereItWasOpened) {
  screen.right_click(kGround, drawing());
  const Eigen::Vector2d place = state.menu_in_enu_m;
  const Actions asked = screen.click("Map/Menu/Copy east and north", drawing());
  EXPECT_THAT(
      asked,
      ElementsAre(Action(actions::Copy{metres_text(place.x()) + " " + metres_text(place.y())})));
}

TEST_F(MapViewTest, EachOfTwoMapsHasAMenuOfItsOwn) {
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

TEST_F(MapViewTest, TheGroundIsAskedForWithTheCameraThatLinesAreDrawnWith) {
  std::vector<MapGround> grounds;
  state.ground = [&](const MapGround& ground) {
    grounds.push_back(ground);
    return kit::TextureId{0};
  };
  show();
  ASSERT_THAT(grounds, Not(IsEmpty()));
  EXPECT_EQ(grounds.back().camera, state.camera);
  EXPECT_EQ(grounds.back().width_px, static_cast<int>(state.where.width));
  EXPECT_EQ(grounds.back().run, 1);
  EXPECT_DOUBLE_EQ(grounds.back().camera.metres_per_px * grounds.back().width_px, 40.0);
}

TEST_F(MapViewTest, TwoRunsCanLieBesideEachOtherUnderOneCamera) {
  MapRun other = model.runs[0];
  other.number = 2;
  other.is_active = false;
  model.runs.insert(model.runs.begin(), other);
  model.look.is_split = true;
  std::vector<MapGround> grounds;
  state.ground = [&](const MapGround& ground) {
    grounds.push_back(ground);
    return kit::TextureId{0};
  };
  show();
  const kit::Rect left = screen.at(kGround).rect;
  const kit::Rect right = screen.at("Map/Second ground").rect;
  EXPECT_LE(left.right(), right.left);
  EXPECT_DOUBLE_EQ(left.width, right.width);
  ASSERT_GE(grounds.size(), 2U);
  EXPECT_EQ(grounds[grounds.size() - 2].run, 1);
  EXPECT_FALSE(grounds[grounds.size() - 2].is_second);
  EXPECT_EQ(grounds.back().run, 2);
  EXPECT_TRUE(grounds.back().is_second);
  EXPECT_LT(state.room.aspect, 1.0) << "of one half";
  EXPECT_EQ(grounds[grounds.size() - 2].camera, grounds.back().camera);
  const Eigen::Vector2d held = ground_at(left.width / 2.0, left.height / 2.0);
  screen.drag(kGround, 60.0, 30.0, drawing());
  show();
  EXPECT_LT((ground_at(left.width / 2.0 + 60.0, left.height / 2.0 + 30.0) - held).norm(), 1e-6);
}

TEST_F(MapViewTest, SaysWhatAClickWillDoAndWhatItWouldMeasure) {
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

TEST_F(MapViewTest, EscapeLetsGoOfAParticleAndThenOfPicking) {
  apply(actions::UseTool{MapTool::kPick});
  show();
  EXPECT_TRUE(screen.shows("Click a particle"));
  model.selected_particle = 3;
  EXPECT_THAT(screen.press("Escape", drawing()), ElementsAre(Action(actions::SelectParticle{})));
  EXPECT_THAT(screen.press("Escape", drawing()),
              ElementsAre(Action(actions::UseTool{MapTool::kPan})));
  EXPECT_THAT(screen.press("Escape", drawing()), IsEmpty());
}

TEST_F(MapViewTest, WithoutAMapTheRunShowsAndTheMapIsOneClickAway) {
  model.map.reset();
  std::vector<MapGround> grounds;
  state.ground = [&](const MapGround& ground) {
    grounds.push_back(ground);
    return kit::TextureId{0};
  };
  show();
  EXPECT_TRUE(screen.has(kGround));
  EXPECT_TRUE(screen.shows("No map is open: open one to see the ground"));
  ASSERT_THAT(grounds, Not(IsEmpty()));
  EXPECT_EQ(grounds.back().run, 1) << "its particles are asked for";
  EXPECT_FALSE(grounds.back().is_lowest) << "the grid lies below";
  EXPECT_THAT(screen.click("Map/Note/Open the map…", drawing()),
              ElementsAre(Action(actions::ShowOverlay{Overlay::kOpen})));
}

TEST_F(MapViewTest, TheGroundIsAskedForInPartsWhereLinesLieBetween) {
  std::vector<MapGround> grounds;
  state.ground = [&](const MapGround& ground) {
    grounds.push_back(ground);
    return kit::TextureId{0};
  };
  show();
  EXPECT_EQ(grounds.back().part_count, 1);
  EXPECT_TRUE(grounds.back().is_lowest);
  EXPECT_THAT(grounds.back().layers,
              ElementsAre(Layer::kPicture, Layer::kTopview, Layer::kParticles));
  // Particles above the estimate.
  std::vector<Layer>& order = model.look.order;
  std::erase(order, Layer::kParticles);
  order.insert(order.end() - 1, Layer::kParticles);
  grounds.clear();
  show();
  ASSERT_GE(grounds.size(), 2U);
  const MapGround& upper = grounds.back();
  const MapGround& lower = grounds[grounds.size() - 2];
  EXPECT_EQ(lower.part_count, 2);
  EXPECT_EQ(lower.part, 0);
  EXPECT_TRUE(lower.is_lowest);
  EXPECT_THAT(lower.layers, ElementsAre(Layer::kPicture, Layer::kTopview));
  EXPECT_EQ(upper.part, 1);
  EXPECT_FALSE(upper.is_lowest);
  EXPECT_THAT(upper.layers, ElementsAre(Layer::kParticles));
  EXPECT_EQ(upper.camera, lower.camera);
}

TEST_F(MapViewTest, TellsWhatItsControlsCover) {
  show();
  const kit::Rect tools = screen.at("Map/Tools/Measure").rect;
  const kit::Rect area = screen.at(kGround).rect;
  EXPECT_DOUBLE_EQ(state.room.aspect, state.where.width / state.where.height);
  EXPECT_GE(state.room.left * state.where.width, tools.right() - area.left);
  EXPECT_LT(state.room.left, 0.1);
  EXPECT_EQ(state.room.bottom, 0.0) << "no legend is shown";
  model.look.layer(Layer::kLegend).is_visible = true;
  show();
  EXPECT_GT(state.room.bottom, 0.02);
  EXPECT_LT(state.room.bottom, 0.4);
}

TEST_F(MapViewTest, WithoutAnythingOpenItOffersTheDemo) {
  model = {};
  model.look = default_map_look();
  EXPECT_THAT(screen.click("Map/Open the demo", drawing()),
              ElementsAre(Action(actions::OpenDemo{})));
  model.reading = "loop";
  show();
  EXPECT_TRUE(screen.shows("loop is being read"));
}

TEST_F(MapViewTest, ARunShowsBeforeItsMapIsRead) {
  model.map.reset();
  model.reading = "town";
  show();
  EXPECT_TRUE(screen.has(kGround));
  EXPECT_TRUE(screen.shows("Reading town…"));
}

TEST(MapLook, AColourOfTheUsersOwnIsTheActiveRuns) {
  const MadeMoment made;
  MapViewModel model = made.map_view();
  model.look.layer(Layer::kEstimate).colour = "#FF8000";
  const Theme& dark = theme(ThemeName::kDark);
  EXPECT_EQ(run_path_look(model, model.runs[0], PoseSource::kEstimate, dark).colour,
            (Rgba{255, 128, 0}));
  MapRun other = model.runs[0];
  other.is_active = false;
  other.colour = 1;
  EXPECT_EQ(run_path_look(model, other, PoseSource::kEstimate, dark).colour, dark.second_run);
  EXPECT_FALSE(colour_from_hex("#12345"));
  EXPECT_FALSE(colour_from_hex("#12345G"));
}

TEST(MapLook, ParticlesAreCasedInTheOppositeOfWhatTheyLieOn) {
  for (const ThemeName name : {ThemeName::kDark, ThemeName::kLight}) {
    const Theme& colours = theme(name);
    EXPECT_EQ(particle_casing(colours, true), with_opacity(colours.casing_on_imagery, 0.85));
    EXPECT_EQ(particle_casing(colours, false), with_opacity(colours.window, 0.85));
  }
}

}  // namespace map_view_test
}  // namespace nadir
