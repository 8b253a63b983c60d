// SPDX-License-Identifier: Apache-2.0
#include "widgets/figures/run_on_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <system_error>

#include "core/run/place_beside.h"

namespace nadir {
namespace fs = std::filesystem;
namespace {

bool touches(const FigureRun& run, const Eigen::AlignedBox2d& bounds_in_enu_m) {
  constexpr std::array kSources = {Source::kEstimate, Source::kTruth, Source::kOdometry};
  return std::any_of(run.steps.begin(), run.steps.end(), [&](const RunStep& step) {
    return std::any_of(kSources.begin(), kSources.end(), [&](Source source) {
      const auto pose = pose_of(step, source);
      return pose && bounds_in_enu_m.contains(pose->translation_m());
    });
  });
}

}  // namespace

Result<void> lay_on_map(FigureRun& run, const fs::path& map, const MapFacts& facts) {
  const RunHeader& header = run.reader->header();
  constexpr double kSameDeg = 1e-9;  // a tenth of a millimetre
  const auto [latitude_deg, longitude_deg] = facts.plane_origin;
  if (!(std::abs(header.plane_latitude_deg - latitude_deg) < kSameDeg &&
        std::abs(header.plane_longitude_deg - longitude_deg) < kSameDeg)) {
    return fail(ErrorCode::kMalformed,
                "{}: was localised on another plane than {}: its origin is {}, {} and not {}, {}",
                run.path.string(), map.string(), header.plane_latitude_deg,
                header.plane_longitude_deg, latitude_deg, longitude_deg);
  }
  if (!header.map_hash.empty() && header.map_hash != facts.hash) {
    std::error_code error;
    const auto own = place_beside(run.path, header.map_path, "map.toml");
    run.remarks.emplace_back(own && fs::equivalent(map, *own, error)
                                 ? "the map has changed since the run"
                                 : "drawn on another map than the run's, or a changed one");
  }
  if (!touches(run, facts.bounds_in_enu_m)) {
    run.remarks.emplace_back("the run lies outside the map");
  }
  return {};
}

std::optional<std::string> unlike_cells(const SemanticTopview& seen, const OverheadMap& map) {
  constexpr double kSame = 1e-9;
  const double cell_m = map.metres_per_cell;
  if (std::abs(seen.metres_per_cell - cell_m) < kSame * cell_m) return std::nullopt;
  return fmt::format("the topview has cells of {} m and map '{}' of {} m", seen.metres_per_cell,
                     map.name, cell_m);
}

void remark_on_flights(std::span<FigureRun> runs, bool is_on_map) {
  if (runs.empty()) return;
  FigureRun& first = runs.front();
  const std::string& flight = first.reader->header().flight_hash;
  const bool are_alike = std::all_of(runs.begin(), runs.end(), [&](const FigureRun& run) {
    return run.reader->header().flight_hash == flight;
  });
  if (are_alike) return;
  first.remarks.push_back(
      is_on_map
          ? fmt::format("the runs are of different flights, truth and odometry are those of {}",
                        first.name)
          : "the runs are of different flights");
}

}  // namespace nadir
