// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "widgets/views/label_overlay.h"
#include "widgets/views/map_overlays.h"

namespace nadir {

// Marks of a labelling editor, at points of the page. All have one size at any zoom, and a casing.

struct MarkLook {
  Rgba colour, casing;
  double px_per_pt = 1.0;
};

/// A small square: hollow, or larger and full where it was picked.
void draw_corner(Canvas& canvas, const Eigen::Vector2d& at, bool is_picked, const MarkLook& look);

/// Told by its form: a square on a corner, a diamond on an edge, two strokes across what continues the last leg, a right angle
/// on what stands square on it, two rings where a border closes.
/// @param along  Direction of the leg that comes, on the page, of length 1.
void draw_snap_mark(Canvas& canvas,
                    const Eigen::Vector2d& at,
                    SnapMark mark,
                    const Eigen::Vector2d& along,
                    const MarkLook& look);

/// A circle with a cross in its middle; of one that is too small to be seen only the cross.
void draw_brush_circle(Canvas& canvas,
                       const Eigen::Vector2d& at,
                       double radius_px,
                       const MarkLook& look);

/// Rings on the page as one outline, whose inside by the even-odd rule is theirs: a way there and back leads to each further
/// one, and covers nothing.
[[nodiscard]] std::vector<Eigen::Vector2d> keyholed(const MapFrame& frame,
                                                    const std::vector<Ring>& rings_in_enu_m);

}  // namespace nadir
