// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "widgets/figures/report_plan.h"
#include "widgets/views/theme.h"

namespace nadir {

/// What there is to show of a report.
struct ReportContents {
  std::span<const FigureRun> runs;  ///< At least one.
  std::span<const PlannedFigure> figures;
  std::span<const std::string> left_out;
  ThemeName theme = ThemeName::kLight;  ///< Of the figures, and so of the page around them.
};

/// The page of a report: facts of the runs, table of errors, a list of all figures, and these, whose files lie beside the
/// page. HTML 5 that is well-formed XML too, without script, network or anything that changes from one day to the next.
[[nodiscard]] std::string report_page(const ReportContents& contents);

/// Rows of what was run on what; each run has the id "run-1", "run-2" ...
[[nodiscard]] std::string run_table(std::span<const FigureRun> runs);
/// Rows of errors: odometry, estimate and their ratio for each run.
[[nodiscard]] std::string error_table(std::span<const FigureRun> runs);

/// A path as part of a URL: what is not a plain letter, digit or one of "-._~/" as %XX of its bytes.
[[nodiscard]] std::string url_path(std::string_view path);

}  // namespace nadir
