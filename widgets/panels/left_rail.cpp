// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/left_rail.h"

#include <algorithm>

#include "widgets/panels/shortcut_hint.h"

namespace nadir {

LeftRailModel left_rail_model(const Session& session) {
  (void)session;  // one workspace so far
  LeftRailModel model;
  model.workspaces = {
      {"Replay", kit::Icon::kPlay, "Replay a flight, see why, rerun, compare", "", true},
      {"Label", kit::Icon::kPaintBrush, "Label overhead pictures into maps",
       "labelling maps comes in a later version", false},
      {"Study", kit::Icon::kChart, "Compare many runs over many flights",
       "studies of many runs come in a later version", false}};
  return model;
}

Actions draw_left_rail(kit::Ui& ui, const LeftRailModel& model) {
  const auto scope = ui.scope("Workspaces");
  Actions asked;
  for (const Workspace& workspace : model.workspaces) {
    const auto pale = ui.disabled(!workspace.why_not.empty(), workspace.why_not);
    (void)ui.rail_button(workspace.name, workspace.icon, {.text = workspace.hint, .shortcut = {}},
                         workspace.is_chosen);
  }
  const double foot = ui.px(2.0 * 28.0 + 12.0);
  ui.space(std::max(0.0, ui.room().height - foot));
  const Action preferences = actions::ShowOverlay{Overlay::kPreferences};
  ui.next_width(ui.room().width);
  if (ui.icon_button("Preferences", kit::Icon::kGear, hint_for("Preferences", preferences))) {
    asked.push_back(preferences);
  }
  const Action shortcuts = actions::ShowOverlay{Overlay::kShortcuts};
  ui.next_width(ui.room().width);
  if (ui.icon_button("Shortcuts", kit::Icon::kQuestion, hint_for("All shortcuts", shortcuts))) {
    asked.push_back(shortcuts);
  }
  return asked;
}

}  // namespace nadir
