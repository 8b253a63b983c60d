// SPDX-License-Identifier: Apache-2.0
#include "widgets/figures/map_panel.h"

#include <vtkProp.h>
#include <vtkPropCollection.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/map/overhead_map_file.h"
#include "widgets/figures/page_layout.h"
#include "widgets/views/map_furniture.h"

namespace nadir {
namespace {

Eigen::AlignedBox2d bounds_of(const OverheadTiles& tiles) {
  const Eigen::Vector2d size_m =
      tiles.metres_per_cell() * Eigen::Vector2d(tiles.width(), tiles.height());
  const Eigen::Vector2d top_left = tiles.top_left_in_enu_m();
  return {Eigen::Vector2d(top_left.x(), top_left.y() - size_m.y()),
          Eigen::Vector2d(top_left.x() + size_m.x(), top_left.y())};
}

/// Grows whenever something in the scene is changed, added or taken away.
std::uint64_t stamp_of(vtkRenderer& renderer) {
  std::uint64_t stamp = renderer.GetViewProps()->GetMTime();
  vtkPropCollection& props = *renderer.GetViewProps();
  vtkCollectionSimpleIterator place;
  props.InitTraversal(place);
  while (vtkProp* const prop = props.GetNextProp(place)) {
    stamp = std::max<std::uint64_t>({stamp, prop->GetMTime(), prop->GetRedrawMTime()});
  }
  return stamp;
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
  const bool has_picture = std::filesystem::exists(package / "image.tif", error);
  panel->shows_picture_ =
      ground == Ground::kPicture && options.layers.has(FigureLayer::kPicture) && has_picture;
  if (panel->shows_picture_) {
    auto picture = OverheadTiles::open(package, OverheadTiles::Layer::kPicture);
    if (!picture) return forward_error(picture);
    panel->layers_.push_back(std::make_unique<OverheadView>(panel->scene_, std::move(*picture),
                                                            OverheadTiles::Layer::kPicture));
  }
  const double opacity = panel->shows_picture_ ? options.label_opacity : 1.0;
  if (opacity > 0.0) {
    panel->layers_.push_back(std::make_unique<OverheadView>(panel->scene_, std::move(*labels),
                                                            OverheadTiles::Layer::kLabels));
    panel->layers_.back()->set_opacity(opacity);
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
  if (!shows_picture_ && !layers_.empty()) layers_.back()->set_opacity(kFaded);
}

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
  const Eigen::AlignedBox2d& shown = shown_.isEmpty() ? bounds_ : shown_;
  if (!options_.crop.is_all()) {
    MapCamera camera;
    camera.centre_in_enu_m = options_.crop.centre_in_enu_m.value_or(shown.center());
    camera.metres_per_px = options_.crop.width_m / where.width;
    return camera;
  }
  // Paths keep away from the border; the map as a whole fills the panel.
  const double margin = shows_whole_map() ? 0.0 : 0.08;
  return MapCamera::fit(shown.min(), shown.max(), where, margin);
}

PageRect MapPanel::frame_inside(const PageRect& where, Graticule graticule, double px) const {
  const Eigen::Vector2d border = graticule_margin_px(graticule, px);
  // Whole pixels, so that the picture is not blurred.
  const double left = std::ceil(where.left + border.x());
  const double bottom = std::ceil(where.bottom + border.y());
  PageRect inside{left, bottom, std::max(1.0, std::floor(where.right() - left)),
                  std::max(1.0, std::floor(where.top() - bottom))};
  if (shows_whole_map()) {  // a frame of the map's own shape, at the top and in the middle of the panel
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
  if (!shows_whole_map() || panel.height <= above_px) return panel;
  PageRect below = panel;
  below.height -= above_px;
  const PageRect frame = frame_inside(below, options_.graticule, format.px_per_pt());
  const double spare =
      std::max(0.0, frame.bottom - panel.bottom -
                        graticule_margin_px(options_.graticule, format.px_per_pt()).y());
  return {panel.left, panel.bottom + std::floor(spare / 2.0), panel.width, panel.height - spare};
}

Result<void> MapPanel::render(FigureContext& context, const GroundState& wanted) {
  const bool is_where_it_was = drawn_ == wanted;
  if (is_where_it_was && content_stamp_ == stamp_of(scene_.renderer())) return {};
  drawn_.reset();  // for after a fault below other tiles are shown than those of the pixels
  MapCamera close = wanted.camera;  // tiles as fine as the supersampled pixels
  close.metres_per_px /= wanted.supersampling;
  // Tiles are shown and hidden by this, which is a change for VTK, so only where others may be in sight.
  for (std::size_t i = 0; !is_where_it_was && i < layers_.size(); ++i) {
    auto updated =
        layers_[i]->update(close, wanted.width * wanted.supersampling,
                           wanted.height * wanted.supersampling, std::numeric_limits<int>::max());
    if (!updated) return forward_error(updated);
  }
  scene_.look({close, 1.0 * wanted.width * wanted.supersampling,
               1.0 * wanted.height * wanted.supersampling,
               wanted.px_per_pt * wanted.supersampling});
  scene_.set_background(wanted.background, wanted.is_transparent);
  const auto renderer = context.renderer();
  if (!renderer) return forward_error(renderer);
  auto pixels =
      (*renderer)->render(scene_.renderer(), wanted.width, wanted.height, wanted.supersampling);
  if (!pixels) return forward_error(pixels);
  pixels_ = std::move(*pixels);
  drawn_ = wanted;
  content_stamp_ = stamp_of(scene_.renderer());
  return {};
}

void MapPanel::keep_on_map(MapFrame& frame) const {
  // What lies beside the map is shown only where something to be shown does.
  if (!options_.crop.is_all() || shown_.isEmpty() || !bounds_.contains(shown_)) return;
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

Result<MapFrame> MapPanel::draw_ground(Canvas& canvas,
                                       FigureContext& context,
                                       const PageRect& where) {
  const PageFormat& format = context.format();
  const double px = format.px_per_pt();
  Graticule graticule = options_.graticule;
  PageRect inside = frame_inside(where, graticule, px);
  constexpr double kLeastWithNumbersPt = 48.0;
  if (std::min(inside.width, inside.height) < kLeastWithNumbersPt * px) {
    graticule = Graticule::kNone;
    inside = frame_inside(where, graticule, px);
  }
  MapFrame frame{inside, camera_for(inside), px};
  keep_on_map(frame);
  // A picture is smooth by itself; the edges of cells and marks are not.
  const bool has_edges = !shows_picture_ || scene_.holds_above(MapLayer::kPicture);
  auto rendered =
      render(context, {frame.camera, static_cast<int>(frame.where.width),
                       static_cast<int>(frame.where.height), has_edges ? context.supersampling : 1,
                       px, format.colours().page, format.is_transparent});
  if (!rendered) return forward_error(rendered);
  canvas.image(frame.where, pixels_);
  if (options_.shows_graticule_lines) {
    draw_graticule_lines(canvas, frame, graticule, plane_, format.colours());
  }
  draw_graticule(canvas, frame, graticule, plane_, format.colours());
  draw_frame(canvas, format, frame.where);
  return frame;
}

void MapPanel::draw_furniture(Canvas& canvas,
                              const PageFormat& format,
                              const MapFrame& frame,
                              std::span<const PageRect> taken) const {
  const double px = frame.px_per_pt;
  const PageRect& where = frame.where;
  const auto has_room = [&](double least_width, double least_height, const PageRect& needed) {
    return where.width >= least_width * px && where.height >= least_height * px &&
           std::none_of(taken.begin(), taken.end(),
                        [&needed](const PageRect& other) { return overlap(needed, other); });
  };
  const double bar_px = std::max(where.width / 4.0, 24.0 * px) + 14.0 * px;
  const double arrow_px = 28.0 * px;
  if (has_room(64.0, 40.0, {where.left, where.bottom, bar_px, 24.0 * px})) {
    draw_scale_bar(canvas, frame, format.colours());
  }
  if (has_room(96.0, 64.0,
               {where.right() - arrow_px, where.top() - arrow_px, arrow_px, arrow_px})) {
    draw_north_arrow(canvas, frame, format.colours());
  }
}

PathLook truth_look(const Theme& theme) {
  return {theme.truth_on_imagery, 1.4, false, theme.casing_on_imagery, 0.5};
}

PathLook odometry_look(const Theme& theme) {
  return {theme.odometry_on_imagery, 1.4, true, theme.casing_on_imagery, 0.5};
}

PathLook estimate_look(const Theme& theme, std::size_t run) {
  return {run_colour_on_imagery(theme, run), 1.7, is_run_dashed(run), theme.casing_on_imagery, 0.5};
}

}  // namespace nadir
