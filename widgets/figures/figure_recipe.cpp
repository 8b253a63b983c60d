// SPDX-License-Identifier: Apache-2.0
#include "widgets/figures/figure_recipe.h"

#include <fmt/ranges.h>

#include <algorithm>

#include "core/base/settings.h"

namespace nadir {
namespace {

namespace fs = std::filesystem;

Result<void> take_text(const Settings& settings, const char* key, std::string& into) {
  auto text = settings.text_or(key, "");
  if (!text) return forward_error(text);
  into = std::move(*text);
  return {};
}

Result<void> take_texts(const Settings& settings, const char* key, std::vector<std::string>& into) {
  if (!settings.has(key)) return {};
  auto texts = settings.texts(key);
  if (!texts) return forward_error(texts);
  into = std::move(*texts);
  return {};
}

Result<void> take_options(const Settings& settings, FigureOptions& into) {
  if (!settings.has("options")) return {};
  const auto options = settings.table("options");
  if (!options) return forward_error(options);
  for (const std::string& key : options->keys()) {
    auto text = options->scalar_as_text(key);
    if (!text) {  // a list, as of layers
      const auto words = options->texts(key);
      if (!words) return forward_error(text);
      text = fmt::format("{}", fmt::join(*words, ","));
    }
    if (auto set = set_option(into, key, *text); !set) return forward_error(set, options->name());
  }
  return {};
}

Result<void> take_inputs(const Settings& settings, InputHashes& into) {
  if (!settings.has("inputs")) return {};
  const auto inputs = settings.table("inputs");
  if (!inputs) return forward_error(inputs);
  return inputs->refuse_unknown({"runs", "map", "picture", "route"})
      .and_then([&] { return take_texts(*inputs, "runs", into.runs); })
      .and_then([&] { return take_text(*inputs, "map", into.map); })
      .and_then([&] { return take_text(*inputs, "picture", into.picture); })
      .and_then([&] { return take_text(*inputs, "route", into.route); });
}

Result<FigureRecipe> recipe_from(const Settings& settings) {
  FigureRecipe recipe;
  auto figure = settings.text("figure");
  const auto taken =
      settings.refuse_unknown({"figure", "runs", "map", "route", "options", "inputs"})
          .and_then([&]() -> Result<void> {
            if (!figure) return forward_error(figure);
            return take_texts(settings, "runs", recipe.runs);
          })
          .and_then([&] { return take_text(settings, "map", recipe.map); })
          .and_then([&] { return take_text(settings, "route", recipe.route); })
          .and_then([&] { return take_options(settings, recipe.options); })
          .and_then([&] { return take_inputs(settings, recipe.inputs); });
  if (!taken) return forward_error(taken);
  recipe.figure = std::move(*figure);
  return recipe;
}

std::string text_list(const std::vector<std::string>& texts) {
  std::string list = "[";
  for (std::size_t i = 0; i < texts.size(); ++i) {
    list += (i > 0 ? ", " : "") + toml_quoted(texts[i]);
  }
  return list + "]";
}

/// Only the lines of keys that have a value.
std::string path_lines(const std::vector<std::string>& runs,
                       const std::string& map,
                       const std::string& picture,
                       const std::string& route) {
  std::string text;
  if (!runs.empty()) text += "runs = " + text_list(runs) + "\n";
  if (!map.empty()) text += "map = " + toml_quoted(map) + "\n";
  if (!picture.empty()) text += "picture = " + toml_quoted(picture) + "\n";
  if (!route.empty()) text += "route = " + toml_quoted(route) + "\n";
  return text;
}

std::string option_lines(const FigureOptions& chosen) {
  const std::vector<OptionText> defaults = option_texts(FigureOptions{});
  const std::vector<OptionText> options = option_texts(chosen);
  std::string lines;
  for (std::size_t i = 0; i < options.size(); ++i) {
    const OptionText& option = options[i];
    if (option.value == defaults[i].value) continue;
    const bool is_word = option.kind == OptionKind::kChoice || option.kind == OptionKind::kOwnText;
    lines += option.name + " = " + (is_word ? toml_quoted(option.value) : option.value) + "\n";
  }
  return lines;
}

}  // namespace

Result<FigureRecipe> read_figure_recipe(const fs::path& path) {
  const auto settings = Settings::read(path);
  if (!settings) return forward_error(settings);
  auto recipe = recipe_from(*settings);
  if (!recipe) return recipe;
  const auto placed = [folder = path.parent_path()](const std::string& named) {
    return named.empty() ? named : (folder / named).lexically_normal().string();
  };
  for (std::string& run : recipe->runs) run = placed(run);
  recipe->route = placed(recipe->route);
  std::error_code error;
  if (fs::exists(placed(recipe->map), error)) recipe->map = placed(recipe->map);
  return recipe;
}

Result<FigureRecipe> parse_figure_recipe(std::string_view text, const std::string& name) {
  const auto settings = Settings::parse(text, name);
  if (!settings) return forward_error(settings);
  return recipe_from(*settings);
}

std::string recipe_text(const FigureRecipe& recipe) {
  std::string text = "figure = " + toml_quoted(recipe.figure) + "\n" +
                     path_lines(recipe.runs, recipe.map, "", recipe.route);
  const std::string options = option_lines(recipe.options);
  if (!options.empty()) text += "\n[options]\n" + options;
  const InputHashes& hashes = recipe.inputs;
  const std::string inputs = path_lines(hashes.runs, hashes.map, hashes.picture, hashes.route);
  if (!inputs.empty())
    text += "\n# Hashes (FNV-1a) of what it was drawn from.\n[inputs]\n" + inputs;
  return text;
}

bool shows_picture(const FigureRecipe& recipe) {
  const FigureOptions& options = recipe.options;
  if (recipe.figure == "moment" && !options.stack.is_own()) {
    return options.stack.has(Layer::kPicture);
  }
  return recipe.figure != "labels" && options.layers.has(FigureLayer::kPicture);
}

std::vector<std::string> changed_inputs(const FigureRecipe& recipe, const InputHashes& now) {
  std::vector<std::string> sentences;
  const auto compare = [&](const std::string& name, const std::string& then,
                           const std::string& hash) {
    if (then.empty() || hash.empty() || then == hash) return;
    sentences.push_back(name + " has changed since the figure was drawn");
  };
  const std::size_t runs = std::min(recipe.inputs.runs.size(), now.runs.size());
  for (std::size_t i = 0; i < runs; ++i) {
    compare(recipe.runs.at(i), recipe.inputs.runs[i], now.runs[i]);
  }
  const std::string map = recipe.map.empty() ? "the run's map" : recipe.map;
  compare(map, recipe.inputs.map, now.map);
  // A map that has changed need not be told of twice.
  const bool is_same_map = recipe.inputs.map.empty() || recipe.inputs.map == now.map;
  if (shows_picture(recipe) && is_same_map) {
    const std::string picture = now.picture.empty() ? "gone" : now.picture;
    compare("the picture of " + map, recipe.inputs.picture, picture);
  }
  compare(recipe.route.empty() ? "the map's route" : recipe.route, recipe.inputs.route, now.route);
  return sentences;
}

}  // namespace nadir
