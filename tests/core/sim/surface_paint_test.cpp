// SPDX-License-Identifier: Apache-2.0
#include "core/sim/surface_paint.h"

#include <gtest/gtest.h>

#include "core/sim/world.h"
#include "tests/core/sim/street_map.h"

namespace nadir {
namespace surface_paint_test {

TEST(Light, OnLevelGroundIsOneAndLeastAwayFromTheSun) {
  EXPECT_NEAR(light(Eigen::Vector3d::UnitZ()), 1.0F, 0.001F);
  const Eigen::Vector3d to_south_east = Eigen::Vector3d(1.0, -1.0, 0.0).normalized();
  EXPECT_GT(light(to_south_east), 1.4F * light(-to_south_east));
  EXPECT_EQ(light(-to_south_east), light(-Eigen::Vector3d::UnitZ())) << "both see the sky alone";
}

TEST(SurfacePaint, AMovingCarKeepsItsPaint) {
  const World world = raise_world(street_map(), {.moving_car_share = 1.0}, 3);
  ASSERT_FALSE(world.moving.empty());
  for (const Mover& mover : world.moving) {
    std::vector<Solid> now;
    std::vector<Solid> later;
    mover.place(0.0, now);
    mover.place(7.3, later);
    for (std::size_t i = 0; i < now.size(); ++i) {
      EXPECT_EQ(paint_of_solid(now[i], now[i].centre_in_enu_m),
                paint_of_solid(later[i], later[i].centre_in_enu_m));
    }
  }
}

TEST(SurfacePaint, TellsTrunkFromCrownAndHeadFromTrousers) {
  Solid tree{.shape = Solid::Shape::kCylinder, .label = kVegetation};
  const Paint trunk = paint_of_solid(tree, tree.centre_in_enu_m);
  tree.shape = Solid::Shape::kEllipsoid;
  const Paint crown = paint_of_solid(tree, tree.centre_in_enu_m);
  EXPECT_GT(trunk.x(), trunk.y()) << "brown";
  EXPECT_GT(crown.y(), crown.x()) << "green";
  const Solid person{.shape = Solid::Shape::kCapsule,
                     .label = kPedestrian,
                     .centre_in_enu_m = {0.0, 0.0, 0.9},
                     .half_size_m = {0.25, 0.25, 0.9}};
  EXPECT_GT(paint_of_solid(person, {0.0, 0.0, 1.7}).sum(),
            paint_of_solid(person, {0.0, 0.0, 0.3}).sum());
}

}  // namespace surface_paint_test
}  // namespace nadir
