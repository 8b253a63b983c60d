// SPDX-License-Identifier: Apache-2.0
#include "widgets/canvas/canvas_device.h"

#include <vtkBrush.h>
#include <vtkMatrix3x3.h>
#include <vtkObjectFactory.h>
#include <vtkPen.h>

#include "core/base/require.h"

namespace nadir {

CanvasDevice* CanvasDevice::New() { VTK_STANDARD_NEW_BODY(CanvasDevice); }

CanvasDevice::CanvasDevice() = default;
CanvasDevice::~CanvasDevice() = default;

void CanvasDevice::draw_on(Canvas& canvas, int width, int height) {
  canvas_ = &canvas;
  this->Geometry[0] = width;
  this->Geometry[1] = height;
  page_from_item_.setIdentity();
  saved_.clear();
  is_clipping_ = false;  // a clip that was left open went with its canvas
}

std::vector<Eigen::Vector2d> CanvasDevice::on_page(const float* points, int n) const {
  std::vector<Eigen::Vector2d> placed;
  placed.reserve(static_cast<std::size_t>(n));
  for (int i = 0; i < n; ++i) {
    const Eigen::Vector3d point(points[2 * i], points[2 * i + 1], 1.0);
    placed.emplace_back((page_from_item_ * point).head<2>());
  }
  return placed;
}

void CanvasDevice::SetColor4(unsigned char color[4]) {
  this->Pen->SetColor(color);
  this->Brush->SetColor(color);
}

void CanvasDevice::SetPointSize(float size) { this->Pen->SetWidth(size); }
void CanvasDevice::SetLineWidth(float width) { this->Pen->SetWidth(width); }
void CanvasDevice::SetLineType(int type) { this->Pen->SetLineType(type); }

namespace {

Eigen::Matrix3d eigen(vtkMatrix3x3* matrix) {
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(matrix->GetData());
}

}  // namespace

void CanvasDevice::SetMatrix(vtkMatrix3x3* matrix) { page_from_item_ = eigen(matrix); }

void CanvasDevice::GetMatrix(vtkMatrix3x3* matrix) {
  Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(matrix->GetData()) = page_from_item_;
  matrix->Modified();
}

void CanvasDevice::MultiplyMatrix(vtkMatrix3x3* matrix) {
  page_from_item_ = page_from_item_ * eigen(matrix);
}

void CanvasDevice::PushMatrix() { saved_.push_back(page_from_item_); }

void CanvasDevice::PopMatrix() {
  NADIR_REQUIRE(!saved_.empty());
  page_from_item_ = saved_.back();
  saved_.pop_back();
}

void CanvasDevice::SetClipping(int* box) {
  clip_ = {static_cast<double>(box[0]), static_cast<double>(box[1]), static_cast<double>(box[2]),
           static_cast<double>(box[3])};
  if (is_clipping_) EnableClipping(true);  // at once, as VTK's own device does
}

void CanvasDevice::EnableClipping(bool enable) {
  if (is_clipping_) canvas_->pop_clip();
  is_clipping_ = enable;
  if (enable) canvas_->push_clip(clip_);
}

}  // namespace nadir
