// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "app/cli/arguments.h"
#include "app/cli/command.h"
#include "app/cli/trajectory_output.h"
#include "core/base/staged_output.h"
#include "core/eval/report.h"
#include "core/run/evaluate_run.h"

namespace nadir::cli {
namespace {

constexpr const char* kEvaluateName = "nadir evaluate";

struct EvaluateArguments {
  std::vector<std::string> runs;
  bool is_json = false, is_csv = false, is_quiet = false;
  std::string alignment = "none";
  std::string out_file, trajectory;
};

void add_arguments(CLI::App& app, EvaluateArguments& values) {
  app.add_option("RUN", values.runs, "Run files, as 'nadir localise --out' writes them")
      ->required();
  CLI::Option* json =
      app.add_flag("--json", values.is_json, "One JSON object with SI units in its key names");
  app.add_flag("--csv", values.is_csv, "One line a run, below a header")->excludes(json);
  const std::vector<std::string> alignments = {"none", "se2", "sim2"};
  app.add_option("--align", values.alignment,
                 "Lay each trajectory onto the truth before judging it: se2 moves and turns it, "
                 "sim2 scales it too. That hides errors of the localisation; default none")
      ->type_name(choices_text(alignments))
      ->check(is_one_of(alignments));
  app.add_option("--out", values.out_file, "Write the results here instead of standard output")
      ->type_name("FILE");
  app.add_option("--trajectory", values.trajectory,
                 "Also write the estimated trajectory of one run as TUM text (time x y z qx qy qz "
                 "qw, metres east and north on the map's plane), as evo reads it; never aligned")
      ->type_name("FILE");
  app.add_flag("--quiet", values.is_quiet, "No words beside the results");
  app.footer("Example: nadir evaluate run.nadir --json");
}

/// What the flags of one file each must not do together. @errors kInvalidOptions.
Result<void> check_outputs(const EvaluateArguments& values) {
  if (!values.trajectory.empty() && values.runs.size() > 1) {
    return fail(ErrorCode::kInvalidOptions, "--trajectory: is for one run, and {} are given",
                values.runs.size());
  }
  if (names_same_file(values.trajectory, values.out_file)) {
    return fail(ErrorCode::kInvalidOptions, "--trajectory: {} is the file of --out",
                values.trajectory);
  }
  for (const std::string& run : values.runs) {
    for (const auto& [flag, file] : {std::pair<std::string, std::string>("--out", values.out_file),
                                     {"--trajectory", values.trajectory}}) {
      if (names_same_file(run, file)) {
        return fail(ErrorCode::kInvalidOptions, "{}: {} is a run to read", flag, run);
      }
    }
  }
  return {};
}

/// Judges one run, and writes its trajectory where that is asked for.
Result<RunEvaluation> judge(const std::string& path, const EvaluateArguments& values) {
  const auto run = RunReader::open(path);
  if (!run) return forward_error(run);
  const Alignment alignment = alignment_from_name(values.alignment).value_or(Alignment::kNone);
  auto evaluation = evaluate_run(*run, path, alignment);
  if (!evaluation) return evaluation;
  if (evaluation->steps == 0) {
    return fail(ErrorCode::kMalformed, "{}: holds no steps, so there is nothing to judge", path);
  }
  if (values.trajectory.empty()) return evaluation;
  const auto recorded = run->steps();
  if (!recorded) return forward_error(recorded);
  std::vector<EvaluatedStep> steps;
  steps.reserve(recorded->size());
  for (const RunStep& step : *recorded) steps.push_back(evaluated_step(step));
  const Geodetic origin{run->header().plane_latitude_deg, run->header().plane_longitude_deg};
  if (const auto written =
          write_estimated_trajectory(values.trajectory, steps, origin, run->header().flight);
      !written) {
    return forward_error(written);
  }
  return evaluation;
}

void say_what_is_missing(const RunEvaluation& evaluation, std::ostream& err) {
  if (!evaluation.is_complete) {
    err << evaluation.run << ": was stopped before its end; these are its first "
        << evaluation.steps << " steps\n";
  }
  if (evaluation.matched_pairs == 0) {
    err << evaluation.run << ": its flight knew no truth, so its errors are unknown\n";
  }
}

std::string report(const EvaluateArguments& values, std::span<const RunEvaluation> evaluations) {
  if (values.is_json) return report_as_json(evaluations);
  if (values.is_csv) return report_as_csv(evaluations);
  return report_as_text(evaluations);
}

}  // namespace

int run_evaluate(std::span<const std::string> arguments, std::ostream& out, std::ostream& err) {
  CLI::App app("Prints the errors of recorded runs: estimate against odometry input",
               kEvaluateName);
  EvaluateArguments values;
  add_arguments(app, values);
  if (const auto status = parse_arguments(app, arguments, out, err)) return *status;

  if (const auto checked = check_outputs(values); !checked) {
    return report_misuse(err, kEvaluateName, checked.error().message);
  }
  std::vector<RunEvaluation> evaluations;
  for (const std::string& run : values.runs) {
    auto evaluation = judge(run, values);
    if (!evaluation) return report_error(err, evaluation.error());
    if (!values.is_quiet) say_what_is_missing(*evaluation, err);
    evaluations.push_back(std::move(*evaluation));
  }
  const std::string text = report(values, evaluations);
  if (values.out_file.empty()) {
    out << text;
    return kDone;
  }
  if (const auto written = write_text_file(values.out_file, text); !written) {
    return report_error(err, written.error());
  }
  if (!values.is_quiet) err << "wrote " << values.out_file << "\n";
  return kDone;
}

}  // namespace nadir::cli
