// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/require.h"
#include "core/flight/flight_summary.h"

namespace nadir {
namespace {

constexpr double kGapInMedians = 1.8;
constexpr double kDuplicateInIntervals = 0.1;

std::vector<double> intervals_of(const std::vector<double>& times_s) {
  std::vector<double> intervals_s;
  intervals_s.reserve(times_s.size());
  for (std::size_t i = 1; i < times_s.size(); ++i) {
    intervals_s.push_back(times_s[i] - times_s[i - 1]);
  }
  return intervals_s;
}

/// Value that a share of the values, which are not empty, stays below; halfway between two.
double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  const double at = share * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return std::lerp(values[below], values[above], at - static_cast<double>(below));
}

/// Two samples in one instant are one moment, or every other interval would be next to nothing and
/// the rest gaps. Three quarters, because half of the intervals and more may be such.
std::vector<double> without_duplicates(const std::vector<double>& times_s) {
  const double least_s = kDuplicateInIntervals * quantile(intervals_of(times_s), 0.75);
  std::vector<double> kept_s = {times_s.front()};
  for (const double time_s : times_s) {
    if (time_s - kept_s.back() > least_s) kept_s.push_back(time_s);
  }
  return kept_s;
}

}  // namespace

StreamSummary summarise_stream(std::string name, const std::vector<double>& times_s) {
  NADIR_REQUIRE(!times_s.empty());
  StreamSummary stream;
  stream.name = std::move(name);
  stream.count = times_s.size();
  stream.span = {times_s.front(), times_s.back()};
  if (times_s.size() < 2) return stream;

  const std::vector<double> kept_s = without_duplicates(times_s);
  stream.duplicates = times_s.size() - kept_s.size();
  if (kept_s.size() < 2) return stream;
  const std::vector<double> intervals_s = intervals_of(kept_s);
  const double median_s = quantile(intervals_s, 0.5);
  stream.rate_hz = 1.0 / median_s;

  double sum = 0.0;
  for (std::size_t i = 0; i < intervals_s.size(); ++i) {
    if (intervals_s[i] > kGapInMedians * median_s) {
      stream.gaps.push_back({kept_s[i], kept_s[i + 1]});
    } else {
      sum += (intervals_s[i] - median_s) * (intervals_s[i] - median_s);
    }
  }
  // At least half of the intervals are no longer than the median, so the divisor is never 0.
  stream.jitter_s = std::sqrt(sum / static_cast<double>(intervals_s.size() - stream.gaps.size()));
  return stream;
}

}  // namespace nadir
