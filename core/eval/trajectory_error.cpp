// SPDX-License-Identifier: Apache-2.0
#include "core/eval/trajectory_error.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/angle.h"
#include "core/base/require.h"

namespace nadir {
namespace {

constexpr std::array<double, 3> kSegmentsM = {100.0, 50.0, 10.0};

double recall(std::span<const double> errors_m, double limit_m) {
  const auto hits = std::count_if(errors_m.begin(), errors_m.end(),
                                  [&](double error_m) { return error_m <= limit_m; });
  return static_cast<double>(hits) / static_cast<double>(errors_m.size());
}

std::optional<RelativeError> relative_error(std::span<const PosePair> pairs) {
  const std::vector<double> path_m = travelled_m(pairs);
  const auto* const length = std::find_if(kSegmentsM.begin(), kSegmentsM.end(),
                                          [&](double m) { return path_m.back() >= 2.0 * m; });
  if (length == kSegmentsM.end()) return std::nullopt;
  RelativeError sum{.segment_m = *length};
  std::size_t end = 0;
  for (std::size_t begin = 0; begin < pairs.size(); ++begin) {
    while (end < pairs.size() && path_m[end] - path_m[begin] < sum.segment_m) ++end;
    if (end == pairs.size()) break;
    const Rigid2 true_motion = pairs[begin].truth_in_enu.inverse() * pairs[end].truth_in_enu;
    const Rigid2 said_motion = pairs[begin].estimate_in_enu.inverse() * pairs[end].estimate_in_enu;
    const Rigid2 error = true_motion.inverse() * said_motion;
    const double metres = path_m[end] - path_m[begin];
    sum.position_m_per_m += error.translation_m().norm() / metres;
    sum.orientation_rad_per_m += std::abs(error.yaw_rad) / metres;
    ++sum.segments;
  }
  sum.position_m_per_m /= static_cast<double>(sum.segments);
  sum.orientation_rad_per_m /= static_cast<double>(sum.segments);
  return sum;
}

}  // namespace

Eigen::Vector3d pose_error(const Rigid2& estimate_in_enu, const Rigid2& truth_in_enu) {
  return {estimate_in_enu.x_m - truth_in_enu.x_m, estimate_in_enu.y_m - truth_in_enu.y_m,
          wrap_rad(estimate_in_enu.yaw_rad - truth_in_enu.yaw_rad)};
}

double order_statistic(std::span<const double> sorted, double share) {
  NADIR_REQUIRE(!sorted.empty() && share >= 0.0 && share <= 1.0);
  const double position = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(position);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  const double weight = position - static_cast<double>(below);
  return sorted[below] + weight * (sorted[above] - sorted[below]);
}

ErrorStatistics summarise_errors(std::vector<double> errors) {
  NADIR_REQUIRE(!errors.empty());
  ErrorStatistics statistics;
  for (double& error : errors) {
    error = std::abs(error);
    statistics.mean += error;
    statistics.mean_square += error * error;
  }
  const auto count = static_cast<double>(errors.size());
  statistics.mean /= count;
  statistics.mean_square /= count;
  statistics.root_mean_square = std::sqrt(statistics.mean_square);
  std::sort(errors.begin(), errors.end());
  statistics.median = order_statistic(errors, 0.5);
  statistics.p90 = order_statistic(errors, 0.9);
  statistics.maximum = errors.back();
  return statistics;
}

std::vector<double> travelled_m(std::span<const PosePair> pairs) {
  std::vector<double> path_m;
  path_m.reserve(pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    path_m.push_back(i == 0 ? 0.0
                            : path_m.back() + (pairs[i].truth_in_enu.translation_m() -
                                               pairs[i - 1].truth_in_enu.translation_m())
                                                  .norm());
  }
  return path_m;
}

std::optional<PoseErrorSummary> summarise_pose_errors(std::span<const PosePair> pairs) {
  if (pairs.empty()) return std::nullopt;
  std::vector<double> position_m, orientation_rad, longitudinal_m, lateral_m;
  for (const PosePair& pair : pairs) {
    const Eigen::Vector3d error = pose_error(pair.estimate_in_enu, pair.truth_in_enu);
    const Eigen::Vector2d error_in_enu = error.head<2>();
    const Eigen::Vector2d error_in_body =
        Rigid2{0.0, 0.0, -pair.truth_in_enu.yaw_rad} * error_in_enu;
    position_m.push_back(error_in_enu.norm());
    orientation_rad.push_back(std::abs(error.z()));
    longitudinal_m.push_back(error_in_body.x());
    lateral_m.push_back(error_in_body.y());
  }
  PoseErrorSummary summary;
  summary.matched_pairs = pairs.size();
  summary.recall_1m = recall(position_m, 1.0);
  summary.recall_3m = recall(position_m, 3.0);
  summary.recall_5m = recall(position_m, 5.0);
  summary.position_m = summarise_errors(std::move(position_m));
  summary.orientation_rad = summarise_errors(std::move(orientation_rad));
  summary.longitudinal_m = summarise_errors(std::move(longitudinal_m));
  summary.lateral_m = summarise_errors(std::move(lateral_m));
  summary.relative = relative_error(pairs);
  return summary;
}

}  // namespace nadir
