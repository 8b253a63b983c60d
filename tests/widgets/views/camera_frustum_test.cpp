// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/camera_frustum.h"

#include <gmock/gmock.h>

#include <numbers>

#include "tests/widgets/views/space_page.h"
#include "widgets/views/frustum_view.h"

namespace nadir {
namespace camera_frustum_test {

const CameraModel kCamera{64, 48, 50.0, 55.0, 30.0, 25.0};

Rigid3 camera_at(const Attitude& body, const Eigen::Vector3d& place) {
  return {rotation_of(body) * forward_body_from_camera(), place};
}

double area_of(const std::vector<Eigen::Vector2d>& outline) {
  double doubled = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Eigen::Vector2d& a = outline[i];
    const Eigen::Vector2d& b = outline[(i + 1) % outline.size()];
    doubled += a.x() * b.y() - b.x() * a.y();
  }
  return doubled / 2.0;
}

TEST(CameraFrustum, HasTheCornersOfTheImageAtItsDepth) {
  const Rigid3 enu_from_camera = camera_at({0.1, 0.3, 2.0}, {5.0, -3.0, 2.5});
  const CameraFrustum frustum = camera_frustum(kCamera, enu_from_camera, 7.0);
  const std::array<Eigen::Vector2d, 4> corners = {Eigen::Vector2d(0, 0), Eigen::Vector2d(64, 0),
                                                  Eigen::Vector2d(64, 48), Eigen::Vector2d(0, 48)};
  for (std::size_t i = 0; i < 4; ++i) {
    const Eigen::Vector3d in_camera = enu_from_camera.inverse() * frustum.corners_in_enu_m.at(i);
    EXPECT_NEAR(in_camera.z(), 7.0, 1e-9);
    EXPECT_LT((kCamera.project(in_camera) - corners.at(i)).norm(), 1e-9);
  }
  EXPECT_EQ(frustum.eye_in_enu_m, enu_from_camera.translation_m);
}

TEST(CameraFrustum, IsUprightForALevelCameraToTheEast) {
  const CameraFrustum frustum = camera_frustum(kCamera, camera_at({}, {0, 0, 2}), 10.0);
  EXPECT_GT(frustum.corners_in_enu_m[0].y(), 0.0);  // the left of a view to the east is north
  EXPECT_LT(frustum.corners_in_enu_m[1].y(), 0.0);
  EXPECT_GT(frustum.corners_in_enu_m[0].z(), 2.0);
  EXPECT_LT(frustum.corners_in_enu_m[3].z(), 2.0);
}

TEST(GroundInside, OfALevelCameraIsATrapezoidBetweenItsLowestRowAndItsDepth) {
  const auto ground = ground_inside(camera_frustum(kCamera, camera_at({}, {100, 50, 2}), 12.0));
  ASSERT_EQ(ground.size(), 4U);
  const double nearest = 2.0 * 55.0 / (48.0 - 25.0);  // where the lowest row meets the ground
  for (const double depth : {nearest, 12.0}) {
    for (const double column : {0.0, 64.0}) {
      const Eigen::Vector2d expected(100.0 + depth, 50.0 - depth * (column - 30.0) / 50.0);
      EXPECT_TRUE(std::any_of(
          ground.begin(), ground.end(),
          [&](const Eigen::Vector2d& place) { return (place - expected).norm() < 1e-9; }))
          << depth << " " << column;
    }
  }
  EXPECT_GT(area_of(ground), 0.0);
}

TEST(GroundInside, HasTheBackProjectionOfEachCornerThatMeetsTheGround) {
  for (const double pitch : {0.2, 0.6, 1.2, 1.5}) {
    for (const double roll : {-0.4, 0.0, 0.2}) {
      const Rigid3 enu_from_camera = camera_at({roll, pitch, -2.3}, {-20, 7, 3});
      const double depth = 15.0;
      const auto ground = ground_inside(camera_frustum(kCamera, enu_from_camera, depth));
      ASSERT_GE(ground.size(), 3U);
      int met = 0;
      for (const Eigen::Vector2d& corner : {Eigen::Vector2d(0, 0), Eigen::Vector2d(64, 0),
                                            Eigen::Vector2d(64, 48), Eigen::Vector2d(0, 48)}) {
        const Eigen::Vector3d ray = enu_from_camera.rotation * kCamera.ray(corner);
        const double at_depth = -3.0 / ray.z();
        if (!(at_depth > 0.0 && at_depth < depth)) continue;
        ++met;
        const Eigen::Vector2d expected = (enu_from_camera.translation_m + at_depth * ray).head<2>();
        EXPECT_TRUE(std::any_of(ground.begin(), ground.end(), [&](const Eigen::Vector2d& place) {
          return (place - expected).norm() < 1e-9;
        }));
      }
      EXPECT_GE(met, 2);
      EXPECT_GT(area_of(ground), 0.0);  // counter-clockwise
    }
  }
}

TEST(GroundInside, IsSeenByTheCameraAndItsEdgeIsTheEdgeOfItsView) {
  const Rigid3 enu_from_camera = camera_at({0.3, 0.5, 0.9}, {4, 4, 2});
  const auto ground = ground_inside(camera_frustum(kCamera, enu_from_camera, 9.0));
  for (const Eigen::Vector2d& place : ground) {
    const Eigen::Vector3d in_camera =
        enu_from_camera.inverse() * Eigen::Vector3d(place.x(), place.y(), 0.0);
    const Eigen::Vector2d pixel = kCamera.project(in_camera);
    const double edge = std::min({std::abs(pixel.x()), std::abs(pixel.x() - 64.0),
                                  std::abs(pixel.y()), std::abs(pixel.y() - 48.0)});
    EXPECT_TRUE(edge < 1e-6 || std::abs(in_camera.z() - 9.0) < 1e-9);
    EXPECT_LT(in_camera.z(), 9.0 + 1e-9);
  }
}

TEST(GroundInside, IsEmptyWhereTheCameraSeesNone) {
  EXPECT_TRUE(
      ground_inside(camera_frustum(kCamera, camera_at({0.0, -1.2, 0.0}, {0, 0, 2}), 9.0)).empty());
  EXPECT_TRUE(ground_inside(camera_frustum(kCamera, camera_at({}, {0, 0, 2}), 1.0)).empty());
}

class Frustum : public SpacePage {};

TEST_F(Frustum, IsDrawnWhereItsCornersAre) {
  SpaceScene scene({0.0, 0.0});
  FrustumView view(scene, {kRed, kNothing, 1.0});
  const Rigid3 enu_from_camera = camera_at({0.0, 0.1, 0.4}, {1.0, 2.0, 2.0});
  view.place(kCamera, enu_from_camera, 8.0);
  const SpaceCamera camera{{4, 3, 1}, 30.0, 0.8, 0.5, 0.7};
  const PinholeOracle oracle(camera, kPage);
  const Raster<Rgba> drawn = draw(scene, camera);
  const CameraFrustum frustum = camera_frustum(kCamera, enu_from_camera, 8.0);
  std::vector<Eigen::Vector3d> places(frustum.corners_in_enu_m.begin(),
                                      frustum.corners_in_enu_m.end());
  places.push_back(frustum.eye_in_enu_m);
  places.emplace_back(1.0, 2.0, 0.0);  // the foot of the line down from the camera
  for (const Eigen::Vector2d& place : ground_inside(frustum))
    places.emplace_back(place.x(), place.y(), 0.0);
  // And half way along an edge.
  places.emplace_back((frustum.eye_in_enu_m + frustum.corners_in_enu_m[2]) / 2.0);
  for (const Eigen::Vector3d& place : places) {
    const auto at = oracle.page_from_enu(place);
    ASSERT_TRUE(at && holds(kPage, *at));
    int near = 0;
    for (const double dx : {-1.0, 0.0, 1.0}) {
      for (const double dy : {-1.0, 0.0, 1.0}) {
        near += pixel_at(drawn, at->x() + dx, at->y() + dy) == kRed ? 1 : 0;
      }
    }
    EXPECT_GT(near, 0) << place.transpose();
  }
}

TEST_F(Frustum, IsMovedAndHiddenInPlace) {
  SpaceScene scene({0.0, 0.0});
  FrustumView view(scene, {kRed, kNothing, 1.0});
  const SpaceCamera camera{{4, 3, 1}, 30.0, 0.8, 0.5, 0.7};
  view.place(kCamera, camera_at({}, {1.0, 2.0, 2.0}), 8.0);
  const Raster<Rgba> first = draw(scene, camera);
  view.place(kCamera, camera_at({}, {3.0, 2.0, 2.0}), 8.0);
  EXPECT_NE(draw(scene, camera), first);
  view.place(kCamera, camera_at({}, {1.0, 2.0, 2.0}), 8.0);
  EXPECT_EQ(draw(scene, camera), first);
  view.set_visible(false);
  EXPECT_EQ(draw(scene, camera), Raster<Rgba>(kPageWidth, kPageHeight, kNothing));
}

}  // namespace camera_frustum_test
}  // namespace nadir
