// SPDX-License-Identifier: Apache-2.0
#include "widgets/figures/run_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "widgets/views/particle_view.h"

namespace nadir {
namespace {

constexpr std::array<double, 2> kSigmas = {3.0, 1.0};

/// Indices of steps that are at least so many seconds apart, the first and the last included.
std::vector<std::size_t> spaced(const FigureRun& run, std::size_t count, double every_s) {
  std::vector<std::size_t> chosen;
  double next_s = -1.0;
  for (std::size_t i = 0; i < count; ++i) {
    const double elapsed_s = run.elapsed_s(run.steps[i]);
    if (elapsed_s + kSameTimeS < next_s && i + 1 < count) continue;
    chosen.push_back(i);
    next_s = (std::floor((elapsed_s + kSameTimeS) / every_s) + 1.0) * every_s;
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
  if (std::none_of(path.begin(), path.end(), [](const auto& p) { return p.allFinite(); })) return;
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
  draw_path_mark(canvas, frame, PathMark::kStart, *known, 0.0, look);
  draw_path_mark(canvas, frame, PathMark::kEnd, path.back(), 0.0, look);
}

bool draws_ellipses(const FigureOptions& options) {
  return options.ellipse_every_s > 0.0 && options.layers.has(FigureLayer::kEllipses);
}

LegendEntry line_entry(const std::string& name, const PathLook& look) {
  return {name, look.colour, look.is_dashed ? LegendEntry::Kind::kDashed : LegendEntry::Kind::kLine,
          look.casing};
}

}  // namespace

void include_run(MapPanel& panel, const FigureRun& run) {
  for (const Source source : {Source::kTruth, Source::kOdometry, Source::kEstimate}) {
    panel.include(path_of(run, source));
  }
}

PathLook look_of(Source source, const Theme& theme) {
  switch (source) {
    case Source::kTruth:
      return truth_look(theme);
    case Source::kOdometry:
      return odometry_look(theme);
    case Source::kEstimate:
      break;
  }
  return estimate_look(theme);
}

FigureLayer layer_of(Source source) {
  switch (source) {
    case Source::kTruth:
      return FigureLayer::kTruth;
    case Source::kOdometry:
      return FigureLayer::kOdometry;
    case Source::kEstimate:
      break;
  }
  return FigureLayer::kEstimate;
}

void draw_runs(Canvas& canvas,
               const MapFrame& frame,
               std::span<const FigureRun> runs,
               const FigureOptions& options,
               double until_s,
               const Theme& theme) {
  const FigureRun& first = runs.front();
  const std::size_t count = first.index_at(until_s) + 1;
  for (const Source source : {Source::kOdometry, Source::kTruth}) {
    if (!options.layers.has(layer_of(source))) continue;
    draw_source(canvas, frame, first, count, source, options.tick_every_s, look_of(source, theme));
  }
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const FigureRun& run = runs[r];
    const PathLook look = estimate_look(theme, r);
    const std::size_t known = run.index_at(until_s) + 1;
    if (draws_ellipses(options)) {
      PathLook thin = look;
      thin.is_dashed = false;
      thin.width_pt = 0.8;
      thin.casing_pt = 0.3;
      for (const std::size_t i : spaced(run, known, options.ellipse_every_s)) {
        const PoseMoments& moments = run.steps[i].estimate.moments;
        draw_ellipses(canvas, frame, moments.mean.translation_m(),
                      moments.covariance.topLeftCorner<2, 2>(), kSigmas, thin);
      }
    }
    if (options.layers.has(FigureLayer::kEstimate)) {
      draw_source(canvas, frame, run, known, Source::kEstimate, options.tick_every_s, look);
    }
  }
}

std::vector<LegendEntry> run_legend(std::span<const FigureRun> runs,
                                    const FigureOptions& options,
                                    const Theme& theme) {
  std::vector<LegendEntry> entries = source_legend(runs.front(), options, theme);
  const bool has_estimate = options.layers.has(FigureLayer::kEstimate);
  if (runs.size() > 1) {
    // Only the first run's truth and odometry are drawn.
    if (has_estimate) entries.pop_back();
    for (LegendEntry& entry : entries) entry.name += " of " + runs.front().name;
    for (std::size_t r = 0; (has_estimate || draws_ellipses(options)) && r < runs.size(); ++r) {
      entries.push_back(line_entry(runs[r].name, estimate_look(theme, r)));
    }
  }
  if (draws_ellipses(options)) {
    entries.push_back(ellipse_legend("ellipses: 1 and 3 sigma", runs.size(), theme));
  }
  return entries;
}

std::vector<LegendEntry> source_legend(const FigureRun& run,
                                       const FigureOptions& options,
                                       const Theme& theme) {
  std::vector<LegendEntry> entries;
  for (const Source source : {Source::kTruth, Source::kOdometry, Source::kEstimate}) {
    const bool is_known =
        std::any_of(run.steps.begin(), run.steps.end(),
                    [source](const RunStep& step) { return pose_of(step, source).has_value(); });
    if (!is_known || !options.layers.has(layer_of(source))) continue;
    const std::array<const char*, 3> names = {"truth", "odometry (input)", "estimate"};
    entries.push_back(
        line_entry(names.at(static_cast<std::size_t>(source)), look_of(source, theme)));
  }
  return entries;
}

LegendEntry ellipse_legend(const std::string& name, std::size_t runs, const Theme& theme) {
  const PathLook look = estimate_look(theme);
  const Rgba colour = runs > 1 ? theme.muted : look.colour;
  return {name, colour, LegendEntry::Kind::kRings, look.casing};
}

LegendEntry particle_legend() {
  return {"particles, light is heavy",
          value_colour(ValueColours::kViridis, ParticleLook::kEqualShare), LegendEntry::Kind::kDot};
}

void name_apart(std::span<FigureRun> runs) {
  const auto number_of = [&runs](const std::string& name) {
    return std::count_if(runs.begin(), runs.end(),
                         [&name](const FigureRun& run) { return run.name == name; });
  };
  std::vector<std::string> names;
  for (const FigureRun& run : runs) {
    const std::string folder = run.path.parent_path().filename().string();
    names.push_back(number_of(run.name) > 1 && !folder.empty() ? folder + "/" + run.name
                                                               : run.name);
  }
  for (std::size_t i = 0; i < runs.size(); ++i) {
    runs[i].name = names[i];
    const auto before =
        std::count(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(i), names[i]);
    if (before > 0) runs[i].name += fmt::format(" ({})", before + 1);
  }
}

std::string foot_of_all(std::span<const FigureRun> runs) {
  if (runs.size() == 1) return foot_of(runs.front());
  std::string text;
  constexpr std::size_t kMostNamed = 4;
  for (std::size_t i = 0; i < std::min(runs.size(), kMostNamed); ++i) {
    text += (i > 0 ? " | " : "") + runs[i].name + ": " + foot_of(runs[i]);
  }
  if (runs.size() > kMostNamed) text += fmt::format(" | and {} more", runs.size() - kMostNamed);
  for (std::size_t i = kMostNamed; i < runs.size(); ++i) {
    if (!runs[i].evaluation.is_complete) {
      text += " | " + runs[i].name + ": stopped before its end";
    }
    for (const std::string& remark : runs[i].remarks) text += " | " + runs[i].name + ": " + remark;
  }
  return text;
}

}  // namespace nadir
