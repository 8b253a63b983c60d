// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>

#include "core/session/run_document.h"

namespace nadir {

/// A step of a flight east at 5 m/s, ten steps a second, 0.1 m off to the north, with a standard deviation of half a metre
/// and 0.03 rad: nothing about it is worth a look.
[[nodiscard]] inline RunStep quiet_step(int number) {
  RunStep step;
  step.step = number;
  step.time_s = 100.0 + 0.1 * number;
  step.truth_in_enu = Rigid2{0.5 * number, 0.0, 0.0};
  step.estimate.moments.mean = {0.5 * number, 0.1, 0.0};
  step.estimate.moments.covariance.diagonal() << 0.25, 0.25, 0.0009;
  step.effective_sample_size = 500.0;
  step.particle_count = 1000;
  step.agreement = 0.9 + 0.01 * (number % 3 - 1);
  step.topview_cells = 100;
  step.update_ms = 10.0;
  return step;
}

/// A run of such steps, each changed as asked.
[[nodiscard]] inline RunDocument made_run(int steps,
                                          const std::function<void(RunStep& step)>& change = {}) {
  RunDocument run;
  run.path = "made.nadir";
  run.header.flight = "loop";
  run.header.flight_hash = "f1";
  run.header.map = "town";
  run.header.map_hash = "a1";
  run.header.preset = "default";
  run.header.seed = 1;
  run.is_complete = true;
  for (int i = 0; i < steps; ++i) {
    run.steps.push_back(quiet_step(i));
    if (change) change(run.steps.back());
  }
  return run;
}

[[nodiscard]] inline std::shared_ptr<const RunDocument> made_document(
    int steps, const std::function<void(RunStep& step)>& change = {}) {
  return RunDocument::from_steps(made_run(steps, change));
}

/// Moves the estimate north, so that it is so far from the truth.
inline void set_error_m(RunStep& step, double error_m) { step.estimate.moments.mean.y_m = error_m; }

}  // namespace nadir
