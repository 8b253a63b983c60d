// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>
#include <filesystem>
#include <string>
#include <type_traits>
#include <vector>

#include "core/base/field.h"
#include "core/base/result.h"
#include "widgets/views/map_furniture.h"
#include "widgets/views/theme.h"

namespace nadir {

/// How a figure is drawn. Every one is a flag of `nadir figure` and a key of a recipe's [options].
struct FigureOptions {
  int width = 1600;
  int height = 0;    ///< 0: the figure's own shape.
  double dpi = 0.0;  ///< 0: such that text is readable at this width.
  ThemeName theme = ThemeName::kLight;
  bool is_transparent = false;
  double time_s = 1e9;
  double from_s = 0.0, to_s = 1e9;
  double crop_east_m = 0.0, crop_north_m = 0.0, crop_width_m = 0.0;
  bool shows_picture = true;
  double label_opacity = 0.0;
  bool shows_particles = true;
  bool shows_topview = true;
  double ellipse_every_s = 5.0;
  double tick_every_s = 0.0;
  Graticule graticule = Graticule::kMetres;
  double fps = 25.0;
  double speed = 4.0;
};

template <typename Options, typename Visitor>
requires std::same_as<std::remove_const_t<Options>, FigureOptions>
void visit_fields(Options& options, Visitor&& visit) {
  visit(options.width, Field{"width", "px", "Width of the page", 200, 16'000});
  visit(options.height,
        Field{"height", "px", "Height of the page; 0 is the figure's own shape", 0, 16'000});
  visit(options.dpi,
        Field{"dpi", "1/inch", "Pixels per inch: the size of text; 0 suits the width", 0, 1200});
  visit(options.theme, Field{"theme", "", "Colours of the page"});
  visit(options.is_transparent, Field{"transparent", "", "Leave the page without a background"});
  visit(options.time_s,
        Field{"time", "s", "Moment shown, after the first step; past the end is the end", 0, 1e9});
  visit(options.from_s, Field{"from", "s", "Steps before this time are left out", 0, 1e9});
  visit(options.to_s, Field{"to", "s", "Steps after this time are left out", 0, 1e9});
  visit(options.crop_east_m,
        Field{"crop-east", "m", "Middle of the map's crop, east on the plane", -1e6, 1e6});
  visit(options.crop_north_m,
        Field{"crop-north", "m", "Middle of the map's crop, north on the plane", -1e6, 1e6});
  visit(options.crop_width_m,
        Field{"crop-width", "m", "Ground across the map; 0 shows all that belongs to the figure", 0,
              1e6});
  visit(options.shows_picture,
        Field{"picture", "", "Show the overhead's picture where it has one, else its labels"});
  visit(options.label_opacity, Field{"label-opacity", "", "Of the labels over the picture", 0, 1});
  visit(options.shows_particles,
        Field{"show-particles", "", "Draw the particles where they were recorded"});
  visit(options.shows_topview, Field{"show-topview", "", "Draw the topview where it was recorded"});
  visit(options.ellipse_every_s,
        Field{"ellipse-every", "s", "Time between covariance ellipses; 0 draws none", 0, 1e6});
  visit(options.tick_every_s,
        Field{"tick-every", "s", "Time between ticks on trajectories; 0 draws none", 0, 1e6});
  visit(options.graticule, Field{"graticule", "", "Coordinates at the border of maps"});
  visit(options.fps, Field{"fps", "1/s", "Frames per second of a film", 1, 120});
  visit(options.speed, Field{"speed", "", "Flight seconds per second of film", 0.01, 1000});
}

/// Everything that draws a figure again: TOML with `figure`, `runs`, `map`, `route` and a table [options] with any of the
/// options above. What is left out has its default.
struct FigureRecipe {
  std::string figure;
  std::vector<std::string> runs;
  std::string map;    ///< Map package; empty: the one that the first run names.
  std::string route;  ///< Route file; empty: the map's own.
  FigureOptions options;
};

/// @errors kNotFound, kMalformed (unknown keys, naming the nearest), kInvalidOptions (values out of range).
[[nodiscard]] Result<FigureRecipe> read_figure_recipe(const std::filesystem::path& path);
/// `name` stands for the file in messages.
[[nodiscard]] Result<FigureRecipe> parse_figure_recipe(std::string_view text,
                                                       const std::string& name);
/// Only what differs from the defaults, in the order of the list; parse_figure_recipe gives the same recipe again.
[[nodiscard]] std::string recipe_text(const FigureRecipe& recipe);

}  // namespace nadir
