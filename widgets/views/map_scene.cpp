// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/map_scene.h"

#include <vtkCamera.h>

#include <cmath>

namespace nadir {

MapScene::MapScene(const Eigen::Vector2d& scene_origin_in_enu_m)
    : scene_origin_in_enu_m_(scene_origin_in_enu_m) {
  renderer_->SetBackground(0.0, 0.0, 0.0);
  renderer_->SetBackgroundAlpha(0.0);
  renderer_->GetActiveCamera()->ParallelProjectionOn();
}

Eigen::Vector3d MapScene::scene_from_enu(const Eigen::Vector2d& point_in_enu_m,
                                         MapLayer layer) const {
  const Eigen::Vector2d point = point_in_enu_m - scene_origin_in_enu_m_;
  return {point.x(), point.y(), static_cast<double>(layer)};
}

void MapScene::look(const MapCamera& camera, double height_px) {
  constexpr double kAbove = 100.0;
  const Eigen::Vector2d centre = camera.centre_in_enu_m - scene_origin_in_enu_m_;
  vtkCamera* const eye = renderer_->GetActiveCamera();
  eye->SetFocalPoint(centre.x(), centre.y(), 0.0);
  eye->SetPosition(centre.x(), centre.y(), kAbove);
  eye->SetViewUp(std::cos(camera.up_rad), std::sin(camera.up_rad), 0.0);
  eye->SetParallelScale(height_px * camera.metres_per_px / 2.0);
  eye->SetClippingRange(1.0, 2.0 * kAbove);
}

}  // namespace nadir
