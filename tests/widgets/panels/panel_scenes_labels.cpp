// SPDX-License-Identifier: Apache-2.0
// What stands beside the map while labels are drawn.
#include "tests/core/desk/desk_at_work.h"
#include "tests/widgets/panels/panel_scene_parts.h"
#include "widgets/panels/label_side_panel.h"
#include "widgets/panels/label_tools_panel.h"

namespace nadir::scenes {
namespace {

LabelToolsModel label_tools() {
  LabelToolsModel model;
  model.view.tool.kind = ToolKind::kBrush;
  model.name = "proving-ground";
  model.is_open = model.is_on_disk = model.is_counted = true;
  model.profiles = {"country road", "main road", "residential street"};
  model.classes.at(kRoad) = {12'400.0, 0.248};
  model.classes.at(kSidewalk) = {2'428.9, 0.049};
  model.classes.at(kBuilding) = {671.0, 0.013};
  return model;
}

/// Labels with some objects, two of them selected; opened once.
const LabelDesk& label_desk() {
  static const ScratchFolder folder;
  static const LabelDesk desk = [] {
    LabelDesk opened = opened_desk(half_a_road(folder.path()));
    const auto place = [](double x, double y) { return Eigen::Vector2d(x, -y); };
    const bool is_drawn =
        opened.draw({ObjectKind::kArea, kBuilding, 0.0},
                    {place(10, 10), place(40, 10), place(40, 30), place(10, 30)}) &&
        opened.draw({ObjectKind::kLine, kCurb, 0.3}, {place(150, 5), place(150, 190)}) &&
        opened.draw({ObjectKind::kOutline, kBuilding, 0.4},
                    {place(200, 20), place(230, 20), place(230, 60)});
    if (!is_drawn) throw std::runtime_error("labels could not be drawn");
    opened.select_all();
    return opened;
  }();
  return desk;
}

const auto kDrawTools = [](kit::Ui& ui, const LabelToolsModel& model, Nothing& /*state*/) {
  return draw_label_tools(ui, model);
};
const auto kDrawSide = [](kit::Ui& ui, const LabelTab& tab, LabelSideState& state) {
  LabelSideModel model;
  model.view.tab = tab;
  model.desk = &label_desk();
  return draw_label_side(ui, model, state);
};

}  // namespace

void add_label_scenes(std::vector<PanelScene>& scenes) {
  PanelScene tools = panel("label-tools", "label_tools_panel", {320.0, 760.0}, Room::kFilled,
                           label_tools(), Nothing(), kDrawTools);
  tools.panels.emplace_back("label_tool_options");
  scenes.push_back(std::move(tools));
  scenes.push_back(panel("label-objects", "label_side_panel", {380.0, 520.0}, Room::kFilled,
                         LabelTab::kObjects, LabelSideState{}, kDrawSide));
}

}  // namespace nadir::scenes
