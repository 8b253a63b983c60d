// SPDX-License-Identifier: Apache-2.0
#include "widgets/figures/run_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace nadir {
namespace {

constexpr std::array<double, 2> kSigmas = {3.0, 1.0};

/// Indices of steps that are at least so many seconds apart, the first and the last included.
std::vector<std::size_t> spaced(const FigureRun& run, std::size_t count, double every_s) {
  std::vector<std::size_t> chosen;
  double next_s = -1.0;
  for (std::size_t i = 0; i < count; ++i) {
    const double elapsed_s = run.elapsed_s(run.steps[i]);
    if (elapsed_s + 1e-9 < next_s && i + 1 < count) continue;
    chosen.push_back(i);
    next_s = (std::floor(elapsed_s / every_s + 1e-9) + 1.0) * every_s;
  }
  return chosen;
}

void draw_source(Canvas& canvas,
                 const MapFrame& frame,
                 const FigureRun& run,
                 std::size_t count,
                 Source source,
                 double tick_every_s,
                 const PathLook& look) {
  std::vector<Eigen::Vector2d> path = path_of(run, source);
  path.resize(count);
  draw_path(canvas, frame, path, look);
  if (tick_every_s > 0.0) {
    for (const std::size_t i : spaced(run, count, tick_every_s)) {
      const auto pose = pose_of(run.steps[i], source);
      if (pose) {
        draw_path_mark(canvas, frame, PathMark::kTick, pose->translation_m(), pose->yaw_rad, look);
      }
    }
  }
  const auto known = std::find_if(path.begin(), path.end(),
                                  [](const Eigen::Vector2d& p) { return p.allFinite(); });
  if (known == path.end()) return;
  draw_path_mark(canvas, frame, PathMark::kStart, *known, 0.0, look);
  draw_path_mark(canvas, frame, PathMark::kEnd, path.back(), 0.0, look);
}

}  // namespace

void include_run(MapPanel& panel, const FigureRun& run) {
  for (const Source source : {Source::kTruth, Source::kOdometry, Source::kEstimate}) {
    panel.include(path_of(run, source));
  }
}

void draw_runs(Canvas& canvas,
               const MapFrame& frame,
               std::span<const FigureRun> runs,
               const FigureOptions& options,
               double until_s,
               const Theme& theme) {
  const FigureRun& first = runs.front();
  const std::size_t count = first.index_at(until_s) + 1;
  draw_source(canvas, frame, first, count, Source::kOdometry, options.tick_every_s,
              odometry_look(theme));
  draw_source(canvas, frame, first, count, Source::kTruth, options.tick_every_s, truth_look(theme));
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const FigureRun& run = runs[r];
    const PathLook look = estimate_look(theme, r);
    const std::size_t known = run.index_at(until_s) + 1;
    if (options.ellipse_every_s > 0.0) {
      PathLook thin = look;
      thin.width_pt = 0.8;
      thin.casing_pt = 0.3;
      for (const std::size_t i : spaced(run, known, options.ellipse_every_s)) {
        const PoseMoments& moments = run.steps[i].estimate.moments;
        draw_ellipses(canvas, frame, moments.mean.translation_m(),
                      moments.covariance.topLeftCorner<2, 2>(), kSigmas, thin);
      }
    }
    draw_source(canvas, frame, run, known, Source::kEstimate, options.tick_every_s, look);
  }
}

std::vector<LegendEntry> run_legend(std::span<const FigureRun> runs, const Theme& theme) {
  std::vector<LegendEntry> entries;
  const FigureRun& first = runs.front();
  const auto add = [&](const std::string& name, const PathLook& look) {
    entries.push_back({name, look.colour,
                       look.is_dashed ? LegendEntry::Kind::kDashed : LegendEntry::Kind::kLine,
                       look.casing});
  };
  if (first.has_truth()) add("truth", truth_look(theme));
  if (first.steps.front().odometry_in_enu) add("odometry (input)", odometry_look(theme));
  for (std::size_t r = 0; r < runs.size(); ++r) {
    add(runs.size() == 1 ? "estimate with 1 and 3 sigma ellipses" : runs[r].name,
        estimate_look(theme, r));
  }
  return entries;
}

std::string foot_of_all(std::span<const FigureRun> runs) {
  if (runs.size() == 1) return foot_of(runs.front());
  std::string text;
  constexpr std::size_t kMostNamed = 4;
  for (std::size_t i = 0; i < std::min(runs.size(), kMostNamed); ++i) {
    text += (i > 0 ? " | " : "") + runs[i].name + ": " + foot_of(runs[i]);
  }
  if (runs.size() > kMostNamed) text += fmt::format(" | and {} more", runs.size() - kMostNamed);
  return text;
}

std::optional<FigureTimes> times_of(std::span<const FigureRun> runs) {
  FigureTimes times{1e300, -1e300};
  for (const FigureRun& run : runs) {
    times.first_s = std::min(times.first_s, run.elapsed_s(run.steps.front()));
    times.last_s = std::max(times.last_s, run.elapsed_s(run.steps.back()));
  }
  return times;
}

}  // namespace nadir
