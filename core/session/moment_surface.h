// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "core/mcl/error_surface.h"
#include "core/run/run_file.h"

namespace nadir {

/// A pose on the grid of an error surface, in samples: (0, 0, 0) is its first pose; need not be whole.
struct GridPlace {
  double x = 0.0, y = 0.0, yaw = 0.0;
};

/// The error surface around an estimate, cut through it: what "why here?" draws. An immutable value; made by one call that
/// may run in any thread.
struct MomentSurface {
  /// The volume. Its counts are odd and its centre is the estimate, so that the two cuts go through the estimate itself.
  ErrorSurface volume;
  /// At the estimate's yaw: count_x * count_y mean costs in [0, 1]; x fastest (west to east), then y (south to north).
  std::vector<float> plane;
  /// At the estimate's place: count_yaw mean costs, clockwise end first.
  std::vector<float> turn;
  /// For each x, y the least cost of all yaws, in the order of `plane`.
  std::vector<float> best_turn;

  float cost_at_estimate = 0.0F;
  float least_cost = 0.0F;  ///< Of the volume.
  Rigid2 least_in_enu;      ///< Where that is; of several the one nearest to the estimate.
  std::optional<GridPlace>
      truth;  ///< Where the truth lies on the grid; nothing where it is not known.
  bool is_truth_inside = false;         ///< Whether it lies between the grid's outermost samples.
  std::optional<double> cost_at_truth;  ///< At the truth itself, on the grid or not.

  /// Any pose in samples of this grid; its yaw goes the short way round from the centre's.
  [[nodiscard]] GridPlace place_of(const Rigid2& enu_from_body) const;
};

/// A grid of 63 x 63 x 37 poses (as many as 64 x 64 x 36), 2 degrees apart, and as many whole cells apart as come nearest to
/// 0.2 m: such a grid is fast. Where the step knows the truth, it is as much wider as the truth needs to lie on it, up to 1 m
/// and 10 degrees (the full circle) apart.
[[nodiscard]] ErrorSurfaceGrid moment_grid(const RunStep& step, double metres_per_cell);

/// Evaluates the matcher's own kernel around the step's estimate. O(poses x cells); below 100 ms on two cores for the default
/// grid. The same numbers on any number of threads.
/// @param grid  Counts must be odd.
/// @errors kInvalidOptions: the step has no topview, or one of other cells than the map's, or nothing that the map knows; an
///         even count; as error_surface().
[[nodiscard]] Result<MomentSurface> moment_surface(const RunStep& step,
                                                   const MapMatcher& matcher,
                                                   const ErrorSurfaceGrid& grid);
[[nodiscard]] Result<MomentSurface> moment_surface(const RunStep& step, const MapMatcher& matcher);

}  // namespace nadir
