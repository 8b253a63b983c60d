// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/raster.h"
#include "core/label/label_document.h"
#include "core/quality/label_checks.h"

namespace nadir {

/// What checks of cells look at. Private to this module.

/// A class, or one of these.
using CellCode = std::uint8_t;
inline constexpr CellCode kBeyondLabels = 251;  ///< Outside of the labelled extent, or of the grid.
inline constexpr CellCode kCurbAstray = 252;    ///< Curb that no road's border is within reach of.
inline constexpr CellCode kNarrowGround =
    253;  ///< Unlabelled, between labels that are near each other.
inline constexpr CellCode kOpenGround = 254;  ///< Unlabelled otherwise.
inline constexpr CellCode kLeftOut = 255;     ///< Unclassified as somebody wants it.

/// The class that a code stands for; kUnclassified where it is none.
[[nodiscard]] ClassId class_of_code(CellCode code);
/// Classes that cover ground, rather than stand or lie on it: islands of others are no mistakes.
[[nodiscard]] bool covers_ground(ClassId id);
/// Ground hangs together by sides, so that a thin line parts it; all that is drawn does by corners too.
[[nodiscard]] inline bool joins_corners(CellCode code) { return code != kOpenGround; }

/// The smallest rectangle of cells with everything that has a class; empty where nothing has.
[[nodiscard]] CellRect labelled_extent(const LabelDocument& document, const LabelGrid& grid);

/// Codes of cells, any window of which is the same part of the whole.
class CellCoder {
 public:
  CellCoder(const LabelDocument& document, const LabelGrid& grid, const CheckSettings& settings);

  [[nodiscard]] const CellRect& extent() const { return extent_; }
  /// Row by row. @param window  Within the grid.
  [[nodiscard]] Raster<CellCode> codes(const CellRect& window) const;

 private:
  [[nodiscard]] Raster<CellCode> plain_codes(const CellRect& window) const;
  void mark_narrow(Raster<CellCode>& codes) const;
  void mark_astray(Raster<CellCode>& codes, const CellRect& window) const;

  const LabelDocument& document_;
  LabelGrid grid_;
  CellRect extent_;
  LabelDocument left_out_;   ///< What makes unclassified, as areas and lines that show.
  double gap_cells_ = 0.0;   ///< Widest gap.
  double curb_cells_ = 0.0;  ///< Reach of curbs.
};

}  // namespace nadir
