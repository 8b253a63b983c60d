// SPDX-License-Identifier: Apache-2.0
#include "widgets/figures/timed_figure.h"

#include <algorithm>
#include <limits>

#include "core/base/require.h"

namespace nadir {

TimedFigure::TimedFigure(FigureInputs inputs)
    : inputs_(std::move(inputs)), time_s_(inputs_.options.time_s) {
  NADIR_REQUIRE(!inputs_.runs.empty());
}

std::optional<FigureTimes> TimedFigure::times() const {
  FigureTimes times{std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest()};
  for (const FigureRun& run : runs()) {
    times.first_s = std::min(times.first_s, run.elapsed_s(run.steps.front()));
    times.last_s = std::max(times.last_s, run.elapsed_s(run.steps.back()));
  }
  return times;
}

bool TimedFigure::is_moment_in_runs() const {
  const auto known = times();
  return known && time_s_ >= known->first_s - kSameTimeS && time_s_ <= known->last_s + kSameTimeS;
}

Result<RunStep> TimedFigure::read_step() const {
  return run().reader->step(run().steps[index()].step);
}

}  // namespace nadir
