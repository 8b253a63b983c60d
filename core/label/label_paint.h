// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>

#include "core/map/semantic_classes.h"

namespace nadir {

/// What a cell was painted with: a class in the level of its class (below objects of higher levels, so that a marking drawn
/// on a painted road shows), a class with kPaintOver over everything, kUnclassified over everything, or kNoPaint.
using PaintValue = std::uint8_t;
inline constexpr PaintValue kPaintOver = 16;
inline constexpr PaintValue kNoPaint = 254;

[[nodiscard]] constexpr bool is_paint_value(PaintValue value) {
  return value < 2 * kPaintOver || value >= kNoPaint;
}
/// Class of a cell that is painted, so not kNoPaint.
[[nodiscard]] constexpr ClassId painted_class(PaintValue value) {
  return value == kUnclassified ? value : static_cast<ClassId>(value % kPaintOver);
}
[[nodiscard]] constexpr bool covers_everything(PaintValue value) {
  return value >= kPaintOver && value != kNoPaint;
}

inline constexpr int kPaintTileSide = 256;

/// A square of the painted layer, row by row from the top. Never changes once it is in a document.
struct PaintTile {
  std::array<PaintValue, static_cast<std::size_t>(kPaintTileSide) * kPaintTileSide> values;

  PaintTile() { values.fill(kNoPaint); }
  [[nodiscard]] PaintValue& at(int column, int row) { return values[index(column, row)]; }
  [[nodiscard]] PaintValue at(int column, int row) const { return values[index(column, row)]; }
  friend bool operator==(const PaintTile&, const PaintTile&) = default;

 private:
  static std::size_t index(int column, int row) {
    return static_cast<std::size_t>(row) * kPaintTileSide + static_cast<std::size_t>(column);
  }
};

/// Place of a tile in the document's grid: tile (0, 0) begins at the grid's upper left corner; others lie also left of and
/// above it.
struct PaintAddress {
  int column = 0, row = 0;
  friend auto operator<=>(const PaintAddress&, const PaintAddress&) = default;
};
/// Farther out nobody paints; 256 times this is still a whole number.
inline constexpr int kMostPaintAddress = 1 << 20;

}  // namespace nadir
