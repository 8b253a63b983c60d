// SPDX-License-Identifier: Apache-2.0
#include "widgets/figures/figure_file.h"

#include <fmt/format.h>

#include "core/base/version.h"
#include "widgets/figures/figures.h"

namespace nadir {

Result<PageFacts> facts_of_recipe(const FigureRecipe& recipe,
                                  FigureSources& sources,
                                  const WorkContext& work) {
  const auto kind = figure_kind(recipe.figure);
  if (!kind) return forward_error(kind);
  auto hashes = hash_inputs(recipe, sources, work);
  if (!hashes) return forward_error(hashes);
  FigureRecipe carried = recipe;
  carried.inputs = std::move(*hashes);
  return PageFacts{fmt::format("Nadir: {}", kind->summary),
                   fmt::format("# Drawn by Nadir {}; 'nadir figure' draws it again from this "
                               "recipe, --recreate from PNG "
                               "and SVG.\n{}",
                               kVersion, recipe_text(carried))};
}

Result<std::string> draw_recipe(const FigureRecipe& recipe,
                                PageFile kind,
                                FigureSources& sources,
                                const WorkContext& work) {
  work.report(0.0, "reading the run and the map");
  const auto known = figure_kind(recipe.figure);
  if (!known) return forward_error(known);
  const auto figure = make_figure(recipe, sources, work);
  if (!figure) return forward_error(figure);
  const auto facts = facts_of_recipe(recipe, sources, work);
  if (!facts) return forward_error(facts);
  if (work.is_stopped())
    return fail(ErrorCode::kCancelled, "figure '{}': was stopped", known->name);
  work.report(0.5, "drawing");
  FigureContext context(page_format(recipe.options, known->aspect));
  return draw_file(**figure, context, kind, *facts);
}

}  // namespace nadir
