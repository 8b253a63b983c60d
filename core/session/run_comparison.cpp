// SPDX-License-Identifier: Apache-2.0
#include "core/session/run_comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "core/eval/consistency.h"
#include "core/mcl/option_effects.h"
#include "core/run/run_options.h"
#include "core/session/moment_episodes.h"
#include "core/session/run_metrics.h"

namespace nadir {
namespace {

constexpr double kNotThere = std::numeric_limits<double>::quiet_NaN();

/// What a run says of its position at a moment of another run's.
struct PositionAt {
  Eigen::Vector2d in_enu_m;
  Eigen::Matrix2d covariance;
  std::size_t index = 0;  ///< The run's latest step then.
};

/// Answers for rising times of another run, walking along.
class PositionWalk {
 public:
  explicit PositionWalk(const RunDocument& run) : run_(run) {}

  std::optional<PositionAt> at(double time_s) {
    const std::vector<double>& times = run_.time_s;
    while (next_ < times.size() && times[next_] <= time_s + kSameTimeS) ++next_;
    if (next_ == 0) return std::nullopt;
    const std::size_t before = next_ - 1;
    const EvaluatedStep& from = run_.judged[before];
    const Eigen::Vector2d from_m = from.estimate_in_enu.translation_m();
    const Eigen::Matrix2d from_covariance = from.covariance.topLeftCorner<2, 2>();
    if (std::abs(times[before] - time_s) <= kSameTimeS) {
      return PositionAt{from_m, from_covariance, before};
    }
    const bool is_gap = std::binary_search(run_.gaps.begin(), run_.gaps.end(), next_);
    if (next_ == times.size() || is_gap) return std::nullopt;
    const EvaluatedStep& to = run_.judged[next_];
    const double share = (time_s - times[before]) / (times[next_] - times[before]);
    const Eigen::Matrix2d to_covariance = to.covariance.topLeftCorner<2, 2>();
    return PositionAt{(1.0 - share) * from_m + share * to.estimate_in_enu.translation_m(),
                      (1.0 - share) * from_covariance + share * to_covariance, before};
  }

 private:
  const RunDocument& run_;
  std::size_t next_ = 0;  ///< The first step after the moment.
};

/// Two estimates at one moment.
struct Apart {
  std::size_t second_index = 0;
  double distance_m = 0.0;
  double sigmas = 0.0;
};

/// At every step of the first run; nothing where the second has no position.
std::vector<std::optional<Apart>> apart_at_steps(const RunDocument& first,
                                                 const RunDocument& second) {
  std::vector<std::optional<Apart>> apart;
  apart.reserve(first.steps.size());
  PositionWalk walk(second);
  for (std::size_t i = 0; i < first.steps.size(); ++i) {
    const auto other = walk.at(first.time_in(second, first.time_s[i]));
    if (!other) {
      apart.emplace_back();
      continue;
    }
    const EvaluatedStep& here = first.judged[i];
    const Eigen::Vector2d difference_m = other->in_enu_m - here.estimate_in_enu.translation_m();
    const Eigen::Matrix2d covariance = here.covariance.topLeftCorner<2, 2>() + other->covariance;
    const auto squared = normalised_error_squared(difference_m, covariance);
    const double sigmas = squared ? std::sqrt(*squared) : std::numeric_limits<double>::infinity();
    apart.push_back(Apart{other->index, difference_m.norm(), sigmas});
  }
  return apart;
}

bool has_parted(const Apart& apart, const DivergenceRule& rule) {
  return apart.distance_m > rule.apart_m ||
         (apart.distance_m > rule.at_least_m && apart.sigmas > rule.apart_sigmas);
}

bool is_same_thing(const std::string& hash_a,
                   const std::string& name_a,
                   const std::string& hash_b,
                   const std::string& name_b) {
  if (!hash_a.empty() && !hash_b.empty()) return hash_a == hash_b;
  return name_a == name_b;
}

/// Adds a row where not all runs say the same.
void add_if_different(std::vector<SettingDifference>& rows, SettingDifference row) {
  const bool is_same = std::all_of(row.values.begin(), row.values.end(),
                                   [&](const auto& value) { return value == row.values.front(); });
  if (!is_same) rows.push_back(std::move(row));
}

/// "town (12ab34)": two inputs of one name are told apart.
std::string named_hash(const std::string& name, const std::string& hash) {
  return hash.empty() ? name : fmt::format("{} ({})", name, hash);
}

std::vector<SettingDifference> setting_differences(RunDocuments runs) {
  std::vector<SettingDifference> rows;
  const auto add = [&](const std::string& name, const std::string& unit, const std::string& help,
                       const auto& value) {
    SettingDifference row{name, unit, help, {}, {}};
    for (const auto& run : runs) {
      row.values.push_back(value(run->header));
      row.no_effect.push_back(why_no_effect(name, run->header.options));
    }
    add_if_different(rows, std::move(row));
  };
  using Text = std::optional<std::string>;
  add("flight", "", "",
      [](const RunHeader& h) -> Text { return named_hash(h.flight, h.flight_hash); });
  add("map", "", "", [](const RunHeader& h) -> Text { return named_hash(h.map, h.map_hash); });
  add("preset", "", "", [](const RunHeader& h) -> Text { return h.preset; });
  add("seed", "", "", [](const RunHeader& h) -> Text { return std::to_string(h.seed); });
  add("went on from", "", "", [](const RunHeader& h) -> Text {
    if (!h.started_at_s) return std::nullopt;
    return fmt::format("{} at {} s", h.parent_run, *h.started_at_s);
  });
  add("program version", "", "", [](const RunHeader& h) -> Text { return h.program_version; });

  std::set<std::string> unlisted;
  for (const auto& run : runs) {
    for (const auto& [name, value] : run->header.options) unlisted.insert(name);
  }
  unlisted.erase("seed");  // told above
  const auto add_option = [&](const std::string& name, const std::string& unit,
                              const std::string& help) {
    add(name, unit, help, [&](const RunHeader& header) -> Text {
      const auto found = header.options.find(name);
      return found == header.options.end() ? Text() : Text(found->second);
    });
  };
  for (const OptionText& option : option_texts(RunOptions{})) {
    if (unlisted.erase(option.name) > 0) add_option(option.name, option.unit, option.help);
  }
  for (const std::string& name : unlisted) add_option(name, "", "");
  return rows;
}

}  // namespace

bool SettingDifference::has_effect() const {
  const auto is_free = [](const std::string& why) { return why.empty(); };
  return no_effect.empty() || std::any_of(no_effect.begin(), no_effect.end(), is_free);
}

std::string divergence_words(const DivergenceRule& rule) {
  return fmt::format(
      "more than {:g} m apart, or more than {:g} m and {:g} sigma, for at least {:g} s",
      rule.apart_m, rule.at_least_m, rule.apart_sigmas, rule.held_for_s);
}

std::optional<Divergence> first_divergence(const RunDocument& first,
                                           const RunDocument& second,
                                           const DivergenceRule& rule) {
  if (!are_of_same_flight(first.header, second.header)) return std::nullopt;
  const auto apart = apart_at_steps(first, second);
  constexpr std::size_t kNowhere = std::numeric_limits<std::size_t>::max();
  std::size_t since = kNowhere;
  for (std::size_t i = 0; i < apart.size(); ++i) {
    if (!apart[i] || !has_parted(*apart[i], rule)) {
      since = kNowhere;
      continue;
    }
    if (since == kNowhere) since = i;
    if (first.time_s[i] - first.time_s[since] < rule.held_for_s - kSameTimeS) continue;
    const Apart& begin = *apart[since];
    std::string words = detail::length_words(begin.distance_m) + " apart";
    if (std::isfinite(begin.sigmas)) words += fmt::format(" ({:.1f} sigma)", begin.sigmas);
    return Divergence{first.time_s[since], since,        begin.second_index,
                      begin.distance_m,    begin.sigmas, std::move(words)};
  }
  return std::nullopt;
}

std::vector<double> distance_between_m(const RunDocument& first, const RunDocument& second) {
  std::vector<double> distances;
  distances.reserve(first.steps.size());
  for (const auto& apart : apart_at_steps(first, second)) {
    distances.push_back(apart ? apart->distance_m : kNotThere);
  }
  return distances;
}

bool are_of_same_flight(const RunHeader& a, const RunHeader& b) {
  return is_same_thing(a.flight_hash, a.flight, b.flight_hash, b.flight);
}

bool are_on_same_map(const RunHeader& a, const RunHeader& b) {
  return is_same_thing(a.map_hash, a.map, b.map_hash, b.map);
}

RunComparison compare_runs(RunDocuments runs, const DivergenceRule& rule) {
  RunComparison comparison;
  for (const auto& run : runs) {
    comparison.names.push_back(run->name);
    comparison.is_same_flight =
        comparison.is_same_flight && are_of_same_flight(runs.front()->header, run->header);
    comparison.is_same_map =
        comparison.is_same_map && are_on_same_map(runs.front()->header, run->header);
    comparison.divergence.push_back(
        run == runs.front() ? std::nullopt : first_divergence(*runs.front(), *run, rule));
  }
  for (SettingDifference& row : setting_differences(runs)) {
    auto& rows = row.has_effect() ? comparison.settings : comparison.idle_settings;
    rows.push_back(std::move(row));
  }
  comparison.span = compared_span(runs);
  comparison.metrics =
      detail::metric_rows(evaluations_within(runs, comparison.span), comparison.do_compete());
  return comparison;
}

}  // namespace nadir
