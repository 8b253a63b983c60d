// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/mcl/pose_estimate.h"
#include "widgets/views/map_overlays.h"

namespace nadir {

/// How the modes of a posterior are drawn.
struct ModeLook {
  PathLook arrow;  ///< Colour and casing.
  double arrow_pt = 10.0;
  TextStyle words;  ///< Face, colour and weight; the size is `words_pt`.
  double words_pt = 7.5;
  Rgba plate;  ///< Below the words.
};

/// A mass in words: "62 %"; what is there but rounds to none or to all is "<1 %" or ">99 %".
[[nodiscard]] std::string mass_text(double mass);

/// Draws each mode as an arrowhead at its mean along its heading, the heaviest on top, and beside it its mass on a plate.
/// Plates lie inside of the map and hide neither each other nor an arrowhead: where there is no room beside a mode its mass is
/// left out, a heavier one's last. Modes that are not finite are passed over.
void draw_modes(Canvas& canvas,
                const MapFrame& frame,
                std::span<const PoseMode> modes,
                const ModeLook& look);

/// Where draw_modes() puts the plate of each mode, page pixels; nothing where there is none.
[[nodiscard]] std::vector<std::optional<PageRect>> mode_plates(const MapFrame& frame,
                                                               std::span<const PoseMode> modes,
                                                               const ModeLook& look);

}  // namespace nadir
