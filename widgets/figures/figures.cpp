// SPDX-License-Identifier: Apache-2.0
#include "widgets/figures/figures.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/settings.h"
#include "widgets/figures/figure_sources.h"
#include "widgets/figures/run_lines.h"
#include "widgets/figures/run_on_map.h"

namespace nadir {
namespace {

constexpr std::size_t kMany = 1000;

constexpr std::array<FigureKind, 14> kFigures{{
    {"overhead-pair",
     "the overhead beside its labels (4-1)",
     0,
     1,
     true,
     false,
     {2.0, 0.6},
     make_overhead_pair},
    {"route",
     "numbered waypoints over the overhead (4-2, 4-3)",
     0,
     1,
     true,
     false,
     {1.25, 1.1},
     make_route},
    {"flight",
     "trajectories with ellipses, errors over time (4-4 to 4-6)",
     1,
     1,
     true,
     true,
     {1.0, 0.5},
     make_flight},
    {"mse-bars",
     "mean squared errors of each run, input against estimate (4-7)",
     1,
     kMany,
     false,
     true,
     {2.0, 1.2},
     make_mse_bars},
    {"cdf",
     "distribution of position and orientation errors (4-8)",
     1,
     kMany,
     false,
     true,
     {2.2, 1.2},
     make_cdf},
    {"trajectories",
     "truth, odometry and estimate over the overhead (4-9, 4-11)",
     1,
     kMany,
     true,
     false,
     {1.25, 1.05},
     make_trajectories},
    {"labels",
     "the labelled overhead with its classes (4-10)",
     0,
     1,
     true,
     false,
     {1.25, 0.95},
     make_labels},
    {"reconstruction",
     "all topviews at odometry and estimate (4-12, 4-13)",
     1,
     1,
     true,
     false,
     {1.15, 0.6},
     make_reconstruction},
    {"consistency",
     "is the filter as sure as it may be: NEES, calibration, sample size, agreement",
     1,
     1,
     false,
     true,
     {1.3, 0.7},
     make_consistency},
    {"timing",
     "computing time, effective sample size and particles over time",
     1,
     1,
     false,
     false,
     {1.5, 0.9},
     make_timing},
    {"moment",
     "one instant: particles, camera, topview against the map",
     1,
     1,
     true,
     false,
     {1.2, 0.42},
     make_moment},
    {"scene",
     "one instant in space: the camera's labelled points on the overhead",
     1,
     1,
     true,
     false,
     {1.5, 1.0},
     make_scene},
    {"error-surface",
     "cost of every pose around the estimate at one instant",
     1,
     1,
     true,
     false,
     {1.55, 0.6},
     make_error_surface},
    {"compare",
     "several runs over the overhead and their errors over time",
     2,
     kMany,
     true,
     true,
     {1.0, 0.5},
     make_compare},
}};

}  // namespace

Result<void> check_run_count(const FigureKind& kind, std::size_t count) {
  if (count < kind.fewest_runs) {
    return fail(ErrorCode::kInvalidOptions, "figure '{}' needs {}", kind.name,
                kind.fewest_runs == 1 ? "a run (--run FILE)"
                                      : fmt::format("at least {} runs", kind.fewest_runs));
  }
  if (count > kind.most_runs) {
    return fail(ErrorCode::kInvalidOptions, "figure '{}' shows one run, and {} are given",
                kind.name, count);
  }
  return {};
}

std::span<const FigureKind> figure_kinds() { return kFigures; }

Result<FigureKind> figure_kind(std::string_view name) {
  const auto found = std::find_if(kFigures.begin(), kFigures.end(),
                                  [name](const FigureKind& kind) { return kind.name == name; });
  if (found != kFigures.end()) return *found;
  std::vector<std::string> names;
  names.reserve(kFigures.size());
  for (const FigureKind& kind : kFigures) names.emplace_back(kind.name);
  const std::string nearest = nearest_word(name, names);
  return fail(ErrorCode::kInvalidOptions, "'{}' is no figure{}", name,
              nearest.empty() ? std::string() : fmt::format(" (did you mean {}?)", nearest));
}

PageFormat page_format(const FigureOptions& options, const PageShape& aspect) {
  // A page of 7.5 inches, the width of a text column and its margins; below 720 pixels text keeps a size that can be read.
  constexpr double kPageInches = 7.5;
  constexpr double kLeastDpi = 96.0;
  PageFormat format;
  const auto [width, height] = options.size;
  format.width = width;
  format.dpi = options.dpi > 0.0 ? options.dpi : std::max(kLeastDpi, width / kPageInches);
  constexpr double kNarrowPt = 240.0;
  constexpr double kWidePt = 400.0;
  const double share =
      std::clamp((width / format.px_per_pt() - kNarrowPt) / (kWidePt - kNarrowPt), 0.0, 1.0);
  const double shape = std::lerp(aspect.narrow, aspect.wide, share);
  format.height = height > 0 ? height : std::max(1, static_cast<int>(std::lround(width / shape)));
  format.theme = options.theme;
  format.is_transparent = options.is_transparent;
  return format;
}

namespace {

Result<void> check_request(const FigureKind& kind, const FigureRecipe& recipe) {
  if (auto valid = validate(recipe.options); !valid) return valid;
  if (recipe.options.from_s > recipe.options.to_s) {
    return fail(ErrorCode::kInvalidOptions, "--from: {:g} s is after --to {:g} s",
                recipe.options.from_s, recipe.options.to_s);
  }
  constexpr double kLeastWidthPt = 100.0;
  constexpr double kLeastHeightPt = 60.0;
  const PageFormat page = page_format(recipe.options, kind.aspect);
  const double px = page.px_per_pt();
  if (page.width < kLeastWidthPt * px || page.height < kLeastHeightPt * px) {
    return fail(ErrorCode::kInvalidOptions,
                "a page of {} x {} pixels at {:g} dpi is too small for a figure (--size, --dpi)",
                page.width, page.height, page.dpi);
  }
  return check_run_count(kind, recipe.runs.size());
}

Result<std::vector<FigureRun>> open_runs(const FigureKind& kind,
                                         const FigureRecipe& recipe,
                                         FigureSources& sources,
                                         const WorkContext& work) {
  std::vector<FigureRun> runs;
  for (const std::string& path : recipe.runs) {
    if (work.is_stopped()) return fail(ErrorCode::kCancelled, "{}: was stopped", path);
    auto run = sources.run(path, recipe.options);
    if (!run) return forward_error(run);
    if (kind.needs_truth && !run->has_truth()) {
      return fail(ErrorCode::kMalformed, "{}: has no truth, which figure '{}' needs", path,
                  kind.name);
    }
    runs.push_back(std::move(*run));
  }
  name_apart(runs);
  return runs;
}

}  // namespace

Result<std::unique_ptr<Figure>> make_figure(const FigureRecipe& recipe) {
  FigureSources sources;
  return make_figure(recipe, sources, {});
}

Result<std::unique_ptr<Figure>> make_figure(const FigureRecipe& recipe,
                                            FigureSources& sources,
                                            const WorkContext& work) {
  const auto kind = figure_kind(recipe.figure);
  if (!kind) return forward_error(kind);
  if (auto valid = check_request(*kind, recipe); !valid) return forward_error(valid);
  auto runs = open_runs(*kind, recipe, sources, work);
  if (!runs) return forward_error(runs);
  auto map = map_of_recipe(recipe, sources);
  if (!map) return forward_error(map);
  FigureInputs inputs{recipe.options, std::move(*runs), *map, route_of_recipe(recipe, *map)};
  // A figure that takes a run only to find its map draws nothing of it.
  if (kind->fewest_runs > 0) {
    if (kind->needs_map) {
      const auto facts = sources.map(*map);
      if (!facts) return forward_error(facts);
      for (FigureRun& run : inputs.runs) {
        if (auto laid = lay_on_map(run, *map, *facts); !laid) return forward_error(laid);
      }
    }
    remark_on_flights(inputs.runs, kind->needs_map);
  }
  if (work.is_stopped()) {
    return fail(ErrorCode::kCancelled, "figure '{}': was stopped", kind->name);
  }
  return kind->make(std::move(inputs));
}

}  // namespace nadir
