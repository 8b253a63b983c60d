// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "core/label/label_grid.h"

namespace nadir {

/// Regions of equal cells, found row by row, so that no raster needs to be kept. Private to this module.

using CellValue = std::uint16_t;
/// Around a window.
inline constexpr CellValue kBesideWindow = 0xFFFF;

/// Cells of one value that hang together.
struct RegionOfCells {
  CellValue value = 0;
  std::int64_t cells = 0;
  CellRect bounds;
  std::int64_t column = 0,
               row = 0;     ///< In the middle of its longest row; of equal ones of the first.
  bool is_touched = false;  ///< It has a cell in the part that somebody asked for.
  std::vector<std::pair<CellValue, std::int64_t>> sides;  ///< Common with others, by their value.
  std::int64_t upright_sides = 0;  ///< Of these, those to the left and to the right.

  [[nodiscard]] std::int64_t sides_with(CellValue other) const;
  [[nodiscard]] std::int64_t all_sides() const;
  /// Around it, cells, as the border was drawn rather than along the stairs of its cells: right for straight strips along rows
  /// and columns, and in the mean over all directions; else up to a fifth off.
  [[nodiscard]] double border_length() const;
  /// Of what is long and thin, cells.
  [[nodiscard]] double mean_width() const;
};

class RegionFinder {
 public:
  /// @param window         Whose rows come. @param asked_for  For is_touched.
  /// @param joins_corners  Whether cells of a value hang together by their corners too, or by their sides only.
  RegionFinder(const CellRect& window,
               const CellRect& asked_for,
               std::function<bool(CellValue value)> joins_corners);

  /// The next row from the top. @param values  As many as the window is wide.
  template <typename Value>
  void add_row(std::span<const Value> values) {
    row_.clear();
    for (std::size_t from = 0; from < values.size();) {
      std::size_t to = from + 1;
      while (to < values.size() && values[to] == values[from]) ++to;
      row_.push_back({window_.left + static_cast<std::int64_t>(from),
                      window_.left + static_cast<std::int64_t>(to),
                      static_cast<CellValue>(values[from]), 0});
      from = to;
    }
    take_row();
  }
  /// After the last row. @returns all regions, in the order of their first cells.
  [[nodiscard]] std::vector<RegionOfCells> finish();

 private:
  struct Run {
    std::int64_t from, to;
    CellValue value;
    std::size_t region;
  };
  struct Node {
    RegionOfCells region;
    std::int64_t longest = 0;  ///< Cells of the row that the place is in.
    std::size_t parent = 0;
  };
  void take_row();
  void join_with_above();
  void count_sides_with_above();
  std::size_t begin_region(CellValue value);
  [[nodiscard]] std::size_t root(std::size_t node);
  std::size_t join(std::size_t a, std::size_t b);
  void add_run(const Run& run);

  CellRect window_, asked_for_;
  std::function<bool(CellValue)> joins_corners_;
  std::int64_t next_row_;
  std::vector<Run> above_, row_;
  std::vector<Node> nodes_;
};

/// The cells of a raster's region by the rectangles of its rows, in cells: left, top, right, bottom.
/// @param values  Row by row, of the window. @param column, row  A cell of it, in the window.
[[nodiscard]] std::vector<CellRect> rows_of_region(std::span<const std::uint8_t> values,
                                                   const CellRect& window,
                                                   std::int64_t column,
                                                   std::int64_t row,
                                                   bool joins_corners);

}  // namespace nadir
