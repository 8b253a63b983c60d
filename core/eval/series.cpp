// SPDX-License-Identifier: Apache-2.0
#include "core/eval/series.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/require.h"
#include "core/eval/consistency.h"
#include "core/eval/trajectory_error.h"

namespace nadir {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

double sigma(double variance) { return variance >= 0.0 ? std::sqrt(variance) : kUnknown; }

/// Makes the points that stay of one line; see decimate_min_max().
class Decimation {
 public:
  Decimation(std::span<const double> x, std::span<const double> y, std::size_t buckets)
      : x_(x), y_(y), buckets_(buckets), width_(x.back() - x.front()) {
    const auto falls = [](double from, double to) { return !(from <= to); };  // or is no number
    NADIR_REQUIRE(std::isfinite(width_) &&
                  std::adjacent_find(x.begin(), x.end(), falls) == x.end());
  }

  /// Points [begin, end), all of them finite and with a break on either side.
  void add_piece(std::size_t begin, std::size_t end) {
    if (!line_.x.empty()) push(x_[break_], kUnknown);
    break_ = end;
    if ((x_.size() + 1) / 2 <= buckets_) {
      for (std::size_t i = begin; i < end; ++i) push(x_[i], y_[i]);
      return;
    }
    for (std::size_t i = begin; i < end;) i = add_bucket(begin, i, end);
  }

  [[nodiscard]] PointLine take() { return std::move(line_); }

 private:
  void push(double x, double y) {
    line_.x.push_back(x);
    line_.y.push_back(y);
  }

  [[nodiscard]] std::size_t bucket_of(std::size_t i) const {
    if (width_ == 0.0) return 0;
    const double position = (x_[i] - x_.front()) / width_ * static_cast<double>(buckets_);
    return std::min(static_cast<std::size_t>(position), buckets_ - 1);
  }

  /// The points from `first` on that share its bucket, inside a piece. Returns where they end.
  std::size_t add_bucket(std::size_t piece_begin, std::size_t first, std::size_t piece_end) {
    std::size_t lowest = first;
    std::size_t highest = first;
    const std::size_t bucket = bucket_of(first);
    std::size_t end = first + 1;
    for (; end < piece_end && bucket_of(end) == bucket; ++end) {
      if (y_[end] < y_[lowest]) lowest = end;
      if (y_[end] > y_[highest]) highest = end;
    }
    std::array<std::size_t, 4> kept = {lowest, highest, first == piece_begin ? first : lowest,
                                       end == piece_end ? end - 1 : highest};
    std::sort(kept.begin(), kept.end());
    for (std::size_t k = 0; k < kept.size(); ++k) {
      if (k == 0 || kept[k] != kept[k - 1]) push(x_[kept[k]], y_[kept[k]]);
    }
    return end;
  }

  std::span<const double> x_, y_;
  std::size_t buckets_;
  double width_;
  std::size_t break_ = 0;  ///< The first point after the last piece.
  PointLine line_;
};

}  // namespace

ErrorSeries error_series(std::span<const EvaluatedStep> steps) {
  ErrorSeries series;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const EvaluatedStep& step = steps[i];
    if (!step.truth_in_enu) continue;
    const Eigen::Vector3d error = pose_error(step.estimate_in_enu, *step.truth_in_enu);
    const StepConsistency consistency = assess_step(error, step.covariance);
    series.step.push_back(i);
    series.time_s.push_back(step.time_s - steps.front().time_s);
    series.x_error_m.push_back(error.x());
    series.y_error_m.push_back(error.y());
    series.yaw_error_rad.push_back(error.z());
    series.position_error_m.push_back(error.head<2>().norm());
    series.x_sigma_m.push_back(sigma(step.covariance(0, 0)));
    series.y_sigma_m.push_back(sigma(step.covariance(1, 1)));
    series.yaw_sigma_rad.push_back(sigma(step.covariance(2, 2)));
    series.nees.push_back(consistency.nees.value_or(kUnknown));
    series.is_inside_95.push_back(consistency.is_inside_95);
    series.is_ellipse_known.push_back(consistency.is_ellipse_known);
  }
  return series;
}

double lower_median(std::vector<double> values) {
  NADIR_REQUIRE(!values.empty());
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

std::vector<std::size_t> time_gaps(std::span<const double> time_s, double most_periods) {
  if (time_s.size() < 2) return {};
  std::vector<double> periods(time_s.size() - 1);
  for (std::size_t i = 1; i < time_s.size(); ++i) periods[i - 1] = time_s[i] - time_s[i - 1];
  const double usual = lower_median(periods);
  std::vector<std::size_t> gaps;
  for (std::size_t i = 0; i < periods.size(); ++i) {
    if (periods[i] > most_periods * usual) gaps.push_back(i + 1);
  }
  return gaps;
}

std::vector<std::size_t> gaps_of(const ErrorSeries& series) {
  std::vector<std::size_t> gaps = time_gaps(series.time_s);
  if (series.step.size() < 2) return gaps;
  constexpr double kMostUsual = 1.5;  // truth at 0, 3, 7, 10 ... has no gaps
  std::vector<double> distances;
  for (std::size_t i = 1; i < series.step.size(); ++i) {
    distances.push_back(static_cast<double>(series.step[i] - series.step[i - 1]));
  }
  const double usual = lower_median(distances);
  for (std::size_t i = 0; i < distances.size(); ++i) {
    if (distances[i] > kMostUsual * usual) gaps.push_back(i + 1);
  }
  std::sort(gaps.begin(), gaps.end());
  gaps.erase(std::unique(gaps.begin(), gaps.end()), gaps.end());
  return gaps;
}

std::vector<double> broken_at(std::span<const std::size_t> gaps, std::span<const double> values) {
  NADIR_REQUIRE(std::is_sorted(gaps.begin(), gaps.end()));
  NADIR_REQUIRE(gaps.empty() || gaps.back() < values.size());
  std::vector<double> broken;
  broken.reserve(values.size() + gaps.size());
  auto gap = gaps.begin();
  for (std::size_t i = 0; i < values.size(); ++i) {
    for (; gap != gaps.end() && *gap == i; ++gap) broken.push_back(kUnknown);
    broken.push_back(values[i]);
  }
  return broken;
}

CumulativeDistribution cumulative_distribution(std::vector<double> values) {
  std::erase_if(values, [](double value) { return std::isnan(value); });
  std::sort(values.begin(), values.end());
  CumulativeDistribution result{.value = std::move(values), .share = {}};
  const auto count = static_cast<double>(result.value.size());
  for (std::size_t i = 0; i < result.value.size(); ++i) {
    result.share.push_back(static_cast<double>(i + 1) / count);
  }
  return result;
}

PointLine decimate_min_max(std::span<const double> x,
                           std::span<const double> y,
                           std::size_t buckets) {
  NADIR_REQUIRE(x.size() == y.size() && buckets > 0);
  if (x.empty()) return {};
  Decimation decimation(x, y, buckets);
  for (std::size_t begin = 0; begin < y.size();) {
    std::size_t end = begin;
    while (end < y.size() && std::isfinite(y[end])) ++end;
    if (end > begin) decimation.add_piece(begin, end);
    begin = end + 1;
  }
  return decimation.take();
}

}  // namespace nadir
