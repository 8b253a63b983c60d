// SPDX-License-Identifier: Apache-2.0
#include "core/sim/solid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/core/sim/solid_oracle.h"

namespace nadir {
namespace solid_test {

constexpr double kMiss = std::numeric_limits<double>::infinity();

Solid tilted(Solid::Shape shape) {
  return {.shape = shape,
          .label = kCar,
          .centre_in_enu_m = {0.3, -0.2, 1.1},
          .half_size_m = shape == Solid::Shape::kBox || shape == Solid::Shape::kEllipsoid
                             ? Eigen::Vector3d(1.5, 0.6, 0.8)
                             : Eigen::Vector3d(0.4, 0.4, 0.9),
          .heading = {std::cos(0.7), std::sin(0.7)}};
}

class EveryShape : public testing::TestWithParam<Solid::Shape> {};

TEST_P(EveryShape, HasANormalThatLeadsOutOfIt) {
  const Solid solid = tilted(GetParam());
  int hits = 0;
  for (int i = 0; i < 200; ++i) {
    const double angle = 0.31 * i;
    const Eigen::Vector3d origin(4.0 * std::cos(angle), 4.0 * std::sin(angle), 0.2 + 0.012 * i);
    const Eigen::Vector3d direction =
        solid.centre_in_enu_m - origin + Eigen::Vector3d(0.0, 0.0, 0.7 * std::sin(0.9 * i));
    const double t = first_hit(solid, origin, direction);
    if (t == kMiss) continue;
    ++hits;
    const Eigen::Vector3d point = origin + t * direction;
    const Eigen::Vector3d normal = outward_normal(solid, point);
    EXPECT_NEAR(normal.norm(), 1.0, 1e-12);
    EXPECT_LT(normal.dot(direction), 1e-9) << "the side that is hit is the one that is seen";
    EXPECT_FALSE(is_inside(solid, point + 1e-4 * normal));
    EXPECT_TRUE(is_inside(solid, point - 1e-4 * normal));
  }
  EXPECT_GT(hits, 150);
}

TEST_P(EveryShape, IsHitWhereASmallStepWalkEntersIt) {
  const Solid solid = tilted(GetParam());
  int hits = 0;
  for (int i = 0; i < 200; ++i) {
    const double angle = 0.31 * i;
    const Eigen::Vector3d origin(4.0 * std::cos(angle), 4.0 * std::sin(angle), 0.2 + 0.012 * i);
    const Eigen::Vector3d aim(0.9 * std::sin(1.7 * i), 0.9 * std::cos(2.3 * i),
                              1.0 + 1.1 * std::sin(0.9 * i));
    const Eigen::Vector3d direction = aim - origin;
    double walked = kMiss;
    for (double t = 0.0; t < 3.0; t += 2e-4) {
      if (is_inside(solid, origin + t * direction)) {
        walked = t;
        break;
      }
    }
    const double t = first_hit(solid, origin, direction);
    if (walked == kMiss) {
      // A step may jump over a sliver, so a graze may be missed by the walk alone.
      EXPECT_TRUE(t == kMiss || is_inside(solid, origin + (t + 1e-7) * direction));
      continue;
    }
    ++hits;
    EXPECT_NEAR(t, walked, 3e-4) << "ray " << i;
  }
  EXPECT_GT(hits, 40);
}

TEST_P(EveryShape, IsNotSeenFromInsideNorBehind) {
  const Solid solid = tilted(GetParam());
  const Eigen::Vector3d away(0.2, 1.0, 0.1);
  EXPECT_EQ(first_hit(solid, solid.centre_in_enu_m, away), kMiss);
  EXPECT_EQ(first_hit(solid, solid.centre_in_enu_m + 10.0 * away, away), kMiss);
}

TEST_P(EveryShape, FitsIntoItsFootprint) {
  const Solid solid = tilted(GetParam());
  const double outside_m = solid.footprint_radius_m() + 1e-6;
  for (int i = 0; i < 64; ++i) {
    const double angle = 0.0982 * i;
    const Eigen::Vector3d rim =
        solid.centre_in_enu_m + outside_m * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0.0);
    EXPECT_FALSE(is_inside(solid, rim));
  }
}

INSTANTIATE_TEST_SUITE_P(Solid,
                         EveryShape,
                         testing::Values(Solid::Shape::kBox,
                                         Solid::Shape::kCylinder,
                                         Solid::Shape::kEllipsoid,
                                         Solid::Shape::kCapsule));

}  // namespace solid_test
}  // namespace nadir
