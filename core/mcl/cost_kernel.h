// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/geo/rigid2.h"
#include "core/map/overhead_map.h"
#include "core/topview/semantic_topview.h"

namespace nadir {

/// What a topview cell of one class costs on each cell of the map, 0 (fits) to 255 (wrong), with a
/// border of one cell around it that stands for everything off the map.
struct CostRaster {
  int width = 0;  ///< Of the map; the raster is two cells wider and higher.
  int height = 0;
  std::vector<std::uint8_t>
      values;  ///< (width + 2) * (height + 2), and three bytes that vector loads may touch.

  [[nodiscard]] int stride() const { return width + 2; }
};

/// No topview cell is farther from the body than this; builders of topviews refuse larger ranges.
inline constexpr int kMaxReachCells = kMaxTopviewReachCells;

/// Maps larger than this on a side are refused: positions are fixed-point numbers with 15 bits
/// behind the point.
inline constexpr int kMaxMapSide = 45'000;

/// Centre of a topview cell in half cells: (2 forward + 1, 2 left + 1), as the kernels load it.
struct HalfCell {
  std::int16_t forward, left;
};

/// Where the body is on the map, in fixed point, so that every instruction set gives the same
/// integers.
///
/// Column and row (of CostRaster, border included) of a cell centre are
///   column = base_column + cos * forward - sin * left,   row = base_row - sin * forward - cos *
///   left
/// in units of 2^-15 cells: the factors have 14 bits behind the point and half cells give the
/// fifteenth.
struct FixedPose {
  std::int32_t base_column, base_row;
  std::int16_t cos, sin;
};

/// Positions farther off the map than any topview reaches are moved nearer, which changes no
/// result; a pose that is not finite counts as such a one. Yaw may be of any size.
[[nodiscard]] FixedPose fixed_pose(const Rigid2& enu_from_body, const OverheadMap& map);

/// Fixed-point coordinates have so many bits behind the point.
inline constexpr int kFractionBits = 15;

/// A cell of a CostRaster, or one beyond its border, which stands for the nearest cell of the border.
struct RasterPlace {
  int column, row;
};

/// Where the centre of a topview cell falls when the body is at a pose.
[[nodiscard]] inline RasterPlace place_of(const HalfCell& cell, const FixedPose& pose) {
  return {(pose.base_column + pose.cos * cell.forward - pose.sin * cell.left) >> kFractionBits,
          (pose.base_row - pose.sin * cell.forward - pose.cos * cell.left) >> kFractionBits};
}

enum class InstructionSet { kPortable, kAvx2, kAvx512 };

/// The one that was measured to be fastest of those that this machine has. Results do not depend on it, only speed does.
[[nodiscard]] InstructionSet best_instruction_set();
[[nodiscard]] bool is_available(InstructionSet set);

/// Sum of the costs of `cells` laid on the map at a pose. The same integer with every instruction
/// set.
[[nodiscard]] std::uint32_t sum_costs(const CostRaster& raster,
                                      std::span<const HalfCell> cells,
                                      const FixedPose& pose,
                                      InstructionSet set);

}  // namespace nadir
