// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/eval/run_evaluation.h"
#include "core/eval/series.h"
#include "core/run/run_file.h"
#include "core/session/worst_moments.h"

namespace nadir {

/// The numbers of a run that need no truth: element i of every array belongs to step i. NaN where a number is not known.
struct RunSeries {
  std::vector<double> agreement;  ///< Share of known topview cells that fit the map, in [0, 1].
  std::vector<double> effective_sample_size;  ///< In particles.
  std::vector<double> particle_count;
  std::vector<double> topview_cells;
  std::vector<double> update_ms;                            ///< Computing time of the update.
  std::vector<double> x_sigma_m, y_sigma_m, yaw_sigma_rad;  ///< Roots of the variances, in enu.
  std::vector<double> position_sigma_m;  ///< Square root of position_spread_m2().
};

/// Which file a run was read from: a run of the same name that took its place is another file.
struct RunFileId {
  std::uint64_t device = 0, number = 0;
  friend bool operator==(const RunFileId&, const RunFileId&) = default;
};

/// A recorded run as the window holds it: all but particles and topviews, which StepCache decodes when they are looked at.
///
/// A value that never changes once it is made, so threads share it. Times in this module are seconds after the run's
/// first step, as in ErrorSeries and in figures, unless they are called `clock_s`: then they are the recording's, as
/// RunStep::time_s. Poses are in the project plane (enu).
struct RunDocument {
  std::filesystem::path path;
  std::string name;  ///< For legends: the file's name without ending.
  RunFileId file;
  RunHeader header;
  bool is_complete =
      false;  ///< Reached its end; false while it is written, and for ever if it was killed.
  std::vector<RunStep>
      steps;  ///< Without particles and topviews; rising in `step` and in time. Empty in a run that has just begun.
  double start_clock_s = 0.0;         ///< The recording's clock at the first step; 0 without steps.
  std::vector<double> time_s;         ///< Of each step, after the first.
  std::vector<EvaluatedStep> judged;  ///< The steps as the evaluation sees them.
  bool has_odometry =
      false;  ///< Of any step it is known where dead reckoning alone would have been.
  /// Corners of the least convex outline around all estimates and truths, counter-clockwise; empty where there are none.
  std::vector<Eigen::Vector2d> outline_in_enu_m;
  RunSeries series;
  ErrorSeries errors;                   ///< Of the steps whose truth is known.
  std::vector<std::size_t> error_gaps;  ///< Where lines through `errors` break; see gaps_of().
  std::vector<std::size_t>
      gaps;  ///< Every step that comes later than usual, see time_gaps(): where lines through `series` break.
  double median_period_s = 0.0;  ///< Between steps, the usual one; 0 with fewer than two.
  RunEvaluation evaluation;      ///< Of all steps, without alignment, as `nadir evaluate` gives it.
  std::vector<WorstMoment> worst_moments;  ///< Of find_worst_moments(), in order of time.

  /// Reads a run. A run without steps is no error. Progress is reported. @errors as RunReader; kCancelled.
  [[nodiscard]] static Result<std::shared_ptr<const RunDocument>> load(
      const std::filesystem::path& path, const WorkContext& context = {});

  /// The same run as it is by now, for one that is being written: only its new steps are read. `earlier` itself where
  /// nothing is new; the whole run where another has taken its name. @param earlier  Not null. @errors as load.
  [[nodiscard]] static Result<std::shared_ptr<const RunDocument>> grown(
      const std::shared_ptr<const RunDocument>& earlier, const WorkContext& context = {});

  /// Computes all that follows from path, header and steps (every field below `steps`); for runs made without a file.
  /// @param made  Steps in order of time.
  [[nodiscard]] static std::shared_ptr<const RunDocument> from_steps(RunDocument made);

  /// "Latest at t": the last step that is not after the moment (to a microsecond). Nothing before the first step.
  [[nodiscard]] std::optional<std::size_t> latest_at(double moment_s) const;
  /// The same for a cursor, which is always somewhere: the first step before it. Nothing only where there are no steps.
  [[nodiscard]] std::optional<std::size_t> index_at(double moment_s) const;
  /// The element of `errors` that belongs to a step; nothing where its truth is not known.
  [[nodiscard]] std::optional<std::size_t> error_index_of(std::size_t step_index) const;

  [[nodiscard]] double duration_s() const { return time_s.empty() ? 0.0 : time_s.back(); }
  [[nodiscard]] double clock_s(double moment_s) const { return start_clock_s + moment_s; }
  /// The same moment of the flight in another run's time: several runs share one cursor.
  [[nodiscard]] double time_in(const RunDocument& other, double moment_s) const {
    return moment_s + (start_clock_s - other.start_clock_s);
  }
  [[nodiscard]] bool has_truth() const { return errors.size() > 0; }
};

}  // namespace nadir
