// SPDX-License-Identifier: Apache-2.0
#include "core/mcl/cell_agreement.h"

#include "core/topview/cell_placement.h"

namespace nadir {

std::optional<double> CellAgreement::Count::share() const {
  const std::size_t known = std::size_t{agreeing} + disagreeing;
  if (known == 0) return std::nullopt;
  return static_cast<double>(agreeing) / static_cast<double>(known);
}

CellAgreement::Count CellAgreement::total() const {
  Count sum;
  for (const Count& count : of_class) {
    sum.agreeing += count.agreeing;
    sum.disagreeing += count.disagreeing;
    sum.unknown += count.unknown;
  }
  return sum;
}

CellAgreement cell_agreement(const SemanticTopview& seen,
                             const OverheadMap& map,
                             const Rigid2& enu_from_body) {
  const CellPlacement placement(enu_from_body, seen.metres_per_cell);
  CellAgreement result{.of_cell = {}, .of_class = {}};
  result.of_cell.reserve(seen.cells.size());
  for (ClassId id = 0; id < kClassCount; ++id) {
    CellAgreement::Count& count = result.of_class[id];
    for (const TopviewCell& cell : seen.of_class(id)) {
      const ClassId there = map.class_at(placement.centre_in_enu_m(cell));
      if (there == kUnclassified) {
        ++count.unknown;
        result.of_cell.push_back(CellVerdict::kUnknown);
      } else if (there == id) {
        ++count.agreeing;
        result.of_cell.push_back(CellVerdict::kAgrees);
      } else {
        ++count.disagreeing;
        result.of_cell.push_back(CellVerdict::kDisagrees);
      }
    }
  }
  return result;
}

}  // namespace nadir
