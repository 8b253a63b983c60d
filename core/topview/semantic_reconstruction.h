// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "core/base/raster.h"
#include "core/base/result.h"
#include "core/geo/rigid2.h"
#include "core/topview/semantic_topview.h"

namespace nadir {

/// Every topview of a drive laid at its pose, votes per cell: the ground as it was seen (thesis
/// figures 4-12 and 4-13).
///
/// The grid is north-up in `enu`. Its cell borders are multiples of `metres_per_cell` from enu's
/// origin, whatever was added first; the cell with indices (i, j) holds x in [i, i + 1) and y in
/// [j, j + 1) times `metres_per_cell`. Votes are counted in blocks of 64 x 64 cells and there by
/// class, each made when its first vote comes (8 KiB), so that memory goes with the ground that was
/// seen and not with the rectangle around it. The votes of a class in a cell stop at 65,535.
/// The result depends neither on the order of the topviews nor on the cells that come between.
class SemanticReconstruction {
 public:
  /// Rasters of more cells are refused.
  static constexpr std::int64_t kMostCells = 1'000'000'000;
  /// Nothing may be added farther from enu's origin, along either axis.
  static constexpr double kFarthestCell = 1e9;

  /// @param metres_per_cell  Of the grid; positive. Topviews may have another one, but coarser
  /// topviews leave empty cells between theirs.
  explicit SemanticReconstruction(double metres_per_cell);

  /// Gives one vote a topview cell for its class to the grid cell that its centre falls into.
  /// O(cells). The pose must be finite and within kFarthestCell; where it is not, nothing is added.
  void add(const SemanticTopview& seen, const Rigid2& enu_from_body);

  [[nodiscard]] bool empty() const { return blocks_.empty(); }
  [[nodiscard]] double metres_per_cell() const { return metres_per_cell_; }
  /// Corner, not centre, of cell (0, 0) of the rasters: the north-west one of the rectangle around
  /// all votes. It moves when later topviews reach beyond that rectangle. Must not be empty().
  [[nodiscard]] Eigen::Vector2d top_left_in_enu_m() const;
  /// Memory that the votes take.
  [[nodiscard]] std::size_t bytes() const;

  /// The class with the most votes of each cell, row 0 northernmost: the smaller id where votes are
  /// equal, kUnclassified where the winner has fewer than `min_votes` (at least 1). Just as large as
  /// the rectangle around all votes; 0 x 0 if empty().
  /// @errors kUnsupported: more than kMostCells.
  [[nodiscard]] Result<Raster<ClassId>> labels(int min_votes = 1) const;

  /// Votes of each cell, all classes together, on the same raster; 65,535 stands for more as well.
  /// @errors kUnsupported: more than kMostCells.
  [[nodiscard]] Result<Raster<std::uint16_t>> votes() const;

  /// Votes of a cell by class.
  using CellVotes = std::array<std::uint16_t, kClassCount>;
  /// Calls `visit(i, j, votes)` for each cell that has any, block by block from the south, in a block row by row.
  void visit_cells(const std::function<void(int i, int j, const CellVotes& votes)>& visit) const;

 private:
  static constexpr int kBlockBits = 6;
  static constexpr int kBlockSide = 1 << kBlockBits;
  static constexpr std::size_t kBlockCells = std::size_t{1} << (2U * kBlockBits);
  /// Votes of a class for the cells of a block, southernmost row first; empty where there are none.
  using Block = std::array<std::vector<std::uint16_t>, kClassCount>;
  using BlockIndex = std::pair<int, int>;  ///< North, east.

  void vote(Block& block, std::size_t cell, ClassId id);
  /// Puts what `decide` makes of each block in its place on a raster.
  template <typename T, typename Decide>
  [[nodiscard]] Result<Raster<T>> assemble(T nothing, Decide&& decide) const;

  double metres_per_cell_;
  std::map<BlockIndex, Block> blocks_;
  int west_ = 0, east_ = 0, south_ = 0, north_ = 0;  ///< Outermost cells that have a vote.
};

}  // namespace nadir
