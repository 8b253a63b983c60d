// SPDX-License-Identifier: Apache-2.0
#include "widgets/figures/figure_options.h"

#include "core/base/settings.h"

namespace nadir {
namespace {

Result<void> take_text(const Settings& settings, const char* key, std::string& into) {
  auto text = settings.text_or(key, "");
  if (!text) return forward_error(text);
  into = std::move(*text);
  return {};
}

Result<FigureRecipe> recipe_from(const Settings& settings) {
  if (auto known = settings.refuse_unknown({"figure", "runs", "map", "route", "options", "inputs"});
      !known) {
    return forward_error(known);
  }
  FigureRecipe recipe;
  auto figure = settings.text("figure");
  if (!figure) return forward_error(figure);
  recipe.figure = std::move(*figure);
  if (settings.has("runs")) {
    auto runs = settings.texts("runs");
    if (!runs) return forward_error(runs);
    recipe.runs = std::move(*runs);
  }
  if (auto map = take_text(settings, "map", recipe.map); !map) return forward_error(map);
  if (auto route = take_text(settings, "route", recipe.route); !route) return forward_error(route);
  if (!settings.has("options")) return recipe;
  const auto options = settings.table("options");
  if (!options) return forward_error(options);
  for (const std::string& key : options->keys()) {
    const auto text = options->scalar_as_text(key);
    if (!text) return forward_error(text);
    if (auto set = set_option(recipe.options, key, *text); !set) {
      return forward_error(set, options->name());
    }
  }
  return recipe;
}

}  // namespace

Result<FigureRecipe> read_figure_recipe(const std::filesystem::path& path) {
  const auto settings = Settings::read(path);
  if (!settings) return forward_error(settings);
  return recipe_from(*settings);
}

Result<FigureRecipe> parse_figure_recipe(std::string_view text, const std::string& name) {
  const auto settings = Settings::parse(text, name);
  if (!settings) return forward_error(settings);
  return recipe_from(*settings);
}

std::string recipe_text(const FigureRecipe& recipe) {
  std::string text = "figure = " + toml_quoted(recipe.figure) + "\n";
  if (!recipe.runs.empty()) {
    text += "runs = [";
    for (std::size_t i = 0; i < recipe.runs.size(); ++i) {
      text += (i > 0 ? ", " : "") + toml_quoted(recipe.runs[i]);
    }
    text += "]\n";
  }
  if (!recipe.map.empty()) text += "map = " + toml_quoted(recipe.map) + "\n";
  if (!recipe.route.empty()) text += "route = " + toml_quoted(recipe.route) + "\n";
  const std::vector<OptionText> defaults = option_texts(FigureOptions{});
  const std::vector<OptionText> options = option_texts(recipe.options);
  std::string table;
  for (std::size_t i = 0; i < options.size(); ++i) {
    if (options[i].value == defaults[i].value) continue;
    // Words need quotes, numbers and booleans do not.
    const bool is_word = options[i].name == "theme" || options[i].name == "graticule";
    table += options[i].name + " = " +
             (is_word ? toml_quoted(options[i].value) : options[i].value) + "\n";
  }
  return table.empty() ? text : text + "\n[options]\n" + table;
}

}  // namespace nadir
