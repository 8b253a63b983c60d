// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "core/session/action.h"
#include "widgets/kit/ui.h"
#include "widgets/panels/moment_model.h"
#include "widgets/views/space_camera.h"

namespace nadir {

/// The scene that the window draws: the cloud of the moment over the overhead, with the camera's frustum.
struct SceneWish {
  SpaceCamera camera;
  int width_px = 0, height_px = 0;  ///< Of the window.
};

struct SceneState {
  /// Draws the scene and gives its texture, bottom row first. Empty: there is none yet.
  std::function<kit::TextureId(const SceneWish&)> scene;

  SpaceCamera camera;
  bool is_placed = false;    ///< The camera has been put where there is something to see.
  bool is_following = true;  ///< The target goes with the estimate.
};

[[nodiscard]] inline MomentModel scene_panel_model(const Session& session) {
  return moment_model(session);
}

/// The scene, as large as the panel. Drag turns about the target, the right button or Shift moves it over the ground, the
/// wheel comes nearer. None of it is an action: where a scene is looked at from is its panel's own.
[[nodiscard]] Actions draw_scene_panel(kit::Ui& ui, const MomentModel& model, SceneState& state);

/// The camera after a drag that turns it: the ground goes with the mouse. @param drag_px  On the page, y up.
[[nodiscard]] SpaceCamera orbited(SpaceCamera camera,
                                  const Eigen::Vector2d& drag_px,
                                  const PageRect& where);
/// After one that moves the target over the ground, so that it stays under the mouse at the target's distance.
[[nodiscard]] SpaceCamera shifted(SpaceCamera camera,
                                  const Eigen::Vector2d& drag_px,
                                  const PageRect& where);
/// Nearer by a factor, from 0.5 m to 5 km away.
[[nodiscard]] SpaceCamera nearer(SpaceCamera camera, double factor);
/// From behind and above of a pose.
[[nodiscard]] SpaceCamera behind(const Rigid2& enu_from_body);

}  // namespace nadir
