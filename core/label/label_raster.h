// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/raster.h"
#include "core/label/label_document.h"

namespace nadir {

/// The labels of a document as cells of any grid on its plane.
///
/// A pure function of document, grid and cell: any window equals the same part of the whole, bit for bit, on any number of
/// threads. Objects are drawn by rising order and id, then paint (label_paint.h).
/// - Area: the cells whose centre is inside by the even-odd rule, as GDAL has it: columns are taken from floor(x + 0.5) up
///   to, and without, floor(x + 0.5) of the next border; rows whose centre is in [y1, y2). So areas with a common border
///   leave no cell out and claim none twice, also where the border runs through centres.
/// - Line: the cells whose centre is within half its width of a segment (ends are cut off square) or of an inner place
///   (round joins). A line narrower than a cell, or shorter, also gets the cells that its centre line passes.
/// - Outline: the inside becomes unclassified, but for the cells within its thickness of a ring and those at the inside's
///   edge. One narrower than a cell also gets the cells that its rings pass.
/// - Paint: that of the cell of the document's grid in which the centre lies.
///
/// @param window  Cells of the grid; may reach outside of it. At most 2^31 - 1 wide and high.
/// @returns       Of the window's size; kUnclassified where nothing was drawn. O(window + its objects' places).
[[nodiscard]] Raster<ClassId> rasterise(const LabelDocument& document,
                                        const LabelGrid& grid,
                                        const CellRect& window);
/// Of the document's own grid, all of it.
[[nodiscard]] Raster<ClassId> rasterise(const LabelDocument& document);

/// Cells of a grid that an edit may change; all others are as before. Empty where it changes none.
/// @param of_document  The grid that tiles are counted in.
[[nodiscard]] CellRect changed_cells(const LabelEdit& edit,
                                     const LabelGrid& of_document,
                                     const LabelGrid& grid);

}  // namespace nadir
