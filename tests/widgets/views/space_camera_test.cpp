// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/space_camera.h"

#include <Eigen/LU>
#include <numbers>

#include "tests/widgets/views/space_page.h"

namespace nadir {
namespace space_camera_test {

constexpr PageRect kWhere{30.0, 10.0, 400.0, 300.0};

std::vector<SpaceCamera> cameras() {
  std::vector<SpaceCamera> made;
  for (const double yaw : {0.0, 0.7, -2.5, std::numbers::pi}) {
    for (const double down : {0.05, 0.5, 1.2, std::numbers::pi / 2.0}) {
      made.push_back({{12.0, -7.0, 0.0}, 35.0, yaw, down, 0.6});
    }
  }
  return made;
}

TEST(SpaceCamera, SeesPointsWhereAPinholeCameraSeesThem) {
  for (const SpaceCamera& camera : cameras()) {
    const PinholeOracle oracle(camera, kWhere);
    for (const Eigen::Vector3d& offset :
         {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(5, 3, 2), Eigen::Vector3d(-4, 8, 0.5),
          Eigen::Vector3d(1, -9, 6), Eigen::Vector3d(90, 90, 0), Eigen::Vector3d(-90, -90, 0)}) {
      const Eigen::Vector3d point = camera.target_in_enu_m + offset;
      const auto expected = oracle.page_from_enu(point);
      const auto seen = camera.page_from_enu(point, kWhere);
      ASSERT_EQ(seen.has_value(), expected.has_value());
      if (!seen) continue;
      EXPECT_LT((*seen - *expected).norm(), 1e-7 * (1.0 + expected->norm()));
    }
  }
}

TEST(SpaceCamera, HasTheTargetInTheMiddleAndUpAbove) {
  for (const SpaceCamera& camera : cameras()) {
    const auto middle = camera.page_from_enu(camera.target_in_enu_m, kWhere);
    ASSERT_TRUE(middle);
    EXPECT_LT((*middle - kWhere.centre()).norm(), 1e-9);
    if (camera.down_rad > 1.5) continue;
    const auto above =
        camera.page_from_enu(camera.target_in_enu_m + Eigen::Vector3d(0, 0, 1), kWhere);
    ASSERT_TRUE(above);
    EXPECT_NEAR(above->x(), middle->x(), 1e-9);
    EXPECT_GT(above->y(), middle->y());
  }
}

TEST(SpaceCamera, IsRightHandedAndOfUnitLength) {
  for (const SpaceCamera& camera : cameras()) {
    const Eigen::Matrix3d axes = camera.enu_from_view();
    EXPECT_TRUE((axes.transpose() * axes).isIdentity(1e-12));
    // Right, up and ahead, like a page and what lies behind it, are a left hand's three fingers.
    EXPECT_NEAR(axes.determinant(), -1.0, 1e-12);
    EXPECT_NEAR((camera.eye_in_enu_m() - camera.target_in_enu_m).norm(), camera.distance_m, 1e-9);
  }
}

TEST(SpaceCamera, LooksDownLikeAMapWithItsHeadingUp) {
  SpaceCamera camera{{0, 0, 0}, 50.0, std::numbers::pi / 2.0, std::numbers::pi / 2.0, 0.6};
  const auto east = camera.page_from_enu({1.0, 0.0, 0.0}, kWhere);
  const auto north = camera.page_from_enu({0.0, 1.0, 0.0}, kWhere);
  ASSERT_TRUE(east && north);
  EXPECT_GT(east->x(), kWhere.centre().x() + 1.0);
  EXPECT_NEAR(east->y(), kWhere.centre().y(), 1e-9);
  EXPECT_GT(north->y(), kWhere.centre().y() + 1.0);
  EXPECT_NEAR(north->x(), kWhere.centre().x(), 1e-9);
}

TEST(SpaceCamera, FindsTheGroundUnderAPointOfThePageAgain) {
  for (const SpaceCamera& camera : cameras()) {
    for (const Eigen::Vector2d& page :
         {Eigen::Vector2d(40, 20), Eigen::Vector2d(230, 160), Eigen::Vector2d(400, 60)}) {
      const auto ground = camera.ground_from_page(page, kWhere);
      if (!ground) continue;
      const auto again = camera.page_from_enu({ground->x(), ground->y(), 0.0}, kWhere);
      ASSERT_TRUE(again);
      EXPECT_LT((*again - page).norm(), 1e-6);
    }
    EXPECT_LT((*camera.ground_from_page(kWhere.centre(), kWhere) - Eigen::Vector2d(12, -7)).norm(),
              1e-6);
  }
}

TEST(SpaceCamera, SeesNoGroundAboveTheHorizon) {
  const SpaceCamera camera{{0, 0, 0}, 50.0, 0.3, 0.1, 0.6};
  EXPECT_TRUE(camera.ground_from_page({200.0, 30.0}, kWhere));
  EXPECT_FALSE(camera.ground_from_page({200.0, 300.0}, kWhere));
}

TEST(SpaceCamera, FillsTheWidthFromTheDistanceThatItNames) {
  SpaceCamera camera{{3, 4, 0}, 1.0, 1.1, 0.5, 0.7};
  camera.distance_m = camera.distance_to_show(20.0, kWhere);
  const Eigen::Vector3d right = camera.enu_from_view().col(0);
  const auto left_end = camera.page_from_enu(camera.target_in_enu_m - 10.0 * right, kWhere);
  const auto right_end = camera.page_from_enu(camera.target_in_enu_m + 10.0 * right, kWhere);
  ASSERT_TRUE(left_end && right_end);
  EXPECT_NEAR(left_end->x(), kWhere.left, 1e-9);
  EXPECT_NEAR(right_end->x(), kWhere.right(), 1e-9);
}

}  // namespace space_camera_test
}  // namespace nadir
