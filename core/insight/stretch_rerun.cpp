// SPDX-License-Identifier: Apache-2.0
#include "core/insight/stretch_rerun.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/require.h"
#include "core/eval/trajectory_error.h"

namespace nadir {
namespace {

void add_counts(std::array<CellAgreement::Count, kClassCount>& sums,
                const CellAgreement& agreement) {
  for (std::size_t id = 0; id < sums.size(); ++id) {
    sums[id].agreeing += agreement.of_class[id].agreeing;
    sums[id].disagreeing += agreement.of_class[id].disagreeing;
    sums[id].unknown += agreement.of_class[id].unknown;
  }
}

/// Mean of a member over the steps that have it.
std::optional<double> mean_of(const std::vector<StretchStep>& steps,
                              std::optional<double> StretchStep::*member) {
  double sum = 0.0;
  std::size_t count = 0;
  for (const StretchStep& step : steps) {
    if (!(step.*member)) continue;
    sum += *(step.*member);
    ++count;
  }
  if (count == 0) return std::nullopt;
  return sum / static_cast<double>(count);
}

void set_means(StretchRerun& result) {
  result.mean_error_before_m = mean_of(result.steps, &StretchStep::error_before_m);
  result.mean_error_after_m = mean_of(result.steps, &StretchStep::error_after_m);
  result.mean_error_before_rad = mean_of(result.steps, &StretchStep::error_before_rad);
  result.mean_error_after_rad = mean_of(result.steps, &StretchStep::error_after_rad);
}

/// Sets a step of the rerun beside the recorded one of its time.
void compare_step(StretchRerun& result,
                  const StretchTask& task,
                  const RunStep& recorded,
                  const RunStep& again) {
  StretchStep step{.time_s = again.time_s,
                   .before_in_enu = recorded.estimate.moments.mean,
                   .after_in_enu = again.estimate.moments.mean};
  if (again.truth_in_enu) {
    const Eigen::Vector3d before = pose_error(step.before_in_enu, *again.truth_in_enu);
    const Eigen::Vector3d after = pose_error(step.after_in_enu, *again.truth_in_enu);
    step.error_before_m = before.head<2>().norm();
    step.error_after_m = after.head<2>().norm();
    step.error_before_rad = std::abs(before.z());
    step.error_after_rad = std::abs(after.z());
  }
  if (again.topview) {
    const CellAgreement before =
        cell_agreement(*again.topview, task.before->map(), step.before_in_enu);
    const CellAgreement after =
        cell_agreement(*again.topview, task.after->map(), step.after_in_enu);
    step.agreement_before = before.total();
    step.agreement_after = after.total();
    add_counts(result.class_before, before);
    add_counts(result.class_after, after);
  }
  result.steps.push_back(step);
  set_means(result);
}

}  // namespace

std::size_t frames_between(const FlightDescription& flight, double from_s, double to_s) {
  return static_cast<std::size_t>(
      std::count_if(flight.frames.begin(), flight.frames.end(), [&](const FlightFrame& frame) {
        return frame.labels && frame.depth && frame.time_s > from_s &&
               frame.time_s <= to_s + kSameTimeS;
      }));
}

Result<StretchRerun> rerun_stretch(const RunReader& run,
                                   const StretchTask& task,
                                   const WorkContext& context,
                                   const std::function<void(const StretchRerun&)>& publish) {
  NADIR_REQUIRE(task.flight != nullptr && task.before != nullptr && task.after != nullptr);
  const auto recorded = run.steps();
  if (!recorded) return forward_error(recorded);
  auto point = resume_point(run, "the run", task.from_s);
  if (!point) return forward_error(point);
  const double start_s = recorded->front().time_s;
  const std::size_t frames =
      frames_between(task.flight->description(), point->after.time_s, start_s + task.to_s);
  if (frames == 0) {
    return fail(ErrorCode::kInvalidOptions, "no frame lies between {:.3f} s and {:.3f} s",
                task.from_s, task.to_s);
  }
  LocaliseRequest request;
  request.options = task.options;
  request.resume_after = std::move(*point);
  request.record_particles = false;
  request.most_frames = frames;
  StretchRerun result;
  const auto compare = [&](const RunStep& again) -> Result<void> {
    const auto same = std::find_if(recorded->begin(), recorded->end(), [&](const RunStep& step) {
      return std::abs(step.time_s - again.time_s) <= kSameTimeS;
    });
    if (same == recorded->end()) return {};  // the run ended before
    compare_step(result, task, *same, again);
    if (publish) publish(result);
    return {};
  };
  const auto summary = localise_flight(*task.flight, task.after, request, compare, context);
  if (!summary) return forward_error(summary);
  return result;
}

}  // namespace nadir
