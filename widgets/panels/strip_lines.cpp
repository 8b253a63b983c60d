// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/strip_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/eval/consistency.h"

namespace nadir {
namespace {

constexpr double kMsPerS = 1000.0;
constexpr double kPercentOfCells = 100.0;
constexpr double kDegPerRad = 180.0 / std::numbers::pi;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
/// Where a few values are so many times larger than nearly all others, the strip shows those others and cuts the few off.
constexpr double kMostOverUsual = 3.0, kUsualShare = 0.98, kRoomAboveUsual = 1.5;
/// A budget so many times longer than the longest update is left out.
constexpr double kMostBudget = 3.0;

constexpr std::array<StripInfo, kStripCount> kStripInfos = {{
    {"Position error", "m", "Distance from the estimate to the truth in the plane"},
    {"Orientation error", "deg", "Angle between the estimated and the true heading"},
    {"Standard deviation", "m", "How sure the filter is, east (full) and north (pale)"},
    {"Effective particles", "",
     "How many equal particles would say as much; all particles in grey"},
    {"Agreement", "%", "Share of seen cells whose class is the map's at the estimate"},
    {"NEES", "",
     "Squared error of each step in the filter's own sigmas: x, y and heading; dashed the 95 % "
     "chi-square bounds 0.22 and 9.35 (3 degrees of freedom), red above"},
    {"Update time", "ms", "Computing time of a step; the line is the time between steps"},
    {"Streams", "", "What the flight and the run have at each moment"},
}};

/// Digits after the point of a strip's values.
constexpr std::array<int, kStripCount> kDecimals = {2, 1, 2, 0, 1, 1, 1, 0};

/// Numbers with their times, both of the run; indices before which the line breaks.
struct RunLine {
  std::span<const double> time_s;
  std::vector<double> values;
  std::span<const std::size_t> gaps;
};

RunLine error_line(const RunDocument& run, const std::vector<double>& values, double factor) {
  RunLine line{run.errors.time_s, values, run.error_gaps};
  for (double& value : line.values) value = std::abs(value) * factor;
  return line;
}
RunLine step_line(const RunDocument& run, const std::vector<double>& values, double factor = 1.0) {
  RunLine line{run.time_s, values, run.gaps};
  for (double& value : line.values) value *= factor;
  return line;
}

/// Lines of a run, the first the most important; the second is drawn pale or muted.
std::vector<RunLine> lines_of(Strip strip, const RunDocument& run) {
  switch (strip) {
    case Strip::kPositionError:
      return {error_line(run, run.errors.position_error_m, 1.0)};
    case Strip::kOrientationError:
      return {error_line(run, run.errors.yaw_error_rad, kDegPerRad)};
    case Strip::kSigma:
      return {step_line(run, run.series.x_sigma_m), step_line(run, run.series.y_sigma_m)};
    case Strip::kSampleSize:
      return {step_line(run, run.series.effective_sample_size),
              step_line(run, run.series.particle_count)};
    case Strip::kAgreement:
      return {step_line(run, run.series.agreement, kPercentOfCells)};
    case Strip::kNees:
      return {error_line(run, run.errors.nees, 1.0)};
    case Strip::kUpdateTime:
      return {step_line(run, run.series.update_ms)};
    case Strip::kStreams:
      return {};
  }
  return {};
}

/// Thinned for the pixels, in the timeline's time.
PointLine thinned(const RunLine& line, double offset_s, double px_per_s) {
  if (line.time_s.empty()) return {};
  std::vector<double> times = broken_at(line.gaps, line.time_s);
  for (std::size_t i = 0; i < times.size();
       ++i) {  // a gap's own time matters to nobody, but it has to be finite
    if (std::isnan(times[i])) times[i] = i == 0 ? line.time_s.front() : times[i - 1];
  }
  const double width_px = (line.time_s.back() - line.time_s.front()) * px_per_s;
  const auto buckets = static_cast<std::size_t>(std::clamp(std::ceil(width_px), 1.0, 1e6));
  PointLine thin = decimate_min_max(times, broken_at(line.gaps, line.values), buckets);
  for (double& moment_s : thin.x) moment_s += offset_s;
  return thin;
}

/// From 0 to a round number above the values. Where a few are much larger than nearly all, above nearly all.
void fit_range(StripPlot& plot, std::vector<double> values) {
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  if (values.empty()) return;
  const auto usual = values.begin() + static_cast<std::ptrdiff_t>(
                                          kUsualShare * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), usual, values.end());
  const double usual_value = *usual;
  const double largest = *std::max_element(usual, values.end());
  plot.high = round_up(largest);
  if (usual_value > 0.0 && largest > kMostOverUsual * usual_value) {
    plot.high = round_up(kRoomAboveUsual * usual_value);
    if (largest > plot.high) plot.cut_off = largest;
  }
}

/// NEES goes over powers of ten, and so do its bounds.
void fit_nees(StripPlot& plot, const std::vector<double>& values) {
  double largest = 0.0;
  for (const double value : values) {
    if (std::isfinite(value)) largest = std::max(largest, value);
  }
  plot.is_logarithmic = true;
  plot.low = 0.1;
  plot.high = 100.0;
  constexpr double kMostHigh = 1e6;
  while (plot.high < largest && plot.high < kMostHigh) plot.high *= 10.0;
  if (largest > plot.high) plot.cut_off = largest;
  const StepNeesBounds bounds = step_nees_bounds();
  plot.levels.push_back({bounds.upper, true});
  plot.levels.push_back({bounds.lower, false});  // to be cautious harms nobody
}

/// The time between steps, where it is not far above what the updates took.
void add_budget(StripPlot& plot,
                std::span<const TimelineRun> runs,
                const std::vector<double>& values) {
  double longest_ms = 0.0;
  for (const double value : values) {
    if (std::isfinite(value)) longest_ms = std::max(longest_ms, value);
  }
  const double budget_ms = runs.empty() ? 0.0 : kMsPerS * runs.back().document->median_period_s;
  if (!(budget_ms > 0.0) || budget_ms > kMostBudget * longest_ms) return;
  plot.levels.push_back({budget_ms, true});
  plot.high = std::max(plot.high, round_up(budget_ms));
  if (plot.cut_off && *plot.cut_off <= plot.high) plot.cut_off.reset();
}

StripCurve::Tone second_tone(Strip strip) {
  return strip == Strip::kSampleSize ? StripCurve::Tone::kMuted : StripCurve::Tone::kPale;
}

std::string with_decimals(double value, int decimals) {
  return std::isfinite(value) ? fmt::format("{:.{}f}", value, decimals) : "–";
}

}  // namespace

const StripInfo& strip_info(Strip strip) { return kStripInfos.at(static_cast<std::size_t>(strip)); }

double StripPlot::height_of(double value) const {
  if (std::isnan(value)) return value;
  constexpr double kBeyond = 10.0;
  double height = (value - low) / (high - low);
  if (is_logarithmic) {
    height = value > 0.0 ? std::log10(value / low) / std::log10(high / low) : -kBeyond;
  }
  return std::clamp(height, -kBeyond, kBeyond);
}

StripPlot strip_plot(Strip strip, std::span<const TimelineRun> runs, double px_per_s) {
  StripPlot plot;
  std::vector<double> values;
  for (const TimelineRun& run : runs) {
    std::vector<RunLine> lines = lines_of(strip, *run.document);
    for (std::size_t i = lines.size(); i-- > 0;) {  // the most important on top
      values.insert(values.end(), lines[i].values.begin(), lines[i].values.end());
      const auto tone = i == 0 ? StripCurve::Tone::kRun : second_tone(strip);
      plot.curves.push_back({thinned(lines[i], run.offset_s, px_per_s), tone, run.colour});
    }
  }
  if (strip == Strip::kNees) {
    fit_nees(plot, values);
    const double bound = plot.levels.front().value;
    for (std::size_t i = 0, count = plot.curves.size(); i < count; ++i) {
      plot.curves.push_back(
          {above(plot.curves[i].line, bound), StripCurve::Tone::kBad, plot.curves[i].colour});
    }
    return plot;
  }
  fit_range(plot, values);
  if (strip == Strip::kAgreement) {
    plot.high = kPercentOfCells;
    plot.cut_off.reset();
  }
  if (strip == Strip::kUpdateTime) add_budget(plot, runs, values);
  return plot;
}

StripNumbers strip_numbers(Strip strip, const TimelineRun& run, double moment_s) {
  const RunDocument& document = *run.document;
  const auto step = document.latest_at(moment_s - run.offset_s);
  // Within a step after its last one a run still says what it said there.
  constexpr double kSlackS = 1e-6;
  const double end_s = document.duration_s() + document.median_period_s + kSlackS;
  if (!step || moment_s - run.offset_s > end_s) return {};
  const auto error = document.error_index_of(*step);
  const auto of_error = [&](const std::vector<double>& all) {
    return error ? std::abs(all[*error]) : kNan;
  };
  const RunSeries& series = document.series;
  switch (strip) {
    case Strip::kPositionError:
      return {of_error(document.errors.position_error_m), kNan};
    case Strip::kOrientationError:
      return {of_error(document.errors.yaw_error_rad) * kDegPerRad, kNan};
    case Strip::kSigma:
      return {series.x_sigma_m[*step], series.y_sigma_m[*step]};
    case Strip::kSampleSize:
      return {series.effective_sample_size[*step], series.particle_count[*step]};
    case Strip::kAgreement:
      return {series.agreement[*step] * kPercentOfCells, kNan};
    case Strip::kNees:
      return {of_error(document.errors.nees), kNan};
    case Strip::kUpdateTime:
      return {series.update_ms[*step], kNan};
    case Strip::kStreams:
      return {};
  }
  return {};
}

std::string strip_value(Strip strip, const TimelineRun& run, double moment_s) {
  const StripNumbers numbers = strip_numbers(strip, run, moment_s);
  if (std::isnan(numbers.main) && std::isnan(numbers.second)) return "–";
  const int decimals = kDecimals.at(static_cast<std::size_t>(strip));
  std::string main = with_decimals(numbers.main, decimals);
  if (strip == Strip::kSigma) return main + " " + with_decimals(numbers.second, decimals);
  if (strip == Strip::kSampleSize) return main + "/" + with_decimals(numbers.second, decimals);
  return main;
}

std::string short_strip_value(Strip strip, const TimelineRun& run, double moment_s) {
  return with_decimals(strip_numbers(strip, run, moment_s).main,
                       kDecimals.at(static_cast<std::size_t>(strip)));
}

PointLine above(const PointLine& line, double limit) {
  PointLine parts;
  const auto push = [&parts](double x, double y) {
    parts.x.push_back(x);
    parts.y.push_back(y);
  };
  bool is_open = false;
  for (std::size_t i = 0; i < line.y.size(); ++i) {
    const bool is_above = line.y[i] > limit;
    const bool has_before = i > 0 && std::isfinite(line.y[i - 1]) && std::isfinite(line.y[i]);
    if (has_before && is_above != (line.y[i - 1] > limit)) {
      const double share = (limit - line.y[i - 1]) / (line.y[i] - line.y[i - 1]);
      const double crossing = line.x[i - 1] + share * (line.x[i] - line.x[i - 1]);
      if (is_above && !parts.x.empty()) push(crossing, kNan);
      push(crossing, limit);
      is_open = is_above;
    } else if (is_above && !is_open) {
      if (!parts.x.empty()) push(line.x[i], kNan);
      is_open = true;
    } else if (!std::isfinite(line.y[i])) {
      is_open = false;
    }
    if (is_above) push(line.x[i], line.y[i]);
  }
  return parts;
}

double round_up(double value) {
  if (!(value > 0.0) || !std::isfinite(value)) return 1.0;
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  constexpr double kSlack = 1.0 - 1e-9;
  for (const double factor : {1.0, 2.0, 2.5, 5.0}) {
    if (value * kSlack <= factor * power) return factor * power;
  }
  return 10.0 * power;
}

}  // namespace nadir
