// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>
#include <type_traits>

#include "core/base/field.h"
#include "core/session/map_stack.h"
#include "core/session/map_upward.h"
#include "widgets/figures/figure_layers.h"
#include "widgets/figures/map_crop.h"
#include "widgets/figures/page_size.h"
#include "widgets/views/graticule.h"
#include "widgets/views/theme.h"

namespace nadir {

/// The pose at which figures 'scene' and 'moment' lay what was seen.
enum class LaidAt { kEstimate, kOdometry, kTruth };

template <>
struct EnumNames<LaidAt> {
  static constexpr std::array<std::string_view, 3> kNames = {"estimate", "odometry", "truth"};
};

/// How a figure is drawn. Every one is a flag of `nadir figure` and a key of a recipe's [options].
struct FigureOptions {
  PageSize size;
  double dpi = 0.0;  ///< 0: such that text is readable at this width.
  ThemeName theme = ThemeName::kLight;
  bool is_transparent = false;
  double time_s = 1e9;
  double from_s = 0.0, to_s = 1e9;
  MapCrop crop;
  FigureLayers layers;
  MapStack stack;
  MapUpward up;
  int run_colour = 1;  ///< Counts from 1; see run_colour() of widgets/views/theme.h.
  double label_opacity = 0.0;
  double ellipse_every_s = 5.0;
  double tick_every_s = 0.0;
  Graticule graticule = Graticule::kMetres;
  bool shows_graticule_lines = false;
  LaidAt laid_at = LaidAt::kEstimate;
  double fps = 25.0;
  double speed = 4.0;
};

template <typename Options, typename Visitor>
requires std::same_as<std::remove_const_t<Options>, FigureOptions>
void visit_fields(Options& options, Visitor&& visit) {
  visit(options.size,
        Field{"size", "px", "Page, each side to 16000; without height the figure's own shape"});
  visit(options.dpi,
        Field{"dpi", "1/inch", "Pixels per inch: the size of text; 0 suits the width", 0, 1200});
  visit(options.theme, Field{"theme", "", "Colours of the page"});
  visit(options.is_transparent, Field{"transparent", "", "Leave the page without a background"});
  visit(options.time_s,
        Field{"time", "s", "Moment shown, after the first step; past the end is the end", 0, 1e9});
  visit(options.from_s, Field{"from", "s", "Steps before this time are left out", 0, 1e9});
  visit(options.to_s, Field{"to", "s", "Steps after this time are left out", 0, 1e9});
  visit(options.crop, Field{"crop", "m",
                            "Ground across the map, around a point of its plane or the middle of "
                            "what the figure shows"});
  visit(options.layers,
        Field{"layers", "",
              "Shown on maps where they are known: picture, truth, odometry, estimate, "
              "ellipses, modes, particles, topview; all, none, or all but those with a "
              "minus (-particles,-modes)"});
  visit(options.stack,
        Field{"stack", "",
              "Layers of the map in figure 'moment' from the ground up, with opacities and colours "
              "(picture,topview:0.8,truth#FF8800); wins over layers, label-opacity and "
              "graticule-lines"});
  visit(options.up,
        Field{"up", "",
              "What is up on the map in figure 'moment': north, the estimate's heading, "
              "or a compass course in degrees, which goes round: 361 is 1, -90 is 270"});
  visit(options.run_colour,
        Field{"run-colour", "",
              "Which of the colours of runs the run has on the map in figure 'moment', where "
              "it has no other",
              1, 1000});
  visit(options.label_opacity,
        Field{"label-opacity", "", "Of the labels over the picture; 0 shows none", 0, 1});
  visit(options.ellipse_every_s,
        Field{"ellipse-every", "s", "Time between covariance ellipses; 0 draws none", 0, 1e6});
  visit(options.tick_every_s,
        Field{"tick-every", "s", "Time between ticks on trajectories; 0 draws none", 0, 1e6});
  visit(options.graticule, Field{"graticule", "", "Coordinates at the border of maps"});
  visit(options.shows_graticule_lines,
        Field{"graticule-lines", "", "Thin lines across maps at those coordinates"});
  visit(options.laid_at,
        Field{"laid-at", "", "Pose at which figures 'scene' and 'moment' lay what was seen"});
  visit(options.fps, Field{"fps", "1/s", "Frames per second of a film", 1, 120});
  visit(options.speed, Field{"speed", "", "Flight seconds per second of film", 0.01, 1000});
}

}  // namespace nadir
