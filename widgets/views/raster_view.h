// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vtkActor.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkSmartPointer.h>
#include <vtkTexture.h>

#include "core/geo/rigid2.h"
#include "widgets/views/map_scene.h"

namespace nadir {

/// Lays a picture on the ground. Owns its VTK pipeline; holds no caller's data after show() returns.
class RasterView {
 public:
  RasterView(MapScene& scene, MapLayer layer);
  ~RasterView();  ///< Takes its prop out of the scene.
  RasterView(const RasterView&) = delete;
  RasterView& operator=(const RasterView&) = delete;

  /// @param enu_from_corner   Frame at the picture's upper left corner: x along its rows, y *up* its columns, so that a
  ///                          picture with north up has yaw 0.
  /// @param metres_per_pixel  Along rows and columns.
  /// @param is_smooth         Colours between pixels are mixed; false for anything that shows classes.
  void show(const Raster<Rgba>& pixels,
            const Rigid2& enu_from_corner,
            const Eigen::Vector2d& metres_per_pixel,
            bool is_smooth);
  /// Moves the picture without uploading it again.
  void place(const Rigid2& enu_from_corner, const Eigen::Vector2d& metres_per_pixel);
  void set_opacity(double opacity);
  void set_visible(bool visible);

 private:
  void make_texture(bool is_smooth);

  MapScene& scene_;
  MapLayer layer_;
  Eigen::Vector2d size_px_ = Eigen::Vector2d::Zero();
  vtkNew<vtkPlaneSource> quad_;
  vtkNew<vtkPolyDataMapper> mapper_;
  vtkSmartPointer<vtkTexture> texture_;
  vtkNew<vtkActor> actor_;
};

}  // namespace nadir
