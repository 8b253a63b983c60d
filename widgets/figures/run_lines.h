// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "widgets/figures/figure_run.h"
#include "widgets/figures/map_panel.h"
#include "widgets/figures/page.h"
#include "widgets/views/legend.h"

namespace nadir {

/// What several figures draw of runs over a map.

/// Makes the panel show every pose of a run.
void include_run(MapPanel& panel, const FigureRun& run);

/// Truth and odometry of the first run and the estimates of all, up to a moment, with start and end marks, ticks and the
/// ellipses that the options ask for.
void draw_runs(Canvas& canvas,
               const MapFrame& frame,
               std::span<const FigureRun> runs,
               const FigureOptions& options,
               double until_s,
               const Theme& theme);

/// Of what draw_runs() draws over imagery.
[[nodiscard]] std::vector<LegendEntry> run_legend(std::span<const FigureRun> runs,
                                                  const Theme& theme);

/// The foots of all runs, shortened where there are many.
[[nodiscard]] std::string foot_of_all(std::span<const FigureRun> runs);

/// From the first step to the last of all runs.
[[nodiscard]] std::optional<FigureTimes> times_of(std::span<const FigureRun> runs);

}  // namespace nadir
