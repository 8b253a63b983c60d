// SPDX-License-Identifier: Apache-2.0
#include "core/topview/semantic_cloud.h"

#include <gmock/gmock.h>

#include <limits>

#include "core/geo/rigid3.h"

namespace nadir {
namespace semantic_cloud_test {

Eigen::Isometry3d level_from_forward_camera(const Attitude& attitude = {}) {
  const Eigen::Quaterniond levelling = level_from_body(rotation_of(attitude));
  return Eigen::Isometry3d(levelling * forward_body_from_camera());
}

struct Scene {
  CameraModel camera = CameraModel::from_horizontal_view(64, 48, 1.0);
  Raster<ClassId> labels{64, 48, kRoad};
  Raster<float> depth_m{64, 48, 0.0F};
};

/// Depth of a plane `height_m` below a camera with this attitude, exact for each pixel; 0 above the
/// horizon.
Raster<float> ground_depth(const CameraModel& camera, const Attitude& attitude, double height_m) {
  const Eigen::Quaterniond level_from_camera =
      level_from_body(rotation_of(attitude)) * forward_body_from_camera();
  Raster<float> depth_m(camera.width, camera.height, 0.0F);
  for (int row = 0; row < camera.height; ++row) {
    for (int column = 0; column < camera.width; ++column) {
      const Eigen::Vector3d ray = level_from_camera * camera.ray({column + 0.5, row + 0.5});
      if (ray.z() < -1e-3) depth_m.at(column, row) = static_cast<float>(height_m / -ray.z());
    }
  }
  return depth_m;
}

TEST(SemanticCloud, PutsAPixelLeftOfTheMiddleToTheLeft) {
  Scene scene;
  scene.depth_m.at(0, 24) = 10.0F;
  const auto cloud = build_semantic_cloud(scene.labels, scene.depth_m, scene.camera,
                                          level_from_forward_camera(), 20.0);
  ASSERT_EQ(cloud->size(), 1U);
  EXPECT_NEAR(cloud->points_in_level_m[0].x(), 10.0, 1e-5);  // depth is along the axis
  EXPECT_NEAR(cloud->points_in_level_m[0].y(), 10.0 * std::tan(0.5) * 31.5 / 32.0, 1e-4);
}

TEST(SemanticCloud, LeavesOutEveryKindOfMissingDepthAndKeepsTheRest) {
  Scene scene;
  scene.depth_m.at(1, 1) = std::numeric_limits<float>::quiet_NaN();
  scene.depth_m.at(2, 1) = std::numeric_limits<float>::infinity();
  scene.depth_m.at(3, 1) = -4.0F;
  scene.depth_m.at(4, 1) = 21.0F;
  scene.depth_m.at(5, 1) = 20.0F;
  scene.labels.at(5, 1) = kCurb;
  const auto cloud = build_semantic_cloud(scene.labels, scene.depth_m, scene.camera,
                                          level_from_forward_camera(), 20.0);
  EXPECT_THAT(cloud->labels, testing::ElementsAre(kCurb));
}

TEST(SemanticCloud, IsFlatWhenATiltedCameraLooksAtFlatGround) {
  Scene scene;
  const Attitude banked{0.2, 0.1, 1.3};
  scene.depth_m = ground_depth(scene.camera, banked, 2.0);
  const auto cloud = build_semantic_cloud(scene.labels, scene.depth_m, scene.camera,
                                          level_from_forward_camera(banked), 30.0);
  ASSERT_GT(cloud->size(), 500U);
  for (const auto& point : cloud->points_in_level_m) EXPECT_NEAR(point.z(), -2.0, 2e-4);
}

TEST(SemanticCloud, IsNotFlatWhenTheTiltIsIgnored) {  // why levelling is there
  Scene scene;
  scene.depth_m = ground_depth(scene.camera, {0.2, 0.1, 0.0}, 2.0);
  const auto cloud = build_semantic_cloud(scene.labels, scene.depth_m, scene.camera,
                                          level_from_forward_camera(), 30.0);
  float highest = -100.0F;
  for (const auto& point : cloud->points_in_level_m) highest = std::max(highest, point.z());
  EXPECT_GT(highest, 0.0F);
}

TEST(SemanticCloud, TakesEverySecondPixelOfEverySecondRowWhenAsked) {
  Scene scene;
  scene.depth_m = Raster<float>(64, 48, 5.0F);
  const auto cloud = build_semantic_cloud(scene.labels, scene.depth_m, scene.camera,
                                          level_from_forward_camera(), 20.0, 2);
  EXPECT_EQ(cloud->size(), 32U * 24U);
}

TEST(SemanticCloud, RefusesImagesOfDifferentSizesAndSaysWhich) {
  const Scene scene;
  const auto transform = level_from_forward_camera();
  const auto labels =
      build_semantic_cloud(Raster<ClassId>(32, 48), scene.depth_m, scene.camera, transform, 20.0);
  EXPECT_EQ(labels.error().message, "labels: 32 x 48 pixels, but the camera has 64 x 48");
  const auto depth =
      build_semantic_cloud(scene.labels, Raster<float>(64, 1), scene.camera, transform, 20.0);
  EXPECT_EQ(depth.error().message, "depth: 64 x 1 pixels, but the camera has 64 x 48");
}

}  // namespace semantic_cloud_test
}  // namespace nadir
