// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>

#include "core/base/raster.h"
#include "core/base/result.h"
#include "core/geo/project_plane.h"
#include "core/map/semantic_classes.h"

namespace nadir {

/// A labelled overhead on its project plane.
///
/// `overhead` coordinates are cells: x = columns to the right, y = rows down, from the top-left
/// corner; a cell's centre is at +0.5. North is up and cells are square: imports warp anything else
/// once, so `enu_from_overhead` is scale and shift.
struct OverheadMap {
  std::string name;
  ProjectPlane plane;
  double metres_per_cell = 0.1;
  Eigen::Vector2d top_left_in_enu_m =
      Eigen::Vector2d::Zero();  ///< Corner, not centre, of cell (0, 0).
  Raster<ClassId> labels;

  [[nodiscard]] Eigen::Vector2d enu_from_overhead(const Eigen::Vector2d& point_in_overhead) const {
    return {top_left_in_enu_m.x() + point_in_overhead.x() * metres_per_cell,
            top_left_in_enu_m.y() - point_in_overhead.y() * metres_per_cell};
  }
  [[nodiscard]] Eigen::Vector2d overhead_from_enu(const Eigen::Vector2d& point_in_enu_m) const {
    return {(point_in_enu_m.x() - top_left_in_enu_m.x()) / metres_per_cell,
            (top_left_in_enu_m.y() - point_in_enu_m.y()) / metres_per_cell};
  }
  /// Class under a point; kUnclassified outside the map.
  [[nodiscard]] ClassId class_at(const Eigen::Vector2d& point_in_enu_m) const;
  [[nodiscard]] bool contains(const Eigen::Vector2d& point_in_enu_m) const;
  [[nodiscard]] double width_m() const { return metres_per_cell * labels.width(); }
  [[nodiscard]] double height_m() const { return metres_per_cell * labels.height(); }
};

/// Hexadecimal, of plane, place, resolution and labels: tells whether a map is still the one that a run was made on.
[[nodiscard]] std::string content_hash(const OverheadMap& map);

/// Checks what every user of a map relies on. @errors kMalformed: "NAME: no cell has a class",
/// "only one class", bad resolution.
[[nodiscard]] Result<void> check_usable_for_localising(const OverheadMap& map);

}  // namespace nadir
