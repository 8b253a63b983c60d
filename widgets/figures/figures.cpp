// SPDX-License-Identifier: Apache-2.0
#include "widgets/figures/figures.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/settings.h"

namespace nadir {
namespace {

constexpr std::size_t kMany = 1000;

constexpr std::array<FigureKind, 12> kFigures{{
    {"overhead-pair", "the overhead beside its labels (4-1)", 0, 1, true, false, 1.75,
     make_overhead_pair},
    {"route", "numbered waypoints over the overhead (4-2, 4-3)", 0, 1, true, false, 1.25,
     make_route},
    {"flight", "trajectories with ellipses, errors over time (4-4 to 4-6)", 1, 1, true, true, 1.0,
     make_flight},
    {"mse-bars", "mean squared errors of each run, input against estimate (4-7)", 1, kMany, false,
     true, 2.0, make_mse_bars},
    {"cdf", "distribution of position and orientation errors (4-8)", 1, kMany, false, true, 2.2,
     make_cdf},
    {"trajectories", "truth, odometry and estimate over the overhead (4-9, 4-11)", 1, kMany, true,
     false, 1.25, make_trajectories},
    {"labels", "the labelled overhead with its classes (4-10)", 0, 1, true, false, 1.25,
     make_labels},
    {"reconstruction", "all topviews at odometry and estimate (4-12, 4-13)", 1, 1, true, false,
     1.75, make_reconstruction},
    {"consistency", "is the filter as sure as it may be: NEES, coverage, deviations", 1, 1, false,
     true, 1.3, make_consistency},
    {"moment", "one instant: particles, camera, topview against the map", 1, 1, true, false, 1.45,
     make_moment},
    {"error-surface", "cost of every pose around the estimate at one instant", 1, 1, true, false,
     1.8, make_error_surface},
    {"compare", "several runs over the overhead and their errors over time", 2, kMany, true, true,
     1.0, make_compare},
}};

Result<void> check_runs(const FigureKind& kind, const FigureRecipe& recipe) {
  const std::size_t count = recipe.runs.size();
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

}  // namespace

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

PageFormat page_format(const FigureOptions& options, double aspect) {
  // A page of 7.5 inches, the width of a text column and its margins; below 720 pixels text keeps a size that can be read.
  constexpr double kPageInches = 7.5;
  constexpr double kLeastDpi = 96.0;
  PageFormat format;
  format.width = options.width;
  format.height = options.height > 0
                      ? options.height
                      : std::max(1, static_cast<int>(std::lround(options.width / aspect)));
  format.dpi = options.dpi > 0.0 ? options.dpi : std::max(kLeastDpi, options.width / kPageInches);
  format.theme = options.theme;
  format.is_transparent = options.is_transparent;
  return format;
}

Result<std::unique_ptr<Figure>> make_figure(const FigureRecipe& recipe) {
  const auto kind = figure_kind(recipe.figure);
  if (!kind) return forward_error(kind);
  if (auto valid = validate(recipe.options); !valid) return forward_error(valid);
  constexpr double kLeastCropM = 0.1;  // less is no ground that a map could show, and no ticks fit
  if (recipe.options.crop_width_m > 0.0 && recipe.options.crop_width_m < kLeastCropM) {
    return fail(ErrorCode::kInvalidOptions, "--crop-width: {} is neither 0 nor at least {} m",
                recipe.options.crop_width_m, kLeastCropM);
  }
  if (auto enough = check_runs(*kind, recipe); !enough) return forward_error(enough);
  FigureInputs inputs;
  inputs.options = recipe.options;
  inputs.route = recipe.route;
  for (const std::string& path : recipe.runs) {
    auto run = open_figure_run(path, recipe.options);
    if (!run) return forward_error(run);
    if (kind->needs_truth && !run->has_truth()) {
      return fail(ErrorCode::kMalformed, "{}: has no truth, which figure '{}' needs", path,
                  kind->name);
    }
    inputs.runs.push_back(std::move(*run));
  }
  inputs.map = recipe.map;
  if (kind->needs_map && inputs.map.empty()) {
    if (inputs.runs.empty()) {
      return fail(ErrorCode::kInvalidOptions, "figure '{}' needs a map (--map FOLDER)", kind->name);
    }
    auto map = find_map_of(inputs.runs.front());
    if (!map) return forward_error(map);
    inputs.map = *map;
  }
  return kind->make(std::move(inputs));
}

}  // namespace nadir
