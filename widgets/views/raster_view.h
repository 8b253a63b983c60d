// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkSmartPointer.h>
#include <vtkTexture.h>

#include <Eigen/Geometry>

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
  /// @param is_for_far_away   A smooth picture also averages where it is drawn smaller than half its size, which costs
  ///                          software rendering three times as much a frame, at any size.
  void show(const Raster<Rgba>& pixels,
            const Rigid2& enu_from_corner,
            const Eigen::Vector2d& metres_per_pixel,
            bool is_smooth,
            bool is_for_far_away = true);
  /// Replaces some pixels of what show() was given, also where a cut-out of them is shown; the texture follows when it is drawn.
  /// @param left, top  Of the part in the picture, which holds all of it.
  void change(const Raster<Rgba>& part, int left, int top);
  /// Shows a cut-out of what another view shows, where that one shows it, without a copy of its pixels.
  /// @param part  x to the right and y down from the picture's upper left corner, in shares of its sides.
  void show_part_of(const RasterView& whole, const Eigen::AlignedBox2d& part);
  /// Moves the picture without uploading it again.
  void place(const Rigid2& enu_from_corner, const Eigen::Vector2d& metres_per_pixel);
  void set_opacity(double opacity);
  void set_visible(bool visible);

 private:
  void make_texture(bool is_smooth, bool is_for_far_away);
  void place_quad(const Eigen::AlignedBox2d& part);

  MapScene& scene_;
  MapLayer layer_;
  Eigen::Vector2d size_px_ = Eigen::Vector2d::Zero();
  Rigid2 enu_from_corner_;
  Eigen::Vector2d metres_per_pixel_ = Eigen::Vector2d::Ones();
  vtkNew<vtkPolyData> quad_;
  vtkNew<vtkPolyDataMapper> mapper_;
  vtkSmartPointer<vtkTexture> texture_;
  vtkNew<vtkActor> actor_;
};

}  // namespace nadir
