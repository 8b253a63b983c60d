// SPDX-License-Identifier: Apache-2.0
#include "core/session/rerun.h"

#include <utility>

#include "core/base/parallel.h"
#include "core/run/localise_flight.h"
#include "core/run/run_file.h"

namespace nadir {
namespace {

/// Steps of a rerun on their way into its file.
class RerunRecorder {
 public:
  RerunRecorder(const RerunTask& task,
                const LocaliseRequest& request,
                const std::function<void(RerunProgress)>& publish)
      : task_(task),
        publish_(publish),
        header_(run_header(*task.flight, task.map->map(), task.map_path, task.preset, request)) {}

  /// Puts the parent's steps up to the resume point before the new ones.
  void begin_after(std::vector<RunStep> before, const WorkContext& context) {
    before_ = std::move(before);
    context_ = context;
    context_.progress = {};  // the new steps are what takes long
  }

  Result<void> record(const RunStep& step) {
    if (!writer_) {  // not before there is something to write
      auto created = RunWriter::create(task_.run, header_);
      if (!created) return forward_error(created);
      writer_.emplace(std::move(*created));
      if (!before_.empty()) {
        auto copied = writer_->copy_steps(task_.parent, before_, context_);
        if (!copied) return copied;
        steps_ += static_cast<int>(before_.size());
      }
    }
    if (auto written = writer_->write(step); !written) return written;
    ++steps_;
    has_evidence_ = has_evidence_ || step.agreement.has_value();
    publish_({steps_});
    return {};
  }

  Result<void> finish() {
    if (!writer_) return {};
    return writer_->finish();
  }
  void stop() {
    static_cast<void>(writer_->stop());
    writer_.reset();
  }
  void discard() {
    if (writer_) writer_->discard();
    writer_.reset();
  }
  /// Only those that are in the file.
  [[nodiscard]] int steps() const { return writer_ ? steps_ : 0; }
  /// Whether what was localised is worth keeping where the rest failed: not so without a step in which the map had a say.
  [[nodiscard]] bool is_worth_keeping() const { return writer_ && has_evidence_; }

 private:
  const RerunTask& task_;
  const std::function<void(RerunProgress)>& publish_;
  RunHeader header_;
  std::vector<RunStep> before_;
  WorkContext context_;
  std::optional<RunWriter> writer_;
  int steps_ = 0;
  bool has_evidence_ = false;
};

/// The parent's steps up to the one that the new run goes on from.
Result<std::vector<RunStep>> steps_until(const RunReader& parent, const ResumePoint& point) {
  auto steps = parent.steps();
  if (!steps) return steps;
  std::erase_if(*steps, [&](const RunStep& step) { return step.step > point.after.step; });
  return steps;
}

}  // namespace

Result<RerunOutcome> rerun(const RerunTask& task,
                           const WorkContext& context,
                           const std::function<void(RerunProgress)>& publish) {
  const ThreadLimit limit(task.threads);
  LocaliseRequest request;
  request.options = task.options;
  request.prior = task.prior;
  std::vector<RunStep> before;
  if (!task.parent.empty()) {
    const auto parent = RunReader::open(task.parent);
    if (!parent) return forward_error(parent);
    const bool is_beside = task.parent.parent_path() == task.run.parent_path();
    auto point = resume_point(*parent, (is_beside ? task.parent.filename() : task.parent).string(),
                              task.from_s);
    if (!point) return forward_error(point);
    auto steps = steps_until(*parent, *point);
    if (!steps) return forward_error(steps);
    before = std::move(*steps);
    request.prior.reset();
    request.resume_after = std::move(*point);
  }
  RerunRecorder recorder(task, request, publish);
  recorder.begin_after(std::move(before), context);
  const auto summary = localise_flight(
      *task.flight, task.map, request,
      [&recorder](const RunStep& step) { return recorder.record(step); }, context);
  const int steps = recorder.steps();
  if (!summary && summary.error().code == ErrorCode::kCancelled && steps > 0) {
    recorder.stop();
    return RerunOutcome{steps, true, {}};
  }
  auto ended = summary ? recorder.finish() : Result<void>(forward_error(summary));
  if (ended) return RerunOutcome{steps, false, {}};
  if (!recorder.is_worth_keeping()) {
    recorder.discard();
    return forward_error(ended);
  }
  recorder.stop();
  return RerunOutcome{steps, false, ended.error().message};
}

}  // namespace nadir
