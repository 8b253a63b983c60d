// SPDX-License-Identifier: Apache-2.0
#include "core/desk/label_coverage.h"

#include <algorithm>

#include "core/label/label_raster.h"

namespace nadir {
namespace {

std::size_t counted_class(ClassId id) { return std::min<std::size_t>(id, kClassCount); }

constexpr std::int64_t kMostTiles = 1'000'000;

std::int64_t tiles_along(int cells) {
  return (std::int64_t{cells} + kPaintTileSide - 1) / kPaintTileSide;
}

}  // namespace

LabelCoverage::LabelCoverage(const LabelGrid& grid) : grid_(grid) {
  const std::int64_t columns = tiles_along(grid.width);
  const std::int64_t rows = tiles_along(grid.height);
  is_counted_ = columns <= kMostTiles && rows <= kMostTiles && columns * rows <= kMostTiles;
  if (!is_counted_) return;
  columns_ = static_cast<int>(columns);
  rows_ = static_cast<int>(rows);
  forget();
}

void LabelCoverage::forget() {
  sum_ = {};
  tiles_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), {});
  waiting_.clear();
  for (int tile = 0; tile < columns_ * rows_; ++tile) waiting_.insert(waiting_.end(), tile);
}

CellRect LabelCoverage::cells_of(int tile) const {
  const std::int64_t left = std::int64_t{tile % columns_} * kPaintTileSide;
  const std::int64_t top = std::int64_t{tile / columns_} * kPaintTileSide;
  return CellRect{left, top, left + kPaintTileSide, top + kPaintTileSide}.cut_to(grid_.whole());
}

void LabelCoverage::discount(int tile) {
  auto& counts = tiles_[static_cast<std::size_t>(tile)];
  for (std::size_t i = 0; i < counts.size(); ++i) sum_.at(i) -= counts.at(i);
  counts = {};
}

void LabelCoverage::follow(const LabelEdit& edit) {
  if (!is_counted_) return;
  // Each thing by itself, so that one edit far apart does not count all that lies between.
  const auto wait_for = [this](const LabelEdit& part) {
    const CellRect cells = changed_cells(part, grid_, grid_).cut_to(grid_.whole());
    if (cells.empty()) return;
    for (std::int64_t row = cells.top / kPaintTileSide; row <= (cells.bottom - 1) / kPaintTileSide;
         ++row) {
      for (std::int64_t column = cells.left / kPaintTileSide;
           column <= (cells.right - 1) / kPaintTileSide; ++column) {
        const int tile = static_cast<int>(row) * columns_ + static_cast<int>(column);
        if (waiting_.insert(tile).second) discount(tile);
      }
    }
  };
  for (const ObjectChange& change : edit.objects) {
    wait_for({.title = {}, .objects = {change}, .tiles = {}, .values = {}});
  }
  for (const TileChange& change : edit.tiles) {
    wait_for({.title = {}, .objects = {}, .tiles = {change}, .values = {}});
  }
}

bool LabelCoverage::count(const LabelDocument& document, int most_tiles) {
  for (int i = 0; i < most_tiles && !waiting_.empty(); ++i) {
    const int tile = *waiting_.begin();
    waiting_.erase(waiting_.begin());
    auto& counts = tiles_[static_cast<std::size_t>(tile)];
    const Raster<ClassId> labels = rasterise(document, grid_, cells_of(tile));
    for (const ClassId id : labels.values()) ++counts.at(counted_class(id));
    for (std::size_t k = 0; k < counts.size(); ++k) sum_.at(k) += counts.at(k);
  }
  return is_complete();
}

std::int64_t LabelCoverage::cells(ClassId id) const { return sum_.at(counted_class(id)); }

std::int64_t LabelCoverage::counted_cells() const {
  std::int64_t all = 0;
  for (const std::int64_t count : sum_) all += count;
  return all;
}

double LabelCoverage::square_metres(ClassId id) const {
  return static_cast<double>(cells(id)) * grid_.metres_per_cell * grid_.metres_per_cell;
}

}  // namespace nadir
