// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>

#include "core/geo/rigid2.h"
#include "core/mcl/localiser_options.h"
#include "core/mcl/particle_set.h"

namespace nadir {

/// Relative pose change that the odometry reports (u_t), with the time it took.
struct OdometryStep {
  Rigid2 before_from_after;  ///< Pose of the body after the step in the body frame before it.
  double elapsed_s = 0.0;    ///< Not negative.

  [[nodiscard]] double way_m() const {
    return std::hypot(before_from_after.x_m, before_from_after.y_m);
  }
};

/// Moves every particle by the odometry's step plus its own noise (thesis 3.5, step 2).
///
/// kThesis: rot1, trans, rot2 each minus a Gaussian of fixed deviation (Thrun, Burgard & Fox 2005, table 5.6).
/// rot1 is the direction of travel in the frame before the step: the thesis's listing leaves out "- theta", the
/// book has it.
/// kScaled: the step in the body frame plus Gaussians along and across the way and of yaw, whose variances grow
/// with elapsed time, way and turn, so that halving the step halves the variance and the frame rate does not matter.
/// A step shorter than `hover_below_m` has no direction, so none is invented.
/// O(N), parallel; draws depend on (seed, step, particle) alone.
void predict(ParticleSet& particles,
             const OdometryStep& odometry,
             const LocaliserOptions& options,
             std::uint32_t step);

/// Adds zero-mean Gaussian noise to every pose (thesis 3.5, step 6), so that the set does not
/// collapse and keeps several hypotheses. The variance is that of one blur interval times elapsed /
/// interval, or of one blur where the interval is 0.
void blur(ParticleSet& particles,
          double elapsed_s,
          const LocaliserOptions& options,
          std::uint32_t step);

}  // namespace nadir
