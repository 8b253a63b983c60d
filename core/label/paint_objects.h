// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "core/base/raster.h"
#include "core/base/result.h"
#include "core/label/label_document.h"

namespace nadir {

/// Cells of one value that hang together by their sides, as an area of the plane: its border, then its holes. Corners lie on
/// corners of cells, so that rasterise() gives the same cells again.
struct CellRegion {
  std::uint8_t value = 0;
  std::vector<Ring> rings_in_cells;  ///< x right, y down.
};

/// All regions of a raster by GDALPolygonize; each cell is in exactly one. O(cells).
/// @param left_out  A value whose cells are in none. @errors kIo: not enough memory.
[[nodiscard]] Result<std::vector<CellRegion>> polygonise(const Raster<std::uint8_t>& values,
                                                         std::uint8_t left_out);

/// Turns paint into areas: the raster stays what it was, to the last cell. Areas take the place of their paint in the levels
/// of classes. @errors as polygonise().
[[nodiscard]] Result<LabelEdit> paint_to_objects(const LabelDocument& document);

/// Turns objects into paint: the raster of the document's grid stays what it was, to the last cell. What others cover of them
/// is gone. @errors kInvalidOptions: an object is not there.
[[nodiscard]] Result<LabelEdit> objects_to_paint(const LabelDocument& document,
                                                 std::span<const ObjectId> objects);

}  // namespace nadir
