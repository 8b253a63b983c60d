// SPDX-License-Identifier: Apache-2.0
#pragma once

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

/// Look of a source of the first run, as draw_runs() and run_legend() have it.
[[nodiscard]] PathLook look_of(Source source, const Theme& theme);
[[nodiscard]] FigureLayer layer_of(Source source);

/// Truth and odometry of the first run and the estimates of all, up to a moment, with start and end marks, ticks and the
/// ellipses that the options ask for; only layers that the options show.
void draw_runs(Canvas& canvas,
               const MapFrame& frame,
               std::span<const FigureRun> runs,
               const FigureOptions& options,
               double until_s,
               const Theme& theme);

/// Of what draw_runs() draws over imagery. Where there are several runs, truth and odometry say whose they are.
[[nodiscard]] std::vector<LegendEntry> run_legend(std::span<const FigureRun> runs,
                                                  const FigureOptions& options,
                                                  const Theme& theme);

/// Truth, odometry and estimate of one run, as far as they are known and shown, without a word of ellipses.
[[nodiscard]] std::vector<LegendEntry> source_legend(const FigureRun& run,
                                                     const FigureOptions& options,
                                                     const Theme& theme);

/// For ellipses around estimates: grey where they have the colours of several runs.
[[nodiscard]] LegendEntry ellipse_legend(const std::string& name,
                                         std::size_t runs,
                                         const Theme& theme);
/// For the particles of a ParticleView.
[[nodiscard]] LegendEntry particle_legend();

/// Gives runs of the same name names that differ: with their folders' names in front, and numbers where that is not enough.
void name_apart(std::span<FigureRun> runs);

/// The foots of all runs, shortened where there are many.
[[nodiscard]] std::string foot_of_all(std::span<const FigureRun> runs);

}  // namespace nadir
