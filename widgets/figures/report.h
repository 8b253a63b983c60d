// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "widgets/figures/figure_options.h"

namespace nadir {

struct ReportRequest {
  std::vector<std::string> runs;
  std::string map;  ///< For all runs; empty: each run's own.
  FigureOptions options;
};

struct ReportSummary {
  int figures = 0;
  /// Figures that the data do not allow and why, one sentence each.
  std::vector<std::string> left_out;
  /// "no OpenGL for labels, flight: WHY", where this machine has none and figures need it; else empty.
  std::string without_graphics;
};

/// Writes every figure that the runs allow as PNG (charts as SVG too), the table of errors and a page `index.html` that
/// shows all of it from the disk, without script and without network. The same runs give the same bytes. A run's `moment`
/// and `error-surface` are those of its largest position error. The folder is whole or as it was.
/// @errors as open_figure_run; kIo, before any work where the folder cannot be written; kCancelled. A figure that cannot be
/// drawn is left out and told of, as are those of a run whose map is not there and those over maps on a machine without
/// OpenGL.
[[nodiscard]] Result<ReportSummary> write_report(const ReportRequest& request,
                                                 const std::filesystem::path& folder,
                                                 const WorkContext& work);

}  // namespace nadir
