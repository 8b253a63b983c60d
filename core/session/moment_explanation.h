// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/eval/consistency.h"
#include "core/mcl/cell_agreement.h"
#include "core/mcl/measurement_model.h"
#include "core/run/run_file.h"

namespace nadir {

/// How well a pose explains what was seen in a step.
struct PoseFit {
  Rigid2 pose_in_enu;
  std::optional<double> mean_cost;  ///< What the filter's weights are made of, in [0, 1]; nothing
                                    ///< where no seen class is on the map.
  CellAgreement agreement;
};

/// A cluster of the posterior, and how far from the truth it lies.
struct ModeFit {
  PoseMode mode;
  std::optional<double> mean_cost;   ///< At the mode's mean.
  std::optional<double> to_truth_m;  ///< Nothing where the truth is not known.
  std::optional<double> to_truth_deg;
};

/// What the cells of one class say of the estimate and of the truth.
struct ClassDifference {
  ClassId id = 0;
  CellAgreement::Count at_estimate, at_truth;
  /// Mean cost at the truth minus mean cost at the estimate, as far as this class makes it: above 0 the
  /// class is cheaper at the estimate, below 0 at the truth; less is better. Over all classes these add up to the difference of the two mean costs.
  double cost_difference = 0.0;
};

/// Why the estimate is where it is, in one word. The rules are tried in this order; ExplanationRules has the numbers.
enum class MomentVerdict {
  kNoEvidence,       ///< Hardly a cell lies on ground that the map knows.
  kNoTruth,          ///< The flight does not know the truth, so nothing can be compared with it.
  kFound,            ///< The estimate is near the truth.
  kTruthFitsBetter,  ///< The filter missed it: the truth would have scored better than the estimate.
  kMapMisleads,      ///< The estimate scores better than the truth: map or topview is wrong here.
  kBothFitAlike,     ///< What is seen here cannot tell the two places apart.
};

struct ExplanationRules {
  double near_m = 2.0;     ///< "Near the truth": closer than this
  double near_deg = 10.0;  ///< and than this.
  /// Mean costs that differ by no more are alike: at the default temperature of 0.01, a weight 1.6 times the other.
  double alike_cost = 0.005;
  double least_known_m2 = 1.0;  ///< Less known ground under the topview is no evidence.
};

/// Everything that answers "why here?" about one step.
struct MomentExplanation {
  MomentVerdict verdict = MomentVerdict::kNoTruth;
  ExplanationRules rules;  ///< That the verdict was found by.
  double time_s = 0.0;
  int known_cells =
      0;  ///< Topview cells of the map's classes on known ground when laid at the estimate.
  PoseFit estimate;
  std::optional<PoseFit> truth, odometry;
  std::vector<ModeFit> modes;  ///< By falling mass.
  std::vector<ClassDifference>
      by_class;  ///< Of the classes that were seen; the one that matters most first. Empty
                 ///< where the truth is not known.
  std::optional<double> error_m, error_deg;  ///< Estimate to truth, not negative.
  std::optional<double> nees;                ///< Nothing without truth or a regular covariance.
  std::optional<bool>
      is_truth_inside_95;  ///< Of the position ellipse; nothing without truth or covariance.
  std::optional<double>
      share_near_truth;  ///< Weight of the particles nearer to the truth than rules.near_m, with any
                         ///< heading; nothing without truth or recorded particles.
  /// Whether the truth would have scored better than the estimate, by however little; nothing where one is not known.
  [[nodiscard]] std::optional<bool> does_truth_score_better() const;
};

/// Whether what was seen in a step can be laid on a map. @errors kInvalidOptions: the step has no
/// topview, or one of other cells than the map's.
[[nodiscard]] Result<void> check_seen(const RunStep& step, const OverheadMap& map);

/// Compares what was seen with the map at estimate, truth, odometry and each mode. A few milliseconds.
/// @param step     With its topview; particles are used where there are any.
/// @param matcher  Of the options and the map that the run was made with; else the costs are not those of the filter.
/// @errors as check_seen().
[[nodiscard]] Result<MomentExplanation> explain_moment(const RunStep& step,
                                                       const MapMatcher& matcher,
                                                       const ExplanationRules& rules = {});

/// The same in one or two plain sentences for people: "The true pose, 7.0 m and 2.1° away, would have scored better (mean cost
/// 0.09 against 0.12; lower is better; a clear difference of 0.030), but only 3 % of the particles were within 2 m of it."
[[nodiscard]] std::string in_words(const MomentExplanation& moment);
/// That the error is more than the filter's covariance makes likely, in a sentence; empty where it is not, or nobody knows.
[[nodiscard]] std::string surety_in_words(const MomentExplanation& moment);

}  // namespace nadir
