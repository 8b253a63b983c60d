// SPDX-License-Identifier: Apache-2.0
#include "core/session/run_document.h"

#include <sys/stat.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "core/eval/consistency.h"
#include "core/run/evaluate_run.h"

namespace nadir {
namespace fs = std::filesystem;
namespace {

constexpr double kUnknownNumber = std::numeric_limits<double>::quiet_NaN();

using LoadedRun = Result<std::shared_ptr<const RunDocument>>;

double root_or_unknown(double value) {
  return value >= 0.0 && std::isfinite(value) ? std::sqrt(value) : kUnknownNumber;
}

RunFileId file_id_of(const fs::path& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) return {};
  return {status.st_dev, status.st_ino};
}

RunSeries series_of(const std::vector<RunStep>& steps) {
  RunSeries series;
  for (auto* values : {&series.agreement, &series.effective_sample_size, &series.particle_count,
                       &series.topview_cells, &series.update_ms, &series.x_sigma_m,
                       &series.y_sigma_m, &series.yaw_sigma_rad, &series.position_sigma_m}) {
    values->reserve(steps.size());
  }
  for (const RunStep& step : steps) {
    const Eigen::Matrix3d& covariance = step.estimate.moments.covariance;
    series.agreement.push_back(step.agreement.value_or(kUnknownNumber));
    series.effective_sample_size.push_back(step.effective_sample_size);
    series.particle_count.push_back(step.particle_count);
    series.topview_cells.push_back(step.topview_cells);
    series.update_ms.push_back(step.update_ms);
    series.x_sigma_m.push_back(root_or_unknown(covariance(0, 0)));
    series.y_sigma_m.push_back(root_or_unknown(covariance(1, 1)));
    series.yaw_sigma_rad.push_back(root_or_unknown(covariance(2, 2)));
    series.position_sigma_m.push_back(root_or_unknown(position_spread_m2(covariance)));
  }
  return series;
}

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// Convex hull by Andrew's monotone chain: lower side, then upper side. O(n log n).
std::vector<Eigen::Vector2d> outline_of(const std::vector<RunStep>& steps) {
  std::vector<Eigen::Vector2d> points;
  for (const RunStep& step : steps) {
    const Rigid2& estimate = step.estimate.moments.mean;
    if (is_finite(estimate)) points.push_back(estimate.translation_m());
    if (step.truth_in_enu) points.push_back(step.truth_in_enu->translation_m());
  }
  const auto is_before = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  };
  std::sort(points.begin(), points.end(), is_before);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<Eigen::Vector2d> outline;
  const auto add_side = [&outline](auto from, auto to) {
    const std::size_t begin = outline.size();
    for (auto at = from; at != to; ++at) {
      while (outline.size() >= begin + 2 &&
             cross(outline.back() - outline[outline.size() - 2], *at - outline.back()) <= 0.0) {
        outline.pop_back();
      }
      outline.push_back(*at);
    }
    outline.pop_back();  // the other side begins with it
  };
  add_side(points.begin(), points.end());
  add_side(points.rbegin(), points.rend());
  return outline;
}

double usual_period_s(const std::vector<double>& time_s) {
  if (time_s.size() < 2) return 0.0;
  std::vector<double> periods;
  periods.reserve(time_s.size() - 1);
  for (std::size_t i = 1; i < time_s.size(); ++i) periods.push_back(time_s[i] - time_s[i - 1]);
  return lower_median(std::move(periods));
}

tl::unexpected<Error> stopped(const fs::path& path) {
  return fail(ErrorCode::kCancelled, "{}: reading was stopped", path.string());
}

/// Whether two readings of one step are of the same run.
bool is_same_step(const RunStep& a, const RunStep& b) {
  return a.step == b.step && a.time_s == b.time_s &&
         a.estimate.moments.mean == b.estimate.moments.mean;
}

}  // namespace

std::shared_ptr<const RunDocument> RunDocument::from_steps(RunDocument made) {
  RunDocument& run = made;
  if (run.name.empty()) run.name = run.path.stem().string();
  run.start_clock_s = run.steps.empty() ? 0.0 : run.steps.front().time_s;
  run.time_s.clear();
  run.judged.clear();
  run.time_s.reserve(run.steps.size());
  run.judged.reserve(run.steps.size());
  for (const RunStep& step : run.steps) {
    run.time_s.push_back(step.time_s - run.start_clock_s);
    run.judged.push_back(evaluated_step(step));
  }
  run.has_odometry = std::any_of(run.steps.begin(), run.steps.end(), [](const RunStep& step) {
    return step.odometry_in_enu.has_value();
  });
  run.outline_in_enu_m = outline_of(run.steps);
  run.series = series_of(run.steps);
  run.errors = error_series(run.judged);
  run.error_gaps = gaps_of(run.errors);
  run.gaps = time_gaps(run.time_s);
  run.median_period_s = usual_period_s(run.time_s);
  run.evaluation = evaluate_steps(run.judged).value();  // nothing fails without alignment
  describe(run.evaluation, run.header, run.path.string());
  run.evaluation.is_complete = run.is_complete;
  run.worst_moments = find_worst_moments(run);
  return std::make_shared<const RunDocument>(std::move(made));
}

LoadedRun RunDocument::load(const fs::path& path, const WorkContext& context) {
  context.report(0.0, "Opening the run");
  RunDocument run;
  run.path = path;
  run.file = file_id_of(path);  // asked first: of a file that comes after, grown() reads all
  auto reader = RunReader::open(path);
  if (!reader) return forward_error(reader);
  run.header = reader->header();
  // Asked before the steps: what is complete now was complete when they are read.
  run.is_complete = reader->is_complete();
  if (context.is_stopped()) return stopped(path);
  context.report(0.1, "Reading its steps");
  auto steps = reader->steps();
  if (!steps) return forward_error(steps);
  run.steps = std::move(*steps);
  if (context.is_stopped()) return stopped(path);
  context.report(0.7, "Judging it");
  auto loaded = from_steps(std::move(run));
  context.report(1.0, "Done");
  return loaded;
}

LoadedRun RunDocument::grown(const std::shared_ptr<const RunDocument>& earlier,
                             const WorkContext& context) {
  const fs::path& path = earlier->path;
  if (earlier->steps.empty() || file_id_of(path) != earlier->file) return load(path, context);
  const auto reader = RunReader::open(path);
  if (!reader) return forward_error(reader);
  if (reader->header() != earlier->header) return load(path, context);
  const bool is_complete = reader->is_complete();
  auto steps = reader->steps_from(earlier->steps.back().step);
  if (!steps) return forward_error(steps);
  if (steps->empty() || !is_same_step(steps->front(), earlier->steps.back())) {
    return load(path, context);
  }
  if (steps->size() == 1 && is_complete == earlier->is_complete) return earlier;
  if (context.is_stopped()) return stopped(path);
  RunDocument run;
  run.path = path;
  run.name = earlier->name;
  run.file = earlier->file;
  run.header = earlier->header;
  run.is_complete = is_complete;
  run.steps.reserve(earlier->steps.size() + steps->size() - 1);
  run.steps = earlier->steps;
  std::move(steps->begin() + 1, steps->end(), std::back_inserter(run.steps));
  return from_steps(std::move(run));
}

std::optional<std::size_t> RunDocument::latest_at(double moment_s) const {
  const auto after = std::upper_bound(time_s.begin(), time_s.end(), moment_s + kSameTimeS);
  if (after == time_s.begin()) return std::nullopt;
  return static_cast<std::size_t>(after - time_s.begin()) - 1;
}

std::optional<std::size_t> RunDocument::index_at(double moment_s) const {
  if (steps.empty()) return std::nullopt;
  return latest_at(moment_s).value_or(0);
}

std::optional<std::size_t> RunDocument::error_index_of(std::size_t step_index) const {
  const auto found = std::lower_bound(errors.step.begin(), errors.step.end(), step_index);
  if (found == errors.step.end() || *found != step_index) return std::nullopt;
  return static_cast<std::size_t>(found - errors.step.begin());
}

}  // namespace nadir
