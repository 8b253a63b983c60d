// SPDX-License-Identifier: Apache-2.0
#include "core/insight/label_ground.h"

#include <utility>

#include "core/label/label_raster.h"

namespace nadir {

LabelGrid grid_of(const OverheadMap& map) {
  return {.metres_per_cell = map.metres_per_cell,
          .top_left_in_enu_m = map.top_left_in_enu_m,
          .width = map.labels.width(),
          .height = map.labels.height()};
}

Result<std::shared_ptr<const MapIndex>> labelled_ground(const OverheadMap& map,
                                                        const LabelDocument& document) {
  if (!(document.plane() == map.plane)) {
    return fail(ErrorCode::kInvalidOptions,
                "map '{}': the labels were drawn on another plane than the map's", map.name);
  }
  const LabelGrid grid = grid_of(map);
  OverheadMap labelled{.name = map.name,
                       .plane = map.plane,
                       .metres_per_cell = map.metres_per_cell,
                       .top_left_in_enu_m = map.top_left_in_enu_m,
                       .labels = rasterise(document, grid, grid.whole())};
  return std::make_shared<const MapIndex>(std::make_shared<const OverheadMap>(std::move(labelled)));
}

}  // namespace nadir
