// SPDX-License-Identifier: Apache-2.0
#include "core/topview/camera_model.h"

#include <gmock/gmock.h>

#include <limits>
#include <numbers>

namespace nadir {
namespace camera_model_test {

constexpr double kThesisView_rad = 59.95 * std::numbers::pi / 180.0;

TEST(CameraModel, SeesTheEdgeOfItsImageUnderHalfItsView) {
  const auto camera = CameraModel::from_horizontal_view(640, 480, kThesisView_rad);
  const Eigen::Vector3d right_edge = camera.ray({640.0, 240.0});
  EXPECT_NEAR(std::atan2(right_edge.x(), right_edge.z()), 0.5 * kThesisView_rad, 1e-12);
  EXPECT_NEAR(camera.focal_x_px, 554.8, 0.5);
}

TEST(CameraModel, LooksAlongZThroughTheMiddleOfTheImage) {
  const auto camera = CameraModel::from_horizontal_view(640, 480, kThesisView_rad);
  EXPECT_TRUE(camera.ray({320.0, 240.0}).isApprox(Eigen::Vector3d::UnitZ()));
}

TEST(CameraModel, HasImageRowsGoingDownAndColumnsGoingRight) {
  const auto camera = CameraModel::from_horizontal_view(640, 480, kThesisView_rad);
  const Eigen::Vector2d image = camera.project({1.0, 0.5, 4.0});
  EXPECT_GT(image.x(), 320.0);
  EXPECT_GT(image.y(), 240.0);
}

TEST(CameraModel, ProjectsAPointBackToThePixelItCameFrom) {
  const CameraModel camera{1242, 375, 721.5, 718.0, 609.6, 172.9};
  for (const Eigen::Vector2d& pixel : {Eigen::Vector2d(0.5, 0.5), Eigen::Vector2d(1241.5, 374.5)}) {
    EXPECT_TRUE(camera.project(7.3 * camera.ray(pixel)).isApprox(pixel, 1e-12));
  }
}

TEST(CameraModel, RefusesSizesAndLengthsThatNoCameraHas) {
  const auto good = CameraModel::from_horizontal_view(640, 480, 1.0);
  EXPECT_TRUE(validate(good).has_value());
  auto bad = good;
  bad.width = 0;
  EXPECT_THAT(validate(bad).error().message, testing::HasSubstr("0 x 480"));
  bad = good;
  bad.focal_y_px = -3.0;
  EXPECT_THAT(validate(bad).error().message, testing::HasSubstr("not positive"));
  bad = good;
  bad.focal_x_px = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(validate(bad).has_value());
  bad = good;
  bad.centre_x_px = std::numeric_limits<double>::infinity();
  EXPECT_THAT(validate(bad).error().message, testing::HasSubstr("principal point"));
}

}  // namespace camera_model_test
}  // namespace nadir
