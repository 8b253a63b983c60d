// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "widgets/panels/map_view.h"
#include "widgets/views/map_overlays.h"

namespace nadir {

/// One thing that the map has to say now: what a click does, what is not there yet, what is not drawn and why.
struct MapNote {
  std::string words;   ///< Empty: nothing.
  std::string button;  ///< What could be done about it; empty: nothing.
  std::optional<Action> action = {};
};
[[nodiscard]] MapNote map_note(const MapViewModel& model);

/// In a line in the middle of the upper border, between tools and north arrow, or in two. Left out where the map is too narrow
/// even for that.
[[nodiscard]] Actions draw_map_note(kit::Ui& ui, const MapNote& note, const kit::Rect& map);

/// What is drawn of a run on the map: "estimate", "particles", "topview at the truth". Only what is in sight.
[[nodiscard]] std::vector<std::string> shown_things(const MapViewModel& model, const MapRun& run);
/// Name of the run and what is drawn of it, as much as there is room for, on a plate at the upper left of a half of a split
/// view. @param other  The run of the other half: what is drawn of both needs no words. Null: all is said.
/// @param aside_px  What lies left of it.
void draw_pane_name(Canvas& canvas,
                    const MapFrame& frame,
                    const MapViewModel& model,
                    const MapRun& run,
                    const MapRun* other,
                    double aside_px,
                    const Theme& theme);

/// What Escape ends: the tool, else a selection, else what is measured; nothing where there is none of them.
[[nodiscard]] std::optional<Action> escape_wish(const MapViewModel& model);

}  // namespace nadir
