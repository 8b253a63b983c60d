// SPDX-License-Identifier: Apache-2.0
#include "core/session/moment_episodes.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <utility>

#include "core/base/angle.h"
#include "core/eval/consistency.h"
#include "core/session/moment_explanation.h"
#include "core/session/run_document.h"

namespace nadir::detail {
namespace {

/// Error of a step in units of its 95 % bounds: 1 is on the bound. Nothing where bounds are not known.
struct BoundRatios {
  std::optional<double> position, heading;
};

BoundRatios bound_ratios(const RunDocument& run, std::size_t step, std::size_t error) {
  static const double limit_2 = chi_square_quantile(0.95, 2.0);
  static const double limit_1 = chi_square_quantile(0.95, 1.0);
  const Eigen::Matrix3d& covariance = run.judged[step].covariance;
  const Eigen::Vector2d position(run.errors.x_error_m[error], run.errors.y_error_m[error]);
  BoundRatios ratios;
  const Eigen::Matrix2d of_position = covariance.topLeftCorner<2, 2>();
  if (const auto squared = normalised_error_squared(position, of_position)) {
    ratios.position = std::sqrt(*squared / limit_2);
  }
  const double sigma = run.errors.yaw_sigma_rad[error];
  if (sigma > 0.0 && std::isfinite(sigma)) {
    ratios.heading = std::abs(run.errors.yaw_error_rad[error]) / (sigma * std::sqrt(limit_1));
  }
  return ratios;
}

bool is_estimate_near_truth(const RunDocument& run, std::size_t step) {
  const auto error = run.error_index_of(step);
  if (!error) return false;
  const ExplanationRules rules;
  return run.errors.position_error_m[*error] <= rules.near_m &&
         Angle::radians(std::abs(run.errors.yaw_error_rad[*error])).degrees() <= rules.near_deg;
}

}  // namespace

std::vector<Episode> find_episodes(const std::vector<double>& time_s,
                                   double merged_within_s,
                                   const std::function<double(std::size_t step)>& severity) {
  std::vector<Episode> episodes;
  for (std::size_t i = 0; i < time_s.size(); ++i) {
    const double here = severity(i);
    if (!(here >= 1.0)) continue;
    const bool goes_on =
        !episodes.empty() && (episodes.back().last + 1 == i ||
                              time_s[i] - time_s[episodes.back().last] < merged_within_s);
    if (!goes_on) {
      episodes.push_back({i, i, i, here});
      continue;
    }
    Episode& episode = episodes.back();
    episode.last = i;
    if (here > episode.severity) {
      episode.peak = i;
      episode.severity = here;
    }
  }
  return episodes;
}

WorstMoment moment_of(const RunDocument& run,
                      const Episode& episode,
                      MomentKind kind,
                      std::string words) {
  return {.step = episode.peak,
          .time_s = run.time_s[episode.peak],
          .kind = kind,
          .severity = episode.severity,
          .words = std::move(words),
          .from_s = run.time_s[episode.first],
          .to_s = run.time_s[episode.last],
          .is_near_truth = is_estimate_near_truth(run, episode.peak)};
}

std::string length_words(double length_m) {
  const int decimals = length_m < 0.995 ? 2 : length_m < 99.95 ? 1 : 0;
  return fmt::format("{:.{}f} m", length_m, decimals);
}

std::string duration_words(double duration_s) {
  if (duration_s < 99.95) return fmt::format("{:.1f} s", duration_s);
  const auto whole = static_cast<long>(std::lround(duration_s));
  return fmt::format("{} min {} s", whole / 60, whole % 60);
}

std::string error_words(const RunDocument& run, std::size_t step) {
  const auto error = run.error_index_of(step);
  if (!error) return {};
  const double error_m = run.errors.position_error_m[*error];
  std::string words = length_words(error_m) + " off";
  if (const auto ratio = bound_ratios(run, step, *error).position; ratio && *ratio > 0.0) {
    words += ", 95 % ellipse " + length_words(error_m / *ratio);
  }
  return words;
}

std::string heading_words(const RunDocument& run, std::size_t step) {
  const auto error = run.error_index_of(step);
  if (!error) return {};
  const auto ratio = bound_ratios(run, step, *error).heading;
  if (!ratio || !(*ratio > 0.0)) return {};
  const double error_deg = Angle::radians(std::abs(run.errors.yaw_error_rad[*error])).degrees();
  return fmt::format("heading {:.1f} deg off, 95 % within {:.1f} deg", error_deg,
                     error_deg / *ratio);
}

bool is_heading_worse(const RunDocument& run, std::size_t step) {
  const auto error = run.error_index_of(step);
  if (!error) return false;
  const BoundRatios ratios = bound_ratios(run, step, *error);
  return ratios.heading.value_or(0.0) > ratios.position.value_or(0.0);
}

}  // namespace nadir::detail
