// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <ostream>

#include "core/base/progress.h"
#include "widgets/figures/figures.h"

namespace nadir::cli {

/// Draws a figure into a file whose ending says what kind: .png, .svg, .pdf or .mp4. The file is whole or as it was.
/// @errors kInvalidOptions: another ending; as make_figure, Figure::draw and write_film; kIo.
[[nodiscard]] Result<void> write_figure(const FigureRecipe& recipe,
                                        const std::filesystem::path& path,
                                        const WorkContext& work);

/// The same as a PNG on a stream.
[[nodiscard]] Result<void> stream_figure(const FigureRecipe& recipe, std::ostream& out);

/// The recipe that a PNG or SVG carries. @errors kNotFound, kMalformed: no such file, no recipe in it.
[[nodiscard]] Result<FigureRecipe> stored_recipe(const std::filesystem::path& path);

}  // namespace nadir::cli
