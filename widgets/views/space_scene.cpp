// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/space_scene.h"

#include <vtkCamera.h>
#include <vtkCameraPass.h>
#include <vtkOpaquePass.h>
#include <vtkRenderPassCollection.h>
#include <vtkSequencePass.h>
#include <vtkTranslucentPass.h>

#include "core/base/angle.h"

namespace nadir {

SpaceScene::SpaceScene(const Eigen::Vector2d& scene_origin_in_enu_m)
    : scene_origin_in_enu_m_(scene_origin_in_enu_m.x(), scene_origin_in_enu_m.y(), 0.0) {
  set_background({0, 0, 0}, true);
  // VTK's translucent step leaves no depth behind, which makes it the ground's, whether opaque or not.
  const vtkNew<vtkRenderPassCollection> steps;
  const vtkNew<vtkTranslucentPass> ground;
  const vtkNew<vtkOpaquePass> solid;
  steps->AddItem(ground);
  steps->AddItem(solid);
  const vtkNew<vtkSequencePass> sequence;
  sequence->SetPasses(steps);
  const vtkNew<vtkCameraPass> camera_pass;
  camera_pass->SetDelegatePass(sequence);
  renderer_->SetPass(camera_pass);
}

void SpaceScene::add(vtkProp& prop, SpaceLayer layer) {
  order_.add(*renderer_, prop, static_cast<int>(layer));
}

void SpaceScene::remove(vtkProp& prop) { order_.remove(*renderer_, prop); }

void SpaceScene::attach(SizedView& view) {
  sized_.push_back(&view);
  view.set_px_per_pt(px_per_pt_);
}

void SpaceScene::detach(SizedView& view) { std::erase(sized_, &view); }

void SpaceScene::set_background(Rgba colour, bool is_transparent) {
  renderer_->SetBackground(colour.red / 255.0, colour.green / 255.0, colour.blue / 255.0);
  renderer_->SetBackgroundAlpha(is_transparent ? 0.0 : 1.0);
}

void SpaceScene::look(const SpaceCamera& camera, double px_per_pt) {
  constexpr double kNearest = 0.02;
  constexpr double kFarthest = 100.0;
  const Eigen::Vector3d eye = scene_from_enu(camera.eye_in_enu_m());
  const Eigen::Vector3d target = scene_from_enu(camera.target_in_enu_m);
  const Eigen::Vector3d up = camera.enu_from_view().col(1);
  vtkCamera* const vtk_camera = renderer_->GetActiveCamera();
  vtk_camera->SetPosition(eye.data());
  vtk_camera->SetFocalPoint(target.data());
  vtk_camera->SetViewUp(up.data());
  vtk_camera->SetViewAngle(Angle::radians(camera.view_rad).degrees());
  vtk_camera->SetClippingRange(kNearest * camera.distance_m, kFarthest * camera.distance_m);
  px_per_pt_ = px_per_pt;
  for (SizedView* const view : sized_) view->set_px_per_pt(px_per_pt);
}

}  // namespace nadir
