// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <string>

#include "app/cli/arguments.h"
#include "app/cli/command.h"
#include "app/cli/console.h"
#include "app/cli/simulate_flow.h"
#include "core/base/angle.h"
#include "core/base/parallel.h"
#include "core/geo/trajectory_file.h"

namespace nadir::cli {
namespace {

struct SimulateArguments {
  std::string map, out, route, truth, odometry, times, start;
  bool is_quiet = false;
  int threads = 0;
  OptionFlags options;
};

constexpr const char* kSimulateName = "nadir simulate";

void add_path_flags(CLI::App& app, SimulateArguments& values) {
  CLI::Option* route =
      app.add_option("--route", values.route,
                     "Route to fly (TOML); default: the map's own routes/loop.toml")
          ->type_name("FILE");
  CLI::Option* truth =
      app.add_option("--truth", values.truth,
                     "Observe the map along this recorded true path (TUM text, or KITTI poses)")
          ->type_name("FILE")
          ->excludes(route);
  app.add_option("--odometry", values.odometry,
                 "Recorded odometry with the times of the truth; default: odometry is simulated")
      ->type_name("FILE")
      ->needs(truth);
  app.add_option("--times", values.times,
                 "Time of each KITTI pose; default: times.txt beside the poses")
      ->type_name("FILE")
      ->needs(truth);
  app.add_option("--start", values.start,
                 "Lay the first true pose here: metres east and north on the map's plane, degrees "
                 "counter-clockwise from east")
      ->type_name("E,N,YAW")
      ->needs(truth);
}

void add_arguments(CLI::App& app, SimulateArguments& values) {
  app.add_option("MAP", values.map,
                 "Labelled overhead: a map package (a folder with map.toml), or a bundled one by "
                 "its name")
      ->required();
  app.add_option("--out", values.out, "Flight folder to write")->type_name("FOLDER")->required();
  add_path_flags(app, values);
  add_threads_flag(app, values.threads);
  app.add_flag("--quiet", values.is_quiet, "No progress and no words");
  add_option_flags(app, "Options of the simulation", option_texts(SimulationOptions{}),
                   values.options);
  app.footer("Example: nadir simulate maps/proving-ground --level hard --seed 7 --out flight");
}

/// @errors kInvalidOptions where the command line is at fault, other codes where a file is.
Result<FlownPath> recorded_path(const SimulateArguments& values, double camera_height_m) {
  const auto truth = read_trajectory(values.truth, values.times);
  if (!truth) return tl::unexpected(blame_file(truth.error().within("--truth")));
  std::optional<Rigid2> start;
  if (!values.start.empty()) {
    const auto numbers = parse_list("--start", values.start, 3);
    if (!numbers) return forward_error(numbers);
    start = Rigid2{(*numbers)[0], (*numbers)[1], wrap_rad(Angle::degrees((*numbers)[2]).radians())};
  }
  FlownPath path{std::filesystem::path(values.truth).stem().string(),
                 place_recorded_path(*truth, start, camera_height_m), std::nullopt, std::nullopt};
  if (!values.odometry.empty()) {
    auto odometry = read_trajectory(values.odometry, values.times);
    if (!odometry) return tl::unexpected(blame_file(odometry.error().within("--odometry")));
    path.odometry = std::move(*odometry);
  }
  return path;
}

}  // namespace

int run_simulate(std::span<const std::string> arguments, std::ostream& out, std::ostream& err) {
  CLI::App app("Makes a flight with known truth on a labelled overhead", kSimulateName);
  SimulateArguments values;
  add_arguments(app, values);
  if (const auto status = parse_arguments(app, arguments, out, err)) return *status;

  SimulateTask task;
  task.map = values.map;
  task.flight = values.out;
  task.route = values.route;
  task.is_quiet = values.is_quiet;
  for (const auto& [name, text] : values.options) {
    if (const auto set = set_option(task.options, name, text); !set) {
      return report_flags_error(err, kSimulateName, set.error());
    }
  }
  if (!values.truth.empty()) {
    auto path = recorded_path(values, task.options.camera_height_m);
    if (!path) return report_flags_error(err, kSimulateName, path.error());
    task.path = std::move(*path);
  }
  if (!values.truth.empty() && values.start.empty() && !values.is_quiet) {
    err << "the path is taken to be in metres on the map's plane already; --start lays its first "
           "pose elsewhere\n";
  }
  const ThreadLimit limit(values.threads);
  const Interrupt interrupt;
  const auto flight = simulate(task, interrupt.token(), err);
  if (!flight) return report_error(err, flight.error());
  if (!values.is_quiet) {
    err << fmt::format("{}: {} frames, {:.1f} s, {:.1f} m\n", flight->folder.string(),
                       flight->frames, flight->duration_s, flight->length_m);
  }
  return kDone;
}

}  // namespace nadir::cli
