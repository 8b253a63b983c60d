// SPDX-License-Identifier: Apache-2.0
// What becomes of tiles whose pictures are different, and of those that a thread makes.
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/require.h"
#include "widgets/views/tile_pyramid_view.h"

namespace nadir {
namespace {

/// A tile that was begun before more changes than these is made anew.
constexpr std::size_t kMostForgotten = 64;

bool lies_alike(const LabelGrid& a, const LabelGrid& b) {
  return a.width == b.width && a.height == b.height && a.metres_per_cell == b.metres_per_cell;
}

}  // namespace

void TilePyramidView::show(std::shared_ptr<const TilePictures> pictures) {
  NADIR_REQUIRE(pictures != nullptr);
  const bool is_alike = lies_alike(pictures->grid(), pictures_->grid()) &&
                        pictures->is_smooth() == pictures_->is_smooth();
  const bool is_moved = pictures->grid().top_left_in_enu_m != pictures_->grid().top_left_in_enu_m;
  pictures_ = std::move(pictures);
  if (!is_alike) {
    drop_all();
    forget_all();
    fits_from_ = revision_;
    return;
  }
  if (!is_moved) return;
  for (const auto& [tile, shown] : shown_) place(tile, shown);
  stand_ins_.clear();
  forgotten_.clear();  // in places that are elsewhere now
  forgotten_from_ = revision_;
}

CellRect TilePyramidView::pixels_in(const TileAddress& tile,
                                    const CellRect& size,
                                    const PlaneBounds& bounds) const {
  if (bounds.is_empty) return {};
  const LabelGrid& grid = pictures_->grid();
  const CellRect cells = pictures_->cells_of(tile);
  const Eigen::Vector2d pixel_in_cells(
      static_cast<double>(cells.width()) / static_cast<double>(size.width()),
      static_cast<double>(cells.height()) / static_cast<double>(size.height()));
  const Eigen::Vector2d corner(static_cast<double>(cells.left), static_cast<double>(cells.top));
  const auto in_pixels = [&](double east_m, double north_m) {
    const Eigen::Vector2d offset = grid.cells_from_enu({east_m, north_m}) - corner;
    // Far outside is outside: numbers stay small.
    return Eigen::Vector2d(offset.cwiseQuotient(pixel_in_cells).cwiseMax(-4.0).cwiseMin(1e4));
  };
  const Eigen::Vector2d first = in_pixels(bounds.low.x(), bounds.high.y());
  const Eigen::Vector2d last = in_pixels(bounds.high.x(), bounds.low.y());
  const auto floor_of = [](double x) { return static_cast<std::int64_t>(std::floor(x)); };
  // A pixel more, for what is thin takes the pixels that it touches.
  return CellRect{floor_of(first.x()) - 1, floor_of(first.y()) - 1, floor_of(last.x()) + 2,
                  floor_of(last.y()) + 2}
      .cut_to(size);
}

void TilePyramidView::forget(const PlaneBounds& bounds_in_enu_m) {
  if (bounds_in_enu_m.is_empty) return;
  ++revision_;
  forgotten_.push_back({revision_, bounds_in_enu_m});
  if (forgotten_.size() > kMostForgotten) {
    forgotten_from_ = forgotten_.front().revision;
    forgotten_.erase(forgotten_.begin());
  }
  for (auto& [tile, shown] : shown_) {
    shown.stale = shown.stale.joined(pixels_in(tile, shown.size, bounds_in_enu_m));
  }
  damaged_.clear();  // what is different may be sound
}

void TilePyramidView::forget_all() {
  forgotten_from_ = ++revision_;
  forgotten_.clear();
  for (auto& [tile, shown] : shown_) shown.stale = shown.size;
  damaged_.clear();
}

void TilePyramidView::take_made(int most_new_tiles) {
  for (TileMaker::Made& made :
       maker_->take(static_cast<std::size_t>(std::max(0, most_new_tiles)))) {
    const TileAddress& tile = made.tile;
    if (made.revision < fits_from_) continue;
    if (!made.pixels) {
      if (made.revision != revision_) continue;
      note_damage(tile, made.pixels.error());
      if (const auto old = shown_.find(tile); old != shown_.end()) old->second.stale = {};
      continue;
    }
    // What was redone in a frame meanwhile is as new, and so may be what was made later.
    const auto found = shown_.find(tile);
    if (found != shown_.end() &&
        (found->second.stale.empty() || found->second.revision > made.revision)) {
      continue;
    }
    put(tile, *made.pixels, made.revision);
    Shown& shown = shown_.at(tile);
    if (made.revision < forgotten_from_) shown.stale = shown.size;  // newer than what was there
    for (const Forgotten& change : forgotten_) {
      if (change.revision <= made.revision) continue;
      shown.stale = shown.stale.joined(pixels_in(tile, shown.size, change.bounds));
    }
  }
}

void TilePyramidView::redo_stale(const std::vector<TileAddress>& seen, int most_tiles) {
  const bool is_quick = pictures_->is_quick();
  if (!is_quick && maker_ != nullptr) return;  // the thread makes them
  std::int64_t redone = 0;
  for (const TileAddress& tile : seen) {
    const auto found = shown_.find(tile);
    if (found == shown_.end() || found->second.stale.empty()) continue;
    Shown& shown = found->second;
    const std::int64_t count = shown.stale.width() * shown.stale.height();
    if (is_quick ? redone > 0 && redone + count > kMostPixelsRedone : most_tiles <= 0) continue;
    redone += count;
    --most_tiles;
    const CellRect part = std::exchange(shown.stale, CellRect{});
    if (const auto pixels = pictures_->part(tile, part)) {
      shown.view->change(*pixels, static_cast<int>(part.left), static_cast<int>(part.top));
      shown.revision = revision_;
    } else {
      note_damage(tile, pixels.error());  // what was seen stays
    }
  }
}

void TilePyramidView::ask_for(const std::vector<TileAddress>& wanted,
                              const std::vector<TileAddress>& seen) {
  std::vector<TileMaker::Wish> wishes;
  const auto wish_for = [&](const TileAddress& tile) {  // one that stands for several once
    const bool is_there = std::any_of(wishes.begin(), wishes.end(),
                                      [&](const auto& wish) { return wish.tile == tile; });
    if (!is_there) wishes.push_back({tile, pictures_, revision_});
  };
  for (const TileAddress& tile : wanted) wish_for(tile);
  for (const TileAddress& tile : seen) {
    const auto found = shown_.find(tile);
    const bool is_stale = found != shown_.end() && !found->second.stale.empty();
    if (is_stale && damaged_.count(tile) == 0) wish_for(tile);
  }
  maker_->ask(std::move(wishes));
}

void TilePyramidView::wait() {
  if (maker_ != nullptr) maker_->wait();
}

}  // namespace nadir
