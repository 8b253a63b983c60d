// SPDX-License-Identifier: Apache-2.0
#include "core/eval/run_evaluation.h"

#include <cmath>
#include <vector>

namespace nadir {
namespace {

bool is_matched(const EvaluatedStep& step) {
  return step.truth_in_enu && is_finite(*step.truth_in_enu) && is_finite(step.estimate_in_enu) &&
         (!step.odometry_in_enu || is_finite(*step.odometry_in_enu));
}

std::vector<PosePair> estimate_pairs(std::span<const EvaluatedStep> steps) {
  std::vector<PosePair> pairs;
  pairs.reserve(steps.size());
  for (const EvaluatedStep& step : steps) {
    pairs.push_back({step.time_s, step.estimate_in_enu, *step.truth_in_enu});
  }
  return pairs;
}

/// Of the steps that have odometry in the plane: all or none of a run.
std::vector<PosePair> odometry_pairs(std::span<const EvaluatedStep> steps) {
  std::vector<PosePair> pairs;
  for (const EvaluatedStep& step : steps) {
    if (step.odometry_in_enu)
      pairs.push_back({step.time_s, *step.odometry_in_enu, *step.truth_in_enu});
  }
  return pairs;
}

Result<Similarity2> find_alignment(std::span<const PosePair> pairs, Alignment alignment) {
  if (alignment == Alignment::kNone) return Similarity2{};
  std::vector<Eigen::Vector2d> points_from, points_to;
  for (const PosePair& pair : pairs) {
    points_from.push_back(pair.estimate_in_enu.translation_m());
    points_to.push_back(pair.truth_in_enu.translation_m());
  }
  if (alignment == Alignment::kSim2) return align_similarity2(points_from, points_to);
  const auto rigid = align_rigid2(points_from, points_to);
  if (!rigid) return forward_error(rigid);
  return Similarity2{.scale = 1.0, .rigid = *rigid};
}

Eigen::Matrix3d aligned_covariance(const Similarity2& alignment,
                                   const Eigen::Matrix3d& covariance) {
  const double c = alignment.scale * std::cos(alignment.rigid.yaw_rad);
  const double s = alignment.scale * std::sin(alignment.rigid.yaw_rad);
  Eigen::Matrix3d jacobian = Eigen::Matrix3d::Identity();
  jacobian.topLeftCorner<2, 2>() << c, -s, s, c;
  return jacobian * covariance * jacobian.transpose();
}

void describe_time(RunEvaluation& evaluation, std::span<const EvaluatedStep> steps) {
  if (steps.empty()) return;
  evaluation.duration_s = steps.back().time_s - steps.front().time_s;
  if (evaluation.duration_s > 0.0) {
    evaluation.update_rate_hz = static_cast<double>(steps.size() - 1) / evaluation.duration_s;
  }
  double sum_ms = 0.0;
  std::size_t timed = 0;
  for (const EvaluatedStep& step : steps) {
    if (!std::isfinite(step.update_ms)) continue;
    sum_ms += step.update_ms;
    ++timed;
  }
  if (timed > 0) evaluation.computing_ms_mean = sum_ms / static_cast<double>(timed);
}

}  // namespace

std::optional<Alignment> alignment_from_name(std::string_view name) {
  for (const Alignment alignment : {Alignment::kNone, Alignment::kSe2, Alignment::kSim2}) {
    if (enum_name(alignment) == name) return alignment;
  }
  return std::nullopt;
}

Result<RunEvaluation> evaluate_steps(std::span<const EvaluatedStep> steps, Alignment alignment) {
  RunEvaluation evaluation;
  evaluation.steps = steps.size();
  evaluation.alignment = alignment;
  describe_time(evaluation, steps);
  std::vector<EvaluatedStep> matched;
  for (const EvaluatedStep& step : steps) {
    if (is_matched(step)) matched.push_back(step);
  }
  evaluation.matched_pairs = matched.size();
  evaluation.dropped_steps = steps.size() - matched.size();
  if (matched.empty() && alignment == Alignment::kNone) return evaluation;

  const auto enu_from_estimate = find_alignment(estimate_pairs(matched), alignment);
  if (!enu_from_estimate) return forward_error(enu_from_estimate, "estimate cannot be aligned");
  std::vector<PosePair> odometry = odometry_pairs(matched);
  const auto enu_from_odometry =
      find_alignment(odometry, odometry.empty() ? Alignment::kNone : alignment);
  if (!enu_from_odometry) return forward_error(enu_from_odometry, "odometry cannot be aligned");
  evaluation.estimate_alignment = *enu_from_estimate;
  evaluation.odometry_alignment = *enu_from_odometry;
  if (alignment != Alignment::kNone) {
    for (EvaluatedStep& step : matched) {
      step.estimate_in_enu = *enu_from_estimate * step.estimate_in_enu;
      step.covariance = aligned_covariance(*enu_from_estimate, step.covariance);
    }
    for (PosePair& pair : odometry)
      pair.estimate_in_enu = *enu_from_odometry * pair.estimate_in_enu;
  }
  const std::vector<PosePair> estimate = estimate_pairs(matched);
  evaluation.estimate = summarise_pose_errors(estimate);
  evaluation.odometry = summarise_pose_errors(odometry);
  evaluation.distance_m = travelled_m(estimate).back();
  evaluation.consistency = assess_consistency(matched);
  evaluation.convergence = find_convergence(matched);
  if (evaluation.convergence.after_s) {  // The clock starts with the run, not with the first truth.
    *evaluation.convergence.after_s += matched.front().time_s - steps.front().time_s;
  }
  return evaluation;
}

}  // namespace nadir
