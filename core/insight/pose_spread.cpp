// SPDX-License-Identifier: Apache-2.0
#include "core/insight/pose_spread.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>

namespace nadir {
namespace {

constexpr int kMostRounds = 9;
constexpr int kRoundsToAverage =
    3;  ///< The last ones, where it swings: errors come in steps of cells.
constexpr double kSettled = 0.05;     ///< No variance changes by a greater part of itself.
constexpr double kMostGrowth = 16.0;  ///< Of a variance, in one round.

struct SpreadNode {
  Eigen::Vector3d place;  ///< In standard deviations.
  double weight;
};

/// Means over the standard Gaussian in three dimensions: Lebedev's 26 directions, exact to degree 7, on two shells of Gauss's
/// rule for the squared radius (generalised Laguerre, alpha = 1/2).
std::array<SpreadNode, 52> spread_nodes() {
  const double root = std::sqrt(10.0);
  const std::array<double, 2> half_squares = {(5.0 - root) / 2.0, (5.0 + root) / 2.0};
  const double weight_of_far = (1.5 - half_squares[0]) / (half_squares[1] - half_squares[0]);
  const std::array<double, 2> weights = {1.0 - weight_of_far, weight_of_far};
  constexpr std::array<double, 4> kWeightOfKind = {0.0, 1.0 / 21.0, 4.0 / 105.0, 9.0 / 280.0};
  std::array<SpreadNode, 52> nodes;
  std::size_t count = 0;
  for (std::size_t shell = 0; shell < 2; ++shell) {
    for (int x = -1; x <= 1; ++x) {
      for (int y = -1; y <= 1; ++y) {
        for (int z = -1; z <= 1; ++z) {
          const int kind = std::abs(x) + std::abs(y) + std::abs(z);
          if (kind == 0) continue;
          nodes[count++] = {Eigen::Vector3d(x, y, z) * std::sqrt(2.0 * half_squares[shell] / kind),
                            weights[shell] * kWeightOfKind[static_cast<std::size_t>(kind)]};
        }
      }
    }
  }
  return nodes;
}

/// One step of the iteration. @param root  Of the covariance: offset = root * standard deviations.
/// @returns by how much variances have changed, along axes of its own.
Eigen::Vector3d improve(Eigen::Matrix3d& root,
                        const std::function<double(const Eigen::Vector3d& offset)>& error,
                        const Eigen::Vector3d& prior_information) {
  static const std::array<SpreadNode, 52> nodes = spread_nodes();
  Eigen::Matrix3d curvature = Eigen::Matrix3d::Zero();
  for (const SpreadNode& node : nodes) {
    curvature += node.weight * error(root * node.place) *
                 (node.place * node.place.transpose() - Eigen::Matrix3d::Identity());
  }
  // In standard deviations of this round. Nothing that was seen makes a pose less sure than it was before.
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> seen(curvature);
  const Eigen::Matrix3d whitened = seen.eigenvectors() *
                                       seen.eigenvalues().cwiseMax(0.0).asDiagonal() *
                                       seen.eigenvectors().transpose() +
                                   root.transpose() * prior_information.asDiagonal() * root;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(whitened);
  Eigen::Vector3d growth =
      solver.eigenvalues().cwiseMax(1.0 / kMostGrowth).cwiseMin(kMostGrowth).cwiseInverse();
  root = root * solver.eigenvectors() * growth.cwiseSqrt().asDiagonal();
  return growth;
}

}  // namespace

Eigen::Matrix3d pose_spread(const std::function<double(const Eigen::Vector3d& offset)>& error,
                            const SpreadRule& rule) {
  const Eigen::Vector3d prior_information(1.0 / (rule.position_sigma_m * rule.position_sigma_m),
                                          1.0 / (rule.position_sigma_m * rule.position_sigma_m),
                                          1.0 / (rule.yaw_sigma_rad * rule.yaw_sigma_rad));
  Eigen::Matrix3d root = Eigen::Vector3d(std::min(rule.first_position_m, rule.position_sigma_m),
                                         std::min(rule.first_position_m, rule.position_sigma_m),
                                         std::min(rule.first_yaw_rad, rule.yaw_sigma_rad))
                             .asDiagonal();
  Eigen::Matrix3d information_sum = Eigen::Matrix3d::Zero();
  for (int round = 0; round < kMostRounds; ++round) {
    const Eigen::Vector3d growth = improve(root, error, prior_information);
    if ((growth.array() - 1.0).abs().maxCoeff() <= kSettled) return root * root.transpose();
    if (round >= kMostRounds - kRoundsToAverage) {
      information_sum += (root * root.transpose()).inverse() / kRoundsToAverage;
    }
  }
  return information_sum.inverse();
}

}  // namespace nadir
