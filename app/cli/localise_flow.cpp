// SPDX-License-Identifier: Apache-2.0
#include "app/cli/localise_flow.h"

#include <fmt/format.h>

#include <cmath>

#include "app/cli/arguments.h"
#include "app/cli/console.h"
#include "app/cli/trajectory_output.h"
#include "core/base/angle.h"
#include "core/map/overhead_map_file.h"
#include "core/run/evaluate_run.h"
#include "core/run/place_beside.h"

namespace nadir::cli {
namespace {

namespace fs = std::filesystem;

void say_what_was_left_out(const LocaliseSummary& summary, std::ostream& err) {
  if (summary.frames_passed_over > 0) {
    err << fmt::format("{} frames were used and {} passed over (--min-update-interval)\n",
                       summary.steps, summary.frames_passed_over);
  }
  if (summary.frames_without_odometry > 0) {
    err << fmt::format("{} frames were left out because the odometry has a gap there\n",
                       summary.frames_without_odometry);
  }
  if (summary.steps_without_evidence > 0) {
    err << fmt::format("{} of {} topviews held nothing that the map could answer\n",
                       summary.steps_without_evidence, summary.steps);
  }
}

/// Where a run ends: place, heading, spread, and how the mass is shared where there is more than one cluster.
std::string ending_of(const RunStep& step, const ProjectPlane& plane) {
  const PoseMoments& moments = step.estimate.moments;
  const Eigen::Matrix3d& covariance = moments.covariance;
  std::string text = fmt::format(
      "ends at {:.2f} m east, {:.2f} m north ({}), heading {:.1f} deg from north; standard "
      "deviations {:.2f} m, {:.1f} deg\n",
      moments.mean.x_m, moments.mean.y_m,
      geodetic_text(plane.geodetic_from_enu(moments.mean.translation_m())),
      compass_deg_from_yaw(Angle::radians(moments.mean.yaw_rad)),
      std::sqrt(covariance(0, 0) + covariance(1, 1)),
      Angle::radians(std::sqrt(covariance(2, 2))).degrees());
  if (step.estimate.modes.size() > 1) {
    text += fmt::format("the particles form {} clusters; the heaviest holds {:.0f} %\n",
                        step.estimate.modes.size(), 100.0 * step.estimate.modes.front().mass);
  }
  return text;
}

/// The library says "prior: ..."; whoever gave one knows it as --prior. A start that is the flight's own truth is named by
/// the same word, and --prior is what to do about it.
Error named_after_flag(Error error) {
  if (error.message.rfind("prior: ", 0) == 0) error.message.insert(0, "--");
  return error;
}

/// A trajectory must not take the place of what is read. @errors kIo.
Result<void> check_not_read(const fs::path& trajectory,
                            const FlightDescription& flight,
                            const fs::path& map) {
  const auto check = [&trajectory](const fs::path& input, const char* what) -> Result<void> {
    if (!names_same_file(trajectory, input)) return {};
    return fail(ErrorCode::kIo, "--trajectory: {} is {}", trajectory.string(), what);
  };
  auto checked =
      check(flight.truth_source, "the truth of the flight")
          .and_then([&] { return check(flight.odometry_source, "the odometry of the flight"); })
          .and_then([&] { return check(flight.path, "the flight itself"); })
          .and_then([&] { return check(flight.path / "flight.toml", "a file of the flight"); })
          .and_then([&] { return check(map / "map.toml", "a file of the map"); });
  for (const fs::path& odometry : flight.other_odometry) {
    if (checked) checked = check(odometry, "an odometry of the flight");
  }
  return checked;
}

/// Steps of a run as they come: into the file, where there is one, and always into the evaluation.
class Recorder {
 public:
  Recorder(const LocaliseTask& task, RunHeader header) : task_(task), header_(std::move(header)) {}

  /// Steps of the run that this one goes on from: they come before its own.
  void begin_after(std::vector<RunStep> earlier) {
    earlier_ = std::move(earlier);
    for (const RunStep& step : earlier_) steps_.push_back(evaluated_step(step));
  }

  Result<void> record(const RunStep& step) {
    if (task_.run && !writer_) {  // not before there is something to write
      auto created = RunWriter::create(*task_.run, header_);
      if (!created) return forward_error(created);
      writer_.emplace(std::move(*created));
      if (!earlier_.empty()) {
        auto copied = writer_->copy_steps(task_.from->run, earlier_);
        if (!copied) return copied;
      }
    }
    steps_.push_back(evaluated_step(step));
    has_evidence_ = has_evidence_ || step.agreement.has_value();
    last_.estimate = step.estimate;
    return writer_ ? writer_->write(step) : Result<void>();
  }

  /// The run before goes last, when nothing can fail any more.
  Result<RunEvaluation> finish() {
    auto evaluation = evaluate_steps(steps_);
    if (!evaluation) return evaluation;
    describe(*evaluation, header_, task_.run ? task_.run->string() : "(not kept)");
    if (writer_) {
      if (const auto finished = writer_->finish(); !finished) return forward_error(finished);
    }
    return evaluation;
  }

  /// Keeps the steps so far. @param how  It ended: "stopped". @returns what was done and where they are, for people.
  std::string stop(const char* how) {
    std::string text = fmt::format("{} after {} steps", how, steps_.size());
    if (!writer_) return text;
    text += "; they are in " + task_.run->string();
    const fs::path earlier = writer_->stop();
    writer_.reset();
    if (!earlier.empty()) text += ", and the run that was there before is in " + earlier.string();
    return text;
  }

  /// The new file goes; the run before comes back.
  void discard() {
    if (writer_) writer_->discard();
    writer_.reset();
  }

  /// What became of the file of a run that failed: its steps stay where the map had a say in any of them, else it goes and
  /// the run before comes back. @returns the error, with the former in words.
  Error fail_with(Error error) {
    if (writer_ && has_evidence_) {
      error.message += "; it " + stop("failed");
    } else {
      discard();
    }
    return error;
  }

  [[nodiscard]] std::size_t step_count() const { return steps_.size(); }
  [[nodiscard]] std::span<const EvaluatedStep> steps() const { return steps_; }
  [[nodiscard]] const RunStep& last() const { return last_; }

 private:
  const LocaliseTask& task_;
  RunHeader header_;
  std::optional<RunWriter> writer_;
  std::vector<RunStep> earlier_;
  std::vector<EvaluatedStep> steps_;
  RunStep last_;
  bool has_evidence_ = false;
};

/// A run from which to go on, opened.
struct EarlierSteps {
  ResumePoint point;
  std::vector<RunStep> steps;  ///< All up to the point.
  std::string map_hash;        ///< Empty where the run does not say it.
};

Result<EarlierSteps> read_earlier(const LocaliseFrom& from) {
  const auto run = RunReader::open(from.run);
  if (!run) return forward_error(run);
  auto point = resume_point(*run, from.run.string(), from.elapsed_s);
  if (!point) return forward_error(point);
  auto steps = run->steps();
  if (!steps) return forward_error(steps);
  std::erase_if(*steps, [&](const RunStep& step) { return step.step > point->after.step; });
  return EarlierSteps{std::move(*point), std::move(*steps), run->header().map_hash};
}

}  // namespace

Result<LocaliseResult> localise_and_evaluate(const LocaliseTask& task,
                                             const std::stop_token& stop,
                                             std::ostream& err) {
  if (task.trajectory) {
    if (const auto free = check_trajectory_file(*task.trajectory); !free) {
      return forward_error(free);
    }
  }
  if (task.run) {
    if (const auto free = RunWriter::check_output(*task.run); !free) return forward_error(free);
  }
  const std::filesystem::path map_path = find_bundled(task.map);
  auto map = read_overhead_map(map_path);
  if (!map) return forward_error(map, "--map");
  if (const auto usable = check_usable_for_localising(*map); !usable) {
    return forward_error(usable, "--map: " + map_path.string());
  }
  const auto flight = open_flight(task.flight);
  if (!flight) return forward_error(flight);
  if (task.trajectory) {
    const auto free = check_not_read(*task.trajectory, (*flight)->description(), map_path);
    if (!free) return forward_error(free);
  }
  const auto index =
      std::make_shared<const MapIndex>(std::make_shared<const OverheadMap>(std::move(*map)));

  LocaliseRequest request = task.request;
  std::vector<RunStep> earlier_steps;
  if (task.from) {
    auto earlier = read_earlier(*task.from);
    if (!earlier) return forward_error(earlier, "--from");
    if (!task.is_quiet) {
      err << fmt::format("goes on from step {}, {:.2f} s, of {}\n", earlier->point.after.step,
                         earlier->point.elapsed_s, earlier->point.run);
      if (!earlier->map_hash.empty() && earlier->map_hash != content_hash(index->map())) {
        err << fmt::format(
            "{} was made on other cells than those of {}: what differs may be the "
            "map's doing\n",
            earlier->point.run, map_path.string());
      }
    }
    request.resume_after = std::move(earlier->point);
    earlier_steps = std::move(earlier->steps);
  }
  RunHeader header = run_header(**flight, index->map(), map_path.string(), task.preset, request);
  if (task.run) {
    header.flight_path = name_from_run(*task.run, header.flight_path);
    header.map_path = name_from_run(*task.run, header.map_path);
  }
  Recorder recorder(task, std::move(header));
  recorder.begin_after(std::move(earlier_steps));
  Result<LocaliseSummary> summary;
  {
    ProgressBar bar(err, task.is_quiet, task.share);
    bar.show(0.0, "preparing the map");
    const WorkContext context{stop, [&bar](double fraction, const std::string& activity) {
                                bar.show(fraction, activity);
                              }};
    summary = localise_flight(
        **flight, index, request,
        [&recorder](const RunStep& step) { return recorder.record(step); }, context);
  }
  if (!summary && summary.error().code == ErrorCode::kCancelled && recorder.step_count() > 0) {
    return fail(ErrorCode::kCancelled, "{}", recorder.stop("stopped"));
  }
  if (!summary) return tl::unexpected(recorder.fail_with(named_after_flag(summary.error())));
  if (!task.is_quiet) say_what_was_left_out(*summary, err);
  auto evaluation = recorder.finish();
  if (!evaluation) return tl::unexpected(recorder.fail_with(evaluation.error()));
  if (task.trajectory) {
    const auto written = write_estimated_trajectory(
        *task.trajectory, recorder.steps(), index->map().plane.origin(), evaluation->flight);
    if (!written) return forward_error(written);
  }
  return LocaliseResult{std::move(*evaluation), ending_of(recorder.last(), index->map().plane)};
}

}  // namespace nadir::cli
