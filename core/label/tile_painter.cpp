// SPDX-License-Identifier: Apache-2.0
#include "core/label/tile_painter.h"

#include <algorithm>
#include <utility>

namespace nadir {

void TilePainter::put(std::int64_t row, std::int64_t from, std::int64_t to, PaintValue value) {
  const int tile_row = tile_of_cell(row);
  const int row_in_tile = static_cast<int>(row - std::int64_t{tile_row} * kPaintTileSide);
  while (from < to) {
    const int tile_column = tile_of_cell(from);
    const std::int64_t left = std::int64_t{tile_column} * kPaintTileSide;
    const std::int64_t end = std::min(to, left + kPaintTileSide);
    std::shared_ptr<PaintTile>& tile = tiles_[{tile_column, tile_row}];
    if (tile == nullptr) {
      const auto before = document_.tile({tile_column, tile_row});
      tile =
          before != nullptr ? std::make_shared<PaintTile>(*before) : std::make_shared<PaintTile>();
    }
    PaintValue* const first = &tile->at(static_cast<int>(from - left), row_in_tile);
    std::fill(first, first + (end - from), value);
    from = end;
  }
}

LabelEdit TilePainter::edit(std::string title) const {
  LabelEdit edit{.title = std::move(title), .objects = {}, .tiles = {}, .values = {}};
  for (const auto& [address, tile] : tiles_) {
    const auto before = document_.tile(address);
    const bool is_blank = std::all_of(tile->values.begin(), tile->values.end(),
                                      [](PaintValue value) { return value == kNoPaint; });
    const bool is_same = before == nullptr ? is_blank : *before == *tile;
    if (is_same) continue;
    Change<PaintTile> change{before, nullptr};
    if (!is_blank) change.after = tile;
    edit.tiles.push_back({address, std::move(change)});
  }
  return edit;
}

}  // namespace nadir
