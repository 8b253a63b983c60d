// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "app/cli/arguments.h"
#include "app/cli/command.h"
#include "app/cli/console.h"
#include "widgets/canvas/fonts.h"
#include "widgets/figures/report.h"

namespace nadir::cli {
namespace {

constexpr const char* kReportName = "nadir report";

struct ReportArguments {
  ReportRequest request;
  std::string folder, map, theme;
  bool is_quiet = false;
};

void add_arguments(CLI::App& app, ReportArguments& values) {
  app.add_option("RUN", values.request.runs, "Run files, as 'nadir localise --out' writes them")
      ->required();
  app.add_option("--out", values.folder, "For the figures, the table and index.html")
      ->type_name("FOLDER")
      ->required();
  app.add_option("--map", values.map,
                 "Map package for all runs; default the one that each was localised on")
      ->type_name("FOLDER");
  app.add_option("--theme", values.theme, "Colours of the figures, default light")
      ->type_name("{light|dark}")
      ->check(is_one_of({"light", "dark"}));
  app.add_flag("--quiet", values.is_quiet, "No progress and no words");
  app.footer("Example: nadir report run.nadir --out report");
}

}  // namespace

int run_report(std::span<const std::string> arguments, std::ostream& out, std::ostream& err) {
  CLI::App app("Draws every figure of recorded runs, with a page that shows them", kReportName);
  ReportArguments values;
  add_arguments(app, values);
  if (const auto status = parse_arguments(app, arguments, out, err)) return *status;
  if (!values.map.empty()) values.request.map = find_bundled(values.map).string();
  if (values.theme == "dark") values.request.options.theme = ThemeName::kDark;
  const auto fonts = check_fonts();
  if (!fonts) return report_error(err, fonts.error());
  const Interrupt interrupt;
  Result<ReportSummary> summary;
  {
    ProgressBar bar(err, values.is_quiet);
    const WorkContext work{interrupt.token(), [&bar](double fraction, const std::string& activity) {
                             bar.show(fraction, activity);
                           }};
    summary = write_report(values.request, values.folder, work);
  }
  if (!summary) return report_flags_error(err, kReportName, summary.error());
  if (!values.is_quiet) {
    for (const std::string& note : *fonts) err << "nadir: " << note << "\n";
    for (const std::string& words : summary->left_out) err << "left out: " << words << "\n";
    err << fmt::format("{} figures in {}; open {}/index.html\n", summary->figures, values.folder,
                       values.folder);
  }
  return kDone;
}

}  // namespace nadir::cli
