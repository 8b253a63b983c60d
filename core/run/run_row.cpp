// SPDX-License-Identifier: Apache-2.0
#include "core/run/run_row.h"

#include <Eigen/Eigenvalues>
#include <array>
#include <cmath>
#include <limits>

#include "core/eval/evaluated_step.h"

namespace nadir::detail {
namespace {

constexpr double kFarthestMetres = 1e8;
constexpr double kRounding = 1e-6;  // Of a correlation.
constexpr double kTiniest = std::numeric_limits<double>::min();

constexpr std::array<std::pair<int, int>, 6> kUpperTriangle = {
    {{0, 0}, {0, 1}, {0, 2}, {1, 1}, {1, 2}, {2, 2}}};

}  // namespace

void RunRow::refuse(const std::string& what) {
  if (fault_.empty()) fault_ = what;
}

void RunRow::refuse(int column, const char* what) {
  const std::string value = row_.is_null(column) ? "NULL" : row_.text(column).substr(0, 40);
  refuse(fmt::format("{} is {}, {}", row_.column_name(column), value, what));
}

Result<void> RunRow::checked() const {
  if (fault_.empty()) return {};
  return fail(ErrorCode::kMalformed, "{}: {}", where_, fault_);
}

double RunRow::number_or_null(int column) {
  if (!row_.is_null(column) && !row_.is_number(column)) refuse(column, "not a number");
  return row_.number(column);
}

double RunRow::number(int column) {
  const double value = number_or_null(column);
  if (!std::isfinite(value)) refuse(column, "not a finite number");
  return value;
}

double RunRow::amount_if_known(int column) {
  const double value = number_or_null(column);
  if (value < 0.0 || std::isinf(value)) refuse(column, "not a finite number from 0 up");
  return value;
}

double RunRow::share(int column, bool may_be_unknown) {
  const double value = may_be_unknown ? number_or_null(column) : number(column);
  if (value < 0.0 || value > 1.0 + kRounding) refuse(column, "not a share from 0 to 1");
  return value;
}

int RunRow::count(int column) {
  const std::int64_t value = row_.whole(column);
  if (!row_.is_whole(column) || value < 0 || value > std::numeric_limits<int>::max()) {
    refuse(column, "not a whole number from 0 to 2147483647");
    return 0;
  }
  return static_cast<int>(value);
}

Rigid2 RunRow::pose(int column) {
  const Rigid2 pose{number(column), number(column + 1), number(column + 2)};
  for (const int at : {column, column + 1}) {
    if (std::abs(row_.number(at)) > kFarthestMetres) refuse(at, "farther than any place on Earth");
  }
  return pose;
}

std::optional<Rigid2> RunRow::pose_if_known(int column) {
  if (row_.is_null(column) && row_.is_null(column + 1) && row_.is_null(column + 2)) {
    return std::nullopt;
  }
  return pose(column);
}

PoseMoments RunRow::moments(int column) {
  PoseMoments moments{.mean = pose(column)};
  int next = column + 3;
  for (const auto& [i, j] : kUpperTriangle) {
    const double value = number_or_null(next);
    if (i == j && value < 0.0) refuse(next, "and a variance is not negative");
    moments.covariance(i, j) = value;
    moments.covariance(j, i) = value;
    ++next;
  }
  check(moments.covariance, column + 3);
  return moments;
}

/// Every pair of columns whose values are known, then all three together.
void RunRow::check(const Eigen::Matrix3d& covariance, int first_column) {
  int column = first_column;
  for (const auto& [i, j] : kUpperTriangle) {
    const double largest = std::sqrt(covariance(i, i)) * std::sqrt(covariance(j, j));
    if (i != j && std::abs(covariance(i, j)) > largest * (1.0 + kRounding) + kTiniest) {
      refuse(column, "more than the two variances allow");
    }
    ++column;
  }
  if (!covariance.allFinite() || !(covariance.diagonal().array() > 0.0).all()) return;
  const Eigen::Vector3d one_by_sigma = covariance.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::Matrix3d correlation =
      one_by_sigma.asDiagonal() * covariance * one_by_sigma.asDiagonal();
  if (!correlation.allFinite()) return;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(correlation, Eigen::EigenvaluesOnly);
  if (solver.eigenvalues().minCoeff() < -kRounding) {
    refuse("its six covariances contradict each other (the matrix has a negative eigenvalue)");
  }
}

}  // namespace nadir::detail
