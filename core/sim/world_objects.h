// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "core/sim/ground.h"
#include "core/sim/solid.h"
#include "core/sim/world.h"

namespace nadir {

// Each adds one kind of thing in a `share` of the squares with suitable ground (see WorldOptions);
// places, sizes and speeds are draws of the stream kWorldObjects, so they depend on map, seed and
// share alone.

void add_trees(const Ground& ground, double share, std::uint64_t seed, std::vector<Solid>& solids);
void add_poles(const Ground& ground, double share, std::uint64_t seed, std::vector<Solid>& solids);
void add_parked_cars(const Ground& ground,
                     double share,
                     std::uint64_t seed,
                     std::vector<Solid>& solids);
void add_moving_cars(const Ground& ground,
                     double share,
                     std::uint64_t seed,
                     std::vector<Mover>& movers);
void add_pedestrians(const Ground& ground,
                     double share,
                     std::uint64_t seed,
                     std::vector<Mover>& movers);

}  // namespace nadir
