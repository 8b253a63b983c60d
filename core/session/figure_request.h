// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/session/view_state.h"

namespace nadir {

/// A figure of what the window shows now.
struct FigureRequest {
  std::string figure;             ///< As in `nadir figure NAME`.
  std::vector<std::string> runs;  ///< Absolute paths; the active one first.
  std::string map;                ///< Map package; empty: the one that the first run names.
  double time_s = 0.0;            ///< After the first run's first step.
  MapLook look;                   ///< With centre and width as they are drawn.
  LightOrDark theme = LightOrDark::kLight;
  int run_colour = 0;                ///< Of the first run, as RunLook::colour.
  std::optional<int> width_px = {};  ///< Nothing: the figure's own.
  /// For a film: the range and the flight seconds per second.
  bool is_film = false;
  std::optional<double> from_s, to_s;
  double speed = 1.0;
};

/// Range of a figure's width.
inline constexpr int kLeastFigureWidthPx = 200, kMostFigureWidthPx = 16'000;

/// How many runs a figure is of. Of a name that is none, one: who draws it will say so.
enum class RunsOfFigure { kNone, kOne, kAll };
[[nodiscard]] RunsOfFigure runs_of_figure(std::string_view figure);

/// The recipe of such a figure, as parse_figure_recipe() of widgets/figures and `nadir figure` take it.
[[nodiscard]] std::string figure_recipe_text(const FigureRequest& request);

}  // namespace nadir
