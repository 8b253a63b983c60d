// SPDX-License-Identifier: Apache-2.0
#include "core/session/moment_value.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace nadir {
namespace {

constexpr double kUnknownValue = std::numeric_limits<double>::quiet_NaN();

MomentValue value_text(double value, const char* unit) {
  if (!std::isfinite(value)) return {"–", ""};
  const int decimals = value < 0.995 ? 2 : value < 99.95 ? 1 : 0;
  return {fmt::format("{:.{}f}", value, decimals), unit};
}

double error_at(const RunDocument& run, const std::vector<double>& values, std::size_t step) {
  const auto error = run.error_index_of(step);
  return error ? values[*error] : kUnknownValue;
}

/// What being lost is told by: the error, or without truth the spread.
double astray_m(const RunDocument& run, std::size_t step) {
  return run.has_truth() ? error_at(run, run.errors.position_error_m, step)
                         : run.series.position_sigma_m[step];
}

double most_astray_m(const RunDocument& run, const WorstMoment& moment) {
  double most_m = kUnknownValue;
  for (std::size_t i = moment.step; i < run.steps.size() && run.time_s[i] <= moment.to_s; ++i) {
    const double here_m = astray_m(run, i);
    if (!(most_m >= here_m)) most_m = std::isfinite(here_m) ? here_m : most_m;
  }
  return most_m;
}

/// A late step ends its gap itself, so it is later than the gap's beginning; where nothing was seen, the step after does.
double missing_s(const RunDocument& run, const WorstMoment& moment) {
  if (moment.from_s < moment.time_s) return moment.to_s - moment.from_s;
  const auto after = std::upper_bound(run.time_s.begin(), run.time_s.end(), moment.to_s);
  return (after == run.time_s.end() ? run.time_s.back() : *after) - moment.from_s;
}

}  // namespace

MomentValue moment_value(const RunDocument& run, const WorstMoment& moment) {
  switch (moment.kind) {
    case MomentKind::kLargestError:
      return value_text(error_at(run, run.errors.position_error_m, moment.step), "m");
    case MomentKind::kOverConfident:
      return value_text(error_at(run, run.errors.nees, moment.step), "");
    case MomentKind::kLowAgreement: {
      constexpr double kPercent = 100.0;
      const double share = run.series.agreement[moment.step];
      return std::isfinite(share) ? MomentValue{fmt::format("{:.0f}", kPercent * share), "%"}
                                  : MomentValue{"–", ""};
    }
    case MomentKind::kLost:
      return value_text(most_astray_m(run, moment), "m");
    case MomentKind::kFound:
      return value_text(astray_m(run, moment.step), "m");
    case MomentKind::kMissingData:
      return value_text(missing_s(run, moment), "s");
  }
  return {};
}

}  // namespace nadir
