// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "widgets/panels/map_view.h"
#include "widgets/views/map_overlays.h"

namespace nadir {

/// Whether two parts of a page have any in common.
[[nodiscard]] bool overlap(const PageRect& one, const PageRect& other);

/// Where on a map's page an arrow and its words may lie.
struct ArrowRoom {
  PageRect inside;              ///< The page without what controls cover along its border.
  std::vector<PageRect> taken;  ///< By legend, cards and notes.
};

/// Nothing where it is in sight, nobody knows it, or the map follows it. The arrow is at the border of the room, or nearer to its
/// middle where something lies there; its words have a plate where they lie on nothing.
[[nodiscard]] std::optional<VehicleAway> vehicle_away(const kit::Ui& ui,
                                                      const MapViewModel& model,
                                                      const MapFrame& frame,
                                                      const ArrowRoom& room);

/// "vehicle 34 m", "vehicle 1.2 km".
[[nodiscard]] std::string away_words(double distance_m);

/// An arrow at the border of the map that points to it.
void draw_vehicle_arrow(kit::Ui& ui, const VehicleAway& away);
/// Beside the arrow the distance, as a button that follows the vehicle. Paths begin with "Vehicle/".
/// @param page  The map's place in the window.
[[nodiscard]] Actions draw_vehicle_plate(kit::Ui& ui,
                                         const VehicleAway& away,
                                         const kit::Rect& page);

}  // namespace nadir
