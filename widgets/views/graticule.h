// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>

#include "core/base/field.h"
#include "core/geo/project_plane.h"
#include "widgets/views/map_overlays.h"
#include "widgets/views/theme.h"

namespace nadir {

/// Coordinates of a map: metres east and north on its plane, or degrees of longitude and latitude.
enum class Graticule { kNone, kMetres, kDegrees };

template <>
struct EnumNames<Graticule> {
  static constexpr std::array<std::string_view, 3> kNames = {"none", "metres", "degrees"};
};

/// Ticks with numbers at round coordinates along the left and lower border, outside of `frame.where`, which must leave
/// the room of graticule_margin_px(), and the names of the coordinates where they have room beside the numbers. Two numbers never are equal nor touch each other; there are fewer where they would,
/// and none where not even one fits. A map that is turned has none, for along its borders no coordinate alone changes;
/// nor has one whose coordinates are not finite, or whose whole width is lost in the rounding of them.
void draw_graticule(Canvas& canvas,
                    const MapFrame& frame,
                    Graticule kind,
                    const ProjectPlane& plane,
                    const Theme& theme);

/// Thin lines across the map from the same ticks, as meridians and parallels truly run on the plane. For below paths.
void draw_graticule_lines(Canvas& canvas,
                          const MapFrame& frame,
                          Graticule kind,
                          const ProjectPlane& plane,
                          const Theme& theme);

/// Room that the numbers take at the left and below, pixels.
[[nodiscard]] Eigen::Vector2d graticule_margin_px(Graticule kind, double px_per_pt);

}  // namespace nadir
