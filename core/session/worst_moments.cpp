// SPDX-License-Identifier: Apache-2.0
#include "core/session/worst_moments.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>

#include "core/base/require.h"
#include "core/eval/consistency.h"
#include "core/session/moment_episodes.h"
#include "core/session/moment_tracking.h"
#include "core/session/run_document.h"

namespace nadir {
namespace {

using detail::duration_words;
using detail::Episode;
using detail::error_words;
using detail::find_episodes;

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

std::optional<double> median_of_known(std::vector<double> values) {
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  if (values.empty()) return std::nullopt;
  return lower_median(std::move(values));
}

/// Collects the moments of one run.
class MomentFinder {
 public:
  MomentFinder(const RunDocument& run, const WorstMomentRule& rule) : run_(run), rule_(rule) {
    agreement_median_ = median_of_known(run.series.agreement);
    if (agreement_median_) {
      std::vector<double> deviations;
      for (const double agreement : run.series.agreement) {
        deviations.push_back(std::abs(agreement - *agreement_median_));
      }
      constexpr double kSigmaFromMedianDeviation = 1.4826;  // of a normal distribution
      const double sigma = kSigmaFromMedianDeviation * median_of_known(deviations).value_or(0.0);
      agreement_drop_ = std::max(rule.agreement_drop, rule.agreement_sigmas * sigma);
    }
  }

  [[nodiscard]] std::vector<WorstMoment> find() {
    std::vector<WorstMoment> same_cause = errors();
    append(same_cause, over_confident());
    append(same_cause, low_agreement());
    append(moments_, one_each(std::move(same_cause)));
    for (std::vector<WorstMoment>& of_kind : detail::tracking_moments(run_, rule_)) {
      append(moments_, best_of(std::move(of_kind)));
    }
    append(moments_, best_of(late_steps()));
    append(moments_, best_of(unseen()));
    std::sort(moments_.begin(), moments_.end(), [](const auto& a, const auto& b) {
      return std::tie(a.step, a.kind) < std::tie(b.step, b.kind);
    });
    return std::move(moments_);
  }

 private:
  static void append(std::vector<WorstMoment>& to, std::vector<WorstMoment> from) {
    std::move(from.begin(), from.end(), std::back_inserter(to));
  }

  [[nodiscard]] WorstMoment moment(const Episode& episode,
                                   MomentKind kind,
                                   std::string words) const {
    return detail::moment_of(run_, episode, kind, std::move(words));
  }

  /// The most severe moments of one kind.
  [[nodiscard]] std::vector<WorstMoment> best_of(std::vector<WorstMoment> moments) const {
    std::stable_sort(moments.begin(), moments.end(),
                     [](const auto& a, const auto& b) { return a.severity > b.severity; });
    if (moments.size() > rule_.most_of_a_kind) moments.resize(rule_.most_of_a_kind);
    return moments;
  }

  /// A value of `errors` by step.
  [[nodiscard]] double error_value(const std::vector<double>& values, std::size_t step) const {
    const auto error = run_.error_index_of(step);
    return error ? values[*error] : kNoNumber;
  }

  [[nodiscard]] double agreement_severity(std::size_t step) const {
    return agreement_median_ ? (*agreement_median_ - run_.series.agreement[step]) / agreement_drop_
                             : kNoNumber;
  }

  [[nodiscard]] std::string agreement_words(std::size_t step) const {
    return fmt::format("agreement {:.2f}, usually {:.2f}", run_.series.agreement[step],
                       *agreement_median_);
  }

  /// The error of a step and, where that is low too, its agreement.
  [[nodiscard]] std::string words_with_agreement(std::string words, std::size_t step) const {
    if (agreement_severity(step) >= 1.0) words += ", " + agreement_words(step);
    return words;
  }

  /// The run's largest error comes first.
  [[nodiscard]] std::vector<WorstMoment> errors() const {
    const auto median_m = median_of_known(run_.errors.position_error_m);
    if (!median_m) return {};
    const double limit_m = std::max(rule_.error_from_m, rule_.error_from_medians * *median_m);
    const auto severity = [&](std::size_t step) {
      return error_value(run_.errors.position_error_m, step) / limit_m;
    };
    auto episodes = find_episodes(run_.time_s, rule_.merged_within_s, severity);
    if (episodes.empty()) {
      const auto& error_m = run_.errors.position_error_m;
      const auto smaller = [](double a, double b) {
        return !std::isfinite(a) ? std::isfinite(b) : a < b;
      };
      const auto largest = std::max_element(error_m.begin(), error_m.end(), smaller);
      const std::size_t step =
          run_.errors.step[static_cast<std::size_t>(largest - error_m.begin())];
      episodes = {{step, step, step, *largest / limit_m}};
    }
    std::vector<WorstMoment> found;
    found.reserve(episodes.size());
    for (const Episode& episode : episodes) {
      found.push_back(moment(episode, MomentKind::kLargestError,
                             words_with_agreement(error_words(run_, episode.peak), episode.peak)));
    }
    return best_of(std::move(found));
  }

  [[nodiscard]] std::vector<WorstMoment> over_confident() const {
    if (!run_.has_truth()) return {};
    const double limit = chi_square_quantile(rule_.nees_probability, 3.0);
    const auto severity = [&](std::size_t step) {
      return std::sqrt(error_value(run_.errors.nees, step) / limit);
    };
    std::vector<WorstMoment> found;
    for (const Episode& episode : find_episodes(run_.time_s, rule_.merged_within_s, severity)) {
      std::string words = detail::is_heading_worse(run_, episode.peak)
                              ? detail::heading_words(run_, episode.peak)
                              : error_words(run_, episode.peak);
      found.push_back(moment(episode, MomentKind::kOverConfident,
                             words_with_agreement(std::move(words), episode.peak)));
    }
    return best_of(std::move(found));
  }

  [[nodiscard]] std::vector<WorstMoment> low_agreement() const {
    std::vector<WorstMoment> found;
    const auto severity = [&](std::size_t step) { return agreement_severity(step); };
    for (const Episode& episode : find_episodes(run_.time_s, rule_.merged_within_s, severity)) {
      std::string words = agreement_words(episode.peak);
      if (run_.error_index_of(episode.peak)) words += ", " + error_words(run_, episode.peak);
      found.push_back(moment(episode, MomentKind::kLowAgreement, std::move(words)));
    }
    return best_of(std::move(found));
  }

  /// Of moments at nearly the same time the most severe; the run's largest error before all.
  [[nodiscard]] std::vector<WorstMoment> one_each(std::vector<WorstMoment> moments) const {
    if (moments.empty()) return {};
    const auto after_largest_error =
        moments.begin() + (moments.front().kind == MomentKind::kLargestError ? 1 : 0);
    std::stable_sort(after_largest_error, moments.end(),
                     [](const auto& a, const auto& b) { return a.severity > b.severity; });
    std::vector<WorstMoment> kept;
    for (WorstMoment& candidate : moments) {
      const bool is_told = std::any_of(kept.begin(), kept.end(), [&](const WorstMoment& other) {
        return other.kind != candidate.kind &&
               std::abs(other.time_s - candidate.time_s) < rule_.same_moment_within_s;
      });
      if (!is_told) kept.push_back(std::move(candidate));
    }
    return kept;
  }

  [[nodiscard]] std::vector<WorstMoment> late_steps() const {
    std::vector<WorstMoment> found;
    for (const std::size_t step : time_gaps(run_.time_s, rule_.gap_from_periods)) {
      const double gap_s = run_.time_s[step] - run_.time_s[step - 1];
      const double limit_s = rule_.gap_from_periods * run_.median_period_s;
      WorstMoment made =
          moment({step - 1, step, step, std::sqrt(gap_s / limit_s)}, MomentKind::kMissingData,
                 fmt::format("no step for {}", duration_words(gap_s)));
      found.push_back(std::move(made));
    }
    return found;
  }

  [[nodiscard]] std::vector<WorstMoment> unseen() const {
    const auto& cells = run_.series.topview_cells;
    if (std::all_of(cells.begin(), cells.end(), [](double count) { return count == 0.0; })) {
      return {};
    }
    const auto severity = [&](std::size_t step) { return cells[step] == 0.0 ? 1.0 : 0.0; };
    std::vector<WorstMoment> found;
    for (Episode episode : find_episodes(run_.time_s, 0.0, severity)) {
      const std::size_t seen = std::min(episode.last + 1, cells.size() - 1);
      const double unseen_s = run_.time_s[seen] - run_.time_s[episode.first];
      if (!(unseen_s >= rule_.unseen_for_s)) continue;
      episode.severity = std::sqrt(unseen_s / rule_.unseen_for_s);
      found.push_back(moment(episode, MomentKind::kMissingData,
                             fmt::format("nothing seen for {}", duration_words(unseen_s))));
    }
    return found;
  }

  const RunDocument& run_;
  const WorstMomentRule& rule_;
  std::optional<double> agreement_median_;
  double agreement_drop_ = 1.0;
  std::vector<WorstMoment> moments_;
};

}  // namespace

std::vector<WorstMoment> find_worst_moments(const RunDocument& run, const WorstMomentRule& rule) {
  NADIR_REQUIRE(rule.error_from_m > 0.0 && rule.agreement_drop > 0.0 &&
                rule.lost_from_sigma_m > 0.0 && rule.unseen_for_s > 0.0);
  if (run.steps.empty()) return {};
  return MomentFinder(run, rule).find();
}

const WorstMoment* next_moment(std::span<const WorstMoment> moments, double time_s) {
  const auto next = std::find_if(moments.begin(), moments.end(), [&](const WorstMoment& moment) {
    return moment.time_s > time_s + kSameTimeS;
  });
  return next == moments.end() ? nullptr : &*next;
}

const WorstMoment* previous_moment(std::span<const WorstMoment> moments, double time_s) {
  const auto previous =
      std::find_if(moments.rbegin(), moments.rend(),
                   [&](const WorstMoment& moment) { return moment.time_s < time_s - kSameTimeS; });
  return previous == moments.rend() ? nullptr : &*previous;
}

const WorstMoment* most_severe(std::span<const WorstMoment> moments) {
  const auto worst = std::max_element(
      moments.begin(), moments.end(),
      [](const WorstMoment& a, const WorstMoment& b) { return a.severity < b.severity; });
  return worst == moments.end() ? nullptr : &*worst;
}

}  // namespace nadir
