// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <span>

#include "core/base/result.h"
#include "widgets/figures/figure_sources.h"

namespace nadir {

/// Whether a run may be drawn over a map: its coordinates mean something only on its own plane. Remarks on the run where
/// the map is not, or is no longer, the one that it was localised on, and where no pose of it lies on the map.
/// @errors kMalformed: "R.nadir: was localised on another plane than MAP: ...".
[[nodiscard]] Result<void> lay_on_map(FigureRun& run,
                                      const std::filesystem::path& map,
                                      const MapFacts& facts);

/// Remarks on the first run where several are of different flights, and whose truth and odometry a map then shows: those
/// of the first.
void remark_on_flights(std::span<FigureRun> runs, bool is_on_map);

}  // namespace nadir
