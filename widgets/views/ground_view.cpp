// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/ground_view.h"

#include <algorithm>
#include <cmath>

#include "widgets/views/raster_pictures.h"

namespace nadir {

GroundView::GroundView(SpaceScene& scene, OverheadTiles tiles, OverheadTiles::Layer layer)
    : scene_(scene), tiles_(std::move(tiles)), layer_(layer) {}

GroundView::Span GroundView::touched(const Eigen::AlignedBox2d& shown_in_enu_m, int level) const {
  const Eigen::Vector2d top_left = tiles_.top_left_in_enu_m();
  const double tile_m = tiles_.metres_per_cell() * std::ldexp(kTileSide, level);
  const Eigen::Vector2d low((shown_in_enu_m.min().x() - top_left.x()) / tile_m,
                            (top_left.y() - shown_in_enu_m.max().y()) / tile_m);
  const Eigen::Vector2d high((shown_in_enu_m.max().x() - top_left.x()) / tile_m,
                             (top_left.y() - shown_in_enu_m.min().y()) / tile_m);
  const auto within = [](double place, int count) {
    return static_cast<int>(std::clamp(place, 0.0, static_cast<double>(count)));
  };
  const int columns = tiles_.columns(level);
  const int rows = tiles_.rows(level);
  return {{within(std::floor(low.x()), columns), within(std::floor(low.y()), rows)},
          {within(std::ceil(high.x()), columns), within(std::ceil(high.y()), rows)}};
}

Eigen::AlignedBox2d GroundView::bounds_of(const TileAddress& tile) const {
  const Eigen::Vector4i cells = tiles_.cells_of(tile);
  const Eigen::Vector2d top_left = tiles_.top_left_in_enu_m();
  const double cell_m = tiles_.metres_per_cell();
  return {Eigen::Vector2d(top_left.x() + cell_m * cells[0],
                          top_left.y() - cell_m * (cells[1] + cells[3])),
          Eigen::Vector2d(top_left.x() + cell_m * (cells[0] + cells[2]),
                          top_left.y() - cell_m * cells[1])};
}

Result<std::unique_ptr<SpacePicture>> GroundView::load(const TileAddress& tile) {
  auto picture = std::make_unique<SpacePicture>(scene_, SpaceLayer::kGround);
  picture->set_opacity(opacity_);
  if (layer_ == OverheadTiles::Layer::kPicture) {
    const auto colours = tiles_.picture(tile);
    if (!colours) return forward_error(colours);
    picture->show(colour_picture(*colours), true);
  } else {
    const auto labels = tiles_.labels(tile);
    if (!labels) return forward_error(labels);
    picture->show(class_picture(*labels), false);
  }
  return picture;
}

Result<void> GroundView::show(const Eigen::AlignedBox2d& shown_in_enu_m, double metres_per_px) {
  constexpr int kMostTiles = 36;
  const double cells_per_px = metres_per_px / tiles_.metres_per_cell();
  int level = std::min(tiles_.level_count() - 1,
                       static_cast<int>(std::floor(std::log2(std::max(1.0, cells_per_px)))));
  while (level + 1 < tiles_.level_count() && touched(shown_in_enu_m, level).count() > kMostTiles) {
    ++level;
  }
  // All that can fail comes first, so that after a fault everything is as it was.
  std::map<TileAddress, Eigen::AlignedBox2d> cuts;
  std::map<TileAddress, std::unique_ptr<SpacePicture>> kept;
  const Span span = touched(shown_in_enu_m, level);
  for (int row = span.first.y(); row < span.end.y(); ++row) {
    for (int column = span.first.x(); column < span.end.x(); ++column) {
      const TileAddress tile{level, column, row};
      const Eigen::AlignedBox2d cut = bounds_of(tile).intersection(shown_in_enu_m);
      if (cut.isEmpty()) continue;
      cuts.emplace(tile, cut);
      if (shown_.count(tile) > 0) continue;
      auto loaded = load(tile);
      if (!loaded) return forward_error(loaded);
      kept.emplace(tile, std::move(*loaded));
    }
  }
  for (const auto& [tile, cut] : cuts) {
    std::unique_ptr<SpacePicture>& picture = kept[tile];
    if (picture == nullptr) picture = std::move(shown_.at(tile));
    const Eigen::AlignedBox2d bounds = bounds_of(tile);
    const Eigen::Vector2d size = bounds.sizes();
    const Eigen::AlignedBox2d part(Eigen::Vector2d((cut.min().x() - bounds.min().x()) / size.x(),
                                                   (bounds.max().y() - cut.max().y()) / size.y()),
                                   Eigen::Vector2d((cut.max().x() - bounds.min().x()) / size.x(),
                                                   (bounds.max().y() - cut.min().y()) / size.y()));
    picture->place({cut.min().x(), cut.max().y(), 0.0}, {cut.sizes().x(), 0.0, 0.0},
                   {0.0, -cut.sizes().y(), 0.0}, part);
  }
  shown_ = std::move(kept);  // the others go
  return {};
}

void GroundView::set_opacity(double opacity) {
  opacity_ = opacity;
  for (const auto& [tile, picture] : shown_) picture->set_opacity(opacity);
}

}  // namespace nadir
