// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <functional>

namespace nadir {

/// What is known of a pose before anything is seen, and where the search for the spread begins.
struct SpreadRule {
  double position_sigma_m = 3.0;  ///< Before; no result is larger.
  double yaw_sigma_rad = 0.2;
  double first_position_m = 0.5;  ///< As far as it is less than that.
  double first_yaw_rad = 0.05;
};

/// The Gaussian that comes nearest to the weights that an error gives to the poses around one.
///
/// Of all Gaussians around the pose with covariance S the one next to prior x exp(-error) in Kullback-Leibler divergence has
///   S^-1 = S_prior^-1 + E[ second derivative of the error ],  the mean taken over the Gaussian itself
/// (Opper & Archambeau 2009), and by partial integration that mean is
///   E[ (S^-1 d d^T S^-1 - S^-1) error(d) ],
/// which needs values only: an error with kinks, or in steps as small as cells, is as good as a smooth one. For a quadratic error the
/// result is exact; at a kink, as of exp(-|x|), it is right within a fifth; where the error says nothing it is the prior. Found by repeating that step, with means over 52 poses
/// (two shells of 26 directions, exact for polynomials of degree 5), at most 2.86 deviations away, beginning small, so that the hill around the pose itself is
/// measured and not one beside it.
///
/// @param error  Of a pose that lies at an offset (x, y in metres, yaw in radians) from the one in question: minus the
///               logarithm of the weight, up to a constant.
/// @returns      Covariance of x, y, yaw.
[[nodiscard]] Eigen::Matrix3d pose_spread(
    const std::function<double(const Eigen::Vector3d& offset)>& error, const SpreadRule& rule);

}  // namespace nadir
