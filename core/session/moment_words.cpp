// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "core/session/moment_explanation.h"

namespace nadir {
namespace {

constexpr double kFewParticles = 0.05;
/// So many times what counts as alike is a clear difference: at the default temperature a weight 7 times the other.
constexpr double kClearDifference = 4.0;

/// "12 %", "less than 1 %".
std::string percent_text(double share) {
  if (share > 0.0 && share < 0.01) return "less than 1 %";
  if (share < 1.0 && share > 0.99) return "more than 99 %";
  return fmt::format("{:.0f} %", 100.0 * share);
}

std::string metres_of(double way_m) {
  return fmt::format("{:.{}f} m", way_m, way_m < 10.0 ? 1 : 0);
}

/// "0.09 against 0.12", with as many digits as tell them apart.
std::string costs_text(double first, double second, const char* between) {
  std::string text;
  for (int digits = 2; digits <= 3; ++digits) {
    const std::string one = fmt::format("{:.{}f}", first, digits);
    const std::string other = fmt::format("{:.{}f}", second, digits);
    text = fmt::format("{}{}{}", one, between, other);
    if (one != other) break;
  }
  return text;
}

/// "lower is better; a clear difference of 0.50".
std::string difference_text(const MomentExplanation& moment) {
  const double by = std::abs(*moment.truth->mean_cost - *moment.estimate.mean_cost);
  const double alike = moment.rules.alike_cost;
  std::string text = "lower is better; ";
  if (by < 5e-5) return text + "no difference";
  const std::string digits = fmt::format("{:.{}f}", by, by >= 0.095 ? 2 : by >= 0.0095 ? 3 : 4);
  if (by <= alike) {
    return text + fmt::format("the difference of {} is too small to tell them apart", digits);
  }
  return text + fmt::format("a {} difference of {}",
                            by > kClearDifference * alike ? "clear" : "small", digits);
}

/// "10 m and 2.3°".
std::string away_text(const MomentExplanation& moment) {
  return fmt::format("{} and {:.1f}°", metres_of(*moment.error_m), *moment.error_deg);
}

/// The class that speaks most for the pose that fits better.
const ClassDifference* telling_class(const MomentExplanation& moment, bool speaks_for_truth) {
  const auto found =
      std::find_if(moment.by_class.begin(), moment.by_class.end(), [&](const auto& difference) {
        return speaks_for_truth ? difference.cost_difference < 0.0
                                : difference.cost_difference > 0.0;
      });
  return found == moment.by_class.end() ? nullptr : &*found;
}

/// " Curb cells tell most: 12 % agree at the estimate, 85 % at the truth."
std::string class_sentence(const ClassDifference* difference) {
  if (difference == nullptr) return "";
  std::string name(class_info(difference->id).name);
  name.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(name.front())));
  const auto at_estimate = difference->at_estimate.share();
  const auto at_truth = difference->at_truth.share();
  if (!at_estimate || !at_truth) {
    return fmt::format(" {} cells tell most; at the {} they lie on unknown ground.", name,
                       at_estimate ? "truth" : "estimate");
  }
  return fmt::format(" {} cells tell most: {} agree at the estimate, {} at the truth.", name,
                     percent_text(*at_estimate), percent_text(*at_truth));
}

std::string words_of_no_evidence(const MomentExplanation& moment) {
  if (moment.estimate.agreement.of_cell.empty()) return "No evidence: the topview is empty.";
  if (!moment.estimate.mean_cost) {
    return "No evidence: nothing that was seen is of a class that the map holds.";
  }
  if (moment.known_cells == 0) return "No evidence: no topview cell lies on known ground.";
  return fmt::format("No evidence: only {} topview cell{} on known ground.", moment.known_cells,
                     moment.known_cells == 1 ? " lies" : "s lie");
}

std::string words_of_without_truth(const MomentExplanation& moment) {
  std::string text = fmt::format(
      "The truth is not known here. The estimate fits the map at a mean cost of {:.2f} (0 fits "
      "everywhere, 1 nowhere), and {} of the cells on known ground agree.",
      *moment.estimate.mean_cost, percent_text(moment.estimate.agreement.share().value_or(0.0)));
  if (moment.modes.size() > 1) {
    text += fmt::format(" The particles form {} clusters; the heaviest holds {}.",
                        moment.modes.size(), percent_text(moment.modes.front().mode.mass));
  }
  return text;
}

std::string words_of_found(const MomentExplanation& moment) {
  return fmt::format(
      "The estimate is {} from the truth; the mean cost is {} at the truth ({}).",
      away_text(moment),
      costs_text(*moment.estimate.mean_cost, *moment.truth->mean_cost, " at the estimate, "),
      difference_text(moment));
}

/// Whether anybody was there to be found.
std::string who_was_near(const MomentExplanation& moment) {
  const double near_m = moment.rules.near_m;
  const auto mode = std::find_if(moment.modes.begin(), moment.modes.end(), [&](const auto& fit) {
    return fit.to_truth_m && *fit.to_truth_m <= near_m &&
           *fit.to_truth_deg <= moment.rules.near_deg;
  });
  if (mode != moment.modes.end()) {
    return fmt::format(", and a cluster with {} of the mass is there",
                       percent_text(mode->mode.mass));
  }
  if (!moment.share_near_truth) return "";
  const double share = *moment.share_near_truth;
  if (share <= 0.0) return fmt::format(", but no particle was within {:g} m of it", near_m);
  return fmt::format(", {} {} of the particles were within {:g} m of it",
                     share < kFewParticles ? "but only" : "and", percent_text(share), near_m);
}

std::string words_of_truth_fits_better(const MomentExplanation& moment) {
  return fmt::format("The true pose, {} away, would have scored better (mean cost {}; {}){}.",
                     away_text(moment),
                     costs_text(*moment.truth->mean_cost, *moment.estimate.mean_cost, " against "),
                     difference_text(moment), who_was_near(moment)) +
         class_sentence(telling_class(moment, true));
}

std::string words_of_map_misleads(const MomentExplanation& moment) {
  return fmt::format(
             "The map itself misleads here, or what was seen does: the estimate, {} off, fits "
             "better than the truth (mean cost {}; {}).",
             away_text(moment),
             costs_text(*moment.estimate.mean_cost, *moment.truth->mean_cost, " against "),
             difference_text(moment)) +
         class_sentence(telling_class(moment, false));
}

std::string words_of_both_fit(const MomentExplanation& moment) {
  return fmt::format(
      "What is seen here cannot tell the estimate from the truth, {} apart: both fit about as well "
      "(mean cost {}; {}){}.",
      away_text(moment), costs_text(*moment.estimate.mean_cost, *moment.truth->mean_cost, " and "),
      difference_text(moment), who_was_near(moment));
}

}  // namespace

std::string surety_in_words(const MomentExplanation& moment) {
  constexpr const char* kOneStep = "; one step is no test of consistency, only many are.";
  if (moment.nees) {
    const StepNeesBounds bounds = step_nees_bounds();
    if (*moment.nees <= bounds.upper) return "";
    return fmt::format(
        "The NEES of this step, {:.1f}, is above the 95 % chi-square bounds {:.2f} to {:.2f} ({} "
        "degrees of freedom){}",
        *moment.nees, bounds.lower, bounds.upper, bounds.degrees_of_freedom, kOneStep);
  }
  if (moment.is_truth_inside_95.value_or(true)) return "";
  return fmt::format(
      "The truth lies outside the 95 % position ellipse of this step (chi-square, 2 degrees of "
      "freedom){}",
      kOneStep);
}

std::string in_words(const MomentExplanation& moment) {
  switch (moment.verdict) {
    case MomentVerdict::kNoEvidence:
      return words_of_no_evidence(moment);
    case MomentVerdict::kNoTruth:
      return words_of_without_truth(moment);
    case MomentVerdict::kFound:
      return words_of_found(moment);
    case MomentVerdict::kTruthFitsBetter:
      return words_of_truth_fits_better(moment);
    case MomentVerdict::kMapMisleads:
      return words_of_map_misleads(moment);
    case MomentVerdict::kBothFitAlike:
      return words_of_both_fit(moment);
  }
  return "";
}

}  // namespace nadir
