// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "widgets/figures/figure_sources.h"
#include "widgets/figures/page.h"

namespace nadir {

/// What goes into the file of a recipe's figure beside the picture: the recipe, the version that drew it and the hashes of
/// its inputs as they are now. @errors as figure_kind and hash_inputs.
[[nodiscard]] Result<PageFacts> facts_of_recipe(const FigureRecipe& recipe,
                                                FigureSources& sources,
                                                const WorkContext& work);

/// Makes a figure and draws it as the bytes of a file with its recipe inside. The work is asked whether to stop before the
/// inputs are read and before the page is drawn. @errors as make_figure, facts_of_recipe and Figure::draw.
[[nodiscard]] Result<std::string> draw_recipe(const FigureRecipe& recipe,
                                              PageFile kind,
                                              FigureSources& sources,
                                              const WorkContext& work);

}  // namespace nadir
