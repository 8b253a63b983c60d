// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <concepts>
#include <cstdint>
#include <vector>

#include "core/base/field.h"
#include "core/map/overhead_map.h"
#include "core/sim/relief.h"
#include "core/sim/solid.h"

namespace nadir {

/// How a world is raised from a map. A share is that of the squares with suitable ground that get
/// one such thing.
struct WorldOptions {
  double curb_height_m = 0.12;
  double tree_share = 0.35;        ///< Of 8 m squares with open ground 1 to 6 m from a road.
  double pole_share = 0.5;         ///< Of 12 m squares with open ground 0.4 to 1.2 m from a road.
  double parked_car_share = 0.35;  ///< Of 7 m squares with a straight road edge.
  double moving_car_share = 0.2;   ///< Of 40 m squares with a straight run of road.
  double pedestrian_share = 0.35;  ///< Of 20 m squares with a straight run of open ground.
};

template <typename Options, typename Visitor>
requires std::same_as<std::remove_const_t<Options>, WorldOptions>
void visit_fields(Options& options, Visitor&& visit) {
  visit(options.curb_height_m,
        Field{"curb-height", "m", "Step from the road up to curb and ground behind it", 0, 0.5});
  visit(options.tree_share, Field{"tree-share", "", "Share of suitable places with a tree", 0, 1});
  visit(options.pole_share, Field{"pole-share", "", "Share of suitable places with a pole", 0, 1});
  visit(options.parked_car_share,
        Field{"parked-car-share", "", "Share of suitable places with a parked car", 0, 1});
  visit(options.moving_car_share,
        Field{"moving-car-share", "", "Share of suitable places with a moving car", 0, 1});
  visit(options.pedestrian_share,
        Field{"pedestrian-share", "", "Share of suitable places with a pedestrian", 0, 1});
}

/// A car or a pedestrian that goes to and fro on a straight line at constant speed, turning on the
/// spot. It knows nothing of other things and passes through them.
struct Mover {
  std::vector<Solid> parts;  ///< At the origin, heading east, standing on z = 0.
  Eigen::Vector2d from_in_enu_m = Eigen::Vector2d::Zero();
  Eigen::Vector2d to_in_enu_m = Eigen::Vector2d::Zero();
  double ground_m = 0.0;
  double speed_mps = 1.0;
  double phase_m = 0.0;  ///< Way gone at time 0.

  /// Adds the parts as they stand at a time.
  void place(double time_s, std::vector<Solid>& solids) const;
};

/// A made-up place with known truth: the relief of a map and things that the map does not show.
struct World {
  OverheadMap map;  ///< Outside of it the ground is unclassified at z = 0.
  Relief relief;
  std::vector<Solid> standing;  ///< Trees, poles, street lights, parked cars.
  std::vector<Mover> moving;    ///< Cars on roads, pedestrians on open ground.

  /// All solids as they stand at a time.
  [[nodiscard]] std::vector<Solid> solids_at(double time_s) const;
};

/// Raises a world from the labels of a map (see Relief) and furnishes it with trees, poles, cars
/// and pedestrians. The same map, options and seed give the same world.
[[nodiscard]] World raise_world(const OverheadMap& map,
                                const WorldOptions& options,
                                std::uint64_t seed);

}  // namespace nadir
