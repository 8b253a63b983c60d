// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/raster.h"
#include "core/map/semantic_classes.h"

namespace nadir {

/// Where a map has one class: a bit a cell, so that 64 cells are compared by one AND and one
/// popcount.
///
/// Cell (column, row) is bit `column % 64` (least significant first) of word `column / 64` of its
/// row. Every row starts a new word and ends with a word of zeros, so that reading 64 cells from
/// any column of the row stays inside it.
class ClassPlane {
 public:
  /// O(cells), on as many threads as there are.
  [[nodiscard]] static ClassPlane of(const Raster<ClassId>& labels, ClassId id);

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  [[nodiscard]] int words_per_row() const { return words_per_row_; }

  /// Whether the cell has the class; false outside the map.
  [[nodiscard]] bool test(int column, int row) const {
    if (column < 0 || row < 0 || column >= width_ || row >= height_) return false;
    return (row_words(row)[static_cast<std::size_t>(column) / 64] >> (column % 64) & 1U) != 0;
  }
  /// The 64 cells from `column` to the right, the leftmost in the lowest bit. Any column and row,
  /// also negative ones: cells outside the map are 0.
  [[nodiscard]] std::uint64_t word_at(int column, int row) const;
  /// Cells of the class on the whole map. O(words).
  [[nodiscard]] std::int64_t count() const;

  /// words_per_row() words; `row` must be inside.
  [[nodiscard]] std::span<const std::uint64_t> row_words(int row) const {
    const auto length = static_cast<std::size_t>(words_per_row_);
    return {words_.data() + static_cast<std::size_t>(row) * length, length};
  }

 private:
  ClassPlane(int width, int height);

  int width_;
  int height_;
  int words_per_row_;
  std::vector<std::uint64_t> words_;
};

}  // namespace nadir
