// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "widgets/views/camera_frustum.h"
#include "widgets/views/space_lines.h"

namespace nadir {

struct FrustumLook {
  Rgba colour;
  Rgba casing{0, 0, 0, 0};  ///< Around the line on the ground; transparent: none.
  double width_pt = 1.2;
};

/// Shows a camera in space: the edges of what it sees up to a depth, the ground in them, and a line from the camera down to
/// the ground.
class FrustumView {
 public:
  FrustumView(SpaceScene& scene, const FrustumLook& look);

  /// @param depth_m  Along the optical axis, > 0.
  void place(const CameraModel& camera, const Rigid3& enu_from_camera, double depth_m);
  void set_visible(bool visible);

 private:
  bool has_casing_;
  SpaceLines casing_, ground_, edges_;
};

}  // namespace nadir
