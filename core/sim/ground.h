// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <optional>

#include "core/map/overhead_map.h"
#include "core/sim/relief.h"

namespace nadir {

/// Where things may stand: distances on a map, made once. Refers to the map and relief, which must
/// outlive it.
class Ground {
 public:
  Ground(const OverheadMap& map, const Relief& relief);

  [[nodiscard]] const OverheadMap& map() const { return map_; }
  [[nodiscard]] double height_m(const Eigen::Vector2d& place_in_enu_m) const;
  /// Chessboard distances in metres, at most 255 cells; 0 outside the map for the first and third.
  [[nodiscard]] double inside_road_m(
      const Eigen::Vector2d& place_in_enu_m) const;  ///< To the nearest non-road.
  [[nodiscard]] double to_road_m(const Eigen::Vector2d& place_in_enu_m) const;
  [[nodiscard]] double inside_open_m(
      const Eigen::Vector2d& place_in_enu_m) const;  ///< To non-open ground.
  /// Sidewalk, terrain and vegetation: where people walk and trees stand.
  [[nodiscard]] bool is_open(const Eigen::Vector2d& place_in_enu_m) const {
    return inside_open_m(place_in_enu_m) > 0.0;
  }
  /// Direction (unit vector) of the road's edge near a place on the road, where that edge is
  /// straight for 5 m.
  [[nodiscard]] std::optional<Eigen::Vector2d> edge_direction(
      const Eigen::Vector2d& place_in_enu_m) const;

 private:
  [[nodiscard]] double distance_m(const Raster<std::uint8_t>& cells,
                                  const Eigen::Vector2d& place_in_enu_m,
                                  double outside) const;

  const OverheadMap& map_;
  const Relief& relief_;
  Raster<std::uint8_t> cells_to_nonroad_, cells_to_road_, cells_to_nonopen_;
};

/// The ends of a straight run.
struct StraightRun {
  Eigen::Vector2d from_in_enu_m, to_in_enu_m;
};

/// The longest straight run through a place on which `is_free` holds every half metre, over 32
/// headings; at most `most_m` to either side. Nothing where it is shorter than `least_m`.
[[nodiscard]] std::optional<StraightRun> longest_run(
    const Eigen::Vector2d& place_in_enu_m,
    const std::function<bool(const Eigen::Vector2d&)>& is_free,
    double least_m,
    double most_m);

}  // namespace nadir
