// SPDX-License-Identifier: Apache-2.0
#include "core/sim/world.h"

#include <cmath>

#include "core/sim/world_objects.h"

namespace nadir {

void Mover::place(double time_s, std::vector<Solid>& solids) const {
  const Eigen::Vector2d way = to_in_enu_m - from_in_enu_m;
  const double length_m = way.norm();
  if (length_m == 0.0) return;
  const double gone_m = std::fmod(phase_m + speed_mps * time_s, 2.0 * length_m);
  const bool is_outward = gone_m <= length_m;
  const Eigen::Vector2d along = way / length_m;
  const Eigen::Vector2d heading = is_outward ? along : Eigen::Vector2d(-along);
  const Eigen::Vector2d place_in_enu_m =
      from_in_enu_m + along * (is_outward ? gone_m : 2.0 * length_m - gone_m);
  for (Solid part : parts) {
    const Eigen::Vector3d offset = part.centre_in_enu_m;
    part.centre_in_enu_m.x() =
        place_in_enu_m.x() + heading.x() * offset.x() - heading.y() * offset.y();
    part.centre_in_enu_m.y() =
        place_in_enu_m.y() + heading.y() * offset.x() + heading.x() * offset.y();
    part.centre_in_enu_m.z() = ground_m + offset.z();
    part.heading = heading;
    solids.push_back(part);
  }
}

std::vector<Solid> World::solids_at(double time_s) const {
  std::vector<Solid> solids = standing;
  for (const Mover& mover : moving) mover.place(time_s, solids);
  return solids;
}

World raise_world(const OverheadMap& map, const WorldOptions& options, std::uint64_t seed) {
  World world{.map = map,
              .relief = raise_relief(map, options.curb_height_m, seed),
              .standing = {},
              .moving = {}};
  const Ground ground(map, world.relief);
  add_trees(ground, options.tree_share, seed, world.standing);
  add_poles(ground, options.pole_share, seed, world.standing);
  add_parked_cars(ground, options.parked_car_share, seed, world.standing);
  add_moving_cars(ground, options.moving_car_share, seed, world.moving);
  add_pedestrians(ground, options.pedestrian_share, seed, world.moving);
  return world;
}

}  // namespace nadir
