// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <string>

#include "app/cli/arguments.h"
#include "app/cli/command.h"
#include "app/cli/localise_flow.h"
#include "app/cli/simulate_flow.h"
#include "core/base/parallel.h"
#include "core/base/staged_output.h"
#include "core/eval/report.h"

namespace nadir::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kBundledMap = "maps/proving-ground";

/// Copies the map beside flight and run, so that the folder can be moved or sent as a whole. One that is there already is
/// left alone: somebody may have worked on it.
Result<void> copy_map(const fs::path& from, const fs::path& to) {
  std::error_code error;
  if (fs::exists(to / "map.toml", error)) return {};
  auto staged = StagedOutput::folder(to, "map.toml");
  if (!staged) return forward_error(staged);
  fs::copy(from, staged->path(), fs::copy_options::recursive, error);
  if (error) return fail(ErrorCode::kIo, "{}: {}: {}", to.string(), from.string(), error.message());
  return staged->commit();
}

Result<void> make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) return fail(ErrorCode::kIo, "{}: {}", folder.string(), error.message());
  return {};
}

std::string what_next(const fs::path& folder) {
  const std::string program = program_name();
  return fmt::format(
      "\nIn {0}: the map, the flight, the run and this table (table.txt, table.json). Next:\n"
      "  what the overhead holds         {1} map info {0}/map\n"
      "  what was recorded               {1} flight info {0}/flight\n"
      "  the published filter on it      {1} localise {0}/flight --map {0}/map --preset thesis\n"
      "  the table for a script          {1} evaluate {0}/run.nadir --json\n"
      "  every step of the run           sqlite3 {0}/run.nadir .tables\n",
      folder.string(), program);
}

}  // namespace

int run_demo(std::span<const std::string> arguments, std::ostream& out, std::ostream& err) {
  CLI::App app("Makes a flight over the bundled town, localises it and prints the errors",
               "nadir demo");
  std::string folder_name = "nadir-demo";
  std::string seed = "1";
  bool is_quiet = false;
  bool is_json = false;
  int threads = 0;
  app.add_option("--out", folder_name, "Folder for map, flight, run and table, default nadir-demo");
  app.add_option("--seed", seed, "Of the flight and of the localiser, default 1");
  app.add_option("--threads", threads,
                 "Threads; 0 is all there are. The result does not depend on it")
      ->check(CLI::Range(0, 1024));
  app.add_flag("--json", is_json, "Print one JSON object instead of the table");
  app.add_flag("--quiet", is_quiet, "No progress and no words beside the result");
  if (const auto status = parse_arguments(app, arguments, out, err)) return *status;
  SimulateTask flight;
  LocaliseTask task;
  for (const auto& set :
       {set_option(flight.options, "seed", seed), set_option(task.request.options, "seed", seed)}) {
    if (!set) return report_error(err, set.error());
  }

  const ThreadLimit limit(threads);
  const fs::path folder = folder_name;
  if (const auto made = make_folder(folder); !made) return report_error(err, made.error());
  if (const auto copied = copy_map(find_bundled(kBundledMap), folder / "map"); !copied) {
    return report_error(err, copied.error());
  }
  flight.map = folder / "map";
  flight.flight = folder / "flight";
  flight.is_quiet = is_quiet;
  if (const auto made = simulate(flight, err); !made) return report_error(err, made.error());

  task.flight = folder / "flight";
  task.map = folder / "map";
  task.run = folder / "run.nadir";
  task.is_quiet = is_quiet;
  const auto result = localise_and_evaluate(task, err);
  if (!result) return report_error(err, result.error());
  const std::span runs(&result->evaluation, 1);
  const std::string table = report_as_text(runs);
  const std::string json = report_as_json(runs);
  for (const auto& [name, text] : {std::pair("table.txt", table), std::pair("table.json", json)}) {
    if (const auto written = write_text_file(folder / name, text); !written) {
      return report_error(err, written.error());
    }
  }
  out << (is_json ? json : table);
  if (!is_quiet) err << what_next(folder);
  return kDone;
}

}  // namespace nadir::cli
