// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmock/gmock.h>

#include <memory>
#include <optional>

#include "core/geo/rigid3.h"
#include "core/topview/camera_model.h"
#include "tests/support/error_text.h"
#include "tests/support/page_pixels.h"
#include "widgets/gl/offscreen_renderer.h"
#include "widgets/views/space_scene.h"

namespace nadir {

/// A test that draws scenes in space. Not for each test a renderer of its own: starting one takes longer than the test.
class SpacePage : public testing::Test {
 protected:
  static constexpr int kPageWidth = 160;
  static constexpr int kPageHeight = 120;
  static constexpr PageRect kPage{0.0, 0.0, kPageWidth, kPageHeight};

  static void SetUpTestSuite() {
    auto made = OffscreenRenderer::create();
    ASSERT_TRUE(made) << error_text(made);
    offscreen() = std::move(*made);
  }
  static void TearDownTestSuite() { offscreen().reset(); }

  [[nodiscard]] static Raster<Rgba> draw(SpaceScene& scene, const SpaceCamera& camera) {
    scene.look(camera, 1.0);
    auto drawn = offscreen()->render(scene.renderer(), kPageWidth, kPageHeight);
    EXPECT_TRUE(drawn) << error_text(drawn);
    return drawn ? *drawn : Raster<Rgba>(kPageWidth, kPageHeight);
  }

 private:
  static std::unique_ptr<OffscreenRenderer>& offscreen() {
    static std::unique_ptr<OffscreenRenderer> renderer;
    return renderer;
  }
};

/// The same view by other means: the pinhole model of the core, turned by aircraft angles.
struct PinholeOracle {
  PinholeOracle(const SpaceCamera& seen_by, const PageRect& where)
      : page(where),
        model(CameraModel::from_horizontal_view(
            static_cast<int>(where.width),
            static_cast<int>(where.height),
            2.0 * std::atan(std::tan(seen_by.view_rad / 2.0) * where.width / where.height))) {
    enu_from_camera.rotation =
        rotation_of({0.0, seen_by.down_rad, seen_by.yaw_rad}) * forward_body_from_camera();
    enu_from_camera.translation_m =
        seen_by.target_in_enu_m -
        seen_by.distance_m * (enu_from_camera.rotation * Eigen::Vector3d::UnitZ());
  }

  [[nodiscard]] std::optional<Eigen::Vector2d> page_from_enu(
      const Eigen::Vector3d& point_in_enu_m) const {
    const Eigen::Vector3d in_camera = enu_from_camera.inverse() * point_in_enu_m;
    if (in_camera.z() <= 0.0) return std::nullopt;
    const Eigen::Vector2d in_image = model.project(in_camera);
    return Eigen::Vector2d(page.left + in_image.x(), page.top() - in_image.y());
  }

  PageRect page;
  CameraModel model;
  Rigid3 enu_from_camera;
};

/// Mean place of the pixels of one colour, page pixels with y up; nothing where there are none.
[[nodiscard]] inline std::optional<Eigen::Vector2d> centre_of(const Raster<Rgba>& drawn,
                                                              Rgba colour) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  int count = 0;
  for (int row = 0; row < drawn.height(); ++row) {
    for (int column = 0; column < drawn.width(); ++column) {
      if (drawn.at(column, row) != colour) continue;
      sum += centre_of_pixel(drawn, column, row);
      ++count;
    }
  }
  if (count == 0) return std::nullopt;
  return Eigen::Vector2d(sum / count);
}

[[nodiscard]] inline int count_of(const Raster<Rgba>& drawn, Rgba colour) {
  return static_cast<int>(std::count(drawn.values().begin(), drawn.values().end(), colour));
}

}  // namespace nadir
