// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string_view>

#include "core/base/result.h"
#include "core/geo/project_plane.h"

namespace nadir {

/// Reads a place as people write it, and as Nadir shows it:
///  - "123.4 -56.7", "E 123.4 N -56.7": metres east and north on the plane;
///  - "32.4, -83.7", "32.4 N 83.7 W", "32.4° N, 83.7° W": degrees of WGS 84;
///  - "17S 230567.1 E 3705123.4 N", with or without letters: UTM. The letter after the zone is its latitude band; an S or N
///    that could as well be the hemisphere is taken for whichever lies nearer to the plane's origin;
///  - "17S KT 30567 05123", with or without blanks: MGRS, the middle of the square.
///
/// @returns  The place in enu, metres.
/// @errors kInvalidOptions: nothing of that kind, no place on Earth, or more than 1000 km from the plane's origin.
[[nodiscard]] Result<Eigen::Vector2d> parse_place_text(std::string_view text,
                                                       const ProjectPlane& plane);

}  // namespace nadir
