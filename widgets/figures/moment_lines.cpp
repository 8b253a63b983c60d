// SPDX-License-Identifier: Apache-2.0
// The lines over the map of figure 'moment', and what they look like.
#include <array>

#include "widgets/figures/ground_layers.h"
#include "widgets/figures/moment_map.h"
#include "widgets/views/map_colours.h"

namespace nadir {
namespace {

Layer layer_of_line(Source source) {
  if (source == Source::kTruth) return Layer::kTruth;
  return source == Source::kOdometry ? Layer::kOdometry : Layer::kEstimate;
}

}  // namespace

PathLook MomentMap::line_look(Layer layer, const Theme& theme) const {
  PathLook look = theme_look(layer, theme);
  const LayerLook& chosen = look_.layer(layer);
  double opacity = chosen.opacity;
  std::optional<std::string> colour = chosen.colour;
  const bool is_over_imagery = options_.stack.is_own() || is_ground_below_lines(look_);
  if (layer == Layer::kEllipses || layer == Layer::kModes) {  // as the estimate that they are of
    const LayerLook& estimate = look_.layer(Layer::kEstimate);
    if (!colour) {
      colour = estimate.colour;
      opacity *= estimate.opacity;
    }
  }
  if (colour) look.colour = colour_from_hex(*colour).value_or(look.colour);
  if (is_over_imagery) look.casing = casing_over_imagery(theme, look.colour);
  if (layer == Layer::kEllipses || layer == Layer::kModes) {
    look.casing = faded(look.casing, look_.layer(Layer::kEstimate).opacity);
  }
  look.colour = faded(look.colour, opacity);
  look.casing = faded(look.casing, chosen.opacity);
  return look;
}

Rgba MomentMap::run_colour(const Theme& theme) const {
  const std::optional<std::string>& own = look_.layer(Layer::kEstimate).colour;
  const Rgba colour = nadir::run_colour(theme, static_cast<std::size_t>(options_.run_colour - 1));
  return own ? colour_from_hex(*own).value_or(colour) : colour;
}

/// Without a colour of the layer's own: over imagery, or on the bare page.
PathLook MomentMap::theme_look(Layer layer, const Theme& theme) const {
  const auto run = static_cast<std::size_t>(options_.run_colour - 1);
  PathLook look = layer == Layer::kTruth      ? truth_look(theme)
                  : layer == Layer::kOdometry ? odometry_look(theme)
                                              : estimate_look(theme, run);
  if (options_.stack.is_own() || is_ground_below_lines(look_)) return look;
  look.colour = layer == Layer::kTruth      ? theme.truth
                : layer == Layer::kOdometry ? theme.odometry
                                            : nadir::run_colour(theme, run);
  look.casing = with_opacity(theme.page, 0.8);
  return look;
}

MapGridLook MomentMap::grid_look(const Theme& theme) const {
  const LayerLook& grid = look_.layer(Layer::kGraticule);
  const auto own = grid.colour ? colour_from_hex(*grid.colour) : std::nullopt;
  if (options_.stack.is_own() || is_ground_below_lines(look_)) {
    return grid_look_on_imagery(theme, own.value_or(light_on_imagery(theme)), grid.opacity);
  }
  return {faded(own.value_or(theme.line), grid.opacity), Rgba{0, 0, 0, 0},
          faded(theme.muted, grid.opacity), with_opacity(theme.page, 0.8 * grid.opacity)};
}

ModeLook MomentMap::mode_look(const Theme& theme) const {
  const double opacity = look_.layer(Layer::kModes).opacity;
  ModeLook look;
  look.arrow = line_look(Layer::kModes, theme);
  look.plate = with_opacity(theme.page, 0.85 * opacity);
  look.words.colour = faded(theme.text, opacity);
  return look;
}

void MomentMap::draw_line_layer(Canvas& canvas,
                                const MapFrame& frame,
                                Layer layer,
                                const FigureRun& run,
                                std::size_t steps,
                                const RunStep& step,
                                const Theme& theme) const {
  constexpr std::array<double, 3> kEllipseSigmas = {3.0, 2.0, 1.0};
  for (const Source source : {Source::kOdometry, Source::kTruth, Source::kEstimate}) {
    if (layer_of_line(source) != layer) continue;
    std::vector<Eigen::Vector2d> path = path_of(run, source);
    path.resize(steps);
    draw_path(canvas, frame, path, line_look(layer, theme));
  }
  if (layer == Layer::kEllipses) {
    PathLook thin = line_look(layer, theme);
    thin.width_pt = 0.9;
    thin.is_dashed = false;
    for (const PoseMode& mode : shown_modes(step)) {
      draw_ellipses(canvas, frame, mode.moments.mean.translation_m(),
                    mode.moments.covariance.topLeftCorner<2, 2>(), kEllipseSigmas, thin);
    }
  }
  if (layer == Layer::kModes && shown_modes(step).size() > 1) {
    draw_modes(canvas, frame, shown_modes(step), mode_look(theme));
  }
}

void MomentMap::draw_poses(Canvas& canvas,
                           const MapFrame& frame,
                           const RunStep& step,
                           const Theme& theme) const {
  for (const Source source : {Source::kOdometry, Source::kTruth, Source::kEstimate}) {
    const auto pose = pose_of(step, source);
    const Layer layer = layer_of_line(source);
    if (!pose || !is_in_sight(look_, layer)) continue;
    draw_pose(canvas, frame, *pose, 10.0, line_look(layer, theme));
  }
}

}  // namespace nadir
