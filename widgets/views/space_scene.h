// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vtkNew.h>
#include <vtkRenderer.h>

#include <Eigen/Core>
#include <vector>

#include "widgets/views/prop_order.h"
#include "widgets/views/space_camera.h"

namespace nadir {

/// What a thing in space hides. The ground and what lies on it are drawn first, each over the one before, and hide nothing
/// that stands on them, also where noise puts it below: the eye is above the ground. Solid things hide each other.
enum class SpaceLayer { kGround, kOnGround, kSolid };

/// A view whose sizes are points of 1/72 inch on the page.
class SizedView {
 public:
  virtual ~SizedView() = default;
  /// Called by SpaceScene before anything is drawn at that scale.
  virtual void set_px_per_pt(double px_per_pt) = 0;
};

/// VTK's side of a scene in space: views put their props into its renderer. Its frame `scene` is enu less an origin near
/// the data, because the graphics card's floats lose millimetres far from zero.
class SpaceScene {
 public:
  /// @param scene_origin_in_enu_m  On the ground.
  explicit SpaceScene(const Eigen::Vector2d& scene_origin_in_enu_m);

  [[nodiscard]] vtkRenderer& renderer() { return *renderer_; }
  void add(vtkProp& prop, SpaceLayer layer);
  void remove(vtkProp& prop);
  /// From now on the view hears of the scale, until it is detached.
  void attach(SizedView& view);
  void detach(SizedView& view);
  [[nodiscard]] Eigen::Vector3d scene_from_enu(const Eigen::Vector3d& point_in_enu_m) const {
    return point_in_enu_m - scene_origin_in_enu_m_;
  }
  /// The sky; a transparent one leaves the pixels clear.
  void set_background(Rgba colour, bool is_transparent);
  /// Points the renderer's camera. What is nearer to the eye than a fiftieth of its distance, or farther than a hundred
  /// times that, is not drawn.
  void look(const SpaceCamera& camera, double px_per_pt);

 private:
  Eigen::Vector3d scene_origin_in_enu_m_;
  double px_per_pt_ = 1.0;
  PropOrder order_;
  std::vector<SizedView*> sized_;
  vtkNew<vtkRenderer> renderer_;
};

}  // namespace nadir
