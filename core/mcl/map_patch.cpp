// SPDX-License-Identifier: Apache-2.0
#include "core/mcl/map_patch.h"

#include "core/topview/cell_placement.h"

namespace nadir {

Raster<ClassId> map_patch(const OverheadMap& map,
                          const Rigid2& enu_from_body,
                          const TopviewRaster& like) {
  const CellPlacement placement(enu_from_body, map.metres_per_cell);
  Raster<ClassId> patch(like.labels.width(), like.labels.height(), kUnclassified);
  for (int row = 0; row < patch.height(); ++row) {
    for (int column = 0; column < patch.width(); ++column) {
      patch.at(column, row) = map.class_at(
          placement.centre_in_enu_m(like.body_row - 1 - row, like.body_column - 1 - column));
    }
  }
  return patch;
}

}  // namespace nadir
