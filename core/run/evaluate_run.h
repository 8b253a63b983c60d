// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "core/base/result.h"
#include "core/eval/run_evaluation.h"
#include "core/run/run_file.h"

namespace nadir {

/// What judging needs of a step.
[[nodiscard]] EvaluatedStep evaluated_step(const RunStep& step);

/// Fills the names and the seed of an evaluation from the run's header.
void describe(RunEvaluation& evaluation, const RunHeader& header, const std::string& run_name);

/// Judges a recorded run against the truth that its flight knew. `path` is only its name in the
/// report. A run without truth or without steps is not an error: its errors are unknown.
/// @errors kMalformed: damaged, or it cannot be aligned as asked (see evaluate_steps).
[[nodiscard]] Result<RunEvaluation> evaluate_run(const RunReader& run,
                                                 const std::filesystem::path& path,
                                                 Alignment alignment = Alignment::kNone);

/// Opens and judges. @errors as RunReader::open, and as above.
[[nodiscard]] Result<RunEvaluation> evaluate_run_file(const std::filesystem::path& path,
                                                      Alignment alignment = Alignment::kNone);

}  // namespace nadir
