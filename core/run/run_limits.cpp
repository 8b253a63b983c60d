// SPDX-License-Identifier: Apache-2.0
#include "core/run/run_limits.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace nadir::detail {
namespace {

constexpr double kFarthestMetres = 1e8;
constexpr double kRounding = 1e-6;  // Of a correlation or a share.
constexpr double kTiniest = std::numeric_limits<double>::min();

constexpr std::array<std::pair<int, int>, 6> kUpperTriangle = {
    {{0, 0}, {0, 1}, {0, 2}, {1, 1}, {1, 2}, {2, 2}}};

/// Looks at values in turn and keeps the first that is none.
class Search {
 public:
  void number(int column, double value) {
    need(std::isfinite(value), column, value, "not a finite number");
  }
  void amount_if_known(int column, double value) {
    need(!(value < 0.0 || std::isinf(value)), column, value, "not a finite number from 0 up");
  }
  void share_if_known(int column, double value) {
    need(!(value < 0.0 || value > 1.0 + kRounding), column, value, "not a share from 0 to 1");
  }
  void count(int column, int value) { need(value >= 0, column, value, kNoCount); }

  void pose(int column, const Rigid2& value) {
    place(column, value.x_m);
    place(column + 1, value.y_m);
    number(column + 2, value.yaw_rad);
  }

  void moments(int column, const PoseMoments& value) {
    pose(column, value.mean);
    covariances(column + 3, value.covariance);
  }

  [[nodiscard]] const std::optional<RunFault>& found() const { return found_; }

 private:
  void need(bool holds, std::optional<int> column, double value, const char* what) {
    if (!holds && !found_) found_ = RunFault{column, value, what};
  }

  void place(int column, double value) {
    number(column, value);
    need(std::abs(value) <= kFarthestMetres, column, value, "farther than any place on Earth");
  }

  /// Every variance, every pair whose values are known, then all three together.
  void covariances(int first_column, const Eigen::Matrix3d& covariance) {
    int column = first_column;
    for (const auto& [i, j] : kUpperTriangle) {
      const double value = covariance(i, j);
      if (i == j) need(!(value < 0.0), column, value, "and a variance is not negative");
      ++column;
    }
    column = first_column;
    for (const auto& [i, j] : kUpperTriangle) {
      const double value = covariance(i, j);
      const double largest = std::sqrt(covariance(i, i)) * std::sqrt(covariance(j, j));
      const bool is_excess = i != j && std::abs(value) > largest * (1.0 + kRounding) + kTiniest;
      need(!is_excess, column, value, "more than the two variances allow");
      ++column;
    }
    need(is_possible(covariance), std::nullopt, 0.0,
         "its six covariances contradict each other (the matrix has a negative eigenvalue)");
  }

  static bool is_possible(const Eigen::Matrix3d& covariance) {
    if (!covariance.allFinite() || !(covariance.diagonal().array() > 0.0).all()) return true;
    const Eigen::Vector3d one_by_sigma = covariance.diagonal().cwiseSqrt().cwiseInverse();
    const Eigen::Matrix3d correlation =
        one_by_sigma.asDiagonal() * covariance * one_by_sigma.asDiagonal();
    if (!correlation.allFinite()) return true;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(correlation,
                                                                Eigen::EigenvaluesOnly);
    return solver.eigenvalues().minCoeff() >= -kRounding;
  }

  std::optional<RunFault> found_;
};

/// The name at this place of a list "step, time_s, ...".
std::string_view column_name(std::string_view columns, int index) {
  constexpr std::string_view kBetween = ", ";
  for (; index > 0; --index) columns.remove_prefix(columns.find(kBetween) + kBetween.size());
  return columns.substr(0, columns.find(kBetween));
}

}  // namespace

std::optional<RunFault> fault_of(const RunStep& step) {
  Search search;
  search.count(0, step.step);
  search.number(1, step.time_s);
  search.pose(2, step.odom_from_body);
  if (step.odometry_in_enu) search.pose(5, *step.odometry_in_enu);
  if (step.truth_in_enu) search.pose(8, *step.truth_in_enu);
  search.moments(11, step.estimate.moments);
  search.amount_if_known(20, step.effective_sample_size);
  search.count(21, step.particle_count);
  if (step.agreement) search.share_if_known(23, *step.agreement);
  search.count(24, step.topview_cells);
  search.amount_if_known(25, step.update_ms);
  return search.found();
}

std::optional<RunFault> fault_of(const PoseMode& mode) {
  Search search;
  search.number(2, mode.mass);
  search.share_if_known(2, mode.mass);
  search.moments(3, mode.moments);
  return search.found();
}

std::string fault_text(const RunFault& fault, std::string_view columns) {
  if (!fault.column) return fault.what;
  return fmt::format("{} is {}, {}", column_name(columns, *fault.column), fault.value, fault.what);
}

}  // namespace nadir::detail
