// SPDX-License-Identifier: Apache-2.0
#include "widgets/figures/map_panel.h"

#include <cmath>
#include <limits>

#include "core/map/overhead_map_file.h"
#include "widgets/figures/page_layout.h"

namespace nadir {
namespace {

Eigen::AlignedBox2d bounds_of(const OverheadTiles& tiles) {
  const Eigen::Vector2d size_m =
      tiles.metres_per_cell() * Eigen::Vector2d(tiles.width(), tiles.height());
  const Eigen::Vector2d top_left = tiles.top_left_in_enu_m();
  return {Eigen::Vector2d(top_left.x(), top_left.y() - size_m.y()),
          Eigen::Vector2d(top_left.x() + size_m.x(), top_left.y())};
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
  panel->shows_picture_ = ground == Ground::kPicture && options.shows_picture && has_picture;
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

void MapPanel::show_square(const Eigen::Vector2d& centre_in_enu_m, double side_m) {
  const Eigen::Vector2d half = Eigen::Vector2d::Constant(side_m / 2.0);
  shown_ = Eigen::AlignedBox2d(centre_in_enu_m - half, centre_in_enu_m + half);
}

double MapPanel::aspect() const {
  if (shown_.isEmpty() || options_.crop_width_m > 0.0) return 1.0;
  const Eigen::Vector2d size = shown_.sizes().cwiseMax(1.0);
  return size.x() / size.y();
}

bool MapPanel::shows_whole_map() const {
  return options_.crop_width_m == 0.0 && (shown_.isEmpty() || shown_.isApprox(bounds_));
}

MapCamera MapPanel::camera_for(const PageRect& where) const {
  if (options_.crop_width_m > 0.0) {
    MapCamera camera;
    camera.centre_in_enu_m = {options_.crop_east_m, options_.crop_north_m};
    camera.metres_per_px = options_.crop_width_m / where.width;
    return camera;
  }
  const Eigen::AlignedBox2d& shown = shown_.isEmpty() ? bounds_ : shown_;
  // Paths keep away from the border; the map as a whole fills the panel.
  const double margin = shows_whole_map() ? 0.0 : 0.08;
  return MapCamera::fit(shown.min(), shown.max(), where, margin);
}

Result<MapFrame> MapPanel::draw_ground(Canvas& canvas,
                                       FigureContext& context,
                                       const PageRect& where) {
  const PageFormat& format = context.format();
  const Eigen::Vector2d border = graticule_margin_px(options_.graticule, format.px_per_pt());
  // Whole pixels, so that the picture is not blurred.
  const double left = std::ceil(where.left + border.x());
  const double bottom = std::ceil(where.bottom + border.y());
  PageRect inside{left, bottom, std::max(1.0, std::floor(where.right() - left)),
                  std::max(1.0, std::floor(where.top() - bottom))};
  if (shows_whole_map()) {  // a frame of the map's own shape, at the top of the panel
    const double aspect = bounds_.sizes().x() / bounds_.sizes().y();
    const double top = inside.top();
    inside.width = std::max(1.0, std::floor(std::min(inside.width, inside.height * aspect)));
    inside.height = std::max(1.0, std::round(inside.width / aspect));
    inside.bottom = top - inside.height;
  }
  MapFrame frame{inside, camera_for(inside), format.px_per_pt()};
  const int width = static_cast<int>(inside.width);
  const int height = static_cast<int>(inside.height);
  MapCamera close = frame.camera;  // tiles as fine as the supersampled pixels
  close.metres_per_px /= context.supersampling;
  for (const auto& layer : layers_) {
    auto updated =
        layer->update(close, inside.width * context.supersampling,
                      inside.height * context.supersampling, std::numeric_limits<int>::max());
    if (!updated) return forward_error(updated);
  }
  scene_.look(frame.camera, inside.height);
  scene_.set_background(format.colours().page, format.is_transparent);
  const auto renderer = context.renderer();
  if (!renderer) return forward_error(renderer);
  const auto pixels = (*renderer)->render(scene_.renderer(), width, height, context.supersampling);
  if (!pixels) return forward_error(pixels);
  canvas.image(inside, *pixels);
  draw_graticule(canvas, frame, options_.graticule, plane_, format.colours());
  draw_frame(canvas, format, inside);
  return frame;
}

void MapPanel::draw_furniture(Canvas& canvas,
                              const PageFormat& format,
                              const MapFrame& frame) const {
  draw_scale_bar(canvas, frame, format.colours());
  draw_north_arrow(canvas, frame, format.colours());
}

PathLook truth_look(const Theme& theme) {
  return {theme.truth_on_imagery, 1.4, false, theme.casing_on_imagery, 0.5};
}

PathLook odometry_look(const Theme& theme) {
  return {theme.odometry_on_imagery, 1.4, true, theme.casing_on_imagery, 0.5};
}

PathLook estimate_look(const Theme& theme, std::size_t run) {
  const std::array<Rgba, 3> colours = {theme.estimate_on_imagery, theme.second_run,
                                       theme.third_run};
  return {colours.at(run % colours.size()), 1.7, run >= colours.size(), theme.casing_on_imagery,
          0.5};
}

}  // namespace nadir
