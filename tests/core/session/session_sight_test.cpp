// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "tests/core/session/session_fixture.h"

namespace nadir {
namespace session_sight_test {

class SessionSightTest : public SessionTest {
 protected:
  [[nodiscard]] const MapLook& look() const { return session_->view().map; }
  [[nodiscard]] const RunStep& step() const { return document().steps[*session_->step_index()]; }
  /// Where a point lies in the view: shares of its width from the left and of its height from below.
  [[nodiscard]] Eigen::Vector2d share_at(const Eigen::Vector2d& point_in_enu_m,
                                         double aspect) const {
    const MapLook now = session_->resolved_map_look();
    const Eigen::Vector2d up(std::cos(now.up_rad), std::sin(now.up_rad)), right(up.y(), -up.x());
    const Eigen::Vector2d away = (point_in_enu_m - now.centre_in_enu_m) / now.width_m;
    return {0.5 + away.dot(right), 0.5 + away.dot(up) * aspect};
  }
};

TEST_F(SessionSightTest, FitsIntoWhatControlsLeaveFree) {
  open_run();
  const std::vector<Eigen::Vector2d> corners = {{0, 0}, {80, 0}, {80, 60}, {0, 60}};
  for (const double aspect : {0.6, 1.0, 2.2}) {
    const MapRoom room{aspect, 0.10, 0.02, 0.20, 0.05};
    session_->set_map_room(room);
    for (const char* turn : {"up north", "rotate 37", "rotate 120"}) {
      act(turn);
      act("fit map");
      Eigen::Vector2d least(1.0, 1.0), most(0.0, 0.0);
      for (const Eigen::Vector2d& corner : corners) {
        const Eigen::Vector2d at = share_at(corner, aspect);
        least = least.cwiseMin(at);
        most = most.cwiseMax(at);
      }
      EXPECT_GE(least.x(), 0.10);
      EXPECT_LE(most.x(), 0.98);
      EXPECT_GE(least.y(), 0.20);
      EXPECT_LE(most.y(), 0.95);
      const double widest = std::max((most.x() - least.x()) / 0.88, (most.y() - least.y()) / 0.75);
      EXPECT_GT(widest, 0.8) << "and not much smaller than that";
      // In the middle of what is free.
      EXPECT_NEAR((least.x() + most.x()) / 2.0, 0.54, 1e-9);
      EXPECT_NEAR((least.y() + most.y()) / 2.0, 0.575, 1e-9);
    }
  }
}

TEST_F(SessionSightTest, PassesOverARoomThatIsNone) {
  open_run();
  session_->set_map_room({1.5, 0.1, 0.0, 0.0, 0.0});
  act("fit map");
  const MapLook before = look();
  for (const MapRoom& room : {MapRoom{0.0, 0.0, 0.0, 0.0, 0.0}, MapRoom{1.5, 0.6, 0.5, 0.0, 0.0},
                              MapRoom{1.5, 0.0, 0.0, -0.1, 0.0}, MapRoom{NAN, 0.0, 0.0, 0.0, 0.0},
                              MapRoom{1.5, 0.0, 0.0, NAN, 0.0}}) {
    session_->set_map_room(room);
    act("fit map");
    EXPECT_EQ(look(), before);
  }
}

TEST_F(SessionSightTest, GoingToAMomentBringsItIntoView) {
  open_run();
  act("bookmark");  // at the start
  act("look -500 -500 30");
  const std::string last = *session_->undo_title();
  act("go worst");
  const Eigen::Vector2d at = share_at(step().estimate.moments.mean.translation_m(), 1.5);
  EXPECT_GT(at.minCoeff(), 0.0);
  EXPECT_LT(at.maxCoeff(), 1.0);
  EXPECT_EQ(look().width_m, 30.0) << "as large as it was";
  EXPECT_EQ(session_->undo_title(), last) << "time is not undone, and neither is this";
  const MapLook there = look();
  act("go worst");
  EXPECT_EQ(look(), there) << "what is in view stays where it is";
  act("look -500 -500 30");
  act("go previous-bookmark");
  EXPECT_LT((look().centre_in_enu_m - step().estimate.moments.mean.translation_m()).norm(), 30.0);
  // Time that only passes leaves the map alone.
  act("look -500 -500 30");
  act("seek 2");
  act("step 1");
  act("go end");
  EXPECT_EQ(look().centre_in_enu_m, Eigen::Vector2d(-500.0, -500.0));
}

TEST_F(SessionSightTest, TheMapGoesAlongWithAVehicleThatATimeJumpWouldTakeOutOfIt) {
  open_run();
  act("seek 0");
  const Eigen::Vector2d start = step().estimate.moments.mean.translation_m();
  act(fmt::format("look {} {} 8", start.x(), start.y()));
  const std::string last = *session_->undo_title();
  const auto is_in_view = [this] {
    const Eigen::Vector2d at = share_at(step().estimate.moments.mean.translation_m(), 1.5);
    return at.minCoeff() > 0.0 && at.maxCoeff() < 1.0;
  };
  for (const char* jump : {"go end", "seek 0.4", "go start", "step 9", "step -9"}) {
    act(jump);
    EXPECT_TRUE(is_in_view()) << jump;
    EXPECT_EQ(look().width_m, 8.0) << jump;
  }
  EXPECT_NE(look().centre_in_enu_m, start);
  EXPECT_EQ(session_->undo_title(), last) << "time is not undone, and neither is this";
  EXPECT_FALSE(look().is_following);
}

TEST_F(SessionSightTest, AClickOnAMarkGoesToItsMomentAsTheKeyDoes) {
  open_run();
  act("look -500 -500 30");
  act("go worst");
  const MapLook there = look();
  const double time_s = session_->playback().time_s;
  act("look -500 -500 30");
  act("seek 0");
  ASSERT_TRUE(session_->apply(actions::GoToMoment{time_s}));
  EXPECT_EQ(session_->playback().time_s, time_s);
  EXPECT_EQ(look(), there);
  EXPECT_FALSE(session_->apply(actions::GoToMoment{NAN}));
}

TEST_F(SessionSightTest, AVehicleUnderTheLegendIsInSightAndMovesNoMap) {
  open_run();
  act("seek 0");
  const Eigen::Vector2d start = step().estimate.moments.mean.translation_m();
  session_->set_map_room({1.0, 0.1, 0.0, 0.3, 0.0});
  act(fmt::format("look {} {} 100", start.x(), start.y() + 45.0));
  const MapLook before = look();
  ASSERT_LT(share_at(start, 1.0).y(), 0.1) << "a legend lies over it";
  act("step 1");
  EXPECT_EQ(look(), before);
  // Where it leaves the page, its new place is in the middle of what is free.
  act(fmt::format("look {} {} 4", start.x(), start.y()));
  act("go end");
  const Eigen::Vector2d at = share_at(step().estimate.moments.mean.translation_m(), 1.0);
  EXPECT_NEAR(at.x(), 0.55, 1e-9);
  EXPECT_NEAR(at.y(), 0.65, 1e-9);
}

TEST_F(SessionSightTest, AScrubOverMarksIsNoWishToLookAtThem) {
  open_run();
  act("go end");
  act("bookmark");  // at the last moment, where a scrub beyond the end stops too
  act("seek 0");
  act("look 40 30 40000");
  act("layer labels off");
  act("undo");
  const MapLook wide = look();
  const std::string next = *session_->redo_title(), last = *session_->undo_title();
  for (const OpenRun& run : session_->runs()) {
    for (const WorstMoment& moment : run.moments) {
      ASSERT_TRUE(session_->apply(actions::Seek{moment.time_s}));
    }
  }
  act("seek 1e9");
  EXPECT_EQ(session_->playback().time_s, document().duration_s());
  EXPECT_EQ(look(), wide) << "a scrub does not zoom";
  EXPECT_EQ(session_->undo_title(), last);
  EXPECT_EQ(session_->redo_title(), next) << "nothing that could be done again is dropped";
  act(fmt::format("moment {}", document().duration_s()));
  EXPECT_LT(look().width_m, 400.0) << "who clicks its mark looks at it";
}

TEST_F(SessionSightTest, GoingToAMomentThatWouldBeTinyComesNear) {
  open_run();
  act("look 40 30 40000");
  for (const char* go : {"go worst", "go previous-worst", "go next-worst"}) {
    act("look 40 30 40000");
    const auto gone = session_->apply(*parse_action(go));
    if (!gone) continue;  // there is none before or behind
    EXPECT_LT(look().width_m, 400.0) << go;
    const Eigen::Vector2d at = share_at(step().estimate.moments.mean.translation_m(), 1.5);
    EXPECT_NEAR(at.x(), 0.5, 0.4) << go;
    EXPECT_NEAR(at.y(), 0.5, 0.4) << go;
  }
  act("go worst");
  const MapLook there = look();
  act("go worst");
  EXPECT_EQ(look(), there) << "what is seen well stays";
}

TEST_F(SessionSightTest, TheScaleThatAMomentTookCanBeTakenBack) {
  open_run();
  act("look 40 30 40000");
  const MapLook wide = look();
  act("go worst");
  const MapLook near = look();
  ASSERT_LT(near.width_m, 400.0);
  act("undo");
  EXPECT_EQ(look(), wide);
  act("redo");
  EXPECT_EQ(look(), near);
}

TEST_F(SessionSightTest, GoingToAMomentShowsAllOfItsParticles) {
  RerunTask task = SmallWorld::get().task(scratch_.path() / "lost.nadir");
  task.prior = GlobalPrior{};
  task.options.localiser.global_particle_count = 400;
  ASSERT_TRUE(rerun(task, {}, [](RerunProgress) {}));
  act(open(task.run));
  settle();
  act("look 40 30 12");  // the first steps know nothing: they are all over the map
  act("bookmark");
  act("seek 3");
  act("go previous-bookmark");
  settle();
  ASSERT_NE(session_->step(), nullptr);
  const ParticleSet& particles = *session_->step()->particles;
  std::size_t in_sight = 0;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const Eigen::Vector2d at = share_at({particles.x_in_enu_m[i], particles.y_in_enu_m[i]}, 1.5);
    if (at.minCoeff() >= 0.0 && at.maxCoeff() <= 1.0) ++in_sight;
  }
  EXPECT_GT(in_sight, particles.size() * 97 / 100);
}

TEST_F(SessionSightTest, AMapThatFollowsComesNearButGoesOnFollowing) {
  open_run();
  act("look 0 0 40000");
  act("follow on");
  act("go worst");
  EXPECT_TRUE(look().is_following);
  EXPECT_LT(look().width_m, 400.0);
}

TEST_F(SessionSightTest, AMomentUnderTheToolsIsNotInView) {
  open_run();
  act("go worst");
  session_->set_map_room({1.0, 0.2, 0.0, 0.0, 0.0});
  const Eigen::Vector2d place = step().estimate.moments.mean.translation_m();
  // At a tenth of the width from the left.
  act("look " + std::to_string(place.x() + 20.0) + " " + std::to_string(place.y()) + " 50");
  act("go worst");
  EXPECT_GE(share_at(place, 1.0).x(), 0.2);
}

TEST_F(SessionSightTest, AMapThatFollowsOrShowsAllIsNotMoved) {
  open_run();
  const MapLook before = look();
  act("go worst");
  EXPECT_EQ(look(), before) << "all of the flight is shown";
  act("look 0 0 10");
  act("follow on");
  const MapLook following = look();
  act("go next-worst");
  EXPECT_EQ(look(), following);
}

}  // namespace session_sight_test
}  // namespace nadir
