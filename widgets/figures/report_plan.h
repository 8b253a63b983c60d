// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "widgets/figures/figure_recipe.h"
#include "widgets/figures/figure_run.h"
#include "widgets/figures/report.h"

namespace nadir {

/// One figure of a report: what to draw and how its files are called.
struct PlannedFigure {
  FigureRecipe recipe;
  std::string section;  ///< What it is of: "All runs", section_of() a run, "Map town".
  std::string file;     ///< Without ending; the only one of its name.
  std::string caption;
  bool has_vectors = false;  ///< A chart, worth an SVG.
};

struct ReportPlan {
  std::vector<PlannedFigure> figures;  ///< Those of one section follow each other.
  /// Why figures over a map are not even tried.
  std::vector<std::string> left_out;
};

[[nodiscard]] std::string section_of(const FigureRun& run);

/// Everything that there is to draw of the runs.
[[nodiscard]] ReportPlan plan_report(const ReportRequest& request, std::span<const FigureRun> runs);

}  // namespace nadir
