// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/raster_view.h"

#include <vtkProperty.h>

#include "core/base/require.h"
#include "widgets/canvas/vtk_image.h"

namespace nadir {

RasterView::RasterView(MapScene& scene, MapLayer layer) : scene_(scene), layer_(layer) {
  mapper_->SetInputConnection(quad_->GetOutputPort());
  actor_->SetMapper(mapper_);
  actor_->GetProperty()->LightingOff();
  // Layers are drawn in the order in which they were added, through each other's holes.
  actor_->ForceTranslucentOn();
  scene_.add(*actor_, layer_);
}

RasterView::~RasterView() { scene_.remove(*actor_); }

void RasterView::make_texture(bool is_smooth) {
  texture_ = vtkSmartPointer<vtkTexture>::New();
  texture_->RepeatOff();
  texture_->EdgeClampOn();
  texture_->SetInterpolate(is_smooth ? 1 : 0);
  texture_->SetMipmap(is_smooth);
  actor_->SetTexture(texture_);
}

void RasterView::show(const Raster<Rgba>& pixels,
                      const Rigid2& enu_from_corner,
                      const Eigen::Vector2d& metres_per_pixel,
                      bool is_smooth) {
  NADIR_REQUIRE(!pixels.empty());
  size_px_ = {pixels.width(), pixels.height()};
  // A texture that was smooth once stays it, whatever VTK is told.
  if (texture_ == nullptr || (texture_->GetInterpolate() != 0) != is_smooth) {
    make_texture(is_smooth);
  }
  texture_->SetInputData(vtk_image_of(pixels));
  place(enu_from_corner, metres_per_pixel);
}

void RasterView::place(const Rigid2& enu_from_corner, const Eigen::Vector2d& metres_per_pixel) {
  const Eigen::Vector2d size_m = size_px_.cwiseProduct(metres_per_pixel);
  const auto corner = [&](double x, double y) {
    return scene_.scene_from_enu(enu_from_corner * Eigen::Vector2d(x, y), layer_);
  };
  const Eigen::Vector3d origin = corner(0.0, -size_m.y());
  const Eigen::Vector3d right = corner(size_m.x(), -size_m.y());
  const Eigen::Vector3d above = corner(0.0, 0.0);
  quad_->SetOrigin(origin.x(), origin.y(), origin.z());
  quad_->SetPoint1(right.x(), right.y(), right.z());
  quad_->SetPoint2(above.x(), above.y(), above.z());
}

void RasterView::set_opacity(double opacity) { actor_->GetProperty()->SetOpacity(opacity); }
void RasterView::set_visible(bool visible) { actor_->SetVisibility(visible ? 1 : 0); }

}  // namespace nadir
