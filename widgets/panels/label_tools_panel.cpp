// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/label_tools_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/desk/label_coverage.h"
#include "core/desk/label_desk.h"
#include "widgets/panels/empty_state.h"
#include "widgets/panels/label_tool_options.h"
#include "widgets/panels/map_geometry.h"
#include "widgets/panels/panel_text.h"
#include "widgets/panels/shortcut_hint.h"
#include "widgets/views/theme.h"

namespace nadir {
namespace {

struct ToolLook {
  ToolKind kind;
  const char* title;
  kit::Icon icon;
  const char* help;
};
constexpr std::array kTools = {
    ToolLook{ToolKind::kSelect, "Select", kit::Icon::kPointer,
             "Click an object, or draw a box; drag what is selected"},
    ToolLook{ToolKind::kVertices, "Vertices", kit::Icon::kShare,
             "Drag corners of what is selected; double click on an edge adds one"},
    ToolLook{ToolKind::kArea, "Area", kit::Icon::kObject,
             "Click its corners; Enter, or a click on the first one, closes it"},
    ToolLook{ToolKind::kLine, "Line", kit::Icon::kPencil,
             "Click along its middle; Enter or a double click ends it"},
    ToolLook{ToolKind::kOutline, "Outline", kit::Icon::kBuilding,
             "Click the corners of a building; its inside stays unclassified"},
    ToolLook{ToolKind::kRectangle, "Rectangle", kit::Icon::kSquare,
             "Click the ends of one edge, then how far it reaches"},
    ToolLook{ToolKind::kCircle, "Circle", kit::Icon::kCircle, "Click the middle, then the rim"},
    ToolLook{ToolKind::kStreet, "Street", kit::Icon::kRoad,
             "Click along the middle: road, curbs, sidewalks and markings follow"},
    ToolLook{ToolKind::kHole, "Hole", kit::Icon::kHole,
             "Click the corners of a hole in what is selected"},
    ToolLook{ToolKind::kSplit, "Split", kit::Icon::kScissors,
             "Click a line across what is to be cut"},
    ToolLook{ToolKind::kBrush, "Brush", kit::Icon::kPaintBrush, "Paint; [ and ] change its size"},
    ToolLook{ToolKind::kEraser, "Eraser", kit::Icon::kEraser, "Take paint away"},
    ToolLook{ToolKind::kFill, "Fill", kit::Icon::kTint,
             "Paint all cells of one class that hang together"},
    ToolLook{ToolKind::kRecode, "Recode", kit::Icon::kExchange,
             "Within a ring, turn one class into another"},
    ToolLook{ToolKind::kMeasure, "Measure", kit::Icon::kRuler, "Lengths, bearings and areas"}};

constexpr double kLayerPercent = 100.0;

void draw_header(kit::Ui& ui, const LabelToolsModel& model) {
  ui.cut_text(model.name, kit::TextLook::kHeading);
  ui.hint({model.view.path, ""});
  if (!model.why_read_only.empty()) {
    ui.wrapped(model.why_read_only, kit::TextLook::kWarning);
  } else if (model.is_on_disk) {
    ui.text("every stroke is on disk", kit::TextLook::kMuted);
    ui.hint({"There is no need to save: each gesture is written as it is finished", ""});
  } else {
    ui.text("the first stroke makes labels.gpkg", kit::TextLook::kMuted);
    ui.hint({"Looking writes nothing; the file is made with the first thing that is drawn", ""});
  }
}

void draw_tools(kit::Ui& ui, const LabelToolsModel& model, Actions& asked) {
  const auto scope = ui.scope("Tools");
  const auto columns = ui.columns("grid", {1.0, 1.0});
  constexpr std::size_t kPerColumn = (kTools.size() + 1) / 2;
  for (std::size_t i = 0; i < kTools.size(); ++i) {
    if (i == kPerColumn) ui.next_column();
    const ToolLook& tool = kTools.at(i);
    const Action wish = actions::SetLabelOption{"tool", std::string(enum_name(tool.kind))};
    const kit::Hint hint = hint_for(tool.help, wish);
    kit::ListRow row;
    row.icon = tool.icon;
    row.detail = hint.shortcut;
    row.is_selected = model.view.tool.kind == tool.kind;
    row.hint = hint;
    if (ui.list_row(tool.title, row)) asked.push_back(wish);
  }
}

void draw_classes(kit::Ui& ui, const LabelToolsModel& model, Actions& asked) {
  const auto section = ui.section("Classes", true, model.is_counted ? "" : "counting…");
  if (!section) return;
  const auto draw_row = [&](ClassId id, const LabelToolsModel::ClassShare& share) {
    const std::string name(class_info(id).name);
    const Action wish = actions::SetLabelOption{"class", name};
    kit::Hint hint = hint_for(
        fmt::format("Draw {}: {:.1f} % of the ground now", name, 100.0 * share.share), wish);
    kit::ListRow row;
    row.colour = class_colour(id);
    row.is_selected = model.view.tool.class_id.id == id;
    row.look =
        share.area_m2 > 0.0 || row.is_selected ? kit::TextLook::kNormal : kit::TextLook::kMuted;
    row.detail = share.area_m2 > 0.0 ? area_text(share.area_m2) : "";
    row.is_detail_number = true;
    row.hint = hint;
    // Longer ones are in the tooltip, so that the names stand below each other.
    const std::string key = hint.shortcut.size() == 1 ? hint.shortcut + "  " : "";
    if (ui.list_row(label_of(key + name, name), row)) asked.push_back(wish);
  };
  for (ClassId id = 0; id < kClassCount; ++id) {
    if (can_lie_in_overhead(id) && !is_movable(id)) draw_row(id, model.classes.at(id));
  }
  draw_row(kUnclassified, model.classes.back());
}

void draw_layers(kit::Ui& ui, const LabelToolsModel& model, Actions& asked) {
  const auto section = ui.section("Layers");
  if (!section) return;
  const auto draw_opacity = [&](const char* title, LabelLayer layer, double opacity) {
    kit::NumberOptions options;
    options.least = 0.0;
    options.most = kLayerPercent;
    options.decimals = 0;
    options.unit = "%";
    options.reset = layer == LabelLayer::kLabels ? 60.0 : kLayerPercent;
    options.hint = {std::string("How much ") + title + " covers what lies below", ""};
    const auto edit = ui.slider(title, kLayerPercent * opacity, options);
    if (edit.is_changed || edit.was_committed) {
      asked.emplace_back(actions::SetLabelOpacity{layer, edit.value / kLayerPercent});
    }
  };
  draw_opacity("labels", LabelLayer::kLabels, model.view.labels_opacity);
  draw_opacity("picture", LabelLayer::kPicture, model.view.picture_opacity);
  const Action borders = actions::ShowBorders{Switch::kToggle};
  if (const auto on = ui.checkbox("borders of all objects", model.view.shows_borders,
                                  hint_for("Draw the border of every object", borders))) {
    asked.emplace_back(actions::ShowBorders{*on ? Switch::kOn : Switch::kOff});
  }
}

}  // namespace

LabelToolsModel label_tools_model(const Session& session) {
  LabelToolsModel model;
  model.view = session.label_view();
  model.name = name_of(model.view.path);
  const LabelDesk* const desk = session.label_desk();
  if (desk == nullptr) return model;
  const LabelSheet& sheet = desk->sheet();
  model.is_open = true;
  model.is_on_disk = sheet.is_on_disk();
  model.why_read_only = sheet.why_read_only();
  model.metres_per_cell = sheet.now().grid().metres_per_cell;
  for (const StreetProfile& profile : desk->profiles()) model.profiles.push_back(profile.name);
  const LabelCoverage& coverage = sheet.coverage();
  model.is_counted = coverage.is_complete();
  const auto all = static_cast<double>(std::max<std::int64_t>(1, coverage.counted_cells()));
  const auto share_of = [&](ClassId id) {
    return LabelToolsModel::ClassShare{coverage.square_metres(id),
                                       static_cast<double>(coverage.cells(id)) / all};
  };
  for (ClassId id = 0; id < kClassCount; ++id) model.classes.at(id) = share_of(id);
  model.classes.back() = share_of(kUnclassified);
  return model;
}

Actions draw_label_tools(kit::Ui& ui, const LabelToolsModel& model) {
  const auto scope = ui.scope("Labels");
  if (!model.is_open) return draw_empty_state(ui, reading_state(model.name));
  Actions asked;
  draw_header(ui, model);
  ui.space();
  draw_tools(ui, model, asked);
  ui.space();
  for (Action& action : draw_tool_options(ui, model)) asked.push_back(std::move(action));
  ui.space();
  draw_classes(ui, model, asked);
  draw_layers(ui, model, asked);
  return asked;
}

}  // namespace nadir
