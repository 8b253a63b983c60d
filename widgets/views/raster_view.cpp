// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/raster_view.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkProperty.h>

#include <array>
#include <cstring>

#include "core/base/require.h"
#include "widgets/canvas/vtk_image.h"

namespace nadir {
namespace {

Eigen::AlignedBox2d whole_picture() {
  return {Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(1.0, 1.0)};
}

}  // namespace

RasterView::RasterView(MapScene& scene, MapLayer layer) : scene_(scene), layer_(layer) {
  mapper_->SetInputData(quad_);
  actor_->SetMapper(mapper_);
  actor_->GetProperty()->LightingOff();
  // Layers are drawn in the order in which they were added, through each other's holes.
  actor_->ForceTranslucentOn();
  scene_.add(*actor_, layer_);
}

RasterView::~RasterView() { scene_.remove(*actor_); }

void RasterView::make_texture(bool is_smooth, bool is_for_far_away) {
  texture_ = vtkSmartPointer<vtkTexture>::New();
  texture_->RepeatOff();
  texture_->EdgeClampOn();
  texture_->SetColorModeToDirectScalars();
  texture_->SetInterpolate(is_smooth ? 1 : 0);
  texture_->SetMipmap(is_smooth && is_for_far_away);
  actor_->SetTexture(texture_);
}

void RasterView::show(const Raster<Rgba>& pixels,
                      const Rigid2& enu_from_corner,
                      const Eigen::Vector2d& metres_per_pixel,
                      bool is_smooth,
                      bool is_for_far_away) {
  NADIR_REQUIRE(!pixels.empty());
  size_px_ = {pixels.width(), pixels.height()};
  // A texture that was smooth once stays it, whatever VTK is told.
  if (texture_ == nullptr || (texture_->GetInterpolate() != 0) != is_smooth ||
      texture_->GetMipmap() != (is_smooth && is_for_far_away)) {
    make_texture(is_smooth, is_for_far_away);
  }
  texture_->SetInputData(vtk_image_of(pixels));
  place(enu_from_corner, metres_per_pixel);
}

void RasterView::change(const Raster<Rgba>& part, int left, int top) {
  NADIR_REQUIRE(texture_ != nullptr && left >= 0 && top >= 0 &&
                left + part.width() <= size_px_.x() && top + part.height() <= size_px_.y());
  vtkImageData* const image = texture_->GetInput();
  const int height = image_size(*image)[1];
  for (int row = 0; row < part.height(); ++row) {
    const auto line = part.row(row);
    std::memcpy(image->GetScalarPointer(left, height - 1 - (top + row), 0), line.data(),
                line.size_bytes());
  }
  image->Modified();
  texture_->Modified();  // so that whoever compares stamps knows it
}

void RasterView::show_part_of(const RasterView& whole, const Eigen::AlignedBox2d& part) {
  NADIR_REQUIRE(whole.texture_ != nullptr && whole_picture().contains(part));
  texture_ = whole.texture_;
  actor_->SetTexture(texture_);
  size_px_ = whole.size_px_;
  enu_from_corner_ = whole.enu_from_corner_;
  metres_per_pixel_ = whole.metres_per_pixel_;
  place_quad(part);
}

void RasterView::place(const Rigid2& enu_from_corner, const Eigen::Vector2d& metres_per_pixel) {
  enu_from_corner_ = enu_from_corner;
  metres_per_pixel_ = metres_per_pixel;
  place_quad(whole_picture());
}

void RasterView::place_quad(const Eigen::AlignedBox2d& part) {
  const Eigen::Vector2d size_m = size_px_.cwiseProduct(metres_per_pixel_);
  const std::array<Eigen::Vector2d, 4> corners = {
      Eigen::Vector2d(part.min().x(), part.max().y()), part.max(),
      Eigen::Vector2d(part.max().x(), part.min().y()), part.min()};
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> in_texture;
  in_texture->SetNumberOfComponents(2);
  for (const Eigen::Vector2d& corner : corners) {
    const Eigen::Vector2d offset_m(corner.x() * size_m.x(), -corner.y() * size_m.y());
    const Eigen::Vector3d point = scene_.scene_from_enu(enu_from_corner_ * offset_m, layer_);
    points->InsertNextPoint(point.data());
    in_texture->InsertNextTuple2(corner.x(), 1.0 - corner.y());  // textures begin at the bottom
  }
  constexpr std::array<vtkIdType, 4> kCorners = {0, 1, 2, 3};
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell(4, kCorners.data());
  quad_->SetPoints(points);
  quad_->SetPolys(cells);
  quad_->GetPointData()->SetTCoords(in_texture);
  quad_->Modified();
}

void RasterView::set_opacity(double opacity) { actor_->GetProperty()->SetOpacity(opacity); }
void RasterView::set_visible(bool visible) { actor_->SetVisibility(visible ? 1 : 0); }

}  // namespace nadir
