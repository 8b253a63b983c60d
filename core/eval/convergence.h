// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/eval/evaluated_step.h"

namespace nadir {

/// When a localiser counts as converged, and when as lost again.
struct ConvergenceRule {
  double error_below_m = 3.0;    ///< Position error, and ...
  double spread_below_m2 = 2.0;  ///< ... sqrt(det(covariance of x and y)), both held ...
  double held_for_m = 20.0;      ///< ... over this much of the true path.
  double lost_from_m = 5.0;      ///< Position error that ends it.
};

/// Convergence does not latch: what is lost later is told too.
struct Convergence {
  std::optional<double>
      after_s;  ///< From the first step to the first that begins a converged stretch.
  std::optional<double>
      after_m;  ///< The same as true path, from the first step whose truth is known.
  std::size_t lost_stretches = 0;  ///< How often the error rose to `lost_from_m` after converging.
  double lost_m = 0.0;  ///< True path flown until converged again, or until the end of the flight.
};

/// A step at which a localiser became converged, or was lost after it had been.
struct TrackingChange {
  std::size_t step = 0;  ///< Index among all steps.
  bool is_found = false;
};

/// The moments behind find_convergence(), in order of time: found, lost, found and so on. The first is always found.
[[nodiscard]] std::vector<TrackingChange> find_tracking_changes(
    std::span<const EvaluatedStep> steps, const ConvergenceRule& rule = {});

/// Walks over the steps whose truth is known. A step converges if from there on the rule holds for
/// `held_for_m`; so nothing can converge in the last `held_for_m` of a flight. O(n).
[[nodiscard]] Convergence find_convergence(std::span<const EvaluatedStep> steps,
                                           const ConvergenceRule& rule = {});

}  // namespace nadir
