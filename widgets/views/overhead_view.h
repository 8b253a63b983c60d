// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>

#include "core/map/overhead_tiles.h"
#include "widgets/views/raster_view.h"
#include "widgets/views/tile_budget.h"

namespace nadir {

/// Shows one layer of an overhead, of any size, by the tiles that are in sight at the resolution that the page asks for.
/// Where such a tile is still missing the finest coarser one that is there stands in for it, cut to its place. Tiles are
/// kept while they are shown, and as long as the budget has room for them. A tile that cannot be read is never tried again:
/// a coarser one stays in its place.
class OverheadView : private TileBudget::Holder {
 public:
  /// @param budget  Shared with other views; null: one of its own.
  OverheadView(MapScene& scene,
               OverheadTiles tiles,
               OverheadTiles::Layer layer,
               std::shared_ptr<TileBudget> budget = nullptr);
  ~OverheadView() override;
  OverheadView(const OverheadView&) = delete;
  OverheadView& operator=(const OverheadView&) = delete;

  /// Brings in what the camera sees. @param most_new_tiles  Reads no more than that now, so that a frame of a window is
  /// never late: where that is too few, first the tile that shows the whole map, then those in the middle of the page.
  /// False says that there is more to come.
  /// @errors kMalformed: the map's file is damaged where it was read; said once, all else is shown all the same.
  [[nodiscard]] Result<bool> update(const MapCamera& camera,
                                    double width_px,
                                    double height_px,
                                    int most_new_tiles);
  void set_opacity(double opacity);
  /// Hides it at once; what is visible again shows with the next update().
  void set_visible(bool visible);
  [[nodiscard]] const OverheadTiles& tiles() const { return tiles_; }
  /// Of the finest level that is worth drawing: its pixels are about as large as those of the page.
  [[nodiscard]] int level_for(double metres_per_px) const;

 private:
  struct Shown {
    std::unique_ptr<RasterView> view;
    std::uint64_t last_used = 0;
    std::size_t bytes = 0;
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
  /// The tile itself, or where it is damaged the finest above it that is not; nothing where all are.
  [[nodiscard]] std::optional<TileAddress> readable(TileAddress tile) const;
  [[nodiscard]] bool is_to_come(const TileAddress& missing) const;
  void show_stand_in(const TileAddress& missing);
  [[nodiscard]] std::map<TileAddress, Shown>::const_iterator least_used() const;
  [[nodiscard]] std::uint64_t longest_unused() const override;
  void forget_longest_unused() override;

  MapScene& scene_;
  OverheadTiles tiles_;
  OverheadTiles::Layer layer_;
  std::shared_ptr<TileBudget> budget_;
  std::map<TileAddress, Shown> shown_;
  std::map<TileAddress, StandIn> stand_ins_;  ///< By the missing tile, of the last update().
  std::set<TileAddress> damaged_;
  std::uint64_t clock_ = 0;  ///< The budget's moment of the last update().
  double opacity_ = 1.0;
  bool is_visible_ = true;
};

}  // namespace nadir
