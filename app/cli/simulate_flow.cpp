// SPDX-License-Identifier: Apache-2.0
#include "app/cli/simulate_flow.h"

#include <fmt/format.h>

#include <system_error>

#include "app/cli/arguments.h"
#include "app/cli/console.h"
#include "core/map/overhead_map_file.h"
#include "core/sim/route.h"

namespace nadir::cli {
namespace {

Result<FlownPath> path_along_route(const SimulateTask& task, const std::filesystem::path& map) {
  const std::filesystem::path file =
      task.route.empty() ? map / "routes" / "loop.toml" : find_bundled(task.route);
  std::error_code error;
  if (task.route.empty() && !std::filesystem::exists(file, error)) {
    return fail(ErrorCode::kNotFound,
                "{}: has no routes/loop.toml; name a route with --route, or a recorded path with "
                "--truth",
                map.string());
  }
  const auto route = read_route(file);
  if (!route) return forward_error(route);
  auto truth = plan_flight(*route, task.options.seed);
  if (!truth) return forward_error(truth, file.string());
  return FlownPath{route->name, std::move(*truth), std::nullopt, task.options.frame_rate_hz};
}

}  // namespace

Result<SimulatedFlight> simulate(const SimulateTask& task,
                                 const std::stop_token& stop,
                                 std::ostream& err) {
  if (const auto valid = validate(task.options); !valid) return forward_error(valid);
  const std::filesystem::path map_path = find_bundled(task.map);
  const auto map = read_overhead_map(map_path);
  if (!map) return forward_error(map);
  const auto picture = task.options.has_colour ? read_overhead_image(map_path)
                                               : Result<std::optional<ColourRaster>>(std::nullopt);
  if (!picture) return forward_error(picture);
  const auto path = task.path ? Result<FlownPath>(*task.path) : path_along_route(task, map_path);
  if (!path) return forward_error(path);
  Result<SimulatedFlight> flight;
  {
    ProgressBar bar(err, task.is_quiet, task.share);
    bar.show(0.0, "raising the world");
    const WorkContext context{stop, [&bar](double fraction, const std::string& activity) {
                                bar.show(fraction, activity);
                              }};
    flight = simulate_flight(*map, *path, task.options, task.flight, context, *picture);
  }
  if (flight && flight->frames_off_map > 0 && !task.is_quiet) {
    err << fmt::format("{} of {} frames were taken off the map\n", flight->frames_off_map,
                       flight->frames);
  }
  return flight;
}

}  // namespace nadir::cli
