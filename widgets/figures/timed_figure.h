// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "widgets/figures/figures.h"

namespace nadir {

/// A figure of runs that shows one moment of them: that of the options, until show_at() asks for another. So the still at
/// a time is the film's picture at that time.
class TimedFigure : public Figure {
 public:
  [[nodiscard]] std::optional<FigureTimes> times() const final;
  void show_at(double time_s) final { time_s_ = time_s; }

 protected:
  /// @param inputs  One run or more.
  explicit TimedFigure(FigureInputs inputs);

  [[nodiscard]] const FigureOptions& options() const { return inputs_.options; }
  [[nodiscard]] std::span<const FigureRun> runs() const { return inputs_.runs; }
  /// The first one, which for many figures is the only one.
  [[nodiscard]] const FigureRun& run() const { return inputs_.runs.front(); }

  /// Seconds after the first step; may lie past the end, which then is shown.
  [[nodiscard]] double time_s() const { return time_s_; }
  /// Whether the moment is one of the runs' times: then charts mark it. Past the end all is shown and nothing marked.
  [[nodiscard]] bool is_moment_in_runs() const;
  /// Of the first run's steps, the one shown.
  [[nodiscard]] std::size_t index() const { return run().index_at(time_s_); }
  /// The same with its particles and its topview. @errors as RunReader::step.
  [[nodiscard]] Result<RunStep> read_step() const;

 private:
  FigureInputs inputs_;
  double time_s_;
};

}  // namespace nadir
