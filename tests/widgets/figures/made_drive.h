// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "core/run/evaluate_run.h"
#include "tests/widgets/figures/recorded_flight.h"
#include "widgets/figures/chart_panel.h"
#include "widgets/figures/figure_run.h"

namespace nadir {

inline const Theme& light() { return theme(ThemeName::kLight); }

/// The drive of recorded_flight.h with its steps changed one by one; not read from a file.
inline FigureRun drive(
    const std::string& name,
    int steps = 30,
    const std::function<void(RunStep&)>& change = [](RunStep&) {}) {
  FigureRun run;
  run.name = name;
  for (int i = 0; i < steps; ++i) {
    run.steps.push_back(street_step(i, {.has_particles = false, .has_topviews = false}));
    change(run.steps.back());
    run.judged.push_back(evaluated_step(run.steps.back()));
  }
  run.start_s = run.steps.front().time_s;
  run.evaluation = evaluate_steps(run.judged).value();
  return run;
}

inline std::vector<std::string> names_of(const ChartSpec& chart) {
  std::vector<std::string> names;
  for (const LegendEntry& entry : legend_of(chart)) names.push_back(entry.name);
  return names;
}

}  // namespace nadir
