// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "app/cli/arguments.h"
#include "app/cli/command.h"
#include "app/cli/console.h"
#include "app/cli/localise_flow.h"
#include "app/cli/trajectory_output.h"
#include "core/base/angle.h"
#include "core/base/parallel.h"
#include "core/eval/report.h"

namespace nadir::cli {
namespace {

struct LocaliseArguments {
  std::string flight, map, run, trajectory, preset, recipe, prior, prior_sigma, from;
  bool is_global = false, is_json = false, is_quiet = false;
  bool has_no_particles = false, has_no_topviews = false;
  int threads = 0;
  std::int64_t most_frames = 0;
  OptionFlags options;
};

constexpr const char* kLocaliseName = "nadir localise";

void add_start_flags(CLI::App& app, LocaliseArguments& values) {
  CLI::Option* prior =
      app.add_option("--prior", values.prior,
                     "Where the flight starts: metres east and north on the map's plane, degrees "
                     "counter-clockwise from east")
          ->type_name("E,N,YAW");
  app.add_option("--prior-sigma", values.prior_sigma,
                 "Standard deviations of the start: metres along each axis, degrees; default "
                 "2.24,28.6")
      ->type_name("METRES,DEGREES")
      ->needs(prior);
  CLI::Option* global =
      app.add_flag("--global", values.is_global, "Nothing is known about the start")
          ->excludes(prior);
  app.add_option("--from", values.from,
                 "Go on from a recorded run of this flight, so many seconds after its first step, "
                 "with the particles it had; its steps before that come first in the new run, and "
                 "its options hold where no flag, preset or recipe says otherwise")
      ->type_name("RUN@SECONDS")
      ->excludes(prior)
      ->excludes(global);
}

void add_arguments(CLI::App& app, LocaliseArguments& values) {
  app.add_option("FLIGHT", values.flight,
                 "Recorded flight with labels, depth and odometry: a folder with flight.toml; "
                 "'nadir flight info' tells what a recording holds")
      ->required();
  app.add_option("--map", values.map,
                 "Labelled overhead: a map package (a folder with map.toml), or a bundled one by "
                 "its name")
      ->type_name("MAP")
      ->required();
  app.add_option("--out", values.run,
                 "Run file to write, such as run.nadir; without it only the table is printed")
      ->type_name("FILE");
  app.add_option("--trajectory", values.trajectory,
                 "Also write the estimated trajectory as TUM text (time x y z qx qy qz qw, metres "
                 "east and north on the map's plane), as evo reads it")
      ->type_name("FILE");
  const std::vector<std::string> presets = localiser_preset_names();
  CLI::Option* preset =
      app.add_option("--preset", values.preset, "Set of options to begin with, default default")
          ->type_name(choices_text(presets))
          ->check(is_one_of(presets));
  app.add_option("--recipe", values.recipe,
                 "TOML file with a preset and options; flags win over what it says")
      ->type_name("FILE")
      ->excludes(preset);
  add_start_flags(app, values);
  app.add_option("--frames", values.most_frames, "Stop after so many frames, 1 or more")
      ->type_name("NUMBER")
      ->check(is_whole_number(1));
  app.add_flag("--no-particles", values.has_no_particles,
               "Leave the particles out of the run file");
  app.add_flag("--no-topviews", values.has_no_topviews, "Leave the topviews out of the run file");
  add_threads_flag(app, values.threads);
  app.add_flag("--json", values.is_json, "Print one JSON object instead of the table");
  app.add_flag("--quiet", values.is_quiet, "No progress and no words beside the result");
  add_option_flags(app, "Options of the localiser (defaults are those of preset 'default')",
                   option_texts(RunOptions{}), values.options);
  app.footer(
      "Without --prior and --global the flight starts at its own truth, with the\n"
      "default of --prior-sigma.\n"
      "Example: nadir localise flight --map maps/proving-ground --out run.nadir\n"
      "What if, from 30 s on: nadir localise flight --map maps/proving-ground \\\n"
      "         --from run.nadir@30 --position-noise 2 --out what-if.nadir");
}

Result<std::optional<Prior>> prior_of(const LocaliseArguments& values) {
  if (values.is_global) return std::optional<Prior>(GlobalPrior{});
  if (values.prior.empty()) return std::optional<Prior>();
  const auto mean = parse_list("--prior", values.prior, 3);
  if (!mean) return forward_error(mean);
  GaussianPrior prior;
  prior.mean_in_enu = {(*mean)[0], (*mean)[1], wrap_rad(Angle::degrees((*mean)[2]).radians())};
  if (!values.prior_sigma.empty()) {
    const auto sigma = parse_list("--prior-sigma", values.prior_sigma, 2);
    if (!sigma) return forward_error(sigma);
    if ((*sigma)[0] < 0.0 || (*sigma)[1] < 0.0) {
      return fail(ErrorCode::kInvalidOptions, "--prior-sigma: '{}' holds a negative deviation",
                  values.prior_sigma);
    }
    prior.position_sigma_m = (*sigma)[0];
    prior.yaw_sigma_rad = Angle::degrees((*sigma)[1]).radians();
  }
  return std::optional<Prior>(prior);
}

/// "RUN@SECONDS"; a name may hold an @ of its own. @errors kInvalidOptions.
Result<std::optional<LocaliseFrom>> from_of(const LocaliseArguments& values) {
  if (values.from.empty()) return std::optional<LocaliseFrom>();
  const auto at = values.from.rfind('@');
  const auto refuse = [&] {
    return fail(ErrorCode::kInvalidOptions,
                "--from: '{}' is not a run file and a time in seconds, RUN@SECONDS", values.from);
  };
  if (at == std::string::npos || at == 0) return refuse();
  const auto seconds = parse_list("--from", values.from.substr(at + 1), 1);
  if (!seconds) return refuse();
  return std::optional(LocaliseFrom{values.from.substr(0, at), seconds->front()});
}

/// No output may take the place of another file of this command line. @errors kInvalidOptions.
Result<void> check_outputs(const LocaliseArguments& values,
                           const std::optional<LocaliseFrom>& from) {
  if (from && names_same_file(values.run, from->run)) {
    return fail(ErrorCode::kInvalidOptions, "--out: {} is the run of --from", values.run);
  }
  for (const auto& [file, what] :
       {std::pair(values.run, "the run file of --out"),
        std::pair(values.recipe, "the recipe to read"),
        std::pair(from ? from->run.string() : "", "the run of --from")}) {
    if (names_same_file(values.trajectory, file)) {
      return fail(ErrorCode::kInvalidOptions, "--trajectory: {} is {}", values.trajectory, what);
    }
  }
  return {};
}

/// What the run of --from was made with. @errors  Of the file, never kInvalidOptions.
Result<void> take_options(const LocaliseFrom& from, LocaliseTask& task) {
  const auto run = RunReader::open(from.run);
  if (!run) return tl::unexpected(blame_file(run.error().within("--from")));
  const auto options = recorded_options(run->header());
  if (!options) return forward_error(options, "--from: " + from.run.string());
  task.preset = run->header().preset;
  task.request.options = *options;
  return {};
}

/// @errors kInvalidOptions where the command line is at fault, other codes where a recipe or a run is.
Result<LocaliseTask> task_of(const LocaliseArguments& values,
                             const std::optional<LocaliseFrom>& from) {
  LocaliseTask task;
  task.from = from;
  task.flight = values.flight;
  task.map = values.map;
  if (!values.run.empty()) task.run = values.run;
  if (!values.trajectory.empty()) task.trajectory = values.trajectory;
  task.is_quiet = values.is_quiet;
  if (from && values.recipe.empty() && values.preset.empty()) {
    if (const auto taken = take_options(*from, task); !taken) return forward_error(taken);
  } else if (values.recipe.empty()) {
    if (!values.preset.empty()) task.preset = values.preset;
    const auto options = run_preset(task.preset);
    if (!options) return forward_error(options);
    task.request.options = *options;
  } else {
    const auto recipe = read_run_recipe(values.recipe);
    if (!recipe) return tl::unexpected(blame_file(recipe.error()));
    task.preset = recipe->preset;
    task.request.options = recipe->options;
  }
  for (const auto& [name, text] : values.options) {
    if (const auto set = set_option(task.request.options, name, text); !set) {
      return forward_error(set);
    }
  }
  if (auto valid = validate_run(task.request.options); !valid) return forward_error(valid);
  auto prior = prior_of(values);
  if (!prior) return forward_error(prior);
  task.request.prior = *prior;
  task.request.record_particles = !values.has_no_particles;
  task.request.record_topviews = !values.has_no_topviews;
  if (values.most_frames > 0)
    task.request.most_frames = static_cast<std::size_t>(values.most_frames);
  return task;
}

}  // namespace

int run_localise(std::span<const std::string> arguments, std::ostream& out, std::ostream& err) {
  CLI::App app("Localises a recorded flight on a labelled overhead", kLocaliseName);
  LocaliseArguments values;
  add_arguments(app, values);
  if (const auto status = parse_arguments(app, arguments, out, err)) return *status;
  const auto from = from_of(values);
  if (!from) return report_misuse(err, kLocaliseName, from.error().message);
  if (const auto checked = check_outputs(values, *from); !checked) {
    return report_misuse(err, kLocaliseName, checked.error().message);
  }
  const auto task = task_of(values, *from);
  if (!task) return report_flags_error(err, kLocaliseName, task.error());

  const ThreadLimit limit(values.threads);
  const Interrupt interrupt;
  const auto result = localise_and_evaluate(*task, interrupt.token(), err);
  if (!result) return report_error(err, result.error());
  const std::span runs(&result->evaluation, 1);
  out << (values.is_json ? report_as_json(runs) : report_as_text(runs) + "\n" + result->ending);
  return kDone;
}

}  // namespace nadir::cli
