// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/map_view.h"

#include <gmock/gmock.h>

#include "tests/widgets/panels/shown_map.h"

namespace nadir {
namespace map_view_test {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Not;

using MapView = ShownMap;

TEST_F(MapView, TheGroundIsAskedForWithTheCameraThatLinesAreDrawnWith) {
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

TEST_F(MapView, TwoRunsCanLieBesideEachOtherUnderOneCamera) {
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

TEST_F(MapView, WithoutAMapTheRunShowsAndTheMapIsOneClickAway) {
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

TEST_F(MapView, TheGroundIsAskedForInPartsWhereLinesLieBetween) {
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

TEST_F(MapView, TellsWhatItsControlsCover) {
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

TEST_F(MapView, TheRoomOfAFittedMapRestsWhileTheRunPlays) {
  model.look.layer(Layer::kLegend).is_visible = true;
  model.look.layer(Layer::kTopview).is_visible = true;
  model.look.layer(Layer::kDisagreement).is_visible = true;
  show();
  const MapRoom room = state.room;
  const double legend_px = state.legend_height_px;
  ASSERT_GT(room.bottom, 0.02);
  RunStep step = *made.step;
  for (ClassId id = 0; id < kClassCount; ++id) {  // a topview of every class that there is
    SemanticTopview topview;
    topview.cells.resize(1);
    for (std::size_t next = id + 1U; next < topview.class_begin.size(); ++next) {
      topview.class_begin.at(next) = 1;
    }
    step.topview = topview;
    model.step = std::make_shared<const RunStep>(step);
    show();
    EXPECT_EQ(state.room, room);
  }
  EXPECT_GT(state.legend_height_px, legend_px) << "the legend names what was seen";
  step.particles.reset();
  step.topview.reset();
  model.step = std::make_shared<const RunStep>(step);
  show();
  EXPECT_EQ(state.room, room) << "a step that saw nothing";
  model.step.reset();
  show();
  EXPECT_EQ(state.room, room) << "a step that is not decoded yet";
}

TEST_F(MapView, WithoutAnythingOpenItOffersTheDemo) {
  model = {};
  model.look = default_map_look();
  EXPECT_THAT(screen.click("Map/Open the demo", drawing()),
              ElementsAre(Action(actions::OpenDemo{})));
  model.reading = "loop";
  show();
  EXPECT_TRUE(screen.shows("loop is being read"));
}

TEST_F(MapView, ARunShowsBeforeItsMapIsRead) {
  model.map.reset();
  model.reading = "town";
  show();
  EXPECT_TRUE(screen.has(kGround));
  EXPECT_TRUE(screen.shows("Reading town…"));
}

}  // namespace map_view_test
}  // namespace nadir
