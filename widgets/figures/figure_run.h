// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/eval/run_evaluation.h"
#include "core/run/run_file.h"
#include "widgets/figures/figure_options.h"

namespace nadir {

/// A recorded run as figures use it: all its steps without particles and topviews, which are read when they are drawn.
/// Copies read the same open file.
struct FigureRun {
  std::string name;  ///< For legends: the file's name without ending.
  std::filesystem::path path;
  std::shared_ptr<const RunReader> reader;
  double start_s = 0.0;               ///< Time of the run's first step; figures count from there.
  std::vector<RunStep> steps;         ///< Those between `from` and `to`; never empty.
  std::vector<EvaluatedStep> judged;  ///< The same as the evaluation sees them.
  RunEvaluation evaluation;           ///< Of these steps, without alignment.
  /// What a reader of the figure must know beside that, said in its foot: "the map has changed since the run".
  std::vector<std::string> remarks;

  [[nodiscard]] double elapsed_s(const RunStep& step) const { return step.time_s - start_s; }
  /// The last step that is not after the moment (to kSameTimeS), else the first.
  [[nodiscard]] std::size_t index_at(double elapsed_s) const;
  [[nodiscard]] bool has_truth() const { return evaluation.matched_pairs > 0; }
};

/// @errors as RunReader; kMalformed: no step between `from` and `to`.
[[nodiscard]] Result<FigureRun> open_figure_run(const std::filesystem::path& path,
                                                const FigureOptions& options);

/// The map package that a run was localised on: where the run says it was, or beside the run under the same name.
/// @errors kNotFound: "R.nadir: its map PATH is not there; name one with --map".
[[nodiscard]] Result<std::filesystem::path> find_map_of(const FigureRun& run);

/// "preset default with temperature 0.05, seed 7, gone on from run.nadir after 66.5 s": options that differ from the preset's
/// and have an effect are named, four at most. @param start_s  Of the run's first step, as its header's times.
[[nodiscard]] std::string made_words(const RunHeader& header, double start_s);

/// How the run was made, "stopped before its end" where it was, the remarks, "no alignment, 401 matched pairs, 0 steps dropped": what every figure of a run says at its foot.
[[nodiscard]] std::string foot_of(const FigureRun& run);

/// Positions of a run's steps in enu, metres; not finite where not known.
enum class Source { kTruth, kOdometry, kEstimate };
[[nodiscard]] std::vector<Eigen::Vector2d> path_of(const FigureRun& run, Source source);
/// Pose of a step from one source. Nothing where not known.
[[nodiscard]] std::optional<Rigid2> pose_of(const RunStep& step, Source source);
/// Whose pose what was seen is laid at.
[[nodiscard]] Source source_of(LaidAt laid_at);

}  // namespace nadir
