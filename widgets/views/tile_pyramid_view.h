// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "widgets/views/raster_view.h"
#include "widgets/views/tile_budget.h"
#include "widgets/views/tile_maker.h"
#include "widgets/views/tile_pictures.h"

namespace nadir {

/// Where tiles are made that are missing.
enum class TileMaking {
  kInFrame,   ///< By update(), for pictures that are to be whole, and where a tile is quickly read.
  kInThread,  ///< By a thread of the view's own: a frame waits for none.
};

/// Shows tile pictures of any size by the tiles that are in sight, at the resolution that the page asks for. Where such a tile
/// is still missing the finest coarser one that is there stands in for it, cut to its place. Tiles are kept while they are
/// shown, and as long as the budget has room for them. A tile that cannot be read is not tried again before it is forgotten:
/// a coarser one stays in its place.
///
/// Pictures that change, such as of a document at work, are given anew by show(), and forget() says what of them is different.
/// What was seen stays until what replaces it is made, so that nothing flickers. What is in sight of quick pictures is made in
/// the next update(), and only the pixels that are different are; others come as tiles that are missing do.
class TilePyramidView : private TileBudget::Holder {
 public:
  /// Of quick pictures, pixels that are different and in sight are made within one update() up to so many, a tile at least.
  static constexpr std::int64_t kMostPixelsRedone = 4'500'000;

  /// @param layer  Of the scene. @param pictures  Not null. @param budget  Shared with other views; null: one of its own.
  TilePyramidView(MapScene& scene,
                  MapLayer layer,
                  std::shared_ptr<const TilePictures> pictures,
                  std::shared_ptr<TileBudget> budget = nullptr,
                  TileMaking making = TileMaking::kInFrame);
  ~TilePyramidView() override;
  TilePyramidView(const TilePyramidView&) = delete;
  TilePyramidView& operator=(const TilePyramidView&) = delete;

  /// From now on tiles are made of these. Those that are there stay, but where the size or the resolution is another; where
  /// only the place is, they move.
  void show(std::shared_ptr<const TilePictures> pictures);
  /// What lies in a part of the plane is different now, also half a pixel of any level around it.
  void forget(const PlaneBounds& bounds_in_enu_m);
  void forget_all();

  /// Brings in what the camera sees. @param most_new_tiles  Makes or takes over no more than that now, so that a frame of a
  /// window is never late: where that is too few, first the tile that shows all, then those in the middle of the page.
  /// False says that there is more to come.
  /// @errors kMalformed: a file is damaged where it was read; said once, all else is shown all the same.
  [[nodiscard]] Result<bool> update(const MapCamera& camera,
                                    double width_px,
                                    double height_px,
                                    int most_new_tiles);
  /// Waits for the tiles that the thread makes for what update() saw last; the next update() shows them.
  void wait();
  void set_opacity(double opacity);
  /// Hides it at once; what is visible again shows with the next update().
  void set_visible(bool visible);
  [[nodiscard]] const TilePictures& pictures() const { return *pictures_; }
  /// Of the finest level that is worth drawing: its pixels are about as large as those of the page.
  [[nodiscard]] int level_for(double metres_per_px) const;

 private:
  struct Shown {
    std::unique_ptr<RasterView> view;
    std::uint64_t last_used = 0;
    std::size_t bytes = 0;
    CellRect size;              ///< All of its pixels.
    CellRect stale;             ///< Pixels that show what is not any more.
    std::int64_t revision = 0;  ///< That the oldest of its pixels are of, unless they are stale.
  };
  /// In the place of a tile that is missing.
  struct StandIn {
    TileAddress cut_from;
    std::unique_ptr<RasterView> view;
  };
  struct Forgotten {
    std::int64_t revision = 0;
    PlaneBounds bounds;
  };
  /// Those in the middle of the page first.
  [[nodiscard]] std::vector<TileAddress> in_sight(const MapCamera& camera,
                                                  double width_px,
                                                  double height_px,
                                                  int level) const;
  [[nodiscard]] bool show_if_there(const TileAddress& tile);
  void put(const TileAddress& tile, const Raster<Rgba>& pixels, std::int64_t revision);
  void place(const TileAddress& tile, const Shown& shown) const;
  void take_made(int most_new_tiles);
  void make_now(const std::vector<TileAddress>& wanted);
  void redo_stale(const std::vector<TileAddress>& seen, int most_tiles);
  void ask_for(const std::vector<TileAddress>& wanted, const std::vector<TileAddress>& seen);
  void note_damage(const TileAddress& tile, const Error& fault);
  [[nodiscard]] CellRect pixels_in(const TileAddress& tile,
                                   const CellRect& size,
                                   const PlaneBounds& bounds) const;
  /// The tile itself, or where it is damaged the finest above it that is not; nothing where all are.
  [[nodiscard]] std::optional<TileAddress> readable(TileAddress tile) const;
  [[nodiscard]] bool is_to_come(const TileAddress& missing) const;
  void show_stand_in(const TileAddress& missing);
  void drop_all();
  [[nodiscard]] std::map<TileAddress, Shown>::const_iterator least_used() const;
  [[nodiscard]] std::uint64_t longest_unused() const override;
  void forget_longest_unused() override;

  MapScene& scene_;
  MapLayer layer_;
  std::shared_ptr<const TilePictures> pictures_;
  std::shared_ptr<TileBudget> budget_;
  std::map<TileAddress, Shown> shown_;
  std::map<TileAddress, StandIn> stand_ins_;  ///< By the missing tile, of the last update().
  std::set<TileAddress> damaged_;
  std::optional<Error> first_fault_;  ///< Of this update().
  std::vector<Forgotten> forgotten_;  ///< The last ones, for tiles that were begun before them.
  std::int64_t revision_ = 0;         ///< Rises with all that is forgotten.
  std::int64_t forgotten_from_ = 0;   ///< What was begun before that is wholly stale.
  std::int64_t fits_from_ = 0;        ///< What was begun before that is of another grid.
  std::uint64_t clock_ = 0;           ///< The budget's moment of the last update().
  double opacity_ = 1.0;
  bool is_visible_ = true;
  std::unique_ptr<TileMaker> maker_;  ///< Null: tiles are made in the frame.
};

}  // namespace nadir
