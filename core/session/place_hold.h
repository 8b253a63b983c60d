// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/session/moment_explanation.h"
#include "core/session/moment_surface.h"

namespace nadir {

/// How firmly what was seen holds the place of an estimate: how far it could be moved, with its heading, while the mean cost
/// stays about as good. Found on MomentSurface::plane, from the samples around the estimate that cost at most so much more and
/// hang together with it.
struct PlaceHold {
  double more_cost = 0.0;  ///< Than at the estimate.
  double along_m =
      0.0;  ///< How far these places reach along their long axis; a grid step at least.
  double across_m = 0.0;       ///< The same at right angles.
  double bearing_deg = 0.0;    ///< Of the long axis, clockwise from north, in [0, 180).
  bool is_along_open = false;  ///< They end with the surface, so the true length is more.
  bool is_across_open = false;
  // The best of these places; the nearest of several.
  double falls_by = 0.0;          ///< Its cost is so much less than the estimate's.
  double best_m = 0.0;            ///< How far it is from the estimate ...
  double best_bearing_deg = 0.0;  ///< ... and where, clockwise from north, in [0, 360).
};

/// @param more_cost  Costs that differ by no more are alike. O(samples of the plane).
[[nodiscard]] PlaceHold place_hold(const MomentSurface& surface,
                                   double more_cost = ExplanationRules{}.alike_cost);

/// The same in a sentence: "The place is held poorly north-east to south-west, across the heading: the cost rises by at most
/// 0.005 over 7.4 m that way, 0.8 m across it."; or, of an estimate that lies on a slope, "The place is not held: the cost falls by
/// 0.12 towards a place 3.0 m south of it."
/// @param yaw_rad  Of the estimate, counter-clockwise from east.
[[nodiscard]] std::string in_words(const PlaceHold& hold, double yaw_rad);

}  // namespace nadir
