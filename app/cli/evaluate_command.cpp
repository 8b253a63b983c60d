// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "app/cli/arguments.h"
#include "app/cli/command.h"
#include "core/base/staged_output.h"
#include "core/eval/report.h"
#include "core/run/evaluate_run.h"

namespace nadir::cli {
namespace {

struct EvaluateArguments {
  std::vector<std::string> runs;
  bool is_json = false, is_csv = false, is_quiet = false;
  std::string alignment = "none";
  std::string out_file;
};

void add_arguments(CLI::App& app, EvaluateArguments& values) {
  app.add_option("RUN", values.runs, "Run files, as 'nadir localise' writes them")->required();
  CLI::Option* json =
      app.add_flag("--json", values.is_json, "One JSON object with SI units in its key names");
  app.add_flag("--csv", values.is_csv, "One line a run, with a header")->excludes(json);
  app.add_option("--align", values.alignment,
                 "Lay each trajectory onto the truth first: none, se2 (move and turn) or sim2 (and "
                 "scale). Hides errors of the localisation, so off by default")
      ->check(CLI::IsMember({"none", "se2", "sim2"}));
  app.add_option("--out", values.out_file, "Write to this file instead of standard output");
  app.add_flag("--quiet", values.is_quiet, "No words beside the results");
}

std::string report(const EvaluateArguments& values, std::span<const RunEvaluation> evaluations) {
  if (values.is_json) return report_as_json(evaluations);
  if (values.is_csv) return report_as_csv(evaluations);
  return report_as_text(evaluations);
}

}  // namespace

int run_evaluate(std::span<const std::string> arguments, std::ostream& out, std::ostream& err) {
  CLI::App app("Prints the errors of recorded runs: estimate against odometry input",
               "nadir evaluate");
  EvaluateArguments values;
  add_arguments(app, values);
  if (const auto status = parse_arguments(app, arguments, out, err)) return *status;

  for (const std::string& run : values.runs) {
    std::error_code error;
    if (!values.out_file.empty() && std::filesystem::equivalent(run, values.out_file, error)) {
      return report_error(err, {ErrorCode::kInvalidOptions, "--out: " + run + " is a run to read"});
    }
  }
  const Alignment alignment = alignment_from_name(values.alignment).value_or(Alignment::kNone);
  std::vector<RunEvaluation> evaluations;
  for (const std::string& run : values.runs) {
    auto evaluation = evaluate_run_file(run, alignment);
    if (!evaluation) return report_error(err, evaluation.error());
    if (!evaluation->is_complete && !values.is_quiet) {
      err << run << ": was stopped before its end; these are its first " << evaluation->steps
          << " steps\n";
    }
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
