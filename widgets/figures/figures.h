// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "core/base/progress.h"
#include "widgets/figures/figure_recipe.h"
#include "widgets/figures/figure_run.h"
#include "widgets/figures/page.h"

namespace nadir {

class FigureSources;

/// What a figure is made from: opened runs, and paths that exist.
struct FigureInputs {
  FigureOptions options;
  std::vector<FigureRun> runs;
  std::filesystem::path map;    ///< Map package; empty where the figure needs none.
  std::filesystem::path route;  ///< Route file; empty where there is none.
};

/// Width by height of a page that has no height of its own. What lies side by side on a page of 400 points and more lies
/// below each other on one of 240 points and less, which is higher for it; in between the shape is in between.
struct PageShape {
  // NOLINTNEXTLINE(google-explicit-constructor): most figures have one shape
  constexpr PageShape(double always) : wide(always), narrow(always) {}
  constexpr PageShape(double when_wide, double when_narrow)
      : wide(when_wide), narrow(when_narrow) {}
  double wide, narrow;
};

/// A figure that can be asked for by name. Numbers in the summaries are those of Rouben's thesis.
struct FigureKind {
  std::string_view name, summary;
  std::size_t fewest_runs = 0, most_runs = 0;
  bool needs_map = false;
  bool needs_truth = false;  ///< Fails without; the others leave out what cannot be drawn.
  PageShape aspect = 1.6;    ///< Where no height is asked for.
  Result<std::unique_ptr<Figure>> (*make)(FigureInputs inputs) = nullptr;
};

/// All figures, in the order of the help page.
[[nodiscard]] std::span<const FigureKind> figure_kinds();
/// @errors kInvalidOptions: no such figure, naming the nearest.
[[nodiscard]] Result<FigureKind> figure_kind(std::string_view name);

/// @errors kInvalidOptions: too few or too many runs, saying how many the figure needs.
[[nodiscard]] Result<void> check_run_count(const FigureKind& kind, std::size_t count);

/// Opens what the recipe names and makes the figure. @errors as its files; kInvalidOptions: too few or too many runs;
/// kMalformed: "R.nadir: has no truth, which figure 'flight' needs", and a run on another plane than the map that it is to
/// be drawn on; kCancelled.
/// @param sources  Open what has not been opened for an earlier figure.
[[nodiscard]] Result<std::unique_ptr<Figure>> make_figure(const FigureRecipe& recipe,
                                                          FigureSources& sources,
                                                          const WorkContext& work);
/// The only figure of its command.
[[nodiscard]] Result<std::unique_ptr<Figure>> make_figure(const FigureRecipe& recipe);

/// The page that a recipe asks for.
[[nodiscard]] PageFormat page_format(const FigureOptions& options, const PageShape& aspect);

// One function a figure; see figure_kinds() for what each shows.
[[nodiscard]] Result<std::unique_ptr<Figure>> make_overhead_pair(FigureInputs inputs);
[[nodiscard]] Result<std::unique_ptr<Figure>> make_route(FigureInputs inputs);
[[nodiscard]] Result<std::unique_ptr<Figure>> make_labels(FigureInputs inputs);
[[nodiscard]] Result<std::unique_ptr<Figure>> make_trajectories(FigureInputs inputs);
[[nodiscard]] Result<std::unique_ptr<Figure>> make_flight(FigureInputs inputs);
[[nodiscard]] Result<std::unique_ptr<Figure>> make_mse_bars(FigureInputs inputs);
[[nodiscard]] Result<std::unique_ptr<Figure>> make_cdf(FigureInputs inputs);
[[nodiscard]] Result<std::unique_ptr<Figure>> make_reconstruction(FigureInputs inputs);
[[nodiscard]] Result<std::unique_ptr<Figure>> make_consistency(FigureInputs inputs);
[[nodiscard]] Result<std::unique_ptr<Figure>> make_timing(FigureInputs inputs);
[[nodiscard]] Result<std::unique_ptr<Figure>> make_moment(FigureInputs inputs);
[[nodiscard]] Result<std::unique_ptr<Figure>> make_scene(FigureInputs inputs);
[[nodiscard]] Result<std::unique_ptr<Figure>> make_error_surface(FigureInputs inputs);
[[nodiscard]] Result<std::unique_ptr<Figure>> make_compare(FigureInputs inputs);

}  // namespace nadir
