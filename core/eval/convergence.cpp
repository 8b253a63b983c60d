// SPDX-License-Identifier: Apache-2.0
#include "core/eval/convergence.h"

#include <cmath>
#include <vector>

#include "core/eval/consistency.h"

namespace nadir {
namespace {

struct Moment {
  std::size_t step = 0;
  double time_s = 0.0;
  double travelled_m = 0.0;
  double error_m = 0.0;
  bool is_good = false;       ///< Error and spread are below the rule's limits.
  bool is_converged = false;  ///< ... and stay so for the rule's distance.
};

std::vector<Moment> moments_with_truth(std::span<const EvaluatedStep> steps,
                                       const ConvergenceRule& rule) {
  std::vector<Moment> moments;
  Eigen::Vector2d last_truth_in_enu = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const EvaluatedStep& step = steps[i];
    if (!step.truth_in_enu) continue;
    const Eigen::Vector2d truth_in_enu = step.truth_in_enu->translation_m();
    Moment moment{.step = i, .time_s = step.time_s};
    if (!moments.empty()) {
      moment.travelled_m = moments.back().travelled_m + (truth_in_enu - last_truth_in_enu).norm();
    }
    last_truth_in_enu = truth_in_enu;
    moment.error_m = (step.estimate_in_enu.translation_m() - truth_in_enu).norm();
    moment.is_good = moment.error_m < rule.error_below_m &&
                     position_spread_m2(step.covariance) < rule.spread_below_m2;
    moments.push_back(moment);
  }
  return moments;
}

void mark_converged(std::vector<Moment>& moments, double held_for_m) {
  double good_until_m = 0.0;
  bool was_good = false;
  for (auto moment = moments.rbegin(); moment != moments.rend(); ++moment) {
    if (moment->is_good && !was_good) good_until_m = moment->travelled_m;
    was_good = moment->is_good;
    moment->is_converged = was_good && good_until_m - moment->travelled_m >= held_for_m;
  }
}

/// A moment at which tracking began or ended.
struct Change {
  const Moment* moment;
  bool is_found;
};

std::vector<Change> changes_of(const std::vector<Moment>& moments, const ConvergenceRule& rule) {
  std::vector<Change> changes;
  bool is_tracking = false;
  for (const Moment& moment : moments) {
    const bool changes_now = is_tracking ? moment.error_m >= rule.lost_from_m : moment.is_converged;
    if (!changes_now) continue;
    is_tracking = !is_tracking;
    changes.push_back({&moment, is_tracking});
  }
  return changes;
}

}  // namespace

std::vector<TrackingChange> find_tracking_changes(std::span<const EvaluatedStep> steps,
                                                  const ConvergenceRule& rule) {
  std::vector<Moment> moments = moments_with_truth(steps, rule);
  mark_converged(moments, rule.held_for_m);
  std::vector<TrackingChange> changes;
  for (const Change& change : changes_of(moments, rule)) {
    changes.push_back({change.moment->step, change.is_found});
  }
  return changes;
}

Convergence find_convergence(std::span<const EvaluatedStep> steps, const ConvergenceRule& rule) {
  Convergence result;
  std::vector<Moment> moments = moments_with_truth(steps, rule);
  mark_converged(moments, rule.held_for_m);
  bool is_lost = false;
  double lost_since_m = 0.0;
  for (const auto& [moment, is_found] : changes_of(moments, rule)) {
    if (!is_found) {
      ++result.lost_stretches;
      lost_since_m = moment->travelled_m;
    } else if (is_lost) {
      result.lost_m += moment->travelled_m - lost_since_m;
    } else {
      result.after_s = moment->time_s - steps.front().time_s;
      result.after_m = moment->travelled_m;
    }
    is_lost = !is_found;
  }
  if (is_lost) result.lost_m += moments.back().travelled_m - lost_since_m;
  return result;
}

}  // namespace nadir
