// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/mcl/cost_kernel.h"

namespace nadir::detail {

/// Poses that sum_rows() evaluates at once.
inline constexpr std::size_t kRowLanes = 64;

/// Part of a CostRaster, copied so that what a topview cell meets at poses side by side, a whole
/// number of cells apart, lies side by side in memory: one load takes the costs of many poses.
///
/// Columns of the same remainder (mod the step between poses) are stored together, row by row.
/// Places beyond the raster hold its nearest cell, as sum_costs() reads them.
class CostWindow {
 public:
  /// The rectangle from `corner` (north-west, in the raster's columns and rows; may lie beyond it).
  /// @param columns, rows, step_cells  All above 0.
  CostWindow(
      const CostRaster& raster, const RasterPlace& corner, int columns, int rows, int step_cells);

  /// Where the cost of a place inside the rectangle is stored; the one for the pose k steps farther
  /// east is k behind it.
  [[nodiscard]] std::size_t index_of(const RasterPlace& place) const;
  /// What a pose one step farther south adds to an index.
  [[nodiscard]] std::size_t index_of_step() const { return step_ * row_size_; }
  /// The costs, and kRowLanes more bytes that loads may touch.
  [[nodiscard]] const std::uint8_t* data() const { return values_.data(); }

  /// Bytes that such a window would take.
  [[nodiscard]] static double bytes(double columns, double rows, int step_cells);

 private:
  RasterPlace corner_;
  std::size_t step_, phase_size_, row_size_;
  std::vector<std::uint8_t> values_;
};

/// Costs of a set of topview cells at kRowLanes poses side by side:
/// sums[k] = sum over i of values[index[i] + k]. The same integers with every instruction set.
/// @param sums  kRowLanes of them; overwritten.
void sum_rows(const std::uint8_t* values,
              std::span<const std::uint32_t> index,
              std::uint32_t* sums,
              InstructionSet set);

}  // namespace nadir::detail
