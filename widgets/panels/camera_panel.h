// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "widgets/panels/moment_panel.h"

namespace nadir {

struct CameraPanelState {
  TextureOf texture_of;
  CameraViewState camera;
};

[[nodiscard]] inline MomentModel camera_panel_model(const Session& session) {
  return moment_model(session);
}

/// The camera's frame of the moment, as large as the panel: the wheel magnifies it.
[[nodiscard]] Actions draw_camera_panel(kit::Ui& ui,
                                        const MomentModel& model,
                                        CameraPanelState& state);

}  // namespace nadir
