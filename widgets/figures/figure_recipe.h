// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "widgets/figures/figure_options.h"

namespace nadir {

/// Hashes of what a figure was drawn from, except the flight whose camera `moment` and `scene` show; hexadecimal; empty where it was drawn without or where it is not known.
struct InputHashes {
  std::vector<std::string> runs;  ///< Of the files, in the order of the recipe's runs.
  std::string map;                ///< As RunHeader::map_hash: the plane, the place and the labels.
  std::string route;              ///< Of the file.
  std::string picture = {};       ///< Of the map's image.tif, where the figure shows it.
};

/// Everything that draws a figure again: TOML with `figure`, `runs`, `map`, `route` and a table [options] with any of
/// FigureOptions. What is left out has its default. A figure carries the recipe that drew it with a table [inputs].
struct FigureRecipe {
  std::string figure;
  std::vector<std::string> runs;
  std::string map;    ///< Map package; empty: the one that the first run names.
  std::string route;  ///< Route file; empty: the map's own.
  FigureOptions options;
  InputHashes
      inputs;  ///< As they were when the figure was drawn; empty in a recipe that was written by hand.
};

/// Reads a recipe file. Relative paths in it start at the file's folder, so that it draws the same wherever it is called
/// from; a map that is not there keeps its name, for it may be one that the program brings along.
/// @errors kNotFound, kMalformed (unknown keys, naming the nearest), kInvalidOptions (values out of range).
[[nodiscard]] Result<FigureRecipe> read_figure_recipe(const std::filesystem::path& path);

/// Paths stay as they are, which means: from the current folder. `name` stands for the file in messages.
[[nodiscard]] Result<FigureRecipe> parse_figure_recipe(std::string_view text,
                                                       const std::string& name);

/// Only what differs from the defaults, in the order of the list; parse_figure_recipe gives the same recipe again.
[[nodiscard]] std::string recipe_text(const FigureRecipe& recipe);

/// Whether the figure draws the map's picture where the map has one.
[[nodiscard]] bool shows_picture(const FigureRecipe& recipe);

/// "run.nadir has changed since the figure was drawn": a sentence for every input of the recipe whose hash is known and
/// another one now.
[[nodiscard]] std::vector<std::string> changed_inputs(const FigureRecipe& recipe,
                                                      const InputHashes& now);

}  // namespace nadir
