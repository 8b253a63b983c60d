// SPDX-License-Identifier: Apache-2.0
#include "core/run/evaluate_run.h"

#include <utility>
#include <vector>

namespace nadir {

EvaluatedStep evaluated_step(const RunStep& step) {
  return {.time_s = step.time_s,
          .truth_in_enu = step.truth_in_enu,
          .estimate_in_enu = step.estimate.moments.mean,
          .covariance = step.estimate.moments.covariance,
          .odometry_in_enu = step.odometry_in_enu,
          .update_ms = step.update_ms};
}

void describe(RunEvaluation& evaluation, const RunHeader& header, const std::string& run_name) {
  evaluation.run = run_name;
  evaluation.flight = header.flight;
  evaluation.map = header.map;
  evaluation.preset = header.preset;
  evaluation.seed = header.seed;
}

Result<RunEvaluation> evaluate_run(const RunReader& run,
                                   const std::filesystem::path& path,
                                   Alignment alignment) {
  const bool is_complete =
      run.is_complete();  // Asked first: what is complete now was complete when its steps are read.
  const auto steps = run.steps();
  if (!steps) return forward_error(steps);
  std::vector<EvaluatedStep> evaluated;
  evaluated.reserve(steps->size());
  for (const RunStep& step : *steps) evaluated.push_back(evaluated_step(step));
  auto evaluation = evaluate_steps(evaluated, alignment);
  if (!evaluation) return forward_error(evaluation, path.string());
  describe(*evaluation, run.header(), path.string());
  evaluation->is_complete = is_complete;
  return evaluation;
}

Result<RunEvaluation> evaluate_run_file(const std::filesystem::path& path, Alignment alignment) {
  const auto run = RunReader::open(path);
  if (!run) return forward_error(run);
  return evaluate_run(*run, path, alignment);
}

}  // namespace nadir
