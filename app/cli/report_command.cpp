// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "app/cli/arguments.h"
#include "app/cli/command.h"
#include "app/cli/console.h"
#include "app/cli/report_flow.h"

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
  app.add_flag("--quiet", values.is_quiet,
               "No progress and no words, unless maps cannot be drawn here");
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
  const Interrupt interrupt;
  const auto drawn =
      draw_report(values.request, values.folder, interrupt.token(), values.is_quiet, err);
  if (!drawn) return report_flags_error(err, kReportName, drawn.error());
  const int status = tell_of_report(err, *drawn, values.is_quiet);
  if (!values.is_quiet) {
    err << fmt::format("{} figures in {}; open {}/index.html\n", drawn->summary.figures,
                       values.folder, values.folder);
  }
  return status;
}

}  // namespace nadir::cli
