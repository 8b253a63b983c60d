// SPDX-License-Identifier: Apache-2.0
#include "app/gui/ground_picture.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/eval/evaluated_step.h"
#include "core/mcl/cell_agreement.h"
#include "core/session/map_parts.h"
#include "core/session/step_pose.h"
#include "core/topview/semantic_topview.h"
#include "widgets/figures/ground_layers.h"
#include "widgets/panels/map_lines.h"
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
/// @param plane  As MomentSurface::plane.
Raster<Rgba> cost_picture(const ErrorSurfaceGrid& grid, const std::vector<float>& plane) {
  const auto [least, most] = std::minmax_element(plane.begin(), plane.end());
  const float span = std::max(*most - *least, 1e-6F);
  Raster<Rgba> picture(grid.count_x, grid.count_y);
  for (int row = 0; row < grid.count_y; ++row) {
    for (int column = 0; column < grid.count_x; ++column) {
      const auto place = static_cast<std::size_t>(grid.count_y - 1 - row) *
                             static_cast<std::size_t>(grid.count_x) +
                         static_cast<std::size_t>(column);
      picture.at(column, row) =
          value_colour(ValueColours::kViridis, 1.0 - (plane[place] - *least) / span);
    }
  }
  return picture;
}

/// Whether two looks make the same ground: where it is looked at from comes with each drawing, and lines are not its.
bool are_grounds_alike(const MapLook& a, const MapLook& b) {
  return a.layers == b.layers && a.order == b.order && a.topview_at == b.topview_at;
}

/// Whether two looks lay the same topview and agreement.
bool are_topviews_alike(const MapLook& a, const MapLook& b) {
  const auto is_shown_alike = [&](Layer layer) {
    return a.layer(layer).is_visible == b.layer(layer).is_visible;
  };
  return a.topview_at == b.topview_at && is_shown_alike(Layer::kTopview) &&
         is_shown_alike(Layer::kDisagreement);
}

/// Larger than in a figure, and cased, for it is looked at on any ground.
ParticleLook window_particles(const Theme& theme, bool is_on_picture, double opacity) {
  ParticleLook look;
  look.size_pt = 1.5;
  look.tick_width_pt = 0.9;
  look.casing = particle_casing(theme, is_on_picture);
  look.casing_of_dark = with_opacity(light_on_imagery(theme), 0.45);
  look.casing_pt = 0.6;
  look.opacity = opacity;
  return look;
}

}  // namespace

std::unique_ptr<GroundPicture> GroundPicture::without_map(const Eigen::Vector2d& centre_in_enu_m) {
  return std::unique_ptr<GroundPicture>(new GroundPicture(centre_in_enu_m));
}

Result<std::unique_ptr<GroundPicture>> GroundPicture::open(const std::filesystem::path& package,
                                                           std::shared_ptr<TileBudget> budget) {
  auto labels = OverheadTiles::open(package, OverheadTiles::Layer::kLabels);
  if (!labels) return forward_error(labels);
  std::unique_ptr<GroundPicture> ground(new GroundPicture(centre_of(*labels)));
  if (budget == nullptr) budget = std::make_shared<TileBudget>();
  ground->labels_ = std::make_unique<OverheadView>(ground->scene_, std::move(*labels),
                                                   OverheadTiles::Layer::kLabels, budget);
  std::error_code error;
  if (std::filesystem::exists(package / "image.tif", error)) {
    auto picture = OverheadTiles::open(package, OverheadTiles::Layer::kPicture);
    if (!picture) return forward_error(picture);
    ground->picture_ = std::make_unique<OverheadView>(ground->scene_, std::move(*picture),
                                                      OverheadTiles::Layer::kPicture, budget);
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
  const bool is_look_new = is_new || !are_grounds_alike(shown_->look, contents.look);
  const bool is_topview_new = is_new || !are_topviews_alike(shown_->look, contents.look);
  const bool is_theme_new = is_new || shown_->theme != contents.theme;
  const bool is_step_new = is_new || shown_->step != contents.step;
  const bool is_seen_new = is_new || shown_->reconstruction != contents.reconstruction;
  const bool is_surface_new = is_new || shown_->surface != contents.surface ||
                              shown_->shows_best_turn != contents.shows_best_turn;
  const bool is_map_new = is_new || shown_->labels != contents.labels;
  if (!(is_look_new || is_theme_new || is_step_new || is_seen_new || is_surface_new ||
        is_map_new)) {
    return;
  }
  for (DrawnPart& part : parts_) part.sight.reset();
  const ParticleLook particles = window_particles(theme(contents.theme), labels_ != nullptr,
                                                  contents.look.layer(Layer::kParticles).opacity);
  if (is_step_new && contents.step && contents.step->particles) {
    particles_.show(*contents.step->particles, particles);
  } else {
    particles_.set_look(particles);
  }
  if (is_seen_new && contents.reconstruction) {
    const ReconstructedGround& seen = *contents.reconstruction;
    reconstruction_.show(class_picture(seen.labels),
                         Rigid2{seen.top_left_in_enu_m.x(), seen.top_left_in_enu_m.y(), 0.0},
                         Eigen::Vector2d::Constant(seen.metres_per_cell), false);
  }
  if (is_surface_new && contents.surface) show_surface(*contents.surface, contents.shows_best_turn);
  if (is_step_new || is_topview_new || is_map_new || is_theme_new) show_topview(contents);
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

void GroundPicture::show_layers(const MapLook& look) {
  if (picture_) {
    picture_->set_visible(is_in_sight(look, Layer::kPicture));
    picture_->set_opacity(look.layer(Layer::kPicture).opacity);
  }
  if (labels_) {
    labels_->set_visible(shows_labels(look, has_picture()));
    labels_->set_opacity(labels_opacity(look, has_picture()));
  }
  scene_.set_order(scene_layers(look.order, look, has_picture()));
  reconstruction_.set_opacity(look.layer(Layer::kReconstruction).opacity);
  surface_.set_opacity(look.layer(Layer::kErrorSurface).opacity);
  topview_.set_opacity(look.layer(Layer::kTopview).opacity);
  agreement_.set_opacity(look.layer(Layer::kDisagreement).opacity);
}

void GroundPicture::show_topview(const GroundContents& contents) {
  ++topviews_laid_;
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

void GroundPicture::show_surface(const MomentSurface& surface, bool shows_best_turn) {
  const ErrorSurfaceGrid& grid = surface.volume.grid;
  // Samples lie in the middle of pixels.
  const Eigen::Vector2d half(grid.count_x / 2.0, grid.count_y / 2.0);
  const Rigid2 enu_from_corner{surface.volume.centre_in_enu.x_m - half.x() * grid.step_m,
                               surface.volume.centre_in_enu.y_m + half.y() * grid.step_m, 0.0};
  surface_.show(cost_picture(grid, shows_best_turn ? surface.best_turn : surface.plane),
                enu_from_corner, Eigen::Vector2d::Constant(grid.step_m), true, false);
}

Result<void> GroundPicture::update_tiles(const MapCamera& camera,
                                         int width,
                                         int height,
                                         const GroundPart& part) {
  Result<void> outcome;
  const MapLook look = shown_ ? shown_->look : default_map_look();
  const std::vector<MapLayer> drawn = scene_layers(part.layers, look, has_picture());
  const auto is_drawn = [&drawn](MapLayer layer) {
    return std::find(drawn.begin(), drawn.end(), layer) != drawn.end();
  };
  bool is_complete = true;
  // One that is hidden lets go of its tiles; one of another part has what it needs there.
  const auto update = [&](OverheadView* view, bool is_here, bool is_seen) {
    if (view == nullptr || (is_seen && !is_here)) return;
    const auto is_all = view->update(camera, width, height, kTilesAFrame);
    if (!is_all) outcome = forward_error(is_all);  // once; the rest comes all the same
    if (!is_all || !*is_all) is_complete = false;
  };
  update(picture_.get(), is_drawn(MapLayer::kPicture), is_in_sight(look, Layer::kPicture));
  update(labels_.get(), is_drawn(MapLayer::kLabels), shows_labels(look, has_picture()));
  parts_[static_cast<std::size_t>(part.number)].wants_more = !is_complete;
  return outcome;
}

Result<void> GroundPicture::draw(
    const MapCamera& camera, int width, int height, double px_per_pt, const GroundPart& part) {
  const auto count = static_cast<std::size_t>(std::max(part.count, part.number + 1));
  if (parts_.size() != count) parts_ = std::vector<DrawnPart>(count);
  DrawnPart& drawn = parts_[static_cast<std::size_t>(part.number)];
  const Sight sight{camera, width, height, px_per_pt, part};
  if (drawn.sight == sight && !drawn.wants_more) return {};
  Result<void> outcome = update_tiles(camera, width, height, part);
  const bool is_alone = part.count == 1 && part.is_lowest;
  scene_.set_background(theme(shown_ ? shown_->theme : ThemeName::kDark).window, !part.is_lowest);
  scene_.look({camera, 1.0 * width, 1.0 * height, px_per_pt});
  const MapLook look = shown_ ? shown_->look : default_map_look();
  if (!is_alone) scene_.show_only(scene_layers(part.layers, look, has_picture()));
  drawn.texture = texture_.draw(width, height);
  scene_.show_all();
  if (!is_alone) {  // the next part is drawn where this one was
    if (!drawn.copy) drawn.copy = std::make_unique<PictureTexture>();
    drawn.texture = drawn.copy->show(texture_.pixels(), false);
  }
  drawn.sight = sight;
  return outcome;
}

std::uint32_t GroundPicture::texture(int number) const {
  const auto index = static_cast<std::size_t>(number);
  return index < parts_.size() ? parts_[index].texture : 0;
}

bool GroundPicture::wants_more() const {
  return std::any_of(parts_.begin(), parts_.end(),
                     [](const DrawnPart& part) { return part.wants_more; });
}

}  // namespace nadir
