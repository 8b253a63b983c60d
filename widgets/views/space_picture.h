// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkSmartPointer.h>
#include <vtkTexture.h>

#include <Eigen/Geometry>

#include "widgets/views/space_scene.h"

namespace nadir {

/// Shows a picture on a parallelogram in space, from both sides. Owns its VTK pipeline; holds no caller's data after
/// show() returns.
class SpacePicture {
 public:
  SpacePicture(SpaceScene& scene, SpaceLayer layer);
  ~SpacePicture();  ///< Takes its prop out of the scene.
  SpacePicture(const SpacePicture&) = delete;
  SpacePicture& operator=(const SpacePicture&) = delete;

  /// @param is_smooth  Colours between pixels are mixed; false for anything that shows classes.
  void show(const Raster<Rgba>& pixels, bool is_smooth);
  /// Lays the picture, or a part of it: the parallelogram is the part's.
  /// @param upper_left_in_enu_m  Of the part, metres.
  /// @param right_m, down_m      Along its upper and its left side.
  /// @param part                 x to the right and y down from the picture's upper left corner, in shares of its sides.
  void place(const Eigen::Vector3d& upper_left_in_enu_m,
             const Eigen::Vector3d& right_m,
             const Eigen::Vector3d& down_m,
             const Eigen::AlignedBox2d& part = {Eigen::Vector2d(0.0, 0.0),
                                                Eigen::Vector2d(1.0, 1.0)});
  void set_opacity(double opacity);  ///< Of ground; what is solid has none.
  void set_visible(bool visible);

 private:
  SpaceScene& scene_;
  vtkNew<vtkPolyData> quad_;
  vtkNew<vtkPolyDataMapper> mapper_;
  vtkSmartPointer<vtkTexture> texture_;
  vtkNew<vtkActor> actor_;
};

}  // namespace nadir
