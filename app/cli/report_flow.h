// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <ostream>
#include <stop_token>
#include <string>
#include <vector>

#include "app/cli/console.h"
#include "widgets/figures/report.h"

namespace nadir::cli {

/// A report that was drawn, and what its user should know.
struct DrawnReport {
  ReportSummary summary;
  std::vector<std::string> font_notes;  ///< As check_fonts().
};

/// Draws a report with a progress bar; `nadir report` and `nadir demo` do the same.
/// @errors as write_report; kUnsupported: no font at all, before any work.
[[nodiscard]] Result<DrawnReport> draw_report(const ReportRequest& request,
                                              const std::filesystem::path& folder,
                                              const std::stop_token& stop,
                                              bool is_quiet,
                                              std::ostream& err,
                                              const ProgressShare& share = {});

/// Prints what is missing: notes on fonts and data unless quiet, and in any case that this machine draws no maps.
/// @returns the program's status: kFailed where it draws none although the report needs them, else kDone.
int tell_of_report(std::ostream& err, const DrawnReport& drawn, bool is_quiet);

}  // namespace nadir::cli
