// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <span>

#include "core/eval/evaluated_step.h"

namespace nadir {

/// Does the filter know how wrong it is? Over the steps whose truth is known.
struct Consistency {
  std::size_t nees_steps = 0;  ///< Steps that entered the mean.
  std::size_t excluded_steps =
      0;  ///< Covariance singular, not finite or no covariance, so no NEES.
  std::optional<double>
      nees_mean;  ///< 3 for a consistent filter (3 degrees of freedom), more if over-confident.
  std::optional<double> nees_lower_95,
      nees_upper_95;  ///< Where the mean of that many *independent* steps would lie
                      ///< 95 times in 100. Steps of a flight are correlated in time, so
                      ///< a mean just outside says little.
  std::size_t coverage_steps = 0;  ///< Steps behind the coverage: all whose truth is known and
                                   ///< whose ellipse is_ellipse_known().
  std::size_t coverage_excluded_steps = 0;  ///< The others whose truth is known.
  std::optional<double>
      coverage_95;  ///< Share of them whose true position is inside the 95 % ellipse: 0.95 if
                    ///< consistent. A singular ellipse has no inside, so a filter that has
                    ///< collapsed to a point does not look better for it.
};

/// Squared Mahalanobis distance e' P^-1 e: chi-square distributed with as many degrees of freedom
/// as e has elements. The three-element form is the normalised estimation error squared (NEES) of a
/// pose.
/// @param error       Estimate minus truth; yaw wrapped by the caller.
/// @returns nothing where the covariance is not finite, not symmetric (to 1e-9 of its standard
/// deviations), not positive definite, or singular: the
/// determinant of its
///          correlation matrix is below 1e-12, a test that does not depend on units.
[[nodiscard]] std::optional<double> normalised_error_squared(const Eigen::Vector3d& error,
                                                             const Eigen::Matrix3d& covariance);
[[nodiscard]] std::optional<double> normalised_error_squared(const Eigen::Vector2d& error,
                                                             const Eigen::Matrix2d& covariance);

/// Spread of the position, sqrt(det) of the covariance of x and y, in m^2: the area of the ellipse of
/// one standard deviation divided by pi. 0 where the covariance is singular, also where rounding makes
/// the determinant of a singular one a little negative. @returns infinity where the covariance is
/// none: not finite, a negative variance, a correlation above 1, or not symmetric.
[[nodiscard]] double position_spread_m2(const Eigen::Matrix3d& covariance);

/// Whether somebody knew a covariance of the position: false where a number of it is not finite, as in a step that was
/// recorded without one. Such a step says nothing about calibration, while a singular ellipse has no inside.
[[nodiscard]] bool is_ellipse_known(const Eigen::Matrix3d& covariance);

/// Value below which a chi-square variable of so many degrees of freedom lies with the given
/// probability.
/// @param probability  In (0, 1).   @param degrees_of_freedom  Above 0.
[[nodiscard]] double chi_square_quantile(double probability, double degrees_of_freedom);

/// Between which the NEES of one step of a consistent filter lies 95 times in 100: the chi-square quantiles of 2.5 and 97.5 %
/// for x, y and heading, about 0.22 and 9.35; above the upper one a step is called over-confident, below the lower one it is
/// cautious, which harms nobody. One step outside of them proves nothing: one in twenty of a consistent filter is. Of the mean
/// of many steps see Consistency.
struct StepNeesBounds {
  double lower = 0.0, upper = 0.0;
  int degrees_of_freedom = 3;
};
[[nodiscard]] StepNeesBounds step_nees_bounds();

/// Whether one estimate knew how wrong it was.
struct StepConsistency {
  std::optional<double> nees;    ///< Nothing where normalised_error_squared() gives nothing.
  bool is_inside_95 = false;     ///< The true position is inside the 95 % ellipse: d^2 <= 5.991. A
                                 ///< singular ellipse has no inside, nor has one that is not known.
  bool is_ellipse_known = true;  ///< As is_ellipse_known() says; else the step tells no coverage.
};
/// @param error  Estimate minus truth, as pose_error() gives it.
[[nodiscard]] StepConsistency assess_step(const Eigen::Vector3d& error,
                                          const Eigen::Matrix3d& covariance);

/// NEES with bounds and the coverage of the 95 % position ellipse: the share with d^2 <=
/// chi2_2(0.95) = 5.991, where d is the Mahalanobis distance, of the steps with a covariance. See Bar-Shalom, Li & Kirubarajan
/// 2001, section 5.4.
[[nodiscard]] Consistency assess_consistency(std::span<const EvaluatedStep> steps);

}  // namespace nadir
