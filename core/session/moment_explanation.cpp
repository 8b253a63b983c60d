// SPDX-License-Identifier: Apache-2.0
#include "core/session/moment_explanation.h"

#include <algorithm>
#include <cmath>

#include "core/base/angle.h"
#include "core/eval/consistency.h"
#include "core/eval/trajectory_error.h"

namespace nadir {
namespace {

/// What the costs and agreements of one step are taken from.
struct SeenStep {
  const MapMatcher& matcher;
  const SemanticTopview& seen;
  MatchCells cells;

  [[nodiscard]] std::optional<double> cost_at(const Rigid2& pose) const {
    if (cells.empty()) return std::nullopt;
    return matcher.mean_cost(cells, pose);
  }
  [[nodiscard]] PoseFit fit_at(const Rigid2& pose) const {
    return {pose, cost_at(pose), cell_agreement(seen, matcher.map(), pose)};
  }
};

double metres_between(const Rigid2& a, const Rigid2& b) {
  return std::hypot(a.x_m - b.x_m, a.y_m - b.y_m);
}

double degrees_between(const Rigid2& a, const Rigid2& b) {
  return Angle::radians(std::abs(wrap_rad(a.yaw_rad - b.yaw_rad))).degrees();
}

int known_cells_of(const PoseFit& fit, const MatchCells& cells) {
  std::uint32_t known = 0;
  for (const MatchCells::OfClass& group : cells.classes) {
    const CellAgreement::Count& count = fit.agreement.of_class[group.id];
    known += count.agreeing + count.disagreeing;
  }
  return static_cast<int>(known);
}

double share_near(const ParticleSet& particles, const Rigid2& truth, double near_m) {
  double share = 0.0;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    if (metres_between(particles.pose(i), truth) <= near_m) share += particles.weight[i];
  }
  return share;
}

std::vector<ClassDifference> class_differences(const SeenStep& step,
                                               const PoseFit& estimate,
                                               const PoseFit& truth) {
  std::array<double, kClassCount> costs_at_estimate{};
  std::array<double, kClassCount> costs_at_truth{};
  if (!step.cells.empty()) {
    costs_at_estimate = step.matcher.class_costs(step.cells, estimate.pose_in_enu);
    costs_at_truth = step.matcher.class_costs(step.cells, truth.pose_in_enu);
  }
  std::vector<ClassDifference> differences;
  for (ClassId id = 0; id < kClassCount; ++id) {
    if (step.seen.of_class(id).empty()) continue;
    differences.push_back({id, estimate.agreement.of_class[id], truth.agreement.of_class[id],
                           costs_at_truth[id] - costs_at_estimate[id]});
  }
  std::stable_sort(differences.begin(), differences.end(), [](const auto& a, const auto& b) {
    return std::abs(a.cost_difference) > std::abs(b.cost_difference);
  });
  return differences;
}

MomentVerdict verdict_on(const MomentExplanation& moment, double cell_m) {
  const ExplanationRules& rules = moment.rules;
  if (!moment.estimate.mean_cost || moment.known_cells * cell_m * cell_m < rules.least_known_m2) {
    return MomentVerdict::kNoEvidence;
  }
  if (!moment.truth) return MomentVerdict::kNoTruth;
  if (*moment.error_m <= rules.near_m && *moment.error_deg <= rules.near_deg) {
    return MomentVerdict::kFound;
  }
  const double difference = *moment.truth->mean_cost - *moment.estimate.mean_cost;
  if (difference < -rules.alike_cost) return MomentVerdict::kTruthFitsBetter;
  if (difference > rules.alike_cost) return MomentVerdict::kMapMisleads;
  return MomentVerdict::kBothFitAlike;
}

/// All that needs the truth.
void compare_with_truth(MomentExplanation& moment,
                        const SeenStep& seen,
                        const RunStep& step,
                        const Rigid2& truth) {
  const PoseMoments& moments = step.estimate.moments;
  moment.truth = seen.fit_at(truth);
  moment.by_class = class_differences(seen, moment.estimate, *moment.truth);
  moment.error_m = metres_between(moments.mean, truth);
  moment.error_deg = degrees_between(moments.mean, truth);
  const StepConsistency consistency =
      assess_step(pose_error(moments.mean, truth), moments.covariance);
  moment.nees = consistency.nees;
  if (consistency.is_ellipse_known) moment.is_truth_inside_95 = consistency.is_inside_95;
  if (step.particles) {
    moment.share_near_truth = share_near(*step.particles, truth, moment.rules.near_m);
  }
}

}  // namespace

std::optional<bool> MomentExplanation::does_truth_score_better() const {
  if (!truth || !truth->mean_cost || !estimate.mean_cost) return std::nullopt;
  return *truth->mean_cost < *estimate.mean_cost;
}

Result<void> check_seen(const RunStep& step, const OverheadMap& map) {
  if (!step.topview) {
    return fail(ErrorCode::kInvalidOptions, "step {}: its topview was not recorded", step.step);
  }
  const double cell_m = step.topview->metres_per_cell;
  // As strict as MapMatcher::prepare().
  if (!(std::abs(cell_m - map.metres_per_cell) < 1e-9 * map.metres_per_cell)) {
    return fail(ErrorCode::kInvalidOptions,
                "step {}: its topview has cells of {} m and map '{}' of {} m", step.step, cell_m,
                map.name, map.metres_per_cell);
  }
  return {};
}

Result<MomentExplanation> explain_moment(const RunStep& step,
                                         const MapMatcher& matcher,
                                         const ExplanationRules& rules) {
  if (const auto checked = check_seen(step, matcher.map()); !checked) return forward_error(checked);
  const SeenStep seen{matcher, *step.topview, matcher.prepare(*step.topview)};
  MomentExplanation moment;
  moment.rules = rules;
  moment.time_s = step.time_s;
  moment.estimate = seen.fit_at(step.estimate.moments.mean);
  moment.known_cells = known_cells_of(moment.estimate, seen.cells);
  if (step.odometry_in_enu) moment.odometry = seen.fit_at(*step.odometry_in_enu);
  for (const PoseMode& mode : step.estimate.modes) {
    ModeFit fit{mode, seen.cost_at(mode.moments.mean), std::nullopt, std::nullopt};
    if (step.truth_in_enu) {
      fit.to_truth_m = metres_between(mode.moments.mean, *step.truth_in_enu);
      fit.to_truth_deg = degrees_between(mode.moments.mean, *step.truth_in_enu);
    }
    moment.modes.push_back(fit);
  }
  if (step.truth_in_enu) compare_with_truth(moment, seen, step, *step.truth_in_enu);
  moment.verdict = verdict_on(moment, matcher.map().metres_per_cell);
  return moment;
}

}  // namespace nadir
