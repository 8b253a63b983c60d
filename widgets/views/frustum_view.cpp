// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/frustum_view.h"

namespace nadir {
namespace {

/// From the eye to the corners, around the picture that they span, and down to the ground.
std::vector<SpacePath> edges_of(const CameraFrustum& frustum) {
  std::vector<SpacePath> edges;
  SpacePath border;
  for (const Eigen::Vector3d& corner : frustum.corners_in_enu_m) {
    edges.push_back({frustum.eye_in_enu_m, corner});
    border.push_back(corner);
  }
  border.push_back(border.front());
  edges.push_back(std::move(border));
  // Down to the ground, where the camera hangs.
  const Eigen::Vector3d& eye = frustum.eye_in_enu_m;
  edges.push_back({eye, Eigen::Vector3d(eye.x(), eye.y(), 0.0)});
  return edges;
}

}  // namespace

FrustumView::FrustumView(SpaceScene& scene, const FrustumLook& look)
    : has_casing_(look.casing.alpha > 0),
      casing_(scene, SpaceLayer::kOnGround, look.casing, look.width_pt + 1.0),
      ground_(scene, SpaceLayer::kOnGround, look.colour, look.width_pt),
      edges_(scene, SpaceLayer::kSolid, look.colour, look.width_pt) {
  casing_.set_visible(has_casing_);
}

void FrustumView::place(const CameraModel& camera, const Rigid3& enu_from_camera, double depth_m) {
  const CameraFrustum frustum = camera_frustum(camera, enu_from_camera, depth_m);
  edges_.show(edges_of(frustum));
  std::vector<SpacePath> ground;
  SpacePath inside = on_ground(ground_inside(frustum));
  if (!inside.empty()) {
    inside.push_back(inside.front());
    ground.push_back(std::move(inside));
  }
  ground_.show(ground);
  casing_.show(ground);
}

void FrustumView::set_visible(bool visible) {
  casing_.set_visible(visible && has_casing_);
  ground_.set_visible(visible);
  edges_.set_visible(visible);
}

}  // namespace nadir
