// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/left_rail.h"

#include <algorithm>

#include "core/session/label_view.h"
#include "widgets/panels/shortcut_hint.h"

namespace nadir {

LeftRailModel left_rail_model(const Session& session) {
  const LabelView& label = session.label_view();
  const bool labels = label.workspace == Workspace::kLabel;
  const bool has_ground = !label.path.empty() || !session.view().map_path.empty();
  LeftRailModel model;
  model.workspaces = {{"Replay", kit::Icon::kPlay, "Replay a flight, see why, rerun, compare", "",
                       !labels, actions::SetWorkspace{Workspace::kReplay}},
                      {"Label", kit::Icon::kPaintBrush, "Label overhead pictures into maps",
                       has_ground ? "" : "open a map or an overhead image first", labels,
                       actions::SetWorkspace{Workspace::kLabel}},
                      {"Study",
                       kit::Icon::kChart,
                       "Compare many runs over many flights",
                       "studies of many runs come in a later version",
                       false,
                       {}}};
  return model;
}

Actions draw_left_rail(kit::Ui& ui, const LeftRailModel& model) {
  const auto scope = ui.scope("Workspaces");
  Actions asked;
  for (const RailEntry& entry : model.workspaces) {
    const auto pale = ui.disabled(!entry.why_not.empty(), entry.why_not);
    const bool is_clicked = ui.rail_button(
        entry.name, entry.icon,
        entry.why_not.empty() ? hint_for(entry.hint, entry.wish) : kit::Hint{.text = entry.hint},
        entry.is_chosen);
    if (is_clicked && !entry.is_chosen) asked.push_back(entry.wish);
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
