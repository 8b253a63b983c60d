// SPDX-License-Identifier: Apache-2.0
// What of a map's panel is drawn: the ground in parts, coordinates, scale bar and north arrow.
#include <algorithm>
#include <iterator>
#include <limits>
#include <vector>

#include "widgets/figures/map_panel.h"
#include "widgets/figures/page_layout.h"
#include "widgets/views/map_colours.h"
#include "widgets/views/map_furniture.h"

namespace nadir {
namespace {

/// What is kept of parts for the next drawing is no more than this, so that parts of large pages do not fill the memory.
constexpr std::size_t kMostKeptPixels = 64'000'000;

}  // namespace

Result<void> MapPanel::choose_tiles(const MapSight& close) {
  // Tiles are shown and hidden by this, which is a change for VTK, so only where others may be in sight.
  if (tiles_for_ == close) return {};
  tiles_for_.reset();  // after a fault below nobody knows which tiles are shown
  for (OverheadView* const view : {picture_.get(), labels_.get()}) {
    if (view == nullptr) continue;
    const auto updated =
        view->update(close.camera, static_cast<int>(close.width_px),
                     static_cast<int>(close.height_px), std::numeric_limits<int>::max());
    if (!updated) return forward_error(updated);
  }
  tiles_for_ = close;
  return {};
}

Result<const Raster<Rgba>*> MapPanel::render(FigureContext& context, const GroundState& wanted) {
  const auto is_current = [&](const RenderedGround& one) {
    return one.content == scene_.stamps(one.state.layers);
  };
  for (const RenderedGround& one : rendered_) {
    if (one.state == wanted && is_current(one)) return &one.pixels;
  }
  const auto kept_end =
      std::stable_partition(rendered_.begin(), rendered_.end(), [&](const RenderedGround& one) {
        return one.state.layers != wanted.layers && is_current(one);
      });
  // Freed when the new ones are there, so that other pixels lie at another address.
  const std::vector<RenderedGround> replaced(std::make_move_iterator(kept_end),
                                             std::make_move_iterator(rendered_.end()));
  rendered_.erase(kept_end, rendered_.end());
  std::size_t kept =
      static_cast<std::size_t>(wanted.width) * static_cast<std::size_t>(wanted.height);
  for (const RenderedGround& one : rendered_) kept += one.pixels.size();
  while (!rendered_.empty() && kept > kMostKeptPixels) {
    kept -= rendered_.front().pixels.size();
    rendered_.erase(rendered_.begin());
  }
  MapSight close{wanted.camera, 1.0 * wanted.width * wanted.supersampling,
                 1.0 * wanted.height * wanted.supersampling,
                 wanted.px_per_pt * wanted.supersampling};
  close.camera.metres_per_px /= wanted.supersampling;  // tiles as fine as the supersampled pixels
  if (auto chosen = choose_tiles(close); !chosen) return forward_error(chosen);
  scene_.look(close);
  scene_.set_background(wanted.background, wanted.is_transparent);
  const auto renderer = context.renderer();
  if (!renderer) return forward_error(renderer);
  if (!wanted.layers.empty()) scene_.show_only(wanted.layers);
  auto pixels =
      (*renderer)->render(scene_.renderer(), wanted.width, wanted.height, wanted.supersampling);
  scene_.show_all();
  if (!pixels) return forward_error(pixels);
  RenderedGround made;
  made.state = wanted;
  made.pixels = std::move(*pixels);
  rendered_.push_back(std::move(made));
  // What was hidden for this part counts as changed, and is as it was.
  for (RenderedGround& one : rendered_) one.content = scene_.stamps(one.state.layers);
  return &rendered_.back().pixels;
}

Result<void> MapPanel::draw_part(Canvas& canvas,
                                 FigureContext& context,
                                 const MapFrame& frame,
                                 std::span<const MapLayer> layers,
                                 bool is_lowest) {
  const PageFormat& format = context.format();
  // A picture is smooth by itself; the edges of cells and marks are not.
  const bool has_edges = !shows_picture_ || scene_.holds_above(MapLayer::kPicture);
  const auto pixels = render(context, {frame.camera,
                                       static_cast<int>(frame.where.width),
                                       static_cast<int>(frame.where.height),
                                       has_edges ? context.supersampling : 1,
                                       frame.px_per_pt,
                                       format.colours().page,
                                       format.is_transparent || !is_lowest,
                                       {layers.begin(), layers.end()}});
  if (!pixels) return forward_error(pixels);
  canvas.image(frame.where, **pixels);
  return {};
}

void MapPanel::draw_lines(Canvas& canvas,
                          const PageFormat& format,
                          const Place& place,
                          const MapGridLook& look) const {
  if (place.frame.camera.is_turned()) {
    draw_grid_lines(canvas, place.frame, look);
  } else {
    draw_graticule_lines(canvas, place.frame, place.graticule, plane_, format.colours());
  }
}

void MapPanel::draw_border(Canvas& canvas, const PageFormat& format, const Place& place) const {
  draw_graticule(canvas, place.frame, place.graticule, plane_, format.colours());
  draw_frame(canvas, format, place.frame.where);
}

Result<MapFrame> MapPanel::draw_ground(Canvas& canvas,
                                       FigureContext& context,
                                       const PageRect& where) {
  const PageFormat& format = context.format();
  const Place place = place_in(where, format.px_per_pt());
  if (auto drawn = draw_part(canvas, context, place.frame, {}, true); !drawn) {
    return forward_error(drawn);
  }
  if (options_.shows_graticule_lines) {
    const Theme& theme = format.colours();
    draw_lines(canvas, format, place, grid_look_on_imagery(theme, light_on_imagery(theme), 1.0));
  }
  draw_border(canvas, format, place);
  return place.frame;
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

}  // namespace nadir
