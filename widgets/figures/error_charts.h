// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/eval/series.h"
#include "widgets/figures/figure_run.h"
#include "widgets/views/theme.h"
#include "widgets/views/xy_chart.h"

namespace nadir {

/// Charts of runs that several figures show. Times are seconds after the run's first step. Colours are those of lines on
/// paper; a run's number picks its colour and dashes, see run_colour(). Lines and bands break where truth is missing and
/// where a run pauses, see gaps_of(). What a run has not is neither drawn nor named.

// Errors: error_charts.cpp.

enum class PoseAxis { kEast, kNorth, kYaw };
/// Error of the estimate with a band of one and two standard deviations of the particles around zero: a consistent
/// filter's error stays in the darker one two thirds of the time (thesis figures 4-4 to 4-6, b to d).
[[nodiscard]] ChartSpec axis_error_chart(const FigureRun& run, PoseAxis axis, const Theme& theme);

/// Distance between estimate and truth of each run, and of the odometry of the first where asked (4-4 to 4-6, e).
[[nodiscard]] ChartSpec position_error_chart(std::span<const FigureRun> runs,
                                             bool with_odometry,
                                             const Theme& theme);
/// Size of the orientation error in degrees, likewise.
[[nodiscard]] ChartSpec orientation_error_chart(std::span<const FigureRun> runs,
                                                bool with_odometry,
                                                const Theme& theme);

enum class ErrorKind { kPosition, kOrientation };
/// Share of steps whose error is at most so large (4-8). Runs of several flights have an odometry each.
[[nodiscard]] ChartSpec cdf_chart(std::span<const FigureRun> runs,
                                  ErrorKind kind,
                                  const Theme& theme);
/// Mean squared error of each run, input beside estimate (4-7), in m^2 or deg^2 as the report has it.
[[nodiscard]] ChartSpec mse_chart(std::span<const FigureRun> runs,
                                  ErrorKind kind,
                                  const Theme& theme);

/// Seconds after the run's first step of a series' elements, which count from the first step shown.
[[nodiscard]] std::vector<double> elapsed_of(const FigureRun& run, const ErrorSeries& series);

// The filter itself, step by step: step_charts.cpp.

/// NEES of each step with the bounds between which a step of a consistent filter lies 95 times in 100 (Bar-Shalom et al.
/// 2001, section 5.4).
[[nodiscard]] ChartSpec nees_chart(const FigureRun& run, const Theme& theme);
/// Share of truth inside the p-ellipse against p: the diagonal for a consistent filter. Of the steps with a covariance.
[[nodiscard]] ChartSpec calibration_chart(const FigureRun& run, const Theme& theme);
/// Effective sample size beside the number of particles.
[[nodiscard]] ChartSpec sample_size_chart(const FigureRun& run, const Theme& theme);
/// Share of topview cells that agree with the map at the estimate.
[[nodiscard]] ChartSpec agreement_chart(std::span<const FigureRun> runs, const Theme& theme);
/// Computing time of each update in milliseconds, with the time between two steps, in which an update has to be done to
/// keep up with the flight, unless that is so long that the updates were flat beside it.
[[nodiscard]] ChartSpec timing_chart(const FigureRun& run, const Theme& theme);
/// Median time between two steps, milliseconds; nothing for a single step.
[[nodiscard]] std::optional<double> step_period_ms(const FigureRun& run);

}  // namespace nadir
