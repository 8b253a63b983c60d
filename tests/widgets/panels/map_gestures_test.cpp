// SPDX-License-Identifier: Apache-2.0
// What the mouse does on a map.
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "tests/widgets/panels/shown_map.h"
#include "widgets/panels/map_cards.h"

namespace nadir {
namespace map_gestures_test {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

using MapGestures = ShownMap;

TEST_F(MapGestures, DraggingCarriesTheGroundWithTheMouse) {
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

TEST_F(MapGestures, ALostFrameDoesNotMakeADragDrift) {
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

TEST_F(MapGestures, TheWheelZoomsToWhatIsUnderTheMouse) {
  model.look.up_rad = 0.8;
  show();
  const kit::Rect area = screen.at(kGround).rect;
  screen.hover(kGround, drawing());
  screen.input().mouse_px = Eigen::Vector2d(area.left + 300.0, area.top + 500.0);
  show();
  const Eigen::Vector2d stays = ground_at(300.5, 500.5);
  screen.input().wheel = {0.0, 2.0};
  const Actions asked = screen.frame(drawing());
  screen.input().wheel = {0.0, 0.0};
  show();
  ASSERT_THAT(asked, SizeIs(1));
  EXPECT_NEAR(std::get<actions::Zoom>(asked[0]).factor, 1.5625, 1e-9);
  EXPECT_LT((ground_at(300.5, 500.5) - stays).norm(), 1e-6);
  EXPECT_NEAR(model.look.width_m, 40.0 / 1.5625, 1e-9);
}

TEST_F(MapGestures, WhileItFollowsTheWheelKeepsTheMiddle) {
  model.look.is_following = true;
  const Actions asked = screen.scroll(kGround, 1.0, drawing());
  ASSERT_THAT(asked, SizeIs(1));
  EXPECT_FALSE(std::get<actions::Zoom>(asked[0]).east_m);
}

TEST_F(MapGestures, TheRightButtonTurnsTheMapWithTheMouse) {
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

TEST_F(MapGestures, RTurnsAndADoubleClickCentres) {
  screen.hover(kGround, drawing());
  const Actions turned = screen.press("R", drawing());
  ASSERT_THAT(turned, Contains(Action(actions::Rotate{15.0})));
  model.look.up_rad = std::numbers::pi / 2.0;
  show();
  const Eigen::Vector2d middle = ground_below(*screen.input().mouse_px);
  const Actions asked = screen.double_click(kGround, drawing());
  ASSERT_THAT(asked, SizeIs(1));
  EXPECT_NEAR(std::get<actions::LookAt>(asked[0]).east_m, middle.x(), 1e-6);
}

TEST_F(MapGestures, HoveringReadsThePlaceUnderTheMouse) {
  model.look.up_rad = 1.1;
  show();
  EXPECT_FALSE(state.readout);
  screen.hover(kGround, drawing());
  ASSERT_TRUE(state.readout);
  const Eigen::Vector2d place = ground_below(*screen.input().mouse_px);
  EXPECT_LT((state.readout->in_enu_m - place).norm(), 1e-6);
  EXPECT_EQ(state.readout->class_id, made.map->map().class_at(place));
  EXPECT_EQ(state.readout->geodetic,
            geodetic_text(made.map->map().plane.geodetic_from_enu(state.readout->in_enu_m)));
  screen.leave();
  show();
  EXPECT_FALSE(state.readout);
}

TEST_F(MapGestures, ReadMeasureAndPickTheMiddleOfThePixelThatTheMouseIsOn) {
  show();
  const PageRect page = state.where;
  const kit::Rect area = screen.at(kGround).rect;
  const double metres_per_px = 40.0 / page.width;
  // The pixel in column 300 and row 200, counted from 0 at the upper left, with north up.
  const Eigen::Vector2d pixel(300.5 - page.width / 2.0, page.height / 2.0 - 200.5);
  const Eigen::Vector2d expected = model.look.centre_in_enu_m + metres_per_px * pixel;
  screen.hover(kGround, drawing());
  screen.input().mouse_px = Eigen::Vector2d(area.left + 300.0, area.top + 200.0);
  show();
  ASSERT_TRUE(state.readout);
  EXPECT_LT((state.readout->in_enu_m - expected).norm(), 1e-3 * metres_per_px);
  apply(actions::UseTool{MapTool::kMeasure});
  screen.click_at(kGround, 300.0, 200.0, drawing());
  ASSERT_THAT(model.look.measured_in_enu_m, SizeIs(1));
  EXPECT_LT((model.look.measured_in_enu_m[0] - expected).norm(), 1e-3 * metres_per_px);
  // Its dot is drawn around that pixel: half a pixel from the mouse's corner.
  const Eigen::Vector2d dot = state.camera.page_from_enu(expected, page);
  EXPECT_NEAR(dot.x(), 300.5, 1e-3);
  EXPECT_NEAR(page.top() - dot.y(), 200.5, 1e-3);
}

TEST_F(MapGestures, ReadTheClassOfTheCellOnEachSideOfItsBorder) {
  show();
  const OverheadMap& map = made.map->map();
  const kit::Rect area = screen.at(kGround).rect;
  screen.hover(kGround, drawing());
  for (int column = 200; column < 700; column += 7) {
    screen.input().mouse_px = Eigen::Vector2d(area.left + column, area.top + 300.0);
    show();
    ASSERT_TRUE(state.readout);
    const Eigen::Vector2d middle =
        state.camera.enu_from_page({column + 0.5, state.where.top() - 300.5}, state.where);
    const ClassId wanted = map.contains(middle) ? map.class_at(middle) : ClassId{kUnclassified};
    EXPECT_EQ(state.readout->class_id.value_or(ClassId{kUnclassified}), wanted) << column;
  }
}

TEST_F(MapGestures, MeasuresByClicksUntilEscape) {
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

TEST_F(MapGestures, ADragWhileMeasuringMovesTheMapAndAddsNoPoint) {
  apply(actions::UseTool{MapTool::kMeasure});
  const Actions asked = screen.drag(kGround, 80.0, 0.0, drawing());
  EXPECT_THAT(model.look.measured_in_enu_m, IsEmpty());
  EXPECT_TRUE(std::holds_alternative<actions::LookAt>(asked.at(0)));
}

TEST_F(MapGestures, AClickPicksTheNearestParticleAndACardSaysWhatItIs) {
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

TEST_F(MapGestures, AParticleThatASmallerStepDoesNotHaveIsNotShown) {
  model.selected_particle = 400;
  show();
  EXPECT_FALSE(screen.has("Map/Particle/east"));
  EXPECT_FALSE(selected_particle(model));
}

}  // namespace map_gestures_test
}  // namespace nadir
