// SPDX-License-Identifier: Apache-2.0
#include "app/cli/report_flow.h"

#include "app/cli/command.h"
#include "widgets/canvas/fonts.h"

namespace nadir::cli {

Result<DrawnReport> draw_report(const ReportRequest& request,
                                const std::filesystem::path& folder,
                                const std::stop_token& stop,
                                bool is_quiet,
                                std::ostream& err,
                                const ProgressShare& share) {
  auto fonts = check_fonts();
  if (!fonts) return forward_error(fonts);
  ProgressBar bar(err, is_quiet, share);
  const WorkContext work{
      stop, [&bar](double fraction, const std::string& activity) { bar.show(fraction, activity); }};
  auto summary = write_report(request, folder, work);
  if (!summary) return forward_error(summary);
  return DrawnReport{std::move(*summary), std::move(*fonts)};
}

int tell_of_report(std::ostream& err, const DrawnReport& drawn, bool is_quiet) {
  if (!is_quiet) {
    for (const std::string& note : drawn.font_notes) err << "nadir: " << note << "\n";
    for (const std::string& words : drawn.summary.left_out) err << "left out: " << words << "\n";
  }
  if (drawn.summary.without_graphics.empty()) return kDone;
  err << "nadir: " << drawn.summary.without_graphics << "\n";
  return kFailed;
}

}  // namespace nadir::cli
