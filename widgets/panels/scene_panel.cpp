// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/scene_panel.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/angle.h"
#include "widgets/panels/empty_state.h"
#include "widgets/panels/picture_area.h"

namespace nadir {
namespace {

constexpr double kSceneZoomPerNotch = 1.2;

void handle_scene_gestures(const kit::AreaInput& area, SceneState& state) {
  const PageRect where = area.page();
  if (area.is_hovered && area.wheel.y() != 0.0) {
    state.camera = nearer(state.camera, std::pow(kSceneZoomPerNotch, area.wheel.y()));
  }
  if (area.drag) {
    const bool moves = area.drag->button != kit::MouseButton::kLeft || area.modifiers.shift;
    state.camera = moves ? shifted(state.camera, area.drag->delta, where)
                         : orbited(state.camera, area.drag->delta, where);
    if (moves) state.is_following = false;
  }
  if (area.double_clicked == kit::MouseButton::kLeft) state.is_placed = false;
}

}  // namespace

SpaceCamera orbited(SpaceCamera camera, const Eigen::Vector2d& drag_px, const PageRect& where) {
  // Half a turn across the page; to the right turns the scene counter-clockwise from above, so the eye clockwise.
  camera.yaw_rad =
      wrap_rad(camera.yaw_rad - std::numbers::pi * drag_px.x() / std::max(where.width, 1.0));
  camera.down_rad = std::clamp(
      camera.down_rad - std::numbers::pi / 2.0 * drag_px.y() / std::max(where.height, 1.0), 0.02,
      std::numbers::pi / 2.0);
  return camera;
}

SpaceCamera shifted(SpaceCamera camera, const Eigen::Vector2d& drag_px, const PageRect& where) {
  const double metres_per_px =
      2.0 * camera.distance_m * std::tan(camera.view_rad / 2.0) / std::max(where.height, 1.0);
  const Eigen::Vector3d right = camera.enu_from_view().col(0);
  const Eigen::Vector2d ahead(std::cos(camera.yaw_rad), std::sin(camera.yaw_rad));
  // A length of ground ahead looks shorter by the sine of the angle from which it is seen.
  const double stretch = 1.0 / std::max(std::sin(camera.down_rad), 0.2);
  camera.target_in_enu_m.head<2>() -=
      metres_per_px * (drag_px.x() * right.head<2>() + drag_px.y() * stretch * ahead);
  return camera;
}

SpaceCamera nearer(SpaceCamera camera, double factor) {
  camera.distance_m = std::clamp(camera.distance_m / factor, 0.5, 5000.0);
  return camera;
}

SpaceCamera behind(const Rigid2& enu_from_body) {
  SpaceCamera camera;
  camera.target_in_enu_m << enu_from_body.translation_m(), 0.0;
  camera.yaw_rad = enu_from_body.yaw_rad;
  camera.distance_m = 35.0;
  camera.down_rad = 0.6;
  return camera;
}

Actions draw_scene_panel(kit::Ui& ui, const MomentModel& model, SceneState& state) {
  const auto scope = ui.scope("Scene");
  if (model.is_reading) return draw_empty_state(ui, reading_state(model.run_name));
  if (!model.has_step())
    return draw_empty_state(ui, no_run_state("its cloud over the map in space"));
  const Rigid2 estimate = model.recorded().estimate.moments.mean;
  if (!state.is_placed && estimate.translation_m().allFinite() && std::isfinite(estimate.yaw_rad)) {
    state.camera = behind(estimate);
    state.is_placed = true;
    state.is_following = true;
  }
  if (state.is_following && estimate.translation_m().allFinite()) {
    state.camera.target_in_enu_m.head<2>() = estimate.translation_m();
  }
  if (ui.icon_button("Behind", kit::Icon::kRefresh, {"Look from behind the vehicle again", ""}))
    state.is_placed = false;
  ui.same_line();
  if (const auto follows =
          ui.checkbox("follow", state.is_following, {"The view goes with the estimate", ""})) {
    state.is_following = *follows;
  }
  if (!model.has_camera_frame) {
    ui.wrapped(model.has_flight
                   ? "The flight has no frame of this moment: the cloud is made from its depth."
                   : "The flight of this run is not open: the cloud is made from its frames.",
               kit::TextLook::kMuted);
  }
  const kit::Rect room = ui.room();
  const auto area = ui.area("View", {room.width, std::max(ui.px(80.0), room.height)});
  handle_scene_gestures(area, state);
  ui.canvas().fill(corners_of(area.page()), ui.theme().window);
  if (state.scene) {
    const SceneWish wish{state.camera, static_cast<int>(area.rect.width),
                         static_cast<int>(area.rect.height)};
    if (const kit::TextureId texture = state.scene(wish); texture != 0) ui.image(texture);
  }
  outline(ui.canvas(), area.page(), ui.theme().line);
  return {};
}

}  // namespace nadir
