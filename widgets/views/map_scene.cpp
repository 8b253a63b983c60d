// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/map_scene.h"

#include <vtkCamera.h>
#include <vtkCameraPass.h>
#include <vtkOpaquePass.h>
#include <vtkRenderPassCollection.h>
#include <vtkSequencePass.h>
#include <vtkTranslucentPass.h>

#include <cmath>

namespace nadir {
namespace {

std::vector<int> numbers_of(std::span<const MapLayer> layers) {
  std::vector<int> numbers;
  numbers.reserve(layers.size());
  for (const MapLayer layer : layers) numbers.push_back(static_cast<int>(layer));
  return numbers;
}

}  // namespace

MapScene::MapScene(const Eigen::Vector2d& scene_origin_in_enu_m)
    : scene_origin_in_enu_m_(scene_origin_in_enu_m) {
  set_background({0, 0, 0}, true);
  renderer_->GetActiveCamera()->ParallelProjectionOn();
  // VTK's own way with what is translucent mixes colours without regard to what lies on top; here it is blended in the
  // order of the layers, and of the views of one as they were made.
  vtkNew<vtkRenderPassCollection> steps;
  vtkNew<vtkOpaquePass> opaque;
  vtkNew<vtkTranslucentPass> translucent;
  steps->AddItem(opaque);
  steps->AddItem(translucent);
  vtkNew<vtkSequencePass> sequence;
  sequence->SetPasses(steps);
  vtkNew<vtkCameraPass> camera_pass;
  camera_pass->SetDelegatePass(sequence);
  renderer_->SetPass(camera_pass);
}

Eigen::Vector3d MapScene::scene_from_enu(const Eigen::Vector2d& point_in_enu_m,
                                         MapLayer layer) const {
  const Eigen::Vector2d point = point_in_enu_m - scene_origin_in_enu_m_;
  return {point.x(), point.y(), static_cast<double>(layer)};
}

void MapScene::add(vtkProp& prop, MapLayer layer) {
  order_.add(*renderer_, prop, static_cast<int>(layer));
}

void MapScene::remove(vtkProp& prop) { order_.remove(*renderer_, prop); }

void MapScene::set_order(std::span<const MapLayer> from_below) {
  order_.set_order(*renderer_, numbers_of(from_below));
}

void MapScene::show_only(std::span<const MapLayer> layers) {
  order_.show_only(*renderer_, numbers_of(layers));
}

std::vector<PropStamp> MapScene::stamps(std::span<const MapLayer> layers) const {
  return order_.stamps(*renderer_, numbers_of(layers));
}

void MapScene::set_background(Rgba colour, bool is_transparent) {
  // Pixels are premultiplied while they are blended, so nothing is black: else it shines through what is translucent.
  if (is_transparent) colour = {0, 0, 0, 0};
  renderer_->SetBackground(colour.red / 255.0, colour.green / 255.0, colour.blue / 255.0);
  renderer_->SetBackgroundAlpha(is_transparent ? 0.0 : 1.0);
}

void MapScene::attach(SightedView& view) { sighted_.push_back(&view); }
void MapScene::detach(SightedView& view) { std::erase(sighted_, &view); }

void MapScene::look(const MapSight& sight) {
  constexpr double kAbove = 100.0;
  const MapCamera& camera = sight.camera;
  const Eigen::Vector2d centre = camera.centre_in_enu_m - scene_origin_in_enu_m_;
  vtkCamera* const eye = renderer_->GetActiveCamera();
  eye->SetFocalPoint(centre.x(), centre.y(), 0.0);
  eye->SetPosition(centre.x(), centre.y(), kAbove);
  eye->SetViewUp(std::cos(camera.up_rad), std::sin(camera.up_rad), 0.0);
  eye->SetParallelScale(sight.height_px * camera.metres_per_px / 2.0);
  eye->SetClippingRange(1.0, 2.0 * kAbove);
  for (SightedView* const view : sighted_) view->adapt_to(sight);
}

}  // namespace nadir
