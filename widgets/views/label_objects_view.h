// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "widgets/views/label_overlay.h"
#include "widgets/views/map_overlays.h"
#include "widgets/views/theme.h"

namespace nadir {

/// What is smaller on the page, in pixels of the screen, is passed over.
inline constexpr double kLeastObjectPx = 2.0;

/// Draws what an editor shows over the map: what is coming, borders and corners of what is selected, what lies under the hand,
/// the places of the tool with lengths on plates, what the next place holds on to, and the brush. Everything carries a casing,
/// so that it is seen on any ground, and nothing is told by its colour alone. What is out of sight, or smaller than
/// kLeastObjectPx, costs next to nothing.
void draw_label_overlay(Canvas& canvas,
                        const MapFrame& frame,
                        const LabelOverlay& overlay,
                        const Theme& theme);

/// The line of an object as people see it: the rings of an area or outline, closed; of a line both of its sides, or, where it
/// is narrower than a few pixels, its middle. @param metres_per_px  > 0.
[[nodiscard]] std::vector<Ring> border_of(const LabelObject& object, double metres_per_px);

/// Points on the page of a line in enu, without those that lie within `least_px` of the one before; the last one stays.
[[nodiscard]] std::vector<Eigen::Vector2d> page_line(const MapFrame& frame,
                                                     const Ring& places_in_enu_m,
                                                     double least_px);

}  // namespace nadir
