// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Geometry>
#include <map>
#include <memory>

#include "core/map/overhead_tiles.h"
#include "widgets/views/space_picture.h"

namespace nadir {

/// Lays a rectangle of an overhead on the ground of a scene, at the resolution that the page asks for. Tiles are kept while
/// they are shown.
class GroundView {
 public:
  GroundView(SpaceScene& scene, OverheadTiles tiles, OverheadTiles::Layer layer);

  /// Shows the map inside of the rectangle and nothing outside. @param metres_per_px  About what the page resolves there;
  /// coarser where the rectangle has too many tiles of that.
  /// @errors kMalformed: the map's file is damaged where it was read; what was shown stays as it was.
  [[nodiscard]] Result<void> show(const Eigen::AlignedBox2d& shown_in_enu_m, double metres_per_px);
  void set_opacity(double opacity);
  [[nodiscard]] const OverheadTiles& tiles() const { return tiles_; }
  /// What is kept, at most, in main memory and as textures.
  [[nodiscard]] std::size_t tile_bytes() const {
    return shown_.size() * 2 * sizeof(Rgba) * kTileSide * kTileSide;
  }

 private:
  /// Of the tiles of a level that touch the rectangle, the first and the one after the last, as column and row.
  struct Span {
    Eigen::Vector2i first, end;
    [[nodiscard]] int count() const { return (end - first).cwiseMax(0).prod(); }
  };
  [[nodiscard]] Span touched(const Eigen::AlignedBox2d& shown_in_enu_m, int level) const;
  [[nodiscard]] Eigen::AlignedBox2d bounds_of(const TileAddress& tile) const;
  [[nodiscard]] Result<std::unique_ptr<SpacePicture>> load(const TileAddress& tile);

  SpaceScene& scene_;
  OverheadTiles tiles_;
  OverheadTiles::Layer layer_;
  double opacity_ = 1.0;
  std::map<TileAddress, std::unique_ptr<SpacePicture>> shown_;
};

}  // namespace nadir
