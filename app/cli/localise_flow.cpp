// SPDX-License-Identifier: Apache-2.0
#include "app/cli/localise_flow.h"

#include <fmt/format.h>

#include "app/cli/arguments.h"
#include "app/cli/console.h"
#include "core/map/overhead_map_file.h"
#include "core/run/evaluate_run.h"

namespace nadir::cli {
namespace {

void say_what_was_left_out(const LocaliseSummary& summary, std::ostream& err) {
  if (summary.frames_without_odometry > 0) {
    err << fmt::format("{} frames were left out because the odometry has a gap there\n",
                       summary.frames_without_odometry);
  }
  if (summary.steps_without_evidence > 0) {
    err << fmt::format("{} of {} topviews held nothing that the map could answer\n",
                       summary.steps_without_evidence, summary.steps);
  }
}

/// Steps of a run as they come: into the file, where there is one, and always into the evaluation.
class Recorder {
 public:
  Recorder(const LocaliseTask& task, RunHeader header) : task_(task), header_(std::move(header)) {}

  Result<void> record(const RunStep& step) {
    if (task_.run && !writer_) {  // not before there is something to write
      auto created = RunWriter::create(*task_.run, header_);
      if (!created) return forward_error(created);
      writer_.emplace(std::move(*created));
    }
    steps_.push_back(evaluated_step(step));
    return writer_ ? writer_->write(step) : Result<void>();
  }

  Result<RunEvaluation> finish() {
    if (writer_) {
      if (const auto finished = writer_->finish(); !finished) return forward_error(finished);
    }
    auto evaluation = evaluate_steps(steps_);
    if (!evaluation) return evaluation;
    describe(*evaluation, header_, task_.run ? task_.run->string() : "(not kept)");
    return evaluation;
  }

  [[nodiscard]] std::size_t step_count() const { return steps_.size(); }

 private:
  const LocaliseTask& task_;
  RunHeader header_;
  std::optional<RunWriter> writer_;
  std::vector<EvaluatedStep> steps_;
};

}  // namespace

Result<RunEvaluation> localise_and_evaluate(const LocaliseTask& task, std::ostream& err) {
  const Interrupt interrupt;
  const std::filesystem::path map_path = find_bundled(task.map);
  auto map = read_overhead_map(map_path);
  if (!map) return forward_error(map);
  const auto flight = open_flight(task.flight);
  if (!flight) return forward_error(flight);
  const auto index =
      std::make_shared<const MapIndex>(std::make_shared<const OverheadMap>(std::move(*map)));

  Recorder recorder(task, run_header(**flight, index->map(), map_path.string(), task.preset,
                                     task.request.options));
  Result<LocaliseSummary> summary;
  {
    ProgressBar bar(err, task.is_quiet);
    bar.show(0.0, "preparing the map");
    const WorkContext context{
        interrupt.token(),
        [&bar](double fraction, const std::string& activity) { bar.show(fraction, activity); }};
    summary = localise_flight(
        **flight, index, task.request,
        [&recorder](const RunStep& step) { return recorder.record(step); }, context);
  }
  if (!summary) {
    if (summary.error().code == ErrorCode::kCancelled && task.run && recorder.step_count() > 0) {
      return fail(ErrorCode::kCancelled, "stopped; the first {} steps are in {}",
                  recorder.step_count(), task.run->string());
    }
    return forward_error(summary);
  }
  if (!task.is_quiet) say_what_was_left_out(*summary, err);
  return recorder.finish();
}

}  // namespace nadir::cli
