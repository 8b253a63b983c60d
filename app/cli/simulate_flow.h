// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <ostream>

#include "core/sim/simulated_flight.h"

namespace nadir::cli {

/// What `nadir simulate` was asked to do; `nadir demo` asks for the same.
struct SimulateTask {
  std::filesystem::path map, flight;
  std::filesystem::path route;    ///< Empty: the map's own routes/loop.toml.
  std::optional<FlownPath> path;  ///< A recorded path instead of a route.
  SimulationOptions options;
  bool is_quiet = false;
};

/// Makes the flight with a progress bar. Words go to `err`. @errors as simulate_flight; nothing is
/// left behind then.
[[nodiscard]] Result<SimulatedFlight> simulate(const SimulateTask& task, std::ostream& err);

}  // namespace nadir::cli
