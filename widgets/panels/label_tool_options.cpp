// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/label_tool_options.h"

#include <fmt/format.h>

#include <algorithm>

namespace nadir {
namespace {

/// Draws options of the tool from its one list of fields, and asks for what is changed.
class OptionRows {
 public:
  OptionRows(kit::Ui& ui, const LabelToolsModel& model) : ui_(ui), model_(model) {}

  void number(std::string_view name, const std::string& title, int decimals) {
    const LabelTool usual;
    visit_fields(model_.view.tool, [&](const auto& value, const Field& field) {
      using T = std::decay_t<decltype(value)>;
      if constexpr (std::is_same_v<T, double>) {
        if (field.name != name) return;
        kit::NumberOptions options;
        options.least = field.minimum;
        options.most = field.maximum;
        options.decimals = decimals;
        options.unit = std::string(field.unit);
        options.reset = usual_number(usual, name);
        options.hint = {std::string(field.help), ""};
        const auto edit = ui_.number_input(title, value, options);
        if (edit.is_changed || edit.was_committed) set(name, fmt::format("{}", edit.value));
      }
    });
  }
  void flag(std::string_view name, const std::string& title) {
    visit_fields(model_.view.tool, [&](const auto& value, const Field& field) {
      using T = std::decay_t<decltype(value)>;
      if constexpr (std::is_same_v<T, bool>) {
        if (field.name != name) return;
        const auto on = ui_.checkbox(title, value, {std::string(field.help), ""});
        if (on) set(name, *on ? "true" : "false");
      }
    });
  }
  void choice(std::string_view name,
              const std::string& title,
              const std::vector<std::string>& items,
              const std::string& now,
              const std::string& help) {
    if (items.empty()) return;
    const auto found = std::find(items.begin(), items.end(), now);
    const auto chosen = found == items.end() ? 0U : static_cast<std::size_t>(found - items.begin());
    if (const auto other = ui_.combo(title, items, chosen, {help, ""})) set(name, items[*other]);
  }
  [[nodiscard]] Actions take() { return std::move(asked_); }

 private:
  static double usual_number(const LabelTool& usual, std::string_view name) {
    double number = 0.0;
    visit_fields(usual, [&](const auto& value, const Field& field) {
      if constexpr (std::is_same_v<std::decay_t<decltype(value)>, double>) {
        if (field.name == name) number = value;
      }
    });
    return number;
  }
  void set(std::string_view name, std::string value) {
    asked_.emplace_back(actions::SetLabelOption{std::string(name), std::move(value)});
  }

  kit::Ui& ui_;
  const LabelToolsModel& model_;
  Actions asked_;
};

std::vector<std::string> class_names() {
  std::vector<std::string> names;
  for (ClassId id = 0; id < kClassCount; ++id) {
    if (can_lie_in_overhead(id) && !is_movable(id)) names.emplace_back(class_info(id).name);
  }
  names.emplace_back(class_info(kUnclassified).name);
  return names;
}

void draw_brush(OptionRows& rows, const LabelToolsModel& model) {
  const bool in_metres = model.view.tool.brush_unit == BrushUnit::kMetres;
  rows.number(in_metres ? "brush-radius" : "brush-cells", "radius", in_metres ? 2 : 1);
  rows.choice("brush-unit", "measured in", {"metres", "cells"}, in_metres ? "metres" : "cells",
              "What the radius is measured in");
  if (model.view.tool.kind == ToolKind::kBrush) rows.flag("paint-over", "over everything");
}

}  // namespace

Actions draw_tool_options(kit::Ui& ui, const LabelToolsModel& model) {
  const auto scope = ui.scope("Options");
  OptionRows rows(ui, model);
  const LabelTool& tool = model.view.tool;
  switch (tool.kind) {
    case ToolKind::kSelect:
      rows.number("simplify", "simplify by", 3);
      rows.number("straighten", "square within", 1);
      break;
    case ToolKind::kLine:
      rows.number("line-width", "width", 2);
      break;
    case ToolKind::kOutline:
      rows.number("outline-thickness", "thickness", 2);
      break;
    case ToolKind::kStreet:
      rows.choice("street-profile", "profile", model.profiles, tool.street_profile.value,
                  "What the street is made of, across");
      break;
    case ToolKind::kBrush:
    case ToolKind::kEraser:
      draw_brush(rows, model);
      break;
    case ToolKind::kFill:
      rows.flag("paint-over", "over everything");
      break;
    case ToolKind::kRecode:
      rows.choice("recode-from", "from", class_names(), tool.recode_from.text(),
                  "The class that becomes the one below");
      break;
    default:
      break;
  }
  const bool is_free = draws_freely(tool.kind) || tool.kind == ToolKind::kFill;
  if (!is_free && tool.kind != ToolKind::kSelect) rows.flag("snap", "snap to what is near");
  if (tool.kind == ToolKind::kVertices) rows.flag("shared-borders", "move shared borders together");
  return rows.take();
}

}  // namespace nadir
