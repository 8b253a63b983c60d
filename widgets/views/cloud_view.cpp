// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/cloud_view.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkMatrix4x4.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

#include <numeric>

#include "core/base/require.h"
#include "widgets/views/theme.h"

namespace nadir {

CloudView::CloudView(SpaceScene& scene) : scene_(scene) {
  mapper_->SetInputData(points_);
  mapper_->SetScalarModeToUsePointData();
  actor_->SetMapper(mapper_);
  actor_->GetProperty()->LightingOff();
  actor_->ForceOpaqueOn();
  scene_.add(*actor_, SpaceLayer::kSolid);
  scene_.attach(*this);
}

CloudView::~CloudView() {
  scene_.detach(*this);
  scene_.remove(*actor_);
}

void CloudView::show(const SemanticCloud& cloud) {
  NADIR_REQUIRE(cloud.points_in_level_m.size() == cloud.labels.size());
  const vtkNew<vtkFloatArray> places;
  places->SetNumberOfComponents(3);
  const vtkNew<vtkUnsignedCharArray> colours;
  colours->SetNumberOfComponents(3);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3f& point = cloud.points_in_level_m[i];
    const Rgba colour = class_colour(cloud.labels[i]);
    if (!point.allFinite() || colour.alpha == 0) continue;
    places->InsertNextTypedTuple(point.data());
    const std::array<unsigned char, 3> channels = {colour.red, colour.green, colour.blue};
    colours->InsertNextTypedTuple(channels.data());
  }
  drawn_ = static_cast<std::size_t>(places->GetNumberOfTuples());
  points_->Initialize();
  if (drawn_ == 0) return;
  const vtkNew<vtkPoints> points;
  points->SetData(places);
  // One cell of all points: as many cells as points would take several times the memory.
  std::vector<vtkIdType> ids(drawn_);
  std::iota(ids.begin(), ids.end(), vtkIdType{0});
  const vtkNew<vtkCellArray> dots;
  dots->InsertNextCell(static_cast<vtkIdType>(drawn_), ids.data());
  points_->SetPoints(points);
  points_->SetVerts(dots);
  points_->GetPointData()->SetScalars(colours);
}

void CloudView::place(const Rigid3& enu_from_level) {
  const Eigen::Matrix3d rotation = enu_from_level.rotation.toRotationMatrix();
  const Eigen::Vector3d offset = scene_.scene_from_enu(enu_from_level.translation_m);
  const vtkNew<vtkMatrix4x4> matrix;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column)
      matrix->SetElement(row, column, rotation(row, column));
    matrix->SetElement(row, 3, offset[row]);
  }
  actor_->SetUserMatrix(matrix);
}

void CloudView::set_size_pt(double size_pt) {
  size_pt_ = size_pt;
  set_px_per_pt(px_per_pt_);
}

void CloudView::set_px_per_pt(double px_per_pt) {
  px_per_pt_ = px_per_pt;
  actor_->GetProperty()->SetPointSize(static_cast<float>(std::max(1.0, size_pt_ * px_per_pt)));
}

void CloudView::set_visible(bool visible) { actor_->SetVisibility(visible ? 1 : 0); }

}  // namespace nadir
