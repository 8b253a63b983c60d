// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "core/map/class_statistics.h"
#include "core/map/overhead_map.h"
#include "core/map/overhead_map_file.h"

namespace nadir {

/// One place on a map, in every notation that people use.
struct MapPlace {
  std::string name;  ///< "centre", "north-west corner", or empty.
  Eigen::Vector2d point_in_enu_m = Eigen::Vector2d::Zero();
  Geodetic geodetic;
  std::string utm;
  std::string mgrs;
  bool is_on_map = false;
  ClassId class_id = kUnclassified;  ///< Of the cell there.
};

[[nodiscard]] MapPlace describe_place(const OverheadMap& map,
                                      const Eigen::Vector2d& point_in_enu_m,
                                      std::string name = {});

/// What there is to say about a map.
struct MapSummary {
  MapProvenance provenance;
  Geodetic plane_origin;
  int width_cells = 0;
  int height_cells = 0;
  double width_m = 0.0;
  double height_m = 0.0;
  double metres_per_cell = 0.0;
  std::vector<MapPlace> places;  ///< Centre, then the corners clockwise from the north-west.
  ClassStatistics statistics;
  /// Of `alpha`: the reading of preset `default`. Preset `thesis` and its relatives use others.
  ImportanceReading alpha_reading = ImportanceReading::kInverseRootShare;
  ClassWeights alpha{};  ///< importance_weights() of this map by that reading.
};

[[nodiscard]] MapSummary summarise_map(const OverheadMap& map, const MapProvenance& provenance);

}  // namespace nadir
