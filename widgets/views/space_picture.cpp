// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/space_picture.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkProperty.h>

#include "core/base/require.h"
#include "widgets/canvas/vtk_image.h"

namespace nadir {

SpacePicture::SpacePicture(SpaceScene& scene, SpaceLayer layer) : scene_(scene) {
  mapper_->SetInputData(quad_);
  actor_->SetMapper(mapper_);
  actor_->GetProperty()->LightingOff();
  if (layer == SpaceLayer::kSolid) {
    actor_->ForceOpaqueOn();
  } else {
    actor_->ForceTranslucentOn();
  }
  scene_.add(*actor_, layer);
}

SpacePicture::~SpacePicture() { scene_.remove(*actor_); }

void SpacePicture::show(const Raster<Rgba>& pixels, bool is_smooth) {
  NADIR_REQUIRE(!pixels.empty());
  // A texture that was smooth once stays it, whatever VTK is told.
  if (texture_ == nullptr || (texture_->GetInterpolate() != 0) != is_smooth) {
    texture_ = vtkSmartPointer<vtkTexture>::New();
    texture_->RepeatOff();
    texture_->EdgeClampOn();
    texture_->SetInterpolate(is_smooth ? 1 : 0);
    texture_->SetMipmap(is_smooth);
    // Seen from aside a pixel of the page holds a long stripe of ground.
    constexpr float kMostStretch = 8.0F;
    if (is_smooth) texture_->SetMaximumAnisotropicFiltering(kMostStretch);
    actor_->SetTexture(texture_);
  }
  texture_->SetInputData(vtk_image_of(pixels));
}

void SpacePicture::place(const Eigen::Vector3d& upper_left_in_enu_m,
                         const Eigen::Vector3d& right_m,
                         const Eigen::Vector3d& down_m,
                         const Eigen::AlignedBox2d& part) {
  const Eigen::Vector3d corner = scene_.scene_from_enu(upper_left_in_enu_m);
  const std::array<Eigen::Vector3d, 4> corners = {corner, corner + right_m,
                                                  corner + right_m + down_m, corner + down_m};
  // Textures count from the lower left.
  const std::array<std::array<double, 2>, 4> shares = {{{part.min().x(), 1.0 - part.min().y()},
                                                        {part.max().x(), 1.0 - part.min().y()},
                                                        {part.max().x(), 1.0 - part.max().y()},
                                                        {part.min().x(), 1.0 - part.max().y()}}};
  const vtkNew<vtkPoints> points;
  const vtkNew<vtkFloatArray> in_picture;
  in_picture->SetNumberOfComponents(2);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    points->InsertNextPoint(corners.at(i).data());
    in_picture->InsertNextTuple(shares.at(i).data());
  }
  const vtkNew<vtkCellArray> outline;
  const std::array<vtkIdType, 4> ids = {0, 1, 2, 3};
  outline->InsertNextCell(4, ids.data());
  quad_->SetPoints(points);
  quad_->SetPolys(outline);
  quad_->GetPointData()->SetTCoords(in_picture);
}

void SpacePicture::set_opacity(double opacity) { actor_->GetProperty()->SetOpacity(opacity); }
void SpacePicture::set_visible(bool visible) { actor_->SetVisibility(visible ? 1 : 0); }

}  // namespace nadir
