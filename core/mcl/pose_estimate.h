// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/geo/rigid2.h"
#include "core/mcl/particle_set.h"

namespace nadir {

/// Weighted mean and covariance of a cloud of poses. Order of the covariance: x, y (enu, m), yaw
/// (rad).
struct PoseMoments {
  Rigid2 mean;  ///< Yaw by the circular mean (thesis 3.9-3.12).
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< Yaw variance by -2 ln R (thesis 3.13).
};

/// One cluster of the posterior.
struct PoseMode {
  double mass = 0.0;  ///< Share of the weight, in (0, 1].
  PoseMoments moments;
};

/// What the filter says after a step.
struct PoseEstimate {
  PoseMoments moments;
  /// By falling mass; one where the posterior is one blob, none where no cluster holds a hundredth of the mass.
  std::vector<PoseMode> modes;
};

/// @param particles  Not empty. Sums in index order, so the result does not depend on threads.
[[nodiscard]] PoseMoments pose_moments(const ParticleSet& particles);

/// Clusters: particles fall into bins of the given size; occupied neighbouring bins belong
/// together. Clusters lighter than `min_mass` and all beyond the first `max_modes` are left out.
struct ModeOptions {
  double bin_m = 1.0;
  double bin_rad = 0.2;
  double min_mass = 0.01;
  int max_modes = 8;
};
[[nodiscard]] std::vector<PoseMode> find_modes(const ParticleSet& particles,
                                               const ModeOptions& options = {});

}  // namespace nadir
