// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "app/cli/arguments.h"
#include "app/cli/command.h"
#include "app/cli/console.h"
#include "app/cli/figure_flow.h"
#include "app/cli/help_page.h"
#include "widgets/figures/figures.h"

namespace nadir::cli {
namespace {

constexpr const char* kFigureName = "nadir figure";

struct FigureArguments {
  std::string figure, out, map, route, recreated;
  std::vector<std::string> runs;
  bool is_quiet = false;
  OptionFlags options;
};

/// Names and summaries, broken between words where a terminal ends.
std::string figure_list() {
  constexpr std::size_t kColumn = 18;
  std::string text = "Figures:\n";
  for (const FigureKind& kind : figure_kinds()) {
    std::string line = fmt::format("  {:<{}}", kind.name, kColumn - 3);
    std::istringstream words{std::string(kind.summary)};
    for (std::string word; words >> word;) {
      if (line.size() + 1 + word.size() > kHelpWidth) {
        text += line + "\n";
        line = std::string(kColumn - 1, ' ');
      }
      line += " " + word;
    }
    text += line + "\n";
  }
  return text + "\nExample: nadir figure flight --run run.nadir --out flight.png";
}

void add_path_flags(CLI::App& app, FigureArguments& values) {
  CLI::Option* figure =
      app.add_option("FIGURE", values.figure,
                     "A figure by its name (below), or a recipe: a TOML file, whose paths start at "
                     "its own folder");
  app.add_option("--run", values.runs, "Run file; given again for figures that compare")
      ->type_name("FILE")
      ->allow_extra_args(false)
      ->excludes(app.add_option("--recreate", values.recreated,
                                "Draw a PNG or SVG again from the recipe that it carries, whose "
                                "paths start at the current folder; flags win over it, and a run, "
                                "map, picture or route that has changed since is told of; what a "
                                "flight's camera saw is not compared")
                     ->type_name("FILE")
                     ->excludes(figure));
  app.add_option("--out", values.out,
                 "File to write: .png, .svg, .pdf or .mp4; - is a PNG on standard output")
      ->type_name("FILE")
      ->required();
  app.add_option("--map", values.map, "Map package; default the one that the run was localised on")
      ->type_name("FOLDER");
  app.add_option("--route", values.route,
                 "Route file of figure 'route'; default the map's routes/loop.toml")
      ->type_name("FILE");
}

void add_arguments(CLI::App& app, FigureArguments& values) {
  constexpr const char* kHeading = "Options of the figure";
  add_path_flags(app, values);
  app.add_flag("--quiet", values.is_quiet, "No progress and no words");
  std::vector<OptionText> with_values;
  for (OptionText& option : option_texts(FigureOptions{})) {
    if (option.kind == OptionKind::kBoolean) {  // all are off unless asked for
      const auto switch_on = [&values, name = option.name](std::int64_t) {
        values.options[name] = "true";
      };
      app.add_flag("--" + option.name, switch_on, option.help)->group(kHeading);
    } else {
      with_values.push_back(std::move(option));
    }
  }
  add_option_flags(app, kHeading, with_values, values.options);
  app.footer(figure_list());
}

/// The figure is drawn on another map than before, so hashes of that one say nothing.
void forget_map(FigureRecipe& recipe) {
  recipe.inputs.map.clear();
  recipe.inputs.picture.clear();
  if (recipe.route.empty()) recipe.inputs.route.clear();
}

Result<FigureRecipe> recipe_of(const FigureArguments& values) {
  FigureRecipe recipe;
  if (!values.recreated.empty()) {
    auto stored = stored_recipe(values.recreated);
    if (!stored) return stored;
    recipe = std::move(*stored);
  } else if (std::filesystem::path(values.figure).extension() == ".toml") {
    auto read = read_figure_recipe(values.figure);
    if (!read) return tl::unexpected(blame_file(read.error()));
    recipe = std::move(*read);
  } else {
    recipe.figure = values.figure;
  }
  if (!values.runs.empty()) {
    recipe.runs = values.runs;
    recipe.inputs.runs.clear();  // others are no change
    if (recipe.map.empty()) forget_map(recipe);
  }
  if (!values.map.empty()) {
    recipe.map = values.map;
    forget_map(recipe);
  }
  if (!values.route.empty()) {
    recipe.route = values.route;
    recipe.inputs.route.clear();
  }
  if (!recipe.map.empty()) recipe.map = find_bundled(recipe.map).string();
  for (const auto& [name, text] : values.options) {
    if (auto set = set_option(recipe.options, name, text); !set) return forward_error(set);
  }
  if (const auto known = figure_kind(recipe.figure); !known) return forward_error(known);
  return recipe;
}

}  // namespace

int run_figure(std::span<const std::string> arguments, std::ostream& out, std::ostream& err) {
  CLI::App app("Draws a figure of a recorded run or of a map, without a display", kFigureName);
  FigureArguments values;
  add_arguments(app, values);
  if (const auto status = parse_arguments(app, arguments, out, err)) return *status;
  if (values.figure.empty() && values.recreated.empty()) {
    return report_misuse(err, kFigureName, "FIGURE is missing");
  }
  const auto recipe = recipe_of(values);
  if (!recipe) return report_flags_error(err, kFigureName, recipe.error());
  if (recipe->figure == values.figure) {  // asked for by name: then runs are arguments
    const auto enough = check_run_count(*figure_kind(recipe->figure), recipe->runs.size());
    if (!enough) return report_misuse(err, kFigureName, enough.error().message);
  }
  const Interrupt interrupt;
  Result<FigureNotes> notes;
  {
    ProgressBar bar(err, values.is_quiet);
    const WorkContext work{interrupt.token(), [&bar](double fraction, const std::string& activity) {
                             bar.show(fraction, activity);
                           }};
    notes = values.out == "-" ? stream_figure(*recipe, out, work)
                              : write_figure(*recipe, values.out, work);
  }
  if (!notes) {
    const bool is_lost = !values.recreated.empty() && notes.error().code == ErrorCode::kNotFound;
    return report_flags_error(
        err, kFigureName,
        is_lost ? notes.error().within(values.recreated +
                                       ": its paths start at the folder that it was drawn in")
                : notes.error());
  }
  if (values.is_quiet) return kDone;
  for (const std::string& note : *notes) err << "nadir: " << note << "\n";
  return kDone;
}

}  // namespace nadir::cli
