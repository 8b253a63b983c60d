// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/geo/rigid2.h"
#include "core/map/overhead_map.h"
#include "core/topview/semantic_topview.h"

namespace nadir {

/// What the map says of one cell of a topview. kUnknown: its centre is off the map or on
/// unclassified ground, so the map says nothing.
enum class CellVerdict : std::uint8_t { kUnknown, kAgrees, kDisagrees };

/// Which cells of a topview have the class that the map has there.
struct CellAgreement {
  struct Count {
    std::uint32_t agreeing = 0, disagreeing = 0, unknown = 0;
    /// agreeing / (agreeing + disagreeing); nothing where neither is.
    [[nodiscard]] std::optional<double> share() const;
    friend bool operator==(const Count&, const Count&) = default;
  };

  std::vector<CellVerdict> of_cell;         ///< In the order of the topview's cells.
  std::array<Count, kClassCount> of_class;  ///< By the class that was seen, not the map's.

  /// Cells of all classes together.
  [[nodiscard]] Count total() const;
  /// Share of the cells on known ground that agree; nothing where no cell is on such ground.
  [[nodiscard]] std::optional<double> share() const { return total().share(); }
};

/// Compares each cell of a topview, laid at a pose, with the class of the map cell that its centre
/// falls into. Classes that no map holds (cars) disagree wherever the ground is known. O(cells).
///
/// @param enu_from_body  Need not be finite: then every cell is kUnknown.
[[nodiscard]] CellAgreement cell_agreement(const SemanticTopview& seen,
                                           const OverheadMap& map,
                                           const Rigid2& enu_from_body);

}  // namespace nadir
