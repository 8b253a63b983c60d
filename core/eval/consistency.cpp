// SPDX-License-Identifier: Apache-2.0
#include "core/eval/consistency.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <limits>

#include "core/base/require.h"
#include "core/eval/trajectory_error.h"

namespace nadir {
namespace {

constexpr double kSingularBelow = 1e-12;
constexpr double kSymmetricTo = 1e-9;  // Correlations.
constexpr double kRounding = 1e-9;     // Of 1 - correlation^2.

template <int size>
std::optional<double> squared_distance(const Eigen::Matrix<double, size, 1>& error,
                                       const Eigen::Matrix<double, size, size>& covariance) {
  if (!error.allFinite() || !covariance.allFinite()) return std::nullopt;
  if (!(covariance.diagonal().array() > 0.0).all()) return std::nullopt;
  using Vector = Eigen::Matrix<double, size, 1>;
  const Vector one_by_sigma = covariance.diagonal().array().sqrt().inverse();
  if (!one_by_sigma.allFinite()) return std::nullopt;
  const Eigen::Matrix<double, size, size> correlation =
      one_by_sigma.asDiagonal() * covariance * one_by_sigma.asDiagonal();
  if (!((correlation - correlation.transpose()).array().abs() <= kSymmetricTo).all()) {
    return std::nullopt;
  }
  const Eigen::LLT<Eigen::Matrix<double, size, size>> cholesky(correlation);
  if (cholesky.info() != Eigen::Success) return std::nullopt;
  const double root_of_determinant = cholesky.matrixLLT().diagonal().prod();
  if (!(root_of_determinant * root_of_determinant >= kSingularBelow)) return std::nullopt;
  const Vector scaled_error = one_by_sigma.cwiseProduct(error);
  const double squared = cholesky.matrixL().solve(scaled_error).squaredNorm();
  if (!std::isfinite(squared)) return std::nullopt;
  return squared;
}

}  // namespace

std::optional<double> normalised_error_squared(const Eigen::Vector3d& error,
                                               const Eigen::Matrix3d& covariance) {
  return squared_distance<3>(error, covariance);
}

std::optional<double> normalised_error_squared(const Eigen::Vector2d& error,
                                               const Eigen::Matrix2d& covariance) {
  return squared_distance<2>(error, covariance);
}

double position_spread_m2(const Eigen::Matrix3d& covariance) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  const double xx = covariance(0, 0);
  const double yy = covariance(1, 1);
  const double largest = std::sqrt(xx) * std::sqrt(yy);  // NaN where a variance is negative
  if (!std::isfinite(largest) || xx < 0.0 || yy < 0.0) return kNone;
  if (!(std::abs(covariance(0, 1) - covariance(1, 0)) <= kSymmetricTo * largest)) return kNone;
  if (largest == 0.0) return 0.0;
  const double correlation = covariance(0, 1) / largest;
  const double uncorrelated = 1.0 - correlation * correlation;
  if (!(uncorrelated >= -kRounding)) return kNone;
  return largest * std::sqrt(std::max(uncorrelated, 0.0));
}

bool is_ellipse_known(const Eigen::Matrix3d& covariance) {
  return covariance.topLeftCorner<2, 2>().allFinite();
}

double chi_square_quantile(double probability, double degrees_of_freedom) {
  NADIR_REQUIRE(probability > 0.0 && probability < 1.0 && degrees_of_freedom > 0.0);
  return boost::math::quantile(boost::math::chi_squared(degrees_of_freedom), probability);
}

StepNeesBounds step_nees_bounds() {
  StepNeesBounds bounds;
  bounds.lower = chi_square_quantile(0.025, bounds.degrees_of_freedom);
  bounds.upper = chi_square_quantile(0.975, bounds.degrees_of_freedom);
  return bounds;
}

StepConsistency assess_step(const Eigen::Vector3d& error, const Eigen::Matrix3d& covariance) {
  static const double ellipse_limit = chi_square_quantile(0.95, 2.0);
  const Eigen::Vector2d position_error = error.head<2>();
  const Eigen::Matrix2d position_covariance = covariance.topLeftCorner<2, 2>();
  const auto squared = normalised_error_squared(position_error, position_covariance);
  return {.nees = normalised_error_squared(error, covariance),
          .is_inside_95 = squared && *squared <= ellipse_limit,
          .is_ellipse_known = is_ellipse_known(covariance)};
}

Consistency assess_consistency(std::span<const EvaluatedStep> steps) {
  Consistency result;
  double nees_sum = 0.0;
  std::size_t inside = 0;
  for (const EvaluatedStep& step : steps) {
    if (!step.truth_in_enu) continue;
    const StepConsistency found =
        assess_step(pose_error(step.estimate_in_enu, *step.truth_in_enu), step.covariance);
    if (found.nees) {
      nees_sum += *found.nees;
      ++result.nees_steps;
    } else {
      ++result.excluded_steps;
    }
    if (!found.is_ellipse_known) {
      ++result.coverage_excluded_steps;
      continue;
    }
    inside += found.is_inside_95 ? 1U : 0U;
    ++result.coverage_steps;
  }
  if (result.nees_steps > 0) {
    const auto count = static_cast<double>(result.nees_steps);
    result.nees_mean = nees_sum / count;
    result.nees_lower_95 = chi_square_quantile(0.025, 3.0 * count) / count;
    result.nees_upper_95 = chi_square_quantile(0.975, 3.0 * count) / count;
  }
  if (result.coverage_steps > 0) {
    result.coverage_95 = static_cast<double>(inside) / static_cast<double>(result.coverage_steps);
  }
  return result;
}

}  // namespace nadir
