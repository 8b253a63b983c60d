// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>

#include "core/label/label_document.h"

namespace nadir {

/// Paints on copies of a document's tiles. Private to this module.
class TilePainter {
 public:
  explicit TilePainter(const LabelDocument& document) : document_(document) {}

  /// Cells [from, to) of a row of the document's grid, or outside of it.
  void put(std::int64_t row, std::int64_t from, std::int64_t to, PaintValue value);
  /// What has come of it; tiles that are as they were are left out.
  [[nodiscard]] LabelEdit edit(std::string title) const;

 private:
  const LabelDocument& document_;
  std::map<PaintAddress, std::shared_ptr<PaintTile>> tiles_;
};

/// The tile that holds a cell, by its column or row; rounds down, also below 0.
[[nodiscard]] constexpr int tile_of_cell(std::int64_t cell) {
  return static_cast<int>(cell >= 0 ? cell / kPaintTileSide : -((-cell - 1) / kPaintTileSide) - 1);
}

}  // namespace nadir
