// SPDX-License-Identifier: Apache-2.0
#include "core/run/run_options.h"

#include "core/base/settings.h"

namespace nadir {

Result<RunOptions> run_preset(std::string_view name) {
  const auto localiser = localiser_preset(name);
  if (!localiser) return forward_error(localiser);
  RunOptions options;
  options.localiser = *localiser;
  if (name != "default") options.topview = TopviewOptions{};
  return options;
}

namespace {

Result<RunRecipe> recipe_from(const Settings& file) {
  if (const auto known = file.refuse_unknown({"preset", "options"}); !known) {
    return forward_error(known);
  }
  const auto preset = file.text_or("preset", "default");
  if (!preset) return forward_error(preset);
  auto options = run_preset(*preset);
  if (!options) return forward_error(options, file.name());
  RunRecipe recipe{*preset, *options};
  if (!file.has("options")) return recipe;
  const auto table = file.table("options");
  if (!table) return forward_error(table);
  for (const std::string& key : table->keys()) {
    const auto value = table->scalar_as_text(key);
    if (!value) return forward_error(value);
    if (const auto set = set_option(recipe.options, key, *value); !set) {
      return forward_error(set, file.name());
    }
  }
  return recipe;
}

}  // namespace

Result<RunRecipe> read_run_recipe(const std::filesystem::path& path) {
  const auto file = Settings::read(path);
  if (!file) return forward_error(file);
  return recipe_from(*file);
}

Result<RunRecipe> parse_run_recipe(std::string_view text, const std::string& name) {
  const auto file = Settings::parse(text, name);
  if (!file) return forward_error(file);
  return recipe_from(*file);
}

Result<void> validate_run(const RunOptions& options) {
  if (auto localiser = validate(options.localiser); !localiser) return localiser;
  return validate(options.topview);
}

}  // namespace nadir
