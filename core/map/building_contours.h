// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/map/overhead_map.h"

namespace nadir {

/// Leaves of every building its walls: building cells whose centre is farther than `thickness_m`
/// from the building's edge become unclassified, for a camera on the ground sees walls and no roofs
/// (Rouben 2018, section 3.5).
///
/// The edge runs between a building cell and any other cell of the map, unclassified ones too. The
/// border of the map is no edge: a building that it cuts has no wall there. The outermost layer of
/// cells always stays. O(cells).
[[nodiscard]] Raster<ClassId> with_building_contours(const Raster<ClassId>& labels,
                                                     double metres_per_cell,
                                                     double thickness_m);

}  // namespace nadir
