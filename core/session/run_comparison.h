// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/session/compared_span.h"

namespace nadir {

/// Something about the runs that is not the same in all of them. One value a run.
struct SettingDifference {
  std::string
      name;  ///< "preset", "seed", "map", "flight", "program version", or an option as on the command line.
  std::string unit;  ///< "m", or empty.
  std::string help;  ///< Of an option; empty where it is none that this version knows.
  std::vector<std::optional<std::string>> values;  ///< Nothing where a run does not say it.
  /// What keeps it from having any effect in a run, "motion = scaled"; empty where it has one. See why_no_effect().
  std::vector<std::string> no_effect = {};
  /// In any of the runs: only then can it be why they differ.
  [[nodiscard]] bool has_effect() const;
};

/// A number of `nadir evaluate`, over the span of the comparison. One value a run.
struct MetricRow {
  std::string key;    ///< As in its JSON and CSV: "estimate_position_rmse_m".
  std::string label;  ///< For people: "Position RMSE".
  std::string unit;   ///< "m", "deg", "ms", or empty for counts and shares.
  /// In `unit`; angles here in degrees. Nothing where not known, such as errors of a run without truth.
  std::vector<std::optional<double>> values;
  /// Which way is better, where one is: -1 lower, 1 higher.
  int better = 0;
  /// The best of the known values, and those that equal it; empty where fewer than two are known, or they do not compete.
  std::vector<std::size_t> best = {};
};

/// When two estimates count as parted.
struct DivergenceRule {
  double apart_m = 2.0;       ///< So far from each other, or ...
  double apart_sigmas = 3.0;  ///< ... more sigmas of their difference, and at least ...
  double at_least_m = 0.5;  ///< ... so far, for a collapsed filter has a sigma of millimetres, ...
  double held_for_s = 1.0;  ///< ... for so long without a break.
};

/// "more than 2 m apart, or more than 0.5 m and 3 sigma, for at least 1 s".
[[nodiscard]] std::string divergence_words(const DivergenceRule& rule = {});

/// Where two runs part.
struct Divergence {
  double time_s = 0.0;          ///< After the first run's first step.
  std::size_t first_index = 0;  ///< Steps of the two runs at that time.
  std::size_t second_index = 0;
  double distance_m = 0.0;  ///< Between the estimates there.
  double sigmas = 0.0;      ///< The same in sigmas; infinite where the covariances have no inverse.
  std::string words;        ///< "0.8 m apart (4.1 sigma)"
};

/// The first moment from which on, for `held_for_s`, the estimates of two runs are farther apart than the rule allows.
///
/// Asked at every step of the first run that lies inside the second; between two steps of the second its position is
/// interpolated, but not across its gaps. The sigma is that of independent estimates, sqrt(e' (P1 + P2)^-1 e); runs that
/// share their flight are closer than that. Runs of different flights have none. O(n).
[[nodiscard]] std::optional<Divergence> first_divergence(const RunDocument& first,
                                                         const RunDocument& second,
                                                         const DivergenceRule& rule = {});

/// Distance between the estimates of two runs at every step of the first, metres; NaN where the second says nothing.
[[nodiscard]] std::vector<double> distance_between_m(const RunDocument& first,
                                                     const RunDocument& second);

/// Whether two runs localised the same recording: by its hash, or by its name where a run does not know the hash.
[[nodiscard]] bool are_of_same_flight(const RunHeader& a, const RunHeader& b);
/// The same for maps.
[[nodiscard]] bool are_on_same_map(const RunHeader& a, const RunHeader& b);

/// Runs beside each other.
struct RunComparison {
  std::vector<std::string> names;  ///< One a run.
  bool is_same_flight = true, is_same_map = true;
  std::vector<SettingDifference>
      settings;  ///< Only what differs: facts first, then options in the order of the field list.
  /// Options that differ, but have no effect in any of the runs.
  std::vector<SettingDifference> idle_settings;
  ComparedSpan span;               ///< That the metrics are over.
  std::vector<MetricRow> metrics;  ///< All of them, known or not.
  std::vector<std::optional<Divergence>>
      divergence;  ///< From the first run, one a run; nothing for the first itself.
  /// Whether one of them can be better than another: runs of one flight, over the same time.
  [[nodiscard]] bool do_compete() const { return is_same_flight && span.is_shared; }
};

/// @param runs  None null; may be one, or none.
[[nodiscard]] RunComparison compare_runs(RunDocuments runs, const DivergenceRule& rule = {});

}  // namespace nadir
