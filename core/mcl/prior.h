// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <variant>

#include "core/base/result.h"
#include "core/map/overhead_map.h"
#include "core/mcl/particle_set.h"

namespace nadir {

/// The body starts near here. The default spread is the thesis's: covariance diag(5, 5, 0.25).
struct GaussianPrior {
  Rigid2 mean_in_enu;
  double position_sigma_m = 2.23606797749979;  ///< sqrt(5), along each axis.
  double yaw_sigma_rad = 0.5;
};
/// The body may be anywhere on the map, heading anywhere.
struct GlobalPrior {};
using Prior = std::variant<GaussianPrior, GlobalPrior>;

/// Draws `count` particles of equal weight from the prior (thesis 3.5, step 1).
/// @errors kInvalidOptions: NaN or negative spread, or a Gaussian whose mean lies off the map.
[[nodiscard]] Result<ParticleSet> draw_particles(const Prior& prior,
                                                 const OverheadMap& map,
                                                 int count,
                                                 std::uint64_t seed);

}  // namespace nadir
