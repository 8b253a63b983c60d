// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <list>
#include <map>
#include <memory>

#include "core/map/overhead_tiles.h"
#include "widgets/views/raster_view.h"

namespace nadir {

/// Shows one layer of an overhead, of any size, by the tiles that are in sight at the resolution that the page asks for.
/// Where such a tile is still missing the finest coarser one that is there stands in for it, cut to its place. Tiles are
/// kept while they are used, and the least used go when there are too many.
class OverheadView {
 public:
  OverheadView(MapScene& scene, OverheadTiles tiles, OverheadTiles::Layer layer);

  /// Brings in what the camera sees. @param most_new_tiles  Reads no more than that now, so that a frame of a window is
  /// never late: where that is too few, first the tile that shows the whole map, then those in the middle of the page.
  /// False says that there is more to come.
  /// @errors kMalformed: the map's file is damaged where it was read.
  [[nodiscard]] Result<bool> update(const MapCamera& camera,
                                    double width_px,
                                    double height_px,
                                    int most_new_tiles);
  void set_opacity(double opacity);
  void set_visible(bool visible);
  [[nodiscard]] const OverheadTiles& tiles() const { return tiles_; }
  /// Of the finest level that is worth drawing: its pixels are about as large as those of the page.
  [[nodiscard]] int level_for(double metres_per_px) const;

 private:
  struct Shown {
    std::unique_ptr<RasterView> view;
    std::uint64_t last_used = 0;
  };
  /// In the place of a tile that is missing.
  struct StandIn {
    TileAddress cut_from;
    std::unique_ptr<RasterView> view;
  };
  [[nodiscard]] MapLayer map_layer() const;
  /// Those in the middle of the page first.
  [[nodiscard]] std::vector<TileAddress> in_sight(const MapCamera& camera,
                                                  double width_px,
                                                  double height_px,
                                                  int level) const;
  [[nodiscard]] Result<void> load(const TileAddress& tile);
  void show_stand_in(const TileAddress& missing);
  void forget_least_used();

  MapScene& scene_;
  OverheadTiles tiles_;
  OverheadTiles::Layer layer_;
  std::map<TileAddress, Shown> shown_;
  std::map<TileAddress, StandIn> stand_ins_;  ///< By the missing tile, of the last update().
  std::uint64_t clock_ = 0;
  double opacity_ = 1.0;
  bool is_visible_ = true;
};

}  // namespace nadir
