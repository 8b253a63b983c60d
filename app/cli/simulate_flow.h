// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <ostream>
#include <stop_token>

#include "app/cli/console.h"
#include "core/sim/simulated_flight.h"

namespace nadir::cli {

/// What `nadir simulate` was asked to do; `nadir demo` asks for the same.
struct SimulateTask {
  std::filesystem::path map, flight;
  std::filesystem::path route;    ///< Empty: the map's own routes/loop.toml.
  std::optional<FlownPath> path;  ///< A recorded path instead of a route.
  SimulationOptions options;
  bool is_quiet = false;
  ProgressShare share = {};  ///< Of a demo.
};

/// Makes the flight with a progress bar. Words go to `err`. @errors as simulate_flight, and kNotFound where neither path
/// nor route are given and the map has none; nothing is left behind then.
[[nodiscard]] Result<SimulatedFlight> simulate(const SimulateTask& task,
                                               const std::stop_token& stop,
                                               std::ostream& err);

}  // namespace nadir::cli
