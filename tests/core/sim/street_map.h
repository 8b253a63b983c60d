// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/geo/rigid3.h"
#include "tests/support/drawn_map.h"

namespace nadir {

/// Letter of a made-up crossing at a place in metres from the lower left corner: two streets,
/// centred on x = 40 and y = 30, with dashed lane markings, curbs, sidewalks, hedges, building
/// contours in the four blocks, a fence.
inline char street_letter(double x_m, double y_m) {
  const double to_east_west = std::abs(y_m - 30.0);
  const double to_north_south = std::abs(x_m - 40.0);
  const double to_road = std::min(to_east_west, to_north_south);
  const double along = to_east_west < to_north_south ? x_m : y_m;
  const bool is_crossing = std::max(to_east_west, to_north_south) < 4.0;
  if (to_road < 0.2 && !is_crossing && std::fmod(along, 4.0) < 2.5) return 'L';
  if (to_road < 4.0) return 'R';
  if (to_road < 4.4) return 'C';
  if (to_road < 6.5) return 'S';
  if (to_road < 7.0 && std::fmod(along, 20.0) < 8.0) return 'V';
  const double into_block = to_road - 11.0;
  if (into_block >= 0.0 && into_block < 0.5) return std::fmod(along, 25.0) < 20.0 ? 'B' : 'T';
  if (into_block >= 0.5 && into_block < 6.0) return '.';
  if (into_block >= 8.0 && into_block < 8.4) return 'F';
  return 'T';
}

/// 80 x 60 m of it.
inline OverheadMap street_map(double metres_per_cell = 0.2) {
  std::vector<std::string> rows;
  const int width = static_cast<int>(std::lround(80.0 / metres_per_cell));
  const int height = static_cast<int>(std::lround(60.0 / metres_per_cell));
  for (int row = 0; row < height; ++row) {
    std::string letters;
    for (int column = 0; column < width; ++column) {
      letters +=
          street_letter((column + 0.5) * metres_per_cell, 60.0 - (row + 0.5) * metres_per_cell);
    }
    rows.push_back(letters);
  }
  return drawn_map(metres_per_cell, rows);
}

/// A camera over a place, looking along a yaw, tilted as its vehicle is.
inline Rigid3 camera_over(double x_m,
                          double y_m,
                          double yaw_deg,
                          double roll_deg = 0.0,
                          double pitch_deg = 0.0,
                          double z_m = 2.0) {
  const Rigid3 enu_from_body{
      rotation_of({Angle::degrees(roll_deg).radians(), Angle::degrees(pitch_deg).radians(),
                   Angle::degrees(yaw_deg).radians()}),
      {x_m, y_m, z_m}};
  return enu_from_body * Rigid3{forward_body_from_camera(), Eigen::Vector3d::Zero()};
}

}  // namespace nadir
