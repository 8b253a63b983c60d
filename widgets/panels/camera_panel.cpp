// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/camera_panel.h"

#include "widgets/panels/empty_state.h"

namespace nadir {

Actions draw_camera_panel(kit::Ui& ui, const MomentModel& model, CameraPanelState& state) {
  const auto scope = ui.scope("Camera");
  if (model.is_reading) return draw_empty_state(ui, reading_state(model.run_name));
  if (!model.has_step()) return draw_empty_state(ui, no_run_state("what the camera saw"));
  draw_camera_view(ui, model, state.camera, state.texture_of, true);
  return {};
}

}  // namespace nadir
