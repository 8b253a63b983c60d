// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "core/label/label_document.h"
#include "widgets/views/tile_pictures.h"

namespace nadir {

/// A labelling document in the colours of its classes, clear where nothing was drawn. A pixel of a level is a cell of 2^level
/// cells a side, drawn by rasterise() at that resolution: level 0 has the labels as they are exported, and thin classes are
/// seen at any other. At the right and lower border pixels may reach outside of the grid, by less than one of the page.
class LabelPictures final : public TilePictures {
 public:
  /// @param document  Not null.
  explicit LabelPictures(std::shared_ptr<const LabelDocument> document);

  [[nodiscard]] CellRect cells_of(const TileAddress& tile) const override;
  [[nodiscard]] bool is_smooth() const override { return false; }
  [[nodiscard]] bool is_quick() const override { return true; }
  [[nodiscard]] Result<Raster<Rgba>> picture(const TileAddress& tile) const override;
  /// O(objects + those in the part), not of the whole tile.
  [[nodiscard]] Result<Raster<Rgba>> part(const TileAddress& tile,
                                          const CellRect& pixels) const override;

 private:
  [[nodiscard]] LabelGrid grid_of_level(int level) const;
  [[nodiscard]] CellRect pixels_of(const TileAddress& tile) const;

  std::shared_ptr<const LabelDocument> document_;
};

}  // namespace nadir
