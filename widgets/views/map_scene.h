// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vtkNew.h>
#include <vtkRenderer.h>

#include <Eigen/Core>
#include <vector>

#include "widgets/views/map_camera.h"

namespace nadir {

/// Height order of what lies on the ground, from below.
enum class MapLayer { kPicture, kLabels, kReconstruction, kSurface, kTopview, kParticles };

/// VTK's side of a map: views put their props into its renderer. Its frame `scene` is enu less an origin near the data,
/// because the graphics card's floats lose millimetres far from zero; z tells only what lies on top of what.
class MapScene {
 public:
  explicit MapScene(const Eigen::Vector2d& scene_origin_in_enu_m);

  [[nodiscard]] vtkRenderer& renderer() { return *renderer_; }
  /// Puts a prop above what lies in lower layers and in its own, below the higher ones, whenever those were added.
  void add(vtkProp& prop, MapLayer layer);
  void remove(vtkProp& prop);
  [[nodiscard]] Eigen::Vector3d scene_from_enu(const Eigen::Vector2d& point_in_enu_m,
                                               MapLayer layer) const;
  /// What shows where nothing lies; a transparent one leaves the pixels clear.
  void set_background(Rgba colour, bool is_transparent);
  /// Points the renderer's camera; `height_px` of the rectangle that it will fill.
  void look(const MapCamera& camera, double height_px);

 private:
  Eigen::Vector2d scene_origin_in_enu_m_;
  std::vector<MapLayer> layers_;  ///< Of the renderer's props, in their order.
  vtkNew<vtkRenderer> renderer_;
};

}  // namespace nadir
