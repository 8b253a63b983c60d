// SPDX-License-Identifier: Apache-2.0
// What of a map's panel is drawn: the ground in parts, coordinates, scale bar and north arrow.
#include <vtkProp.h>
#include <vtkPropCollection.h>

#include <algorithm>
#include <limits>

#include "widgets/figures/map_panel.h"
#include "widgets/figures/page_layout.h"
#include "widgets/views/map_colours.h"
#include "widgets/views/map_furniture.h"

namespace nadir {
namespace {

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

Result<void> MapPanel::render(FigureContext& context, const GroundState& wanted) {
  const bool is_where_it_was = drawn_ == wanted;
  if (is_where_it_was && content_stamp_ == stamp_of(scene_.renderer())) return {};
  drawn_.reset();  // for after a fault below other tiles are shown than those of the pixels
  MapCamera close = wanted.camera;  // tiles as fine as the supersampled pixels
  close.metres_per_px /= wanted.supersampling;
  // Tiles are shown and hidden by this, which is a change for VTK, so only where others may be in sight.
  for (OverheadView* const view : {picture_.get(), labels_.get()}) {
    if (is_where_it_was || view == nullptr) continue;
    const auto updated =
        view->update(close, wanted.width * wanted.supersampling,
                     wanted.height * wanted.supersampling, std::numeric_limits<int>::max());
    if (!updated) return forward_error(updated);
  }
  scene_.look({close, 1.0 * wanted.width * wanted.supersampling,
               1.0 * wanted.height * wanted.supersampling,
               wanted.px_per_pt * wanted.supersampling});
  scene_.set_background(wanted.background, wanted.is_transparent);
  const auto renderer = context.renderer();
  if (!renderer) return forward_error(renderer);
  if (!wanted.layers.empty()) scene_.show_only(wanted.layers);
  auto pixels =
      (*renderer)->render(scene_.renderer(), wanted.width, wanted.height, wanted.supersampling);
  scene_.show_all();
  if (!pixels) return forward_error(pixels);
  pixels_ = std::move(*pixels);
  drawn_ = wanted;
  content_stamp_ = stamp_of(scene_.renderer());
  return {};
}

Result<void> MapPanel::draw_part(Canvas& canvas,
                                 FigureContext& context,
                                 const MapFrame& frame,
                                 std::span<const MapLayer> layers,
                                 bool is_lowest) {
  const PageFormat& format = context.format();
  // A picture is smooth by itself; the edges of cells and marks are not.
  const bool has_edges = !shows_picture_ || scene_.holds_above(MapLayer::kPicture);
  auto rendered = render(context, {frame.camera,
                                   static_cast<int>(frame.where.width),
                                   static_cast<int>(frame.where.height),
                                   has_edges ? context.supersampling : 1,
                                   frame.px_per_pt,
                                   format.colours().page,
                                   format.is_transparent || !is_lowest,
                                   {layers.begin(), layers.end()}});
  if (!rendered) return forward_error(rendered);
  canvas.image(frame.where, pixels_);
  return {};
}

void MapPanel::draw_lines(Canvas& canvas,
                          const PageFormat& format,
                          const Place& place,
                          const MapGridLook& look) const {
  if (is_turned()) {
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
