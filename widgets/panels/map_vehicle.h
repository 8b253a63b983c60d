// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "widgets/panels/map_view.h"
#include "widgets/views/map_overlays.h"

namespace nadir {

/// Nothing where it is in sight, nobody knows it, or the map follows it. @param free  The part of the page that controls leave.
[[nodiscard]] std::optional<VehicleAway> vehicle_away(const MapViewModel& model,
                                                      const MapFrame& frame,
                                                      const PageRect& free);

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
