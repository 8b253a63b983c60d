// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/map_cards.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/angle.h"
#include "core/mcl/cell_agreement.h"
#include "widgets/panels/shortcut_hint.h"

namespace nadir {
namespace {

constexpr double kToolSize = 28.0, kToolPadding = 4.0, kAboveScaleBar = 40.0;
constexpr double kCardWidth = 232.0, kCardRow = 24.0, kCardHead = 32.0;
constexpr double kBelowCards = 60.0;  ///< Room for the legend.

std::string compass_text(double yaw_rad) {
  return bearing_text(compass_deg_from_yaw(Angle::radians(yaw_rad)));
}

/// A card of so many read-outs below the others; `top` moves below it. It is cut where the map ends, and then scrolls.
kit::Rect card_place(kit::Ui& ui, const kit::Rect& map, double rows, double& top) {
  const double width = std::min(ui.px(kCardWidth), map.width - ui.px(16.0));
  const double height = std::max(
      ui.px(kCardHead + 24.0),
      std::min(ui.px(kCardHead + rows * kCardRow + 24.0), map.bottom() - ui.px(kBelowCards) - top));
  const kit::Rect place{map.right() - width - ui.px(8.0), top, width, height};
  top += height + ui.px(8.0);
  return place;
}

/// Cells of each class that were seen and that do not fit the map where the particle is.
std::vector<std::pair<ClassId, CellAgreement::Count>> particle_classes(const MapViewModel& model,
                                                                       const Rigid2& pose) {
  std::vector<std::pair<ClassId, CellAgreement::Count>> counts;
  if (!model.map || !model.step->topview) return counts;
  const CellAgreement agreement = cell_agreement(*model.step->topview, model.map->map(), pose);
  for (ClassId id = 0; id < kClassCount; ++id) {
    if (agreement.of_class.at(id).share()) counts.emplace_back(id, agreement.of_class.at(id));
  }
  return counts;
}

/// A row of a card: its title, and a button at the right.
bool card_head(kit::Ui& ui,
               const std::string& title,
               const std::string& button,
               const kit::Hint& hint) {
  ui.heading(title);
  ui.same_line();
  ui.right_align(ui.px(kToolSize));
  return ui.icon_button(button, kit::Icon::kClose, hint);
}

void draw_particle_card(kit::Ui& ui,
                        const MapViewModel& model,
                        std::size_t index,
                        const kit::Rect& map,
                        double& top,
                        Actions& asked) {
  const ParticleSet& particles = *model.step->particles;
  const Rigid2 pose = particles.pose(index);
  const auto classes = particle_classes(model, pose);
  const double rows = 4.0 + (model.step->truth_in_enu ? 1.0 : 0.0) +
                      (classes.empty() ? 0.0 : 1.0 + static_cast<double>(classes.size()));
  const kit::Rect place = card_place(ui, map, rows, top);
  const auto card = ui.region(
      "Particle", place, {.surface = kit::Surface::kPlate, .has_scroll = true, .is_above = true});
  if (card_head(ui, fmt::format("Particle {}", index), "Close",
                hint_for("Select no particle", actions::SelectParticle{}))) {
    asked.emplace_back(actions::SelectParticle{});
  }
  ui.read_out("east", metres_text(pose.x_m), "m");
  ui.read_out("north", metres_text(pose.y_m), "m");
  ui.read_out("heading", compass_text(pose.yaw_rad), {}, {"Clockwise from north", ""});
  const double mean = 1.0 / static_cast<double>(particles.size());
  ui.read_out(
      "weight", fmt::format("{:.3g}", particles.weight[index] / mean), "× mean",
      {fmt::format("Weight {:.3g} of {} particles", particles.weight[index], particles.size()),
       ""});
  if (model.step->truth_in_enu) {
    const double away_m = (pose.translation_m() - model.step->truth_in_enu->translation_m()).norm();
    ui.read_out("from the truth", metres_text(away_m), "m");
  }
  if (classes.empty()) return;
  ui.text("cells that misfit the map", kit::TextLook::kMuted);
  for (const auto& [id, count] : classes) {
    const auto known = static_cast<double>(count.agreeing + count.disagreeing);
    ui.colour_dot(class_colour(id));
    ui.same_line();
    ui.read_out(std::string(class_info(id).name),
                fmt::format("{:.0f}", 100.0 * count.disagreeing / known), "%",
                {fmt::format("{} of {:.0f} cells on known ground", count.disagreeing, known), ""});
  }
}

void draw_measure_card(
    kit::Ui& ui, const MapViewModel& model, const kit::Rect& map, double& top, Actions& asked) {
  const Measured measured = measure(model.look.measured_in_enu_m);
  const double rows = 1.0 + (measured.bearing_deg ? 1.0 : 0.0) + (measured.area_m2 ? 1.0 : 0.0);
  const kit::Rect place = card_place(ui, map, rows, top);
  const auto card =
      ui.region("Measured", place, {.surface = kit::Surface::kPlate, .is_above = true});
  if (card_head(ui, "Measured", "Clear", hint_for("Measure anew", actions::MeasurePoint{}))) {
    asked.emplace_back(actions::MeasurePoint{});
  }
  if (model.look.measured_in_enu_m.size() < 2) {
    ui.text("Click the next place", kit::TextLook::kMuted);
    return;
  }
  ui.read_out("distance", distance_text(measured.length_m), {},
              {"Along all legs, on the map's plane", ""});
  if (measured.bearing_deg) {
    ui.read_out("bearing", bearing_text(*measured.bearing_deg), {},
                {"Of the last leg, clockwise from grid north", ""});
  }
  if (measured.area_m2) {
    ui.read_out("area", area_text(*measured.area_m2), {},
                {"Inside the line, closed from its end to its start", ""});
  }
}

}  // namespace

std::optional<std::size_t> selected_particle(const MapViewModel& model) {
  if (!model.selected_particle || !model.step || !model.step->particles) return std::nullopt;
  const int index = *model.selected_particle;
  if (index < 0 || static_cast<std::size_t>(index) >= model.step->particles->size()) {
    return std::nullopt;
  }
  return static_cast<std::size_t>(index);
}

double map_tools_width(const kit::Ui& ui) {
  return ui.px(8.0 + kToolSize + 2.0 * kToolPadding + 4.0);
}

kit::Rect beside_map_tools(const kit::Ui& ui, const kit::Rect& map) {
  const double tools = std::min(map_tools_width(ui), map.width);
  return {map.left + tools, map.top, map.width - tools, map.height};
}

Actions draw_map_tools(kit::Ui& ui, const MapViewModel& model, const kit::Rect& map) {
  const MapLook& look = model.look;
  std::vector<kit::Tool> tools;
  Actions actions_of_tools;
  const auto deed = [&](const std::string& name, kit::Icon icon, const std::string& text,
                        const Action& action, bool is_on = false, bool begins_group = false) {
    kit::Tool tool{name, icon, hint_for(text, action), is_on};
    tool.begins_group = begins_group;
    tools.push_back(std::move(tool));
    actions_of_tools.push_back(action);
  };
  const auto choice = [&](const std::string& name, kit::Icon icon, const std::string& text,
                          MapTool which) {
    deed(name, icon, text, actions::UseTool{which}, look.tool == which);
  };
  if (model.labels == nullptr) {
    choice("Pan", kit::Icon::kMove, "Move the map by dragging; drag the right button to turn it",
           MapTool::kPan);
    choice("Measure", kit::Icon::kRuler, "Measure distance, bearing and area by clicking places",
           MapTool::kMeasure);
    choice("Pick", kit::Icon::kLocate, "Click a particle to see its pose, weight and errors",
           MapTool::kPick);
  }
  deed("Zoom in", kit::Icon::kPlus, "Show it larger", actions::Zoom{}, false, true);
  deed("Zoom out", kit::Icon::kMinus, "Show it smaller", actions::Zoom{1.0 / 1.5, {}, {}});
  const bool has_flight = !model.runs.empty();
  deed("Fit", kit::Icon::kExpand, has_flight ? "Show the whole flight" : "Show the whole map",
       actions::Fit{has_flight ? FitTo::kFlight : FitTo::kMap});
  if (model.labels == nullptr) {
    deed("Follow", kit::Icon::kMapMarker, "Keep the estimate in the middle",
         actions::Follow{Switch::kToggle}, look.is_following, true);
    if (!has_flight) tools.back().disabled_because = "open a run first";
  }
  const bool is_heading_up = look.up == MapUp::kHeading;
  deed("Up", kit::Icon::kCompass,
       is_heading_up ? "Heading is up; click for north"
                     : (look.up == MapUp::kNorth ? "North is up; click for the heading"
                                                 : "The map is turned; click for north up"),
       actions::SetUp{look.up == MapUp::kNorth && has_flight ? MapUp::kHeading : MapUp::kNorth},
       look.up != MapUp::kNorth);
  // The scale bar stays free below them.
  const double padding = ui.px(kToolPadding);
  const double room = map.height - ui.px(8.0) - ui.px(kAboveScaleBar) - 2.0 * padding;
  const kit::Rect place{map.left + ui.px(8.0), map.top + ui.px(8.0),
                        ui.px(kToolSize) + 2.0 * padding,
                        ui.tool_column_height(tools, room) + 2.0 * padding};
  const auto column = ui.region(
      "Tools", place, {.surface = kit::Surface::kPlate, .padding = padding, .is_above = true});
  const auto clicked = ui.tool_column(tools, room);
  return clicked ? Actions{actions_of_tools[*clicked]} : Actions{};
}

Actions draw_map_cards(kit::Ui& ui, const MapViewModel& model, const kit::Rect& map) {
  Actions asked;
  double top = map.top + ui.px(48.0);  // below the north arrow
  if (!model.look.measured_in_enu_m.empty()) draw_measure_card(ui, model, map, top, asked);
  if (const auto index = selected_particle(model)) {
    draw_particle_card(ui, model, *index, map, top, asked);
  }
  return asked;
}

Actions draw_map_menu(kit::Ui& ui,
                      const std::string& name,
                      const MapViewModel& model,
                      const Eigen::Vector2d& point_in_enu_m) {
  Actions asked;
  const auto menu = ui.context_menu(name);
  if (!menu) return asked;
  const MapReadout place =
      map_readout(point_in_enu_m, nullptr, model.plane ? &*model.plane : nullptr);
  const auto copy = [&](const std::string& label, const std::string& text) {
    if (!text.empty() && ui.menu_item(label, {.icon = kit::Icon::kCopy, .hint = text})) {
      asked.emplace_back(actions::Copy{text});
    }
  };
  copy("Copy east and north",
       metres_text(point_in_enu_m.x()) + " " + metres_text(point_in_enu_m.y()));
  copy("Copy latitude and longitude", place.geodetic);
  copy("Copy UTM", place.utm);
  copy("Copy MGRS", place.mgrs);
  ui.menu_line();
  if (ui.menu_item("Centre here", {.icon = kit::Icon::kLocate})) {
    asked.emplace_back(actions::LookAt{point_in_enu_m.x(), point_in_enu_m.y(), {}});
  }
  if (ui.menu_item("Measure from here", {.icon = kit::Icon::kRuler})) {
    asked.emplace_back(actions::MeasurePoint{});
    asked.emplace_back(actions::MeasurePoint{point_in_enu_m.x(), point_in_enu_m.y()});
    if (model.look.tool != MapTool::kMeasure)
      asked.emplace_back(actions::UseTool{MapTool::kMeasure});
  }
  return asked;
}

}  // namespace nadir
