// SPDX-License-Identifier: Apache-2.0
#include "core/label/edit_paint.h"

#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "core/base/require.h"
#include "core/label/cell_fill.h"
#include "core/label/label_raster.h"
#include "core/label/tile_painter.h"

namespace nadir {
namespace {

Ring in_cells(const Ring& path_in_enu_m, const LabelGrid& grid) {
  Ring path = path_in_enu_m;
  for (Eigen::Vector2d& point : path) point = grid.cells_from_enu(point);
  return path;
}

/// The raster of a document by tiles, made where somebody looks, with what has been visited.
class VisitedRaster {
 public:
  explicit VisitedRaster(const LabelDocument& document) : document_(document) {}

  [[nodiscard]] ClassId class_at(std::int64_t column, std::int64_t row) {
    const auto [tile, at] = place(column, row);
    return tile->labels.values()[at];
  }
  /// @returns whether it was not visited before.
  [[nodiscard]] bool visit(std::int64_t column, std::int64_t row) {
    const auto [tile, at] = place(column, row);
    if (tile->is_visited[at]) return false;
    tile->is_visited[at] = true;
    return true;
  }

 private:
  struct Tile {
    Raster<ClassId> labels;
    std::vector<bool> is_visited;
  };
  std::pair<Tile*, std::size_t> place(std::int64_t column, std::int64_t row) {
    const PaintAddress address{tile_of_cell(column), tile_of_cell(row)};
    const std::int64_t left = std::int64_t{address.column} * kPaintTileSide;
    const std::int64_t top = std::int64_t{address.row} * kPaintTileSide;
    if (last_ == nullptr || !(address == last_address_)) {
      Tile& tile = tiles_[address];
      if (tile.labels.empty()) {
        tile.labels = rasterise(document_, document_.grid(),
                                {left, top, left + kPaintTileSide, top + kPaintTileSide});
        tile.is_visited.assign(tile.labels.size(), false);
      }
      last_ = &tile;
      last_address_ = address;
    }
    return {last_, static_cast<std::size_t>((row - top) * kPaintTileSide + (column - left))};
  }

  const LabelDocument& document_;
  std::map<PaintAddress, Tile> tiles_;
  Tile* last_ = nullptr;  ///< That was looked at last, for the next cell is mostly in it too.
  PaintAddress last_address_;
};

}  // namespace

LabelEdit paint_stroke(const LabelDocument& document,
                       const Ring& path_in_enu_m,
                       double radius_m,
                       PaintValue value,
                       std::string title) {
  NADIR_REQUIRE(!path_in_enu_m.empty() && radius_m > 0.0 && is_paint_value(value));
  const LabelGrid& grid = document.grid();
  const Ring path = in_cells(path_in_enu_m, grid);
  const double radius = radius_m / grid.metres_per_cell;
  TilePainter painter(document);
  const TakeCells take = [&](std::int64_t row, std::int64_t from, std::int64_t to) {
    painter.put(row, from, to, value);
  };
  fill_stroke(path, false, radius, grid.whole(), take);
  // A ring of one place is a disc.
  for (const Eigen::Vector2d& end : {path.front(), path.back()}) {
    fill_stroke({end}, true, radius, grid.whole(), take);
  }
  if (radius < 1.0) fill_path(path, false, grid.whole(), take);
  return painter.edit(std::move(title));
}

LabelEdit paint_rings(const LabelDocument& document,
                      const std::vector<Ring>& rings_in_enu_m,
                      PaintValue value,
                      std::string title) {
  NADIR_REQUIRE(is_paint_value(value));
  std::vector<Ring> rings;
  rings.reserve(rings_in_enu_m.size());
  for (const Ring& ring : rings_in_enu_m) rings.push_back(in_cells(ring, document.grid()));
  TilePainter painter(document);
  fill_rings(rings, document.grid().whole(),
             [&](std::int64_t row, std::int64_t from, std::int64_t to) {
               painter.put(row, from, to, value);
             });
  return painter.edit(std::move(title));
}

Result<LabelEdit> flood_fill(const LabelDocument& document,
                             const Eigen::Vector2d& at_in_enu_m,
                             PaintValue value,
                             std::string title) {
  NADIR_REQUIRE(is_paint_value(value));
  const CellRect whole = document.grid().whole();
  const Eigen::Vector2d at = document.grid().cells_from_enu(at_in_enu_m);
  const bool is_inside = at.x() >= 0.0 && at.y() >= 0.0 &&
                         at.x() < static_cast<double>(whole.right) &&
                         at.y() < static_cast<double>(whole.bottom);
  if (!is_inside)
    return fail(ErrorCode::kInvalidOptions, "the place to fill is outside of the map");
  struct Cell {
    std::int64_t column, row;
  };
  const Cell start{static_cast<std::int64_t>(at.x()), static_cast<std::int64_t>(at.y())};
  VisitedRaster raster(document);
  TilePainter painter(document);
  const ClassId wanted = raster.class_at(start.column, start.row);
  const auto belongs = [&](std::int64_t column, std::int64_t row) {
    return raster.class_at(column, row) == wanted && raster.visit(column, row);
  };
  std::vector<Cell> waiting;
  if (belongs(start.column, start.row)) waiting.push_back(start);
  std::int64_t filled = 0;
  // Row by row: what waits is one cell, from which its row is gone along both ways.
  while (!waiting.empty()) {
    const Cell cell = waiting.back();
    waiting.pop_back();
    std::int64_t from = cell.column;
    std::int64_t to = cell.column + 1;
    while (from > whole.left && belongs(from - 1, cell.row)) --from;
    while (to < whole.right && belongs(to, cell.row)) ++to;
    painter.put(cell.row, from, to, value);
    filled += to - from;
    if (filled > kMostFilledCells) {
      return fail(ErrorCode::kInvalidOptions, "there are more than {} cells to fill",
                  kMostFilledCells);
    }
    for (const std::int64_t row : {cell.row - 1, cell.row + 1}) {
      if (row < whole.top || row >= whole.bottom) continue;
      for (std::int64_t column = from; column < to; ++column) {
        if (belongs(column, row)) waiting.push_back({column, row});
      }
    }
  }
  return painter.edit(std::move(title));
}

}  // namespace nadir
