// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>
#include <filesystem>
#include <string_view>
#include <type_traits>
#include <utility>

#include "core/mcl/localiser_options.h"
#include "core/topview/semantic_topview.h"

namespace nadir {

/// Everything that can be set about a run: how the topview is made and how the filter works. The
/// defaults are the preset `default`; it asks for three votes a cell, because single points are
/// often noise.
struct RunOptions {
  LocaliserOptions localiser;
  TopviewOptions topview{.min_votes = 3};
};

template <typename Options, typename Visitor>
requires std::same_as<std::remove_const_t<Options>, RunOptions>
void visit_fields(Options& options, Visitor&& visit) {
  visit_fields(options.localiser, visit);
  visit_fields(options.topview, visit);
}

/// Options of a preset by name; those of the thesis take the thesis's topview (beta = 1, its value
/// in simulation). @errors kInvalidOptions, naming the nearest preset.
[[nodiscard]] Result<RunOptions> run_preset(std::string_view name);

/// A recipe: TOML with `preset = "..."` and, in a table `[options]`, any option by its name.
/// @errors kNotFound, kMalformed, kInvalidOptions (unknown option: names it and the nearest known
/// one).
struct RunRecipe {
  std::string preset;
  RunOptions options;
};
[[nodiscard]] Result<RunRecipe> read_run_recipe(const std::filesystem::path& path);
/// `name` stands for the file in messages.
[[nodiscard]] Result<RunRecipe> parse_run_recipe(std::string_view text, const std::string& name);

/// Ranges of all fields and what holds between them. @errors kInvalidOptions.
[[nodiscard]] Result<void> validate_run(const RunOptions& options);

}  // namespace nadir
