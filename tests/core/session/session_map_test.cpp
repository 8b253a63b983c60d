// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include "tests/core/session/session_fixture.h"

namespace nadir {
namespace session_map_test {

using testing::HasSubstr;

constexpr double kPi = std::numbers::pi;

class SessionMapTest : public SessionTest {
 protected:
  [[nodiscard]] const MapLook& look() const { return session_->view().map; }
  [[nodiscard]] Rigid2 estimate() const {
    return document().steps[*session_->step_index()].estimate.moments.mean;
  }
  /// Where a point lies in the view: right and up from its middle, in widths of the view.
  [[nodiscard]] Eigen::Vector2d in_view(const Eigen::Vector2d& point_in_enu_m) const {
    const MapLook now = session_->resolved_map_look();
    const Eigen::Vector2d up(std::cos(now.up_rad), std::sin(now.up_rad)), right(up.y(), -up.x());
    const Eigen::Vector2d away = point_in_enu_m - now.centre_in_enu_m;
    return Eigen::Vector2d(away.dot(right), away.dot(up)) / now.width_m;
  }
  void expect_all_in_view(const std::vector<Eigen::Vector2d>& points, double aspect) const {
    double widest = 0.0;
    for (const Eigen::Vector2d& point : points) {
      const Eigen::Vector2d at = in_view(point);
      EXPECT_LE(std::abs(at.x()), 0.5);
      EXPECT_LE(std::abs(at.y()), 0.5 / aspect);
      widest = std::max({widest, std::abs(at.x()), std::abs(at.y()) * aspect});
    }
    EXPECT_GT(widest, 0.4) << "and not much more than that";
  }
};

TEST_F(SessionMapTest, ShowsAllOfTheFlightBeforeAnythingElseIsChosen) {
  open_run();
  EXPECT_EQ(look().width_m, 0.0);
  std::vector<Eigen::Vector2d> points;
  for (const RunStep& step : document().steps) points.push_back(step.truth_in_enu->translation_m());
  for (const Eigen::Vector2d& point : points) {
    EXPECT_LE(in_view(point).cwiseAbs().maxCoeff(), 0.5);
  }
  EXPECT_LT(session_->resolved_map_look().width_m, 80.0) << "not all of the map";
}

TEST_F(SessionMapTest, FitsTheMapIntoAViewOfAnyShapeAndTurn) {
  open_run();
  const std::vector<Eigen::Vector2d> corners = {{0, 0}, {80, 0}, {80, 60}, {0, 60}};
  for (const double aspect : {0.5, 1.0, 1.5, 3.0}) {
    session_->set_map_aspect(aspect);
    for (const char* turn : {"up north", "rotate 37", "rotate 90"}) {
      act(turn);
      act("fit map");
      expect_all_in_view(corners, aspect);
    }
  }
  session_->set_map_aspect(std::nan(""));
  act("up north");
  act("fit map");
  expect_all_in_view(corners, 3.0);
}

TEST_F(SessionMapTest, FitsFlightAndParticles) {
  open_run();
  act("fit particles");
  std::vector<Eigen::Vector2d> points;
  const ParticleSet& particles = *session_->step()->particles;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    points.push_back(particles.pose(i).translation_m());
  }
  for (const Eigen::Vector2d& point : points) EXPECT_LE(std::abs(in_view(point).x()), 0.5);
  EXPECT_FALSE(look().is_following);
  act("follow on");
  act("fit flight");
  EXPECT_FALSE(look().is_following);
}

TEST_F(SessionMapTest, CannotFitWhatIsNotThere) {
  EXPECT_EQ(refused("fit map"), "no map is open: open one first");
  EXPECT_EQ(refused("fit particles"), "no run is open: open one first");
}

TEST_F(SessionMapTest, ZoomsAroundAPointThatStays) {
  act("look 10 20 100");
  act("rotate 30");
  const Eigen::Vector2d stays(25.0, 5.0);
  const Eigen::Vector2d before = in_view(stays);
  act("zoom 2.5 25 5");
  EXPECT_LT((in_view(stays) - before).norm(), 1e-12);
  EXPECT_DOUBLE_EQ(look().width_m, 40.0);
  act("zoom 0.4 25 5");
  EXPECT_LT((look().centre_in_enu_m - Eigen::Vector2d(10.0, 20.0)).norm(), 1e-9);
  act("zoom 2");
  EXPECT_LT((look().centre_in_enu_m - Eigen::Vector2d(10.0, 20.0)).norm(), 1e-9) << "the middle";
}

TEST_F(SessionMapTest, ZoomsNoFartherThanThereIsAMapAndKeepsThePointThere) {
  act("look 0 0 1");
  const Eigen::Vector2d before = in_view({0.25, 0.0});
  act("zoom 1000 0.25 0");
  EXPECT_DOUBLE_EQ(look().width_m, kLeastMapWidthM);
  EXPECT_LT((in_view({0.25, 0.0}) - before).norm(), 1e-9);
  act("zoom 0.000000001");
  EXPECT_DOUBLE_EQ(look().width_m, kMostMapWidthM);
  EXPECT_THAT(refused("zoom 0"), HasSubstr("cannot be shown 0 times larger"));
  EXPECT_THAT(refused("zoom -2"), HasSubstr("cannot be shown"));
}

TEST_F(SessionMapTest, FollowsTheEstimateUntilTheMapIsMoved) {
  open_run();
  act("look 10 20 60");
  act("follow on");
  for (const char* moment : {"step 3", "step 5"}) {
    act(moment);
    EXPECT_EQ(session_->resolved_map_look().centre_in_enu_m, estimate().translation_m());
  }
  act("zoom 2 0 0");
  EXPECT_TRUE(look().is_following) << "zooming does not lose it";
  EXPECT_EQ(session_->resolved_map_look().centre_in_enu_m, estimate().translation_m());
  const Eigen::Vector2d last = estimate().translation_m();
  act("follow off");
  EXPECT_EQ(look().centre_in_enu_m, last) << "it stays where it was";
  act("follow on");
  act("look 1 2");
  EXPECT_FALSE(look().is_following);
}

TEST_F(SessionMapTest, TurnsWithTheHeading) {
  open_run();
  act("look 10 20 60");
  act("up heading");
  act("go end");
  EXPECT_DOUBLE_EQ(session_->resolved_map_look().up_rad, estimate().yaw_rad);
  act("up free");
  EXPECT_DOUBLE_EQ(look().up_rad, estimate().yaw_rad) << "as it was";
  act("go start");
  EXPECT_NE(session_->resolved_map_look().up_rad, estimate().yaw_rad);
  act("up north");
  EXPECT_DOUBLE_EQ(session_->resolved_map_look().up_rad, kPi / 2.0);
}

TEST_F(SessionMapTest, TurnsCounterClockwise) {
  act("look 0 0 100");
  EXPECT_GT(in_view({0.0, 10.0}).y(), 0.0);
  act("rotate 90");
  EXPECT_LT(in_view({0.0, 10.0}).x(), -0.09) << "north has gone to the left";
  EXPECT_EQ(look().up, MapUp::kFree);
  act("rotate -90");
  EXPECT_NEAR(in_view({0.0, 10.0}).x(), 0.0, 1e-12);
}

TEST_F(SessionMapTest, GoesToPlacesInAnyNotation) {
  EXPECT_EQ(refused("place 1 2"), "no map is open: open a map or a run first");
  open_run();
  act("look 0 0 50");
  act("place 12.5 -30");
  EXPECT_EQ(look().centre_in_enu_m, Eigen::Vector2d(12.5, -30.0));
  EXPECT_EQ(look().width_m, 50.0) << "as large as before";
  const Geodetic there = session_->map()->index->map().plane.geodetic_from_enu({30.0, 20.0});
  act("place " + geodetic_text(there));
  EXPECT_LT((look().centre_in_enu_m - Eigen::Vector2d(30.0, 20.0)).norm(), 0.2);
  EXPECT_THAT(refused("place nowhere"), HasSubstr("'nowhere' is no place"));
}

TEST_F(SessionMapTest, RefusesNumbersThatAreNoPlace) {
  EXPECT_THAT(refused("look 1 2 0"), HasSubstr("a width of 0 m is not in [0.1, 1e+06]"));
  EXPECT_FALSE(session_->apply(actions::LookAt{std::nan(""), 0.0, {}}));
  EXPECT_FALSE(session_->apply(actions::Zoom{2.0, 1.0, {}})) << "half a point";
  EXPECT_FALSE(session_->apply(actions::Rotate{INFINITY}));
  EXPECT_FALSE(session_->apply(actions::MeasurePoint{{}, 1.0}));
  EXPECT_EQ(session_->view(), default_view_state());
}

TEST_F(SessionMapTest, ShowsRaisesAndColoursLayers) {
  act("layer labels on");
  act("layer-opacity labels 0.3");
  act("layer-colour truth #A0b1C2");
  EXPECT_TRUE(look().layer(Layer::kLabels).is_visible);
  EXPECT_EQ(look().layer(Layer::kLabels).opacity, 0.3);
  EXPECT_EQ(look().layer(Layer::kTruth).colour, "#A0b1C2");
  act("layer-colour truth");
  EXPECT_FALSE(look().layer(Layer::kTruth).colour);
  act("layer-move picture 2");
  EXPECT_EQ(look().order[2], Layer::kPicture);
  EXPECT_EQ(look().order[0], Layer::kLabels);
  act("layer-move picture 99");
  EXPECT_EQ(look().order[kLayerCount - 2], Layer::kPicture);
  EXPECT_EQ(look().order.back(), Layer::kLegend) << "nothing lies on the legend";
  act("layer-move particles -99");
  EXPECT_EQ(look().order.front(), Layer::kParticles);
  EXPECT_EQ(look().order.size(), kLayerCount);
  EXPECT_EQ(refused("layer-move legend -1"), "the legend always lies on top");
  act("undo");
  EXPECT_NE(look().order.front(), Layer::kParticles);
  act("undo");
  EXPECT_EQ(look().order[2], Layer::kPicture) << "each move is a step";
  EXPECT_THAT(refused("layer-colour truth red"), HasSubstr("'red' is no colour: write #RRGGBB"));
}

TEST_F(SessionMapTest, SelectsParticlesThatThereAre) {
  EXPECT_THAT(refused("select-particle 1"), HasSubstr("no run is open"));
  open_run();
  act("select-particle 299");
  EXPECT_EQ(session_->view().selected_particle, 299);
  EXPECT_THAT(refused("select-particle 300"),
              HasSubstr("there is no particle 300: this moment has 300"));
  EXPECT_THAT(refused("select-particle -1"), HasSubstr("there is no particle -1"));
  act("select-particle");
  EXPECT_FALSE(session_->view().selected_particle);
}

TEST_F(SessionMapTest, LetsGoOfAParticleWithItsStep) {
  open_run();
  act("seek 2");
  act("select-particle 7");
  act("theme light");
  session_->poll(0.0);
  EXPECT_EQ(session_->view().selected_particle, 7) << "while the step is the same";
  act("step 1");
  EXPECT_FALSE(session_->view().selected_particle) << "another particle has its number now";
  EXPECT_EQ(session_->undo_title(), "Light theme");
  act("undo");
  EXPECT_FALSE(session_->view().selected_particle);
  act("select-particle 7");
  act("play on");
  session_->poll(1.0);
  EXPECT_FALSE(session_->view().selected_particle);
}

TEST_F(SessionMapTest, MeasuresPointByPoint) {
  act("tool measure");
  act("measure 1 2");
  act("measure 3 4");
  EXPECT_EQ(look().tool, MapTool::kMeasure);
  ASSERT_EQ(look().measured_in_enu_m.size(), 2U);
  EXPECT_EQ(look().measured_in_enu_m[1], Eigen::Vector2d(3.0, 4.0));
  act("undo");
  EXPECT_EQ(look().measured_in_enu_m.size(), 1U) << "points are taken back one by one";
  act("measure");
  EXPECT_TRUE(look().measured_in_enu_m.empty());
}

}  // namespace session_map_test
}  // namespace nadir
