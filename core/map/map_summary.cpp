// SPDX-License-Identifier: Apache-2.0
#include "core/map/map_summary.h"

#include <utility>

namespace nadir {

MapPlace describe_place(const OverheadMap& map,
                        const Eigen::Vector2d& point_in_enu_m,
                        std::string name) {
  MapPlace place;
  place.name = std::move(name);
  place.point_in_enu_m = point_in_enu_m;
  place.geodetic = map.plane.geodetic_from_enu(point_in_enu_m);
  place.utm = utm_text(place.geodetic);
  place.mgrs = mgrs_text(place.geodetic);
  place.is_on_map = map.contains(point_in_enu_m);
  place.class_id = map.class_at(point_in_enu_m);
  return place;
}

MapSummary summarise_map(const OverheadMap& map, const MapProvenance& provenance) {
  MapSummary summary;
  summary.provenance = provenance;
  summary.plane_origin = map.plane.origin();
  summary.width_cells = map.labels.width();
  summary.height_cells = map.labels.height();
  summary.width_m = map.width_m();
  summary.height_m = map.height_m();
  summary.metres_per_cell = map.metres_per_cell;
  const double right = map.labels.width();
  const double bottom = map.labels.height();
  const auto add = [&](const char* name, double x, double y) {
    summary.places.push_back(describe_place(map, map.enu_from_overhead({x, y}), name));
  };
  add("centre", 0.5 * right, 0.5 * bottom);
  add("north-west corner", 0.0, 0.0);
  add("north-east corner", right, 0.0);
  add("south-east corner", right, bottom);
  add("south-west corner", 0.0, bottom);
  summary.statistics = class_statistics(map.labels);
  summary.alpha = importance_weights(summary.statistics, summary.alpha_reading);
  return summary;
}

}  // namespace nadir
