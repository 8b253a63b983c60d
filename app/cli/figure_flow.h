// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "widgets/figures/figure_recipe.h"

namespace nadir::cli {

/// What the user should know of a figure that was drawn all the same, one sentence each: fonts that are missing, and
/// inputs that have changed since the recipe was drawn.
using FigureNotes = std::vector<std::string>;

/// Draws a figure into a file whose ending says what kind: .png, .svg, .pdf or .mp4. The file is whole or as it was.
/// @errors kInvalidOptions: another ending; kIo: not writable, both before any work; as make_figure, Figure::draw and
/// write_film.
[[nodiscard]] Result<FigureNotes> write_figure(const FigureRecipe& recipe,
                                               const std::filesystem::path& path,
                                               const WorkContext& work);

/// The same as a PNG on a stream.
[[nodiscard]] Result<FigureNotes> stream_figure(const FigureRecipe& recipe,
                                                std::ostream& out,
                                                const WorkContext& work);

/// The recipe that a PNG or SVG carries. @errors kNotFound, kMalformed: no such file, no recipe in it.
[[nodiscard]] Result<FigureRecipe> stored_recipe(const std::filesystem::path& path);

}  // namespace nadir::cli
