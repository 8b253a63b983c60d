// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/overhead_view.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "widgets/views/theme.h"

namespace nadir {
namespace {

/// Tiles kept in memory: 192 of 512 x 512 RGBA pixels are 200 MB.
constexpr std::size_t kMostTiles = 192;

Raster<Rgba> opaque(const ColourRaster& colours) {
  Raster<Rgba> pixels(colours.width(), colours.height());
  std::transform(colours.values().begin(), colours.values().end(), pixels.values().begin(),
                 [](const Colour& colour) {
                   return Rgba{colour.red, colour.green, colour.blue};
                 });
  return pixels;
}

Raster<Rgba> in_class_colours(const Raster<ClassId>& labels) {
  std::array<Rgba, 256> colours{};
  for (int id = 0; id < 256; ++id) {
    colours.at(static_cast<std::size_t>(id)) = class_colour(static_cast<ClassId>(id));
  }
  Raster<Rgba> pixels(labels.width(), labels.height());
  std::transform(labels.values().begin(), labels.values().end(), pixels.values().begin(),
                 [&colours](ClassId id) { return colours[id]; });
  return pixels;
}

}  // namespace

OverheadView::OverheadView(MapScene& scene, OverheadTiles tiles, OverheadTiles::Layer layer)
    : scene_(scene), tiles_(std::move(tiles)), layer_(layer) {}

int OverheadView::level_for(double metres_per_px) const {
  const double cells_per_px = metres_per_px / tiles_.metres_per_cell();
  const int level = static_cast<int>(std::floor(std::log2(std::max(1.0, cells_per_px)) + 1e-9));
  return std::min(level, tiles_.level_count() - 1);
}

std::vector<TileAddress> OverheadView::in_sight(const MapCamera& camera,
                                                double width_px,
                                                double height_px,
                                                int level) const {
  // The map's cells under the corners of the page; with a turned camera, the box around them.
  const PageRect page{0.0, 0.0, width_px, height_px};
  Eigen::AlignedBox2d cells;
  for (const double x : {0.0, width_px}) {
    for (const double y : {0.0, height_px}) {
      const Eigen::Vector2d offset_m =
          camera.enu_from_page({x, y}, page) - tiles_.top_left_in_enu_m();
      cells.extend(Eigen::Vector2d(offset_m.x(), -offset_m.y()) / tiles_.metres_per_cell());
    }
  }
  const double side = std::ldexp(kTileSide, level);
  const auto index = [side](double cell, int count) {
    return static_cast<int>(std::clamp(std::floor(cell / side), -1.0, static_cast<double>(count)));
  };
  std::vector<TileAddress> found;
  const int columns = tiles_.columns(level);
  const int rows = tiles_.rows(level);
  const int last_row = std::min(rows - 1, index(cells.max().y(), rows));
  const int last_column = std::min(columns - 1, index(cells.max().x(), columns));
  for (int row = std::max(0, index(cells.min().y(), rows)); row <= last_row; ++row) {
    for (int column = std::max(0, index(cells.min().x(), columns)); column <= last_column;
         ++column) {
      found.push_back({level, column, row});
    }
  }
  return found;
}

Result<void> OverheadView::load(const TileAddress& tile) {
  Raster<Rgba> pixels;
  if (layer_ == OverheadTiles::Layer::kPicture) {
    const auto picture = tiles_.picture(tile);
    if (!picture) return forward_error(picture);
    pixels = opaque(*picture);
  } else {
    const auto labels = tiles_.labels(tile);
    if (!labels) return forward_error(labels);
    pixels = in_class_colours(*labels);
  }
  const Eigen::Vector4i cells = tiles_.cells_of(tile);
  const Eigen::Vector2d corner_m =
      tiles_.top_left_in_enu_m() + tiles_.metres_per_cell() * Eigen::Vector2d(cells[0], -cells[1]);
  const Eigen::Vector2d metres_per_pixel(tiles_.metres_per_cell() * cells[2] / pixels.width(),
                                         tiles_.metres_per_cell() * cells[3] / pixels.height());
  Shown& shown = shown_[tile];
  shown.view = std::make_unique<RasterView>(
      scene_, layer_ == OverheadTiles::Layer::kPicture ? MapLayer::kPicture : MapLayer::kLabels);
  shown.view->show(pixels, {corner_m.x(), corner_m.y(), 0.0}, metres_per_pixel,
                   layer_ == OverheadTiles::Layer::kPicture);
  shown.view->set_opacity(opacity_);
  return {};
}

Result<bool> OverheadView::update(const MapCamera& camera,
                                  double width_px,
                                  double height_px,
                                  int most_new_tiles) {
  ++clock_;
  for (auto& [tile, shown] : shown_) shown.view->set_visible(false);
  if (!is_visible_) return true;
  const std::vector<TileAddress> wanted =
      in_sight(camera, width_px, height_px, level_for(camera.metres_per_px));
  bool is_complete = true;
  for (const TileAddress& tile : wanted) {
    if (shown_.count(tile) == 0) {
      if (most_new_tiles-- <= 0) {
        is_complete = false;
        continue;
      }
      if (auto loaded = load(tile); !loaded) return forward_error(loaded);
    }
    Shown& shown = shown_.at(tile);
    shown.last_used = clock_;
    shown.view->set_visible(true);
  }
  forget_least_used();
  return is_complete;
}

void OverheadView::forget_least_used() {
  while (shown_.size() > kMostTiles) {
    const auto oldest = std::min_element(
        shown_.begin(), shown_.end(),
        [](const auto& a, const auto& b) { return a.second.last_used < b.second.last_used; });
    if (oldest->second.last_used == clock_) return;
    shown_.erase(oldest);
  }
}

void OverheadView::set_opacity(double opacity) {
  opacity_ = opacity;
  for (auto& [tile, shown] : shown_) shown.view->set_opacity(opacity);
}

void OverheadView::set_visible(bool visible) { is_visible_ = visible; }

}  // namespace nadir
