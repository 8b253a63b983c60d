// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "core/map/map_summary.h"

namespace nadir::cli {

/// `nadir map info` in words: facts, places and a table of classes.
[[nodiscard]] std::string map_text(const MapSummary& summary, const std::optional<MapPlace>& asked);
/// The same as one JSON object with units in its keys; `asked` is the place of --at, or null.
[[nodiscard]] std::string map_json(const std::string& path,
                                   const MapSummary& summary,
                                   const std::optional<MapPlace>& asked);
/// One place, one line a notation.
[[nodiscard]] std::string place_text(const MapPlace& place);

}  // namespace nadir::cli
