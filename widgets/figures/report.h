// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "widgets/figures/figures.h"

namespace nadir {

struct ReportRequest {
  std::vector<std::string> runs;
  std::string map;  ///< Empty: as the runs say.
  FigureOptions options;
};

struct ReportSummary {
  int figures = 0;
  /// Figures that could not be drawn and why, one sentence each.
  std::vector<std::string> left_out;
};

/// Writes every figure that the runs allow as PNG (charts as SVG too), the table of errors and a page `index.html` that
/// shows all of it from the disk, without script and without network. The same runs give the same bytes. A run's `moment`
/// and `error-surface` are those of its largest position error. The folder is whole or as it was.
/// @errors as open_figure_run and find_map_of; kIo; kCancelled. A figure that cannot be drawn is left out and told of.
[[nodiscard]] Result<ReportSummary> write_report(const ReportRequest& request,
                                                 const std::filesystem::path& folder,
                                                 const WorkContext& work);

/// Draws a figure as a file's bytes with its recipe inside: what `nadir figure` writes too. @errors as make_figure and
/// Figure::draw.
[[nodiscard]] Result<std::string> draw_recipe(const FigureRecipe& recipe, PageFile kind);

/// The recipe as a figure carries it: with the version that drew it and the hashes of its runs. @errors kNotFound, kIo.
[[nodiscard]] Result<std::string> carried_recipe(const FigureRecipe& recipe);

}  // namespace nadir
