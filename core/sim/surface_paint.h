// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "core/map/semantic_classes.h"
#include "core/sim/solid.h"

namespace nadir {

using Paint = Eigen::Vector3f;  ///< Red, green, blue, 0 to 255.

[[nodiscard]] inline Paint paint_of(const Colour& c) {
  return {static_cast<float>(c.red), static_cast<float>(c.green), static_cast<float>(c.blue)};
}

/// How bright a surface is in sun and sky by Lambert's law; level ground has 1. The sun stands in
/// the south-east, 50 degrees high, as over the bundled town. `normal_in_enu` has length 1.
[[nodiscard]] float light(const Eigen::Vector3d& normal_in_enu);

/// Paint of a column of the map: wall, fence, post. Buildings differ by their height, which is that
/// of the whole building.
[[nodiscard]] Paint paint_of_class(ClassId label, double height_m);

/// Paint of a solid at a point of its surface: a car is a body and a cabin of glass, a person
/// trousers, shirt and head, a tree trunk and crown. Cars and people differ by their size.
[[nodiscard]] Paint paint_of_solid(const Solid& solid, const Eigen::Vector3d& point_in_enu_m);

}  // namespace nadir
