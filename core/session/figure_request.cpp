// SPDX-License-Identifier: Apache-2.0
#include "core/session/figure_request.h"

#include <array>
#include <utility>

#include "core/base/settings.h"
#include "core/session/export_kinds.h"
#include "core/session/map_stack.h"
#include "core/session/map_upward.h"

namespace nadir {
namespace {

constexpr std::string_view kMomentFigure = "moment";

/// Layers of the window that figures can leave out, and what they are called there.
constexpr std::array<std::pair<Layer, std::string_view>, 8> kFigureLayers = {{
    {Layer::kPicture, "picture"},
    {Layer::kTruth, "truth"},
    {Layer::kOdometry, "odometry"},
    {Layer::kEstimate, "estimate"},
    {Layer::kEllipses, "ellipses"},
    {Layer::kModes, "modes"},
    {Layer::kParticles, "particles"},
    {Layer::kTopview, "topview"},
}};

std::string layers_text(const MapLook& look) {
  std::string shown;
  std::size_t count = 0;
  for (const auto& [layer, name] : kFigureLayers) {
    if (!look.layer(layer).is_visible) continue;
    shown += (count > 0 ? "," : "") + std::string(name);
    ++count;
  }
  if (count == 0) return "none";
  return count == kFigureLayers.size() ? "all" : shown;
}

/// The map of figure 'moment' is the window's: turned as it is, with its layers in their order.
std::string moment_map_lines(const FigureRequest& request) {
  const MapLook& look = request.look;
  std::string text = "stack = " + toml_quoted(MapStack::of(look).text()) + "\n";
  if (look.up != MapUp::kNorth) {
    text += "up = " + toml_quoted(MapUpward::of(look).text()) + "\n";
  }
  if (request.run_colour > 0) text += fmt::format("run-colour = {}\n", request.run_colour + 1);
  return text;
}

/// Other figures have their own order, and north up.
std::string layer_lines(const MapLook& look) {
  std::string text = "layers = " + toml_quoted(layers_text(look)) + "\n";
  if (look.layer(Layer::kLabels).is_visible) {
    text += fmt::format("label-opacity = {}\n", look.layer(Layer::kLabels).opacity);
  }
  if (look.layer(Layer::kGraticule).is_visible) text += "graticule-lines = true\n";
  return text;
}

std::string crop_line(const FigureRequest& request) {
  const MapLook& look = request.look;
  if (!(look.width_m > 0.0)) return {};
  // A film of a map that follows the vehicle goes with it.
  const bool is_around_vehicle = request.figure == kMomentFigure && look.is_following;
  const std::string crop = is_around_vehicle
                               ? fmt::format("{}", look.width_m)
                               : fmt::format("{}@{},{}", look.width_m, look.centre_in_enu_m.x(),
                                             look.centre_in_enu_m.y());
  return "crop = " + toml_quoted(crop) + "\n";
}

}  // namespace

RunsOfFigure runs_of_figure(std::string_view figure) {
  const ExportKind* const kind = export_kind(figure);
  return kind != nullptr ? kind->runs : RunsOfFigure::kOne;
}

std::string figure_recipe_text(const FigureRequest& request) {
  std::string text = "figure = " + toml_quoted(request.figure) + "\n";
  if (!request.runs.empty()) {
    std::string list;
    for (const std::string& run : request.runs)
      list += (list.empty() ? "" : ", ") + toml_quoted(run);
    text += "runs = [" + list + "]\n";
  }
  if (!request.map.empty()) text += "map = " + toml_quoted(request.map) + "\n";
  const MapLook& look = request.look;
  text += "\n[options]\n";
  text += "theme = " + toml_quoted(enum_name(request.theme)) + "\n";
  text += fmt::format("time = {}\n", request.time_s);
  if (request.width_px) text += fmt::format("size = \"{}\"\n", *request.width_px);
  text += crop_line(request);
  text += request.figure == kMomentFigure ? moment_map_lines(request) : layer_lines(look);
  text += "laid-at = " + toml_quoted(enum_name(look.topview_at)) + "\n";
  if (!request.is_film) return text;
  if (request.from_s) text += fmt::format("from = {}\n", *request.from_s);
  if (request.to_s) text += fmt::format("to = {}\n", *request.to_s);
  return text + fmt::format("speed = {}\n", request.speed);
}

}  // namespace nadir
