// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/raster.h"
#include "core/geo/rigid2.h"
#include "core/map/overhead_map.h"
#include "core/topview/semantic_topview.h"

namespace nadir {

/// What the map holds under each cell of a topview's picture when the body is at a pose: the picture
/// that a perfect topview would be, to lie beside the one that was seen.
///
/// Its cell (column, row) is that of `like`: row 0 farthest ahead, column 0 leftmost, and the map is
/// asked at the cell's centre, which is (body_row - row - 0.5, body_column - column - 0.5) cells
/// ahead and to the left of the body. Cells are as large as the map's, as those of a topview that
/// was built for it.
///
/// @param enu_from_body  Need not be finite: then the patch is empty ground.
/// @param like           Gives size and place of the body; its labels are not read.
/// @returns              As large as `like.labels`; kUnclassified off the map. O(cells).
[[nodiscard]] Raster<ClassId> map_patch(const OverheadMap& map,
                                        const Rigid2& enu_from_body,
                                        const TopviewRaster& like);

}  // namespace nadir
