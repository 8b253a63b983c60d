// SPDX-License-Identifier: Apache-2.0
#include "core/sim/world.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/sim/ground.h"
#include "tests/core/sim/street_map.h"

namespace nadir {
namespace world_test {

using testing::AnyOf;
using testing::SizeIs;

int count_of(const std::vector<Solid>& solids, ClassId label) {
  return static_cast<int>(std::count_if(solids.begin(), solids.end(),
                                        [&](const Solid& solid) { return solid.label == label; }));
}

WorldOptions bare() {
  return {.tree_share = 0.0,
          .pole_share = 0.0,
          .parked_car_share = 0.0,
          .moving_car_share = 0.0,
          .pedestrian_share = 0.0};
}

TEST(World, HasNoObjectsWhereAllSharesAreZero) {
  const World world = raise_world(street_map(), bare(), 3);
  EXPECT_THAT(world.standing, SizeIs(0));
  EXPECT_THAT(world.moving, SizeIs(0));
}

TEST(World, HasEveryKindOfObjectInAStreet) {
  const std::vector<Solid> solids = raise_world(street_map(), {}, 3).solids_at(0.0);
  for (const ClassId label : {kVegetation, kPole, kStreetLight, kCar, kPedestrian}) {
    EXPECT_GT(count_of(solids, label), 0) << class_info(label).name;
  }
}

TEST(World, IsTheSameForTheSameSeedAndAnotherForAnother) {
  const auto places = [](std::uint64_t seed) {
    std::vector<double> values;
    for (const Solid& solid : raise_world(street_map(), {}, seed).solids_at(12.5)) {
      values.insert(values.end(), solid.centre_in_enu_m.begin(), solid.centre_in_enu_m.end());
    }
    return values;
  };
  EXPECT_EQ(places(3), places(3));
  EXPECT_NE(places(3), places(4));
}

TEST(World, PlantsTreesAndPolesOnOpenGroundOnly) {
  const OverheadMap map = street_map();
  WorldOptions options = bare();
  options.tree_share = 1.0;
  options.pole_share = 1.0;
  const World world = raise_world(map, options, 5);
  EXPECT_GT(world.standing.size(), 40U);
  for (const Solid& solid : world.standing) {
    EXPECT_THAT(map.class_at(solid.centre_in_enu_m.head<2>()),
                AnyOf(kSidewalk, kTerrain, kVegetation));
  }
}

TEST(World, ParksCarsAlongTheEdgeOfTheRoadAndNotBesideIt) {
  const OverheadMap map = street_map();
  WorldOptions options = bare();
  options.parked_car_share = 1.0;
  const World world = raise_world(map, options, 5);
  EXPECT_GT(world.standing.size(), 10U);
  for (const Solid& part : world.standing) {
    const double along_axis = std::max(std::abs(part.heading.x()), std::abs(part.heading.y()));
    EXPECT_NEAR(along_axis, 1.0, 0.02) << "the streets run along the axes";
    const Eigen::Vector2d across(-part.heading.y(), part.heading.x());
    for (const double side : {-1.0, 1.0}) {
      for (const double end : {-1.0, 1.0}) {
        const Eigen::Vector2d corner = part.centre_in_enu_m.head<2>() +
                                       0.95 * end * part.half_size_m.x() * part.heading +
                                       0.95 * side * part.half_size_m.y() * across;
        EXPECT_THAT(map.class_at(corner), AnyOf(kRoad, kLaneMarking));
      }
    }
  }
}

TEST(World, KeepsMovingThingsOnTheirGroundForEver) {
  const OverheadMap map = street_map();
  const World world = raise_world(map, {}, 9);
  ASSERT_FALSE(world.moving.empty());
  for (double time_s = 0.0; time_s < 300.0; time_s += 7.3) {
    for (const Mover& mover : world.moving) {
      std::vector<Solid> parts;
      mover.place(time_s, parts);
      for (const Solid& part : parts) {
        const ClassId ground = map.class_at(part.centre_in_enu_m.head<2>());
        if (part.label == kCar) {
          EXPECT_THAT(ground, AnyOf(kRoad, kLaneMarking));
        } else {
          EXPECT_THAT(ground, AnyOf(kSidewalk, kTerrain, kVegetation));
        }
      }
    }
  }
}

TEST(Mover, GoesToTheEndTurnsAndComesBack) {
  const Mover mover{.parts = {{.centre_in_enu_m = {1.0, 0.5, 0.7}}},
                    .from_in_enu_m = {10.0, 20.0},
                    .to_in_enu_m = {10.0, 24.0},
                    .ground_m = 0.12,
                    .speed_mps = 2.0,
                    .phase_m = 1.0};
  std::vector<Solid> parts;
  mover.place(0.5, parts);  // two metres on its way north, the part ahead of it and to its left
  mover.place(2.5, parts);  // six metres: two back from the far end, heading south
  mover.place(4.5, parts);  // ten metres: out again
  EXPECT_TRUE(parts[0].centre_in_enu_m.isApprox(Eigen::Vector3d(9.5, 23.0, 0.82)));
  EXPECT_TRUE(parts[1].centre_in_enu_m.isApprox(Eigen::Vector3d(10.5, 21.0, 0.82)));
  EXPECT_TRUE(parts[2].centre_in_enu_m.isApprox(parts[0].centre_in_enu_m));
  EXPECT_TRUE(parts[1].heading.isApprox(Eigen::Vector2d(0.0, -1.0)));
}

TEST(LongestRun, FollowsAStripAndStopsAtItsEnds) {
  const auto is_free = [](const Eigen::Vector2d& place) {
    return std::abs(place.y()) < 0.6 && std::abs(place.x()) < 20.25;
  };
  const auto run = longest_run({2.0, 0.0}, is_free, 10.0, 100.0);
  ASSERT_TRUE(run.has_value());
  EXPECT_NEAR((run->to_in_enu_m - run->from_in_enu_m).norm(), 40.0, 0.01);
  EXPECT_NEAR(run->from_in_enu_m.y(), 0.0, 1e-9);
  EXPECT_FALSE(longest_run({2.0, 0.0}, is_free, 50.0, 100.0).has_value()) << "too short";
  EXPECT_FALSE(longest_run({2.0, 1.0}, is_free, 10.0, 100.0).has_value()) << "not free at all";
}

TEST(Ground, TellsTheDirectionOfAStraightEdgeAndNoneAtACorner) {
  const OverheadMap map = street_map();
  const Relief relief = raise_relief(map, 0.12, 1);
  const Ground ground(map, relief);
  const auto along = ground.edge_direction({20.0, 33.0});
  ASSERT_TRUE(along.has_value());
  EXPECT_NEAR(std::abs(along->x()), 1.0, 1e-3);
  EXPECT_FALSE(ground.edge_direction({36.2, 33.8}).has_value());
  EXPECT_NEAR(ground.inside_road_m({20.0, 33.0}), 1.0, 0.21);
  EXPECT_EQ(ground.inside_road_m({-5.0, 33.0}), 0.0);
  EXPECT_NEAR(ground.height_m({20.0, 35.0}), 0.12, 1e-6);
}

}  // namespace world_test
}  // namespace nadir
