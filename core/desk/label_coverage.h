// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <set>
#include <vector>

#include "core/label/label_document.h"

namespace nadir {

/// How many cells of a document's grid each class has, kept as it is edited. Cells are counted by tiles of 256 x 256, and
/// after an edit only those again that it may have changed, so that a stroke costs a millisecond. The first count of a large
/// grid takes seconds and is done in pieces.
class LabelCoverage {
 public:
  /// A grid of more than a million tiles is not counted at all.
  explicit LabelCoverage(const LabelGrid& grid);

  /// What an edit may have changed has to be counted again.
  void follow(const LabelEdit& edit);
  void forget();
  /// Counts at most so many tiles. @param document  As it is now. @returns whether all are counted.
  bool count(const LabelDocument& document, int most_tiles);

  [[nodiscard]] bool is_complete() const { return is_counted_ && waiting_.empty(); }
  /// Of the cells that are counted.
  [[nodiscard]] std::int64_t cells(ClassId id) const;
  [[nodiscard]] std::int64_t counted_cells() const;
  [[nodiscard]] double square_metres(ClassId id) const;

 private:
  /// By class, the last of what is unclassified.
  using Counts = std::array<std::int64_t, kClassCount + 1>;
  [[nodiscard]] CellRect cells_of(int tile) const;
  void discount(int tile);

  LabelGrid grid_;
  int columns_ = 0, rows_ = 0;
  bool is_counted_ = false;
  Counts sum_{};
  std::vector<std::array<std::uint32_t, kClassCount + 1>> tiles_;
  std::set<int> waiting_;
};

}  // namespace nadir
