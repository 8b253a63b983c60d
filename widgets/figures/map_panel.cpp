// SPDX-License-Identifier: Apache-2.0
#include "widgets/figures/map_panel.h"

#include <algorithm>
#include <cmath>

#include "core/map/overhead_map_file.h"
#include "widgets/figures/page_layout.h"
#include "widgets/views/map_colours.h"

namespace nadir {
namespace {

Eigen::AlignedBox2d bounds_of(const OverheadTiles& tiles) {
  const Eigen::Vector2d size_m =
      tiles.metres_per_cell() * Eigen::Vector2d(tiles.width(), tiles.height());
  const Eigen::Vector2d top_left = tiles.top_left_in_enu_m();
  return {Eigen::Vector2d(top_left.x(), top_left.y() - size_m.y()),
          Eigen::Vector2d(top_left.x() + size_m.x(), top_left.y())};
}

/// The room, in directions right and up of the page, that a rectangle of ground takes on a map that is turned.
Eigen::AlignedBox2d turned_box(const Eigen::AlignedBox2d& box, double up_rad) {
  const double along = std::abs(std::sin(up_rad)), across = std::abs(std::cos(up_rad));
  const Eigen::Vector2d half = box.sizes() / 2.0;
  const Eigen::Vector2d turned_half(along * half.x() + across * half.y(),
                                    across * half.x() + along * half.y());
  return {Eigen::Vector2d(box.center() - turned_half), Eigen::Vector2d(box.center() + turned_half)};
}

}  // namespace

Result<std::unique_ptr<MapPanel>> MapPanel::create(const std::filesystem::path& package,
                                                   Ground ground,
                                                   const FigureOptions& options) {
  const auto plane = read_map_plane(package);
  if (!plane) return forward_error(plane);
  auto labels = OverheadTiles::open(package, OverheadTiles::Layer::kLabels);
  if (!labels) return forward_error(labels);
  std::unique_ptr<MapPanel> panel(new MapPanel(*plane, bounds_of(*labels), options));
  std::error_code error;
  panel->has_picture_ = std::filesystem::exists(package / "image.tif", error);
  panel->shows_picture_ = ground == Ground::kPicture && options.layers.has(FigureLayer::kPicture) &&
                          panel->has_picture_;
  if (panel->shows_picture_) {
    auto picture = OverheadTiles::open(package, OverheadTiles::Layer::kPicture);
    if (!picture) return forward_error(picture);
    panel->picture_ = std::make_unique<OverheadView>(panel->scene_, std::move(*picture),
                                                     OverheadTiles::Layer::kPicture);
  }
  const double opacity = panel->shows_picture_ ? options.label_opacity : 1.0;
  if (opacity > 0.0) {
    panel->labels_ = std::make_unique<OverheadView>(panel->scene_, std::move(*labels),
                                                    OverheadTiles::Layer::kLabels);
    panel->labels_->set_opacity(opacity);
  }
  return panel;
}

MapPanel::MapPanel(const ProjectPlane& plane,
                   const Eigen::AlignedBox2d& bounds,
                   const FigureOptions& options)
    : plane_(plane), bounds_(bounds), options_(options), scene_(bounds.center()) {}

void MapPanel::include(std::span<const Eigen::Vector2d> points_in_enu_m) {
  for (const Eigen::Vector2d& point : points_in_enu_m) {
    if (point.allFinite()) shown_.extend(point);
  }
}

void MapPanel::include_map() { shown_.extend(bounds_); }

void MapPanel::fade_labels() {
  constexpr double kFaded = 0.35;
  if (!shows_picture_ && labels_) labels_->set_opacity(kFaded);
}

void MapPanel::set_picture(bool is_visible, double opacity) {
  if (!picture_) return;
  picture_->set_visible(is_visible);
  picture_->set_opacity(opacity);
}

void MapPanel::set_labels(bool is_visible, double opacity) {
  if (!labels_) return;
  labels_->set_visible(is_visible);
  labels_->set_opacity(opacity);
}

bool MapPanel::is_turned() const { return MapCamera{.up_rad = up_rad_}.is_turned(); }

void MapPanel::show_square(const Eigen::Vector2d& centre_in_enu_m, double side_m) {
  if (!centre_in_enu_m.allFinite()) {
    shown_ = bounds_;
    return;
  }
  const Eigen::Vector2d half = Eigen::Vector2d::Constant(side_m / 2.0);
  shown_ = Eigen::AlignedBox2d(centre_in_enu_m - half, centre_in_enu_m + half);
}

bool MapPanel::shows_whole_map() const {
  return options_.crop.is_all() && (shown_.isEmpty() || shown_.isApprox(bounds_));
}

MapCamera MapPanel::camera_for(const PageRect& where) const {
  Eigen::AlignedBox2d shown = shown_.isEmpty() ? bounds_ : shown_;
  if (!options_.crop.is_all()) {
    MapCamera camera;
    camera.centre_in_enu_m = options_.crop.centre_in_enu_m.value_or(shown.center());
    camera.metres_per_px = options_.crop.width_m / where.width;
    camera.up_rad = up_rad_;
    return camera;
  }
  if (shows_whole_map() && is_turned()) shown = turned_box(shown, up_rad_);
  // Paths keep away from the border; the map as a whole fills the panel.
  const double margin = shows_whole_map() ? 0.0 : 0.08;
  MapCamera camera = MapCamera::fit(shown.min(), shown.max(), where, margin);
  camera.up_rad = up_rad_;
  return camera;
}

PageRect MapPanel::frame_inside(const PageRect& where, Graticule graticule, double px) const {
  const Eigen::Vector2d border = graticule_margin_px(graticule, px);
  // Whole pixels, so that the picture is not blurred.
  const double left = std::ceil(where.left + border.x());
  const double bottom = std::ceil(where.bottom + border.y());
  PageRect inside{left, bottom, std::max(1.0, std::floor(where.right() - left)),
                  std::max(1.0, std::floor(where.top() - bottom))};
  if (shows_whole_map() &&
      !is_turned()) {  // a frame of the map's own shape, at the top and in the middle of the panel
    const double aspect = bounds_.sizes().x() / bounds_.sizes().y();
    const PageRect whole = inside;
    inside.width = std::max(1.0, std::floor(std::min(whole.width, whole.height * aspect)));
    inside.height = std::max(1.0, std::round(inside.width / aspect));
    inside.left += std::floor((whole.width - inside.width) / 2.0);
    inside.bottom = whole.top() - inside.height;
  }
  return inside;
}

PageRect MapPanel::part_filled(const PageRect& panel,
                               double above_px,
                               const PageFormat& format) const {
  if (!shows_whole_map() || is_turned() || panel.height <= above_px) return panel;
  PageRect below = panel;
  below.height -= above_px;
  const PageRect frame = frame_inside(below, options_.graticule, format.px_per_pt());
  const double spare =
      std::max(0.0, frame.bottom - panel.bottom -
                        graticule_margin_px(options_.graticule, format.px_per_pt()).y());
  return {panel.left, panel.bottom + std::floor(spare / 2.0), panel.width, panel.height - spare};
}

void MapPanel::keep_on_map(MapFrame& frame) const {
  // What lies beside the map is shown only where something to be shown does.
  if (is_turned() || !options_.crop.is_all() || shown_.isEmpty() || !bounds_.contains(shown_)) {
    return;
  }
  PageRect& where = frame.where;
  MapCamera& camera = frame.camera;
  const Eigen::Vector2d map_px = bounds_.sizes() / camera.metres_per_px;
  const double spare = std::max(0.0, std::floor(where.width - map_px.x()));
  where.left += std::floor(spare / 2.0);
  where.width -= spare;
  const double spare_below = std::max(0.0, std::floor(where.height - map_px.y()));
  where.bottom += spare_below;
  where.height -= spare_below;
  const Eigen::Vector2d half_m =
      0.5 * camera.metres_per_px * Eigen::Vector2d(where.width, where.height);
  const Eigen::Vector2d low = bounds_.min() + half_m;
  const Eigen::Vector2d high = (bounds_.max() - half_m).cwiseMax(low);
  camera.centre_in_enu_m = camera.centre_in_enu_m.cwiseMax(low).cwiseMin(high);
}

MapPanel::Place MapPanel::place_in(const PageRect& where, double px_per_pt) const {
  Place place;
  place.graticule = is_turned() ? Graticule::kNone : options_.graticule;
  PageRect inside = frame_inside(where, place.graticule, px_per_pt);
  constexpr double kLeastWithNumbersPt = 48.0;
  if (std::min(inside.width, inside.height) < kLeastWithNumbersPt * px_per_pt) {
    place.graticule = Graticule::kNone;
    inside = frame_inside(where, place.graticule, px_per_pt);
  }
  place.frame = {inside, camera_for(inside), px_per_pt};
  keep_on_map(place.frame);
  return place;
}

PathLook truth_look(const Theme& theme) {
  return {theme.truth_on_imagery, 1.4, false, theme.casing_on_imagery, 0.5};
}

PathLook odometry_look(const Theme& theme) {
  return {theme.odometry_on_imagery, 1.4, true, theme.casing_on_imagery, 0.5};
}

PathLook estimate_look(const Theme& theme, std::size_t run) {
  const Rgba colour = run_colour_on_imagery(theme, run);
  return {colour, 1.7, is_run_dashed(run), casing_over_imagery(theme, colour), 0.5};
}

}  // namespace nadir
