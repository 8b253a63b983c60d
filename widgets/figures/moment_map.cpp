// SPDX-License-Identifier: Apache-2.0
#include "widgets/figures/moment_map.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "widgets/figures/ground_layers.h"
#include "widgets/figures/moment_panels.h"
#include "widgets/figures/run_lines.h"
#include "widgets/figures/run_on_map.h"
#include "widgets/views/map_colours.h"
#include "widgets/views/raster_pictures.h"

namespace nadir {
namespace {

/// The figure's own order, from the ground up.
constexpr std::array kOwnOrder = {
    Layer::kPicture,  Layer::kLabels, Layer::kTopview,  Layer::kParticles, Layer::kGraticule,
    Layer::kOdometry, Layer::kTruth,  Layer::kEstimate, Layer::kEllipses,  Layer::kModes};

/// The same layer in the words of the option `layers`.
std::optional<FigureLayer> figure_layer(Layer layer) {
  const auto& names = EnumNames<FigureLayer>::kNames;
  const auto found = std::find(names.begin(), names.end(), enum_name(layer));
  if (found == names.end()) return std::nullopt;
  return static_cast<FigureLayer>(found - names.begin());
}

MapLook own_look(const FigureOptions& options) {
  MapLook look;
  for (LayerLook& layer : look.layers) layer.is_visible = false;
  look.order.assign(kOwnOrder.begin(), kOwnOrder.end());
  for (const Layer layer : kOwnOrder) {
    const auto named = figure_layer(layer);
    look.layer(layer).is_visible = !named || options.layers.has(*named);
  }
  look.layer(Layer::kLabels) = {options.label_opacity > 0.0, options.label_opacity, {}};
  look.layer(Layer::kGraticule).is_visible = options.shows_graticule_lines;
  look.layer(Layer::kTopview).opacity = 0.8;
  // The panel sees to it that there is a ground.
  return look;
}

}  // namespace

FigureOptions with_stack_applied(FigureOptions options) {
  if (options.stack.is_own()) return options;
  const MapLook look = options.stack.laid_on(default_map_look());
  for (std::size_t i = 0; i < kLayerCount; ++i) {
    const auto layer = static_cast<Layer>(i);
    if (const auto named = figure_layer(layer)) {
      options.layers.set(*named, is_in_sight(look, layer));
    }
  }
  const LayerLook& labels = look.layer(Layer::kLabels);
  options.label_opacity = labels.is_visible ? labels.opacity : 0.0;
  options.shows_graticule_lines = is_in_sight(look, Layer::kGraticule);
  return options;
}

std::string not_in_moment(const MapStack& stack) {
  std::string words;
  for (const auto& [layer, name] : {std::pair(Layer::kReconstruction, "reconstruction"),
                                    std::pair(Layer::kErrorSurface, "error surface")}) {
    if (stack.has(layer)) words += (words.empty() ? "" : " and ") + std::string(name);
  }
  return words;
}

Result<std::unique_ptr<MomentMap>> MomentMap::create(const std::filesystem::path& package,
                                                     const FigureOptions& options) {
  auto panel = MapPanel::create(package, MapPanel::Ground::kPicture, options);
  if (!panel) return forward_error(panel);
  return std::unique_ptr<MomentMap>(new MomentMap(std::move(*panel), options));
}

MomentMap::MomentMap(std::unique_ptr<MapPanel> panel, const FigureOptions& options)
    : panel_(std::move(panel)),
      options_(options),
      look_(options.stack.is_own() ? own_look(options) : options.stack.laid_on(default_map_look())),
      topview_(panel_->scene(), MapLayer::kTopview),
      agreement_(panel_->scene()),
      particles_(panel_->scene()) {
  topview_.set_opacity(look_.layer(Layer::kTopview).opacity);
  agreement_.set_opacity(look_.layer(Layer::kDisagreement).opacity);
  agreement_.set_visible(false);
  if (options_.stack.is_own()) {
    panel_->fade_labels();
    return;
  }
  const bool has_picture = panel_->has_picture();
  panel_->scene().set_order(scene_layers(look_.order, look_, has_picture));
  panel_->set_picture(is_in_sight(look_, Layer::kPicture), look_.layer(Layer::kPicture).opacity);
  panel_->set_labels(shows_labels(look_, has_picture), labels_opacity(look_, has_picture));
}

bool MomentMap::shows_particles(const RunStep& step) const {
  return is_in_sight(look_, Layer::kParticles) && step.particles.has_value();
}

std::span<const PoseMode> MomentMap::shown_modes(const RunStep& step) const {
  const std::span<const PoseMode> modes = step.estimate.modes;
  return is_in_sight(look_, Layer::kModes) ? modes
                                           : modes.first(std::min<std::size_t>(modes.size(), 1));
}

void MomentMap::show(const RunStep& step, const OverheadMap& labels, const Theme& theme) {
  look_around(step);
  const bool has_particles = shows_particles(step);
  particles_.set_visible(has_particles);
  if (has_particles) {
    ParticleLook look;
    look.opacity = look_.layer(Layer::kParticles).opacity;
    particles_.show(*step.particles, look);
  }
  lay_topview(step, labels, theme);
}

/// Room for the topview, the truth and three deviations around the estimate.
void MomentMap::look_around(const RunStep& step) {
  constexpr double kLeastSideM = 50.0;
  const Rigid2& mean = step.estimate.moments.mean;
  const Eigen::Vector2d centre = mean.translation_m();
  const Eigen::Matrix3d& covariance = step.estimate.moments.covariance;
  double reach_m = 0.0;
  const auto reach = [&reach_m](double length_m) {
    if (std::isfinite(length_m)) reach_m = std::max(reach_m, length_m);
  };
  reach(3.0 * std::sqrt(covariance(0, 0) + covariance(1, 1)));
  if (step.truth_in_enu) reach((step.truth_in_enu->translation_m() - centre).norm());
  const Eigen::Vector2d size_m = panel_->map_bounds_in_enu_m().sizes();
  panel_->show_square(centre, std::min(std::max(kLeastSideM, 2.5 * reach_m), size_m.maxCoeff()));
  panel_->turn(options_.up.up_rad(is_finite(mean) ? mean.yaw_rad : MapCamera{}.up_rad));
}

void MomentMap::lay_topview(const RunStep& step, const OverheadMap& labels, const Theme& theme) {
  const auto pose = pose_of(step, source_of(options_.laid_at));
  const bool has_topview = pose && is_finite(*pose) && step.topview && !step.topview->cells.empty();
  const bool shows_topview = has_topview && is_in_sight(look_, Layer::kTopview);
  topview_.set_visible(shows_topview);
  if (shows_topview) {
    const TopviewRaster raster = topview_raster(*step.topview);
    const double cell_m = step.topview->metres_per_cell;
    topview_.show(class_picture(raster.labels), enu_from_topview_corner(*pose, raster, cell_m),
                  Eigen::Vector2d::Constant(cell_m), false);
  }
  const bool shows_agreement = has_topview && is_in_sight(look_, Layer::kDisagreement) &&
                               !unlike_cells(*step.topview, labels);
  agreement_.set_visible(shows_agreement);
  if (shows_agreement) {
    agreement_.show(*step.topview, cell_agreement(*step.topview, labels, *pose), *pose, theme);
  }
}

Result<void> MomentMap::draw(Canvas& canvas,
                             FigureContext& context,
                             const PageRect& where,
                             const FigureRun& run,
                             std::size_t steps,
                             const RunStep& step) {
  const auto frame = draw_parts(canvas, context, where, run, steps, step);
  if (!frame) return forward_error(frame);
  const PageFormat& format = context.format();
  std::vector<PageRect> plates;
  if (shown_modes(step).size() > 1) {
    for (const auto& plate : mode_plates(*frame, shown_modes(step), mode_look(format.colours()))) {
      if (plate) plates.push_back(*plate);
    }
  }
  panel_->draw_furniture(canvas, format, *frame, plates);
  return {};
}

Result<MapFrame> MomentMap::draw_parts(Canvas& canvas,
                                       FigureContext& context,
                                       const PageRect& where,
                                       const FigureRun& run,
                                       std::size_t steps,
                                       const RunStep& step) {
  const PageFormat& format = context.format();
  const Theme& theme = format.colours();
  const bool is_own = options_.stack.is_own();
  const MapPanel::Place place = panel_->place_in(where, format.px_per_pt());
  if (is_own) {  // its ground is one, whatever is shown of it
    if (auto drawn = panel_->draw_part(canvas, context, place.frame, {}, true); !drawn) {
      return forward_error(drawn);
    }
    panel_->draw_border(canvas, format, place);
  }
  const std::vector<MapPart> parts = map_parts(look_);
  for (const MapPart& part : parts) {
    const bool is_lowest = &part == &parts.front();
    if (part.is_ground) {
      const std::vector<MapLayer> layers = scene_layers(part.layers, look_, panel_->has_picture());
      if (is_own || layers.empty()) continue;
      if (auto drawn = panel_->draw_part(canvas, context, place.frame, layers, is_lowest); !drawn) {
        return forward_error(drawn);
      }
      continue;
    }
    for (const Layer layer : part.layers) {
      if (layer == Layer::kGraticule && is_own) {
        panel_->draw_lines(canvas, format, place, grid_look(theme));
        continue;
      }
      if (layer == Layer::kGraticule) {  // as the window has it, turned or not
        draw_grid_lines(canvas, place.frame, grid_look(theme));
        continue;
      }
      canvas.push_clip(place.frame.where);
      // In the figure's own order the masses of the modes lie on the arrows of now.
      if (is_own && layer == Layer::kModes) draw_poses(canvas, place.frame, step, theme);
      draw_line_layer(canvas, place.frame, layer, run, steps, step, theme);
      canvas.pop_clip();
    }
  }
  if (!is_own || !is_in_sight(look_, Layer::kModes)) {
    canvas.push_clip(place.frame.where);
    draw_poses(canvas, place.frame, step, theme);
    canvas.pop_clip();
  }
  if (!is_own) panel_->draw_border(canvas, format, place);
  return place.frame;
}

}  // namespace nadir
