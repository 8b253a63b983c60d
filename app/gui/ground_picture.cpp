// SPDX-License-Identifier: Apache-2.0
#include "app/gui/ground_picture.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/eval/evaluated_step.h"
#include "core/mcl/cell_agreement.h"
#include "core/session/step_pose.h"
#include "core/topview/semantic_topview.h"
#include "widgets/views/raster_pictures.h"

namespace nadir {
namespace {

/// A tile takes about 5 ms to read, and a frame has 50.
constexpr int kTilesAFrame = 3;

Eigen::Vector2d centre_of(const OverheadTiles& tiles) {
  return tiles.top_left_in_enu_m() +
         tiles.metres_per_cell() / 2.0 * Eigen::Vector2d(tiles.width(), -tiles.height());
}

/// Costs from west to east and from north to south; cheap is light. The scale is the plane's own.
Raster<Rgba> cost_picture(const MomentSurface& surface) {
  const ErrorSurfaceGrid& grid = surface.volume.grid;
  const auto [least, most] = std::minmax_element(surface.plane.begin(), surface.plane.end());
  const float span = std::max(*most - *least, 1e-6F);
  Raster<Rgba> picture(grid.count_x, grid.count_y);
  for (int row = 0; row < grid.count_y; ++row) {
    for (int column = 0; column < grid.count_x; ++column) {
      const auto place = static_cast<std::size_t>(grid.count_y - 1 - row) *
                             static_cast<std::size_t>(grid.count_x) +
                         static_cast<std::size_t>(column);
      picture.at(column, row) =
          value_colour(ValueColours::kViridis, 1.0 - (surface.plane[place] - *least) / span);
    }
  }
  return picture;
}

}  // namespace

Result<std::unique_ptr<GroundPicture>> GroundPicture::open(const std::filesystem::path& package) {
  auto labels = OverheadTiles::open(package, OverheadTiles::Layer::kLabels);
  if (!labels) return forward_error(labels);
  std::unique_ptr<GroundPicture> ground(new GroundPicture(centre_of(*labels)));
  ground->labels_ = std::make_unique<OverheadView>(ground->scene_, std::move(*labels),
                                                   OverheadTiles::Layer::kLabels);
  std::error_code error;
  if (std::filesystem::exists(package / "image.tif", error)) {
    auto picture = OverheadTiles::open(package, OverheadTiles::Layer::kPicture);
    if (!picture) return forward_error(picture);
    ground->picture_ = std::make_unique<OverheadView>(ground->scene_, std::move(*picture),
                                                      OverheadTiles::Layer::kPicture);
  }
  return ground;
}

GroundPicture::GroundPicture(const Eigen::Vector2d& centre_in_enu_m)
    : scene_(centre_in_enu_m),
      texture_(scene_.renderer()),
      reconstruction_(scene_, MapLayer::kReconstruction),
      surface_(scene_, MapLayer::kSurface),
      topview_(scene_, MapLayer::kTopview),
      agreement_(scene_),
      particles_(scene_) {
  for (RasterView* const view : {&reconstruction_, &surface_, &topview_}) view->set_visible(false);
  agreement_.set_visible(false);
}

void GroundPicture::show(const GroundContents& contents) {
  const bool is_new = !shown_.has_value();
  const bool is_look_new = is_new || !(shown_->look == contents.look);
  const bool is_theme_new = is_new || shown_->theme != contents.theme;
  const bool is_step_new = is_new || shown_->step != contents.step;
  const bool is_seen_new = is_new || shown_->reconstruction != contents.reconstruction;
  const bool is_surface_new = is_new || shown_->surface != contents.surface;
  const bool is_map_new = is_new || shown_->labels != contents.labels;
  if (!(is_look_new || is_theme_new || is_step_new || is_seen_new || is_surface_new ||
        is_map_new)) {
    return;
  }
  drawn_.reset();
  if (is_theme_new) scene_.set_background(theme(contents.theme).window, false);
  if (is_step_new && contents.step && contents.step->particles) {
    particles_.show(*contents.step->particles);
  }
  if (is_seen_new && contents.reconstruction) {
    const ReconstructedGround& seen = *contents.reconstruction;
    reconstruction_.show(class_picture(seen.labels),
                         Rigid2{seen.top_left_in_enu_m.x(), seen.top_left_in_enu_m.y(), 0.0},
                         Eigen::Vector2d::Constant(seen.metres_per_cell), false);
  }
  if (is_surface_new && contents.surface) show_surface(*contents.surface);
  if (is_step_new || is_look_new || is_map_new || is_theme_new) show_topview(contents);
  const bool has_step = contents.step != nullptr;
  const MapLook& look = contents.look;
  particles_.set_visible(look.layer(Layer::kParticles).is_visible && has_step &&
                         contents.step->particles.has_value());
  reconstruction_.set_visible(look.layer(Layer::kReconstruction).is_visible &&
                              contents.reconstruction && !contents.reconstruction->labels.empty());
  surface_.set_visible(look.layer(Layer::kErrorSurface).is_visible && contents.surface);
  show_layers(look);
  shown_ = contents;
}

bool GroundPicture::shows_labels(const MapLook& look) const {
  const auto is_seen = [&look](Layer layer) {
    return look.layer(layer).is_visible && look.layer(layer).opacity > 0.0;
  };
  return is_seen(Layer::kLabels) || (!picture_ && is_seen(Layer::kPicture));
}

void GroundPicture::show_layers(const MapLook& look) {
  const LayerLook& picture = look.layer(Layer::kPicture);
  const LayerLook& labels = look.layer(Layer::kLabels);
  if (picture_) {
    picture_->set_visible(picture.is_visible);
    picture_->set_opacity(picture.opacity);
  }
  labels_->set_visible(shows_labels(look));
  labels_->set_opacity(picture_ ? labels.opacity : std::max(labels.opacity, picture.opacity));
  reconstruction_.set_opacity(look.layer(Layer::kReconstruction).opacity);
  surface_.set_opacity(look.layer(Layer::kErrorSurface).opacity);
  topview_.set_opacity(look.layer(Layer::kTopview).opacity);
  agreement_.set_opacity(look.layer(Layer::kDisagreement).opacity);
}

void GroundPicture::show_topview(const GroundContents& contents) {
  const RunStep* const step = contents.step.get();
  const auto pose = step != nullptr ? pose_of(*step, contents.look.topview_at) : std::nullopt;
  const bool has_topview =
      pose && is_finite(*pose) && step->topview && !step->topview->cells.empty();
  const bool shows_classes = has_topview && contents.look.layer(Layer::kTopview).is_visible;
  topview_.set_visible(shows_classes);
  if (shows_classes) {
    const TopviewRaster raster = topview_raster(*step->topview);
    topview_.show(class_picture(raster.labels),
                  enu_from_topview_corner(*pose, raster, step->topview->metres_per_cell),
                  Eigen::Vector2d::Constant(step->topview->metres_per_cell), false);
  }
  const bool shows_agreement = has_topview && contents.labels &&
                               contents.look.layer(Layer::kDisagreement).is_visible &&
                               step->topview->metres_per_cell == contents.labels->metres_per_cell;
  agreement_.set_visible(shows_agreement);
  if (shows_agreement) {
    agreement_.show(*step->topview, cell_agreement(*step->topview, *contents.labels, *pose), *pose,
                    theme(contents.theme));
  }
}

void GroundPicture::show_surface(const MomentSurface& surface) {
  const ErrorSurfaceGrid& grid = surface.volume.grid;
  // Samples lie in the middle of pixels.
  const Eigen::Vector2d half(grid.count_x / 2.0, grid.count_y / 2.0);
  const Rigid2 enu_from_corner{surface.volume.centre_in_enu.x_m - half.x() * grid.step_m,
                               surface.volume.centre_in_enu.y_m + half.y() * grid.step_m, 0.0};
  surface_.show(cost_picture(surface), enu_from_corner, Eigen::Vector2d::Constant(grid.step_m),
                true, false);
}

Result<void> GroundPicture::draw(const MapCamera& camera, int width, int height, double px_per_pt) {
  const Sight sight{camera, width, height, px_per_pt};
  if (drawn_ == sight && !wants_more_) return {};
  Result<void> outcome;
  wants_more_ = false;
  const MapLook look = shown_ ? shown_->look : default_map_look();
  for (const auto& [view, layer] :
       {std::pair(picture_.get(), Layer::kPicture), std::pair(labels_.get(), Layer::kLabels)}) {
    const bool is_shown = layer == Layer::kLabels
                              ? shows_labels(look)
                              : look.layer(layer).is_visible && look.layer(layer).opacity > 0.0;
    if (view == nullptr || !is_shown) continue;
    const auto is_all = view->update(camera, width, height, kTilesAFrame);
    if (!is_all) {
      outcome = forward_error(is_all);
    } else if (!*is_all) {
      wants_more_ = true;
    }
  }
  scene_.look({camera, 1.0 * width, 1.0 * height, px_per_pt});
  texture_.draw(width, height);
  drawn_ = sight;
  return outcome;
}

}  // namespace nadir
