// SPDX-License-Identifier: Apache-2.0
#include "core/sim/route.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/sim/flight_path.h"

namespace nadir {
namespace route_test {

using testing::HasSubstr;

Route square() {
  return {.name = "square",
          .waypoints_in_enu_m = {{0.0, 0.0}, {60.0, 0.0}, {60.0, 40.0}, {0.0, 40.0}},
          .corner_radius_m = 5.0,
          .is_closed = true};
}

Route figure_eight() {
  return {.name = "eight",
          .waypoints_in_enu_m = {{0.0, 0.0},
                                 {30.0, 0.0},
                                 {60.0, 20.0},
                                 {90.0, 20.0},
                                 {90.0, -20.0},
                                 {60.0, -20.0},
                                 {30.0, 0.5},
                                 {0.0, 30.0}},
          .corner_radius_m = 6.0,
          .is_closed = true,
          .laps = 2};
}

class EveryRoute : public testing::TestWithParam<Route> {};

TEST_P(EveryRoute, IsFlownWithinAllItsLimits) {
  const Route route = GetParam();
  const auto path = build_flight_path(route);
  ASSERT_TRUE(path.has_value());
  const auto motions = plan_motion(*path, route, 0.01);
  double fastest_mps = 0.0;
  for (std::size_t i = 1; i < motions.size(); ++i) {
    const double step_s = motions[i].time_s - motions[i - 1].time_s;
    const double speed_mps = (motions[i].along_m - motions[i - 1].along_m) / step_s;
    const double bend = std::abs(path->at(motions[i].along_m).piece->curvature_per_m);
    EXPECT_GE(speed_mps, 0.0);
    EXPECT_LE(speed_mps, route.speed_mps + 1e-6);
    EXPECT_LE(std::abs(motions[i].acceleration_mps2), route.acceleration_mps2 + 1e-6);
    EXPECT_LE(std::abs(motions[i].speed_mps - motions[i - 1].speed_mps),
              route.acceleration_mps2 * step_s + 1e-6);
    EXPECT_LE(motions[i].speed_mps * motions[i].speed_mps * bend,
              route.lateral_acceleration_mps2 + 1e-6);
    fastest_mps = std::max(fastest_mps, motions[i].speed_mps);
  }
  EXPECT_NEAR(fastest_mps, route.speed_mps, 1e-6) << "and no slower than it needs to be";
  EXPECT_EQ(motions.front().speed_mps, 0.0);
  EXPECT_NEAR(motions.back().speed_mps, 0.0, 1e-6);
  EXPECT_NEAR(motions.back().along_m, path->length_m, 1e-6);
}

TEST_P(EveryRoute, HasContinuousYawAlongTheWayThatItFlies) {
  const auto flight = plan_flight(GetParam(), 1);
  ASSERT_TRUE(flight.has_value());
  const auto& poses = flight->poses();
  for (std::size_t i = 1; i < poses.size(); ++i) {
    const Rigid2 before = planar(poses[i - 1].pose);
    const Rigid2 now = planar(poses[i].pose);
    const Eigen::Vector2d step = now.translation_m() - before.translation_m();
    EXPECT_LT(std::abs(wrap_rad(now.yaw_rad - before.yaw_rad)), 0.06) << "at pose " << i;
    EXPECT_LT(step.norm(), 4.0 * 0.05 + 1e-6);
    if (step.norm() < 0.02) continue;
    EXPECT_LT(std::abs(wrap_rad(std::atan2(step.y(), step.x()) - now.yaw_rad)), 0.06);
  }
}

INSTANTIATE_TEST_SUITE_P(Route, EveryRoute, testing::Values(square(), figure_eight()));

TEST(PlanFlight, RoundsTheCornersOfASquareAndComesBack) {
  const auto path = build_flight_path(square());
  ASSERT_TRUE(path.has_value());
  // Three rounded corners save 2 r - r pi / 2 each; start and end are at the first waypoint itself.
  const double saved_m = 3.0 * 5.0 * (2.0 - std::numbers::pi / 2.0);
  EXPECT_NEAR(path->length_m, 200.0 - saved_m, 1e-9);
  const auto [last, along_m] = path->at(path->length_m);
  EXPECT_NEAR(last->place_in_enu_m(along_m).norm(), 0.0, 1e-9);
  Route two_laps = square();
  two_laps.laps = 2;
  // Between the laps the first waypoint is a corner like any other.
  EXPECT_NEAR(build_flight_path(two_laps)->length_m, 400.0 - saved_m * 7.0 / 3.0, 1e-9);
}

TEST(PlanFlight, JoinsItsPiecesWithoutGapsOrKinks) {
  const auto path = build_flight_path(figure_eight());
  ASSERT_TRUE(path.has_value());
  for (std::size_t i = 1; i < path->pieces.size(); ++i) {
    const PathPiece& before = path->pieces[i - 1];
    const PathPiece& after = path->pieces[i];
    EXPECT_NEAR((before.place_in_enu_m(before.length_m) - after.start_in_enu_m).norm(), 0.0, 1e-9);
    EXPECT_NEAR(wrap_rad(before.yaw_at_rad(before.length_m) - after.yaw_rad), 0.0, 1e-9);
  }
}

TEST(PlanFlight, FliesAtItsAltitudeAtTwentySamplesASecond) {
  const auto flight = plan_flight(square(), 1);
  ASSERT_TRUE(flight.has_value());
  EXPECT_EQ(flight->start_s(), 0.0);
  EXPECT_NEAR(flight->poses()[7].time_s, 0.35, 1e-12);
  for (const TimedPose& timed : flight->poses()) EXPECT_EQ(timed.pose.translation_m.z(), 2.0);
  // 187 m at 4 m/s are 47 s; starting, stopping and three corners at 2.7 m/s cost some seconds.
  EXPECT_GT(flight->end_s(), 48.0);
  EXPECT_LT(flight->end_s(), 62.0);
}

TEST(PlanFlight, IsTheSameForTheSameSeedAndSwaysOtherwiseForAnother) {
  const auto sway = [](std::uint64_t seed) {
    return attitude_of(plan_flight(square(), seed)->poses()[200].pose.rotation).roll_rad;
  };
  EXPECT_EQ(sway(1), sway(1));
  EXPECT_NE(sway(1), sway(2));
}

TEST(RouteFile, GivesTheRouteThatItSays) {
  const auto route = parse_route(R"(name = "loop"
corner_radius_m = 4
closed = true
laps = 3
speed_mps = 3.5
[[waypoint]]
name = "S"
east_m = 0
north_m = 0.5
[[waypoint]]
east_m = 60
north_m = 0
[[waypoint]]
east_m = 60
north_m = 40
)",
                                 "loop.toml");
  ASSERT_TRUE(route.has_value()) << route.error().message;
  EXPECT_EQ(route->name, "loop");
  ASSERT_EQ(route->waypoints_in_enu_m.size(), 3U);
  EXPECT_EQ(route->waypoints_in_enu_m[0], Eigen::Vector2d(0.0, 0.5));
  EXPECT_THAT(route->waypoint_names, testing::ElementsAre("S", "2", "3"));
  EXPECT_EQ(route->corner_radius_m, 4.0);
  EXPECT_TRUE(route->is_closed);
  EXPECT_EQ(route->laps, 3);
  EXPECT_EQ(route->speed_mps, 3.5);
  EXPECT_EQ(route->altitude_m, 2.0) << "the default";
}

TEST(RouteFile, IsRefusedInOneSentenceThatNamesTheFault) {
  const auto fault = [](const std::string& text) {
    const auto route = parse_route(text, "r.toml");
    return route ? std::string("none") : route.error().message;
  };
  const auto point = [](const std::string& east, const std::string& north) {
    return "[[waypoint]]\neast_m = " + east + "\nnorth_m = " + north + "\n";
  };
  const std::string points = point("0", "0") + point("10", "0") + point("10", "10");
  EXPECT_EQ(fault(points), "none");
  EXPECT_THAT(fault(""), HasSubstr("waypoint is missing"));
  EXPECT_THAT(fault("[[waypoint]]\neast_m = 3\n"), HasSubstr("north_m is missing"));
  EXPECT_THAT(fault(point("0", "0")), HasSubstr("at least two waypoints"));
  EXPECT_THAT(fault(point("0", "0") + point("0", "0") + point("5", "5")),
              HasSubstr("waypoint 1 is at the same"));
  EXPECT_THAT(fault(point("0", "0") + point("nan", "0")), HasSubstr("east_m"));
  EXPECT_THAT(fault(point("0", "0") + point("1e9", "0")), HasSubstr("waypoint 2"));
  EXPECT_THAT(fault("speed_mps = 0\n" + points), HasSubstr("speed_mps"));
  EXPECT_THAT(fault("speed_mps = \"fast\"\n" + points), HasSubstr("speed_mps"));
  EXPECT_THAT(fault("speed_mps = 1e-9\n" + points), HasSubstr("not in [0.1, 50]"));
  EXPECT_THAT(fault("acceleration_mps2 = 1e-9\n" + points), HasSubstr("not in [0.05, 20]"));
  EXPECT_THAT(fault("altitude_m = 0.1\n" + points), HasSubstr("altitude_m = 0.1 is not in [0.5"));
  EXPECT_EQ(fault("altitude_m = 0.5\n" + points), "none");
  EXPECT_THAT(fault("laps = 2\n" + points), HasSubstr("laps = 2"));
  EXPECT_THAT(fault("closed = true\nlaps = -7\n" + points), HasSubstr("laps"));
  EXPECT_THAT(fault("sped_mps = 2\n" + points), HasSubstr("did you mean speed_mps?"));
  EXPECT_THAT(fault(points + "hight = 2\n"), HasSubstr("hight"));
  EXPECT_THAT(fault(points), testing::Not(HasSubstr("\n")));
}

TEST(RouteFile, SaysWhichFileIsMissing) {
  const auto route = read_route("no/such/route.toml");
  ASSERT_FALSE(route.has_value());
  EXPECT_EQ(route.error().code, ErrorCode::kNotFound);
  EXPECT_THAT(route.error().message, HasSubstr("no/such/route.toml"));
}

TEST(PlanFlight, RefusesFlightsOfMoreThanFiftyKilometres) {
  Route route = square();
  route.waypoints_in_enu_m = {{0.0, 0.0}, {25'000.0, 0.0}, {25'000.0, 25'000.0}, {0.0, 25'000.0}};
  route.laps = 1000;
  const auto far = plan_flight(route, 1);
  ASSERT_FALSE(far.has_value());
  EXPECT_EQ(far.error().message, "square: is 100000.0 km long, and a flight may be 50 km");
  route = square();  // 200 m a lap.
  route.laps = 250;
  EXPECT_TRUE(validate(route).has_value());
  route.laps = 251;
  EXPECT_FALSE(validate(route).has_value());
}

TEST(PlanFlight, RefusesCornersThatCannotBeFlown) {
  Route back = square();
  back.waypoints_in_enu_m = {{0.0, 0.0}, {20.0, 0.0}, {0.0, 0.2}};
  back.is_closed = false;
  const auto turned = plan_flight(back, 1);
  ASSERT_FALSE(turned.has_value());
  EXPECT_THAT(turned.error().message, HasSubstr("turns back at (20.0, 0.0) m"));

  Route tight = square();
  tight.waypoints_in_enu_m = {{0.0, 0.0}, {10.0, 0.0}, {10.0, 0.5}, {20.0, 0.5}};
  tight.is_closed = false;
  const auto cramped = plan_flight(tight, 1);
  ASSERT_FALSE(cramped.has_value());
  EXPECT_THAT(cramped.error().message, HasSubstr("room for a radius of 0.25 m"));
}

}  // namespace route_test
}  // namespace nadir
