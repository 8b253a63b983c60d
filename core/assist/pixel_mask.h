// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/assist/assist_window.h"
#include "core/label/label_document.h"

namespace nadir {

/// Of a window's size: 1 where a pixel belongs to what was found, else 0.
using PixelMask = Raster<std::uint8_t>;

/// Whether pixels hang together by their sides only, or by their corners too.
enum class PixelNeighbours { kFour, kEight };
template <>
struct EnumNames<PixelNeighbours> {
  static constexpr std::array<std::string_view, 2> kNames = {"four", "eight"};
};

/// With holes of at most so many pixels filled. A hole is what hangs together outside of the mask and does not reach the
/// window's border; by corners too where the mask's own pixels hang together by their sides only.
[[nodiscard]] PixelMask filled_holes(const PixelMask& mask,
                                     int most_pixels,
                                     PixelNeighbours of_mask);

/// The borders of what was found, for the eye: closed rings along the sides of pixels, holes too, in enu, metres.
[[nodiscard]] Result<std::vector<Ring>> borders_in_enu(const AssistWindow& window,
                                                       const PixelMask& mask);

/// Cells of a label grid that were found.
struct CellMask {
  CellRect cells;
  Raster<std::uint8_t> values;  ///< Of their size: 1 belongs, else 0.
  friend bool operator==(const CellMask&, const CellMask&) = default;
};

/// The cells whose centre lies in a pixel of the mask, cut to the grid. Their rectangle holds no more than a cell beside them.
/// @errors kInvalidOptions: there are more than kMostFilledCells to look at.
[[nodiscard]] Result<CellMask> cells_of(const AssistWindow& window,
                                        const PixelMask& mask,
                                        const LabelGrid& grid);

// Edits of what was found, each of one step, empty where nothing changes; none changes anything itself.

/// Paints the cells. @param value  As a brush has it: kPaintOver, kUnclassified and kNoPaint too.
[[nodiscard]] LabelEdit paint_cells(const LabelDocument& document,
                                    const CellMask& found,
                                    PaintValue value,
                                    std::string title);

struct DrawCellsOptions {
  double simplify_m = 0.0;
  double least_area_m2 = 0.0;
  friend bool operator==(const DrawCellsOptions&, const DrawCellsOptions&) = default;
};
template <typename Options, typename Visitor>
void visit_fields(Options& options, Visitor&& visit) requires
    std::is_same_v<std::remove_const_t<Options>, DrawCellsOptions> {
  visit(options.simplify_m,
        Field{"simplify-found", "m", "How far the border of an area may run from that of its cells",
              0.0, 100.0});
  visit(options.least_area_m2,
        Field{"least-area", "m2", "Smaller pieces and holes are left out", 0.0, 1e6});
}

/// Draws the cells as areas on top of their class, one for each piece that hangs together by sides, with holes. Without
/// simplifying and leaving out rasterise() gives just these cells.
/// @errors kInvalidOptions: a class that no map holds, an option out of its range; kIo: not enough memory.
[[nodiscard]] Result<LabelEdit> draw_cells(const LabelDocument& document,
                                           const CellMask& found,
                                           ClassId class_id,
                                           const DrawCellsOptions& options,
                                           std::string title);

}  // namespace nadir
