// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "core/geo/project_plane.h"
#include "widgets/views/map_overlays.h"
#include "widgets/views/theme.h"

namespace nadir {

/// What tells a reader of a map how large it is and where: quiet, at the border, over any ground.

/// A bar of a round length (1, 2 or 5 times a power of ten, at most a quarter of the map's width) at the lower left, on a
/// plate with its length.
void draw_scale_bar(Canvas& canvas, const MapFrame& frame, const Theme& theme);

/// An arrow to the north of the project plane at the upper right.
void draw_north_arrow(Canvas& canvas, const MapFrame& frame, const Theme& theme);

enum class Graticule { kNone, kMetres, kDegrees };

template <>
struct EnumNames<Graticule> {
  static constexpr std::array<std::string_view, 3> kNames = {"none", "metres", "degrees"};
};

/// Ticks with numbers at the left and lower border at round coordinates: metres east and north on the plane, or degrees
/// (labels outside of `frame.where`, which must leave room: see graticule_margin_px). Lines across the map are fine.
void draw_graticule(Canvas& canvas,
                    const MapFrame& frame,
                    Graticule kind,
                    const ProjectPlane& plane,
                    const Theme& theme);

/// Room that the numbers take at the left and below, pixels.
[[nodiscard]] Eigen::Vector2d graticule_margin_px(Graticule kind, double px_per_pt);

/// The largest of 1, 2, 5 times a power of ten that is at most `largest`.
[[nodiscard]] double round_length(double largest);

}  // namespace nadir
