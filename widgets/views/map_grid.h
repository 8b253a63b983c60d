// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "widgets/views/map_overlays.h"
#include "widgets/views/theme.h"

namespace nadir {

/// A line of constant east or north across a page, with what is to be written at it.
struct GridLine {
  bool is_east = false;  ///< Of constant east, so it runs north.
  double value_m = 0.0;
  std::array<Eigen::Vector2d, 2>
      ends;  ///< On the borders of the page; the lower (or else the left) one first.
};
/// Lines at round coordinates that are at least so many pixels apart, of a map turned in any way. None where the coordinates
/// are so large that neighbours are lost in rounding.
[[nodiscard]] std::vector<GridLine> grid_lines(const MapCamera& camera,
                                               const PageRect& where,
                                               double least_px);

struct MapGridLook {
  Rgba line, casing;  ///< A transparent casing is none.
  Rgba text, plate;
};
/// Over pictures and labels. @param line  Of the lines before they are made thin and pale.
[[nodiscard]] MapGridLook grid_look_on_imagery(const Theme& theme, Rgba line, double opacity);

/// The lines across a map with their numbers on plates inside of its border: east along the upper one, north along the right
/// one, each where no other is.
void draw_grid_lines(Canvas& canvas, const MapFrame& frame, const MapGridLook& look);

}  // namespace nadir
