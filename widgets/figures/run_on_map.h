// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "core/base/result.h"
#include "core/map/overhead_map.h"
#include "core/topview/semantic_topview.h"
#include "widgets/figures/figure_sources.h"

namespace nadir {

/// Whether a run may be drawn over a map: its coordinates mean something only on its own plane. Remarks on the run where
/// the map is not, or is no longer, the one that it was localised on, and where no pose of it lies on the map.
/// @errors kMalformed: "R.nadir: was localised on another plane than MAP: ...".
[[nodiscard]] Result<void> lay_on_map(FigureRun& run,
                                      const std::filesystem::path& map,
                                      const MapFacts& facts);

/// Cells of a topview and of a map can be compared only where they are of one size. Nothing where they are, else what to
/// say: "the topview has cells of 0.5 m and map 'NAME' of 0.25 m".
[[nodiscard]] std::optional<std::string> unlike_cells(const SemanticTopview& seen,
                                                      const OverheadMap& map);

/// Remarks on the first run where several are of different flights, and whose truth and odometry a map then shows: those
/// of the first.
void remark_on_flights(std::span<FigureRun> runs, bool is_on_map);

}  // namespace nadir
