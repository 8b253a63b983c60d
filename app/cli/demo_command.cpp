// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <string>

#include "app/cli/arguments.h"
#include "app/cli/command.h"
#include "app/cli/console.h"
#include "app/cli/localise_flow.h"
#include "app/cli/report_flow.h"
#include "app/cli/simulate_flow.h"
#include "core/base/parallel.h"
#include "core/base/staged_output.h"
#include "core/eval/report.h"
#include "widgets/canvas/fonts.h"

namespace nadir::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kBundledMap = "maps/proving-ground";

constexpr const char* kDemoName = "nadir demo";

/// Makes the folder of the demo with a copy of the map, so that it can be moved or sent as a whole. A map that is there
/// already is left alone: somebody may have worked on it. @errors kNotFound: no map to copy; kCancelled; kIo.
Result<void> prepare_folder(const fs::path& folder,
                            const fs::path& from,
                            const std::stop_token& stop) {
  const fs::path to = folder / "map";
  std::error_code error;
  if (fs::exists(to / "map.toml", error)) return {};
  if (!fs::exists(from / "map.toml", error)) {
    return fail(ErrorCode::kNotFound,
                "{}: the bundled map is missing from this installation of Nadir", from.string());
  }
  fs::create_directories(folder, error);
  if (error) return fail(ErrorCode::kIo, "{}: {}", folder.string(), error.message());
  auto staged = StagedOutput::folder(to, "map.toml");
  if (!staged) return forward_error(staged);
  for (fs::recursive_directory_iterator at(from, error), end; !error && at != end;
       at.increment(error)) {
    if (stop.stop_requested()) return fail(ErrorCode::kCancelled, "the demo was stopped");
    const fs::path copy = staged->path() / at->path().lexically_relative(from);
    std::error_code failed;
    if (at->is_directory(failed)) {
      fs::create_directory(copy, failed);
    } else {
      fs::copy_file(at->path(), copy, failed);
    }
    if (failed) {
      return fail(ErrorCode::kIo, "{}: cannot be copied to {}: {}", at->path().string(),
                  to.string(), failed.message());
    }
  }
  if (error) return fail(ErrorCode::kIo, "{}: {}", from.string(), error.message());
  return staged->commit();
}

std::string what_next(const fs::path& folder) {
  const std::string program = program_name();
  return fmt::format(
      "\nIn {0}: the map, the flight, the run, this table (table.txt, table.json) and every "
      "figure. Next:\n"
      "  the figures                     {0}/report/index.html in a browser\n"
      "  one of them, or a film          {1} figure moment --run {0}/run.nadir --out moment.mp4\n"
      "  what the overhead holds         {1} map info {0}/map\n"
      "  what was recorded               {1} flight info {0}/flight\n"
      "  the published filter on it      {1} localise {0}/flight --map {0}/map --preset thesis\n"
      "  the table for a script          {1} evaluate {0}/run.nadir --json\n"
      "  every step of the run           sqlite3 {0}/run.nadir .tables\n",
      folder.string(), program);
}

struct DemoArguments {
  std::string folder = "nadir-demo";
  std::string seed = "1";
  bool is_quiet = false, is_json = false;
  int threads = 0;
};

void add_arguments(CLI::App& app, DemoArguments& values) {
  app.add_option("--out", values.folder,
                 "For map, flight, run, table and figures, default nadir-demo")
      ->type_name("FOLDER");
  app.add_option("--seed", values.seed, "Of the flight and of the localiser, 0 or more, default 1")
      ->type_name("NUMBER");
  add_threads_flag(app, values.threads);
  app.add_flag("--json", values.is_json, "Print one JSON object instead of the table");
  app.add_flag("--quiet", values.is_quiet, "No progress and no words beside the result");
}

/// How the demo's time is shared out on few cores, about: rendering the flight takes most of it.
constexpr ProgressShare kOfFlight{0.0, 0.7}, kOfRun{0.7, 0.84}, kOfFigures{0.84, 1.0};

/// What the demo has made.
struct DemoResult {
  RunEvaluation evaluation;
  DrawnReport report;
};

/// Flight, run, tables and figures in the folder of the demo, where its map lies already.
Result<DemoResult> fly_and_localise(SimulateTask flight,
                                    LocaliseTask task,
                                    const fs::path& folder,
                                    const std::stop_token& stop,
                                    std::ostream& err) {
  flight.map = folder / "map";
  flight.flight = folder / "flight";
  flight.share = kOfFlight;
  if (const auto made = simulate(flight, stop, err); !made) return forward_error(made);
  task.flight = folder / "flight";
  task.map = folder / "map";
  task.run = folder / "run.nadir";
  task.share = kOfRun;
  auto result = localise_and_evaluate(task, stop, err);
  if (!result) return forward_error(result);
  const std::span runs(&result->evaluation, 1);
  for (const auto& [name, text] : {std::pair("table.txt", report_as_text(runs)),
                                   std::pair("table.json", report_as_json(runs))}) {
    if (const auto written = write_text_file(folder / name, text); !written) {
      return forward_error(written);
    }
  }
  const ReportRequest report{{task.run->string()}, task.map.string(), {}};
  auto drawn = draw_report(report, folder / "report", stop, task.is_quiet, err, kOfFigures);
  if (!drawn) return forward_error(drawn);
  return DemoResult{std::move(result->evaluation), std::move(*drawn)};
}

}  // namespace

int run_demo(std::span<const std::string> arguments, std::ostream& out, std::ostream& err) {
  CLI::App app("Makes a flight over the bundled town, localises it and prints the errors",
               kDemoName);
  DemoArguments values;
  add_arguments(app, values);
  if (const auto status = parse_arguments(app, arguments, out, err)) return *status;
  SimulateTask flight;
  LocaliseTask task;
  flight.is_quiet = task.is_quiet = values.is_quiet;
  for (const auto& set : {set_option(flight.options, "seed", values.seed),
                          set_option(task.request.options, "seed", values.seed)}) {
    if (!set) return report_flags_error(err, kDemoName, set.error());
  }

  const ThreadLimit limit(values.threads);
  const Interrupt interrupt;
  const fs::path folder = values.folder;
  if (const auto fonts = check_fonts(); !fonts) return report_error(err, fonts.error());
  const auto prepared = prepare_folder(folder, find_bundled(kBundledMap), interrupt.token());
  if (!prepared) return report_error(err, prepared.error());
  const auto made =
      fly_and_localise(std::move(flight), std::move(task), folder, interrupt.token(), err);
  if (!made) return report_error(err, made.error());
  const std::span runs(&made->evaluation, 1);
  out << (values.is_json ? report_as_json(runs) : report_as_text(runs));
  const int status = tell_of_report(err, made->report, values.is_quiet);
  if (!values.is_quiet) err << what_next(folder);
  return status;
}

}  // namespace nadir::cli
