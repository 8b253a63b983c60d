// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "core/map/overhead_map.h"

namespace nadir {

/// The class that a letter stands for in a drawn map: R road, S sidewalk, B building, V vegetation,
/// T terrain, C curb, L lane marking, F fence, . unclassified.
[[nodiscard]] inline ClassId class_of_letter(char letter) {
  switch (letter) {
    case 'R':
      return kRoad;
    case 'S':
      return kSidewalk;
    case 'B':
      return kBuilding;
    case 'V':
      return kVegetation;
    case 'T':
      return kTerrain;
    case 'C':
      return kCurb;
    case 'L':
      return kLaneMarking;
    case 'F':
      return kFence;
    case '.':
      return kUnclassified;
    default:
      throw std::logic_error(std::string("drawn_map: no class has the letter ") + letter);
  }
}

/// A map drawn in the test: one string a row from north to south, one letter a cell. All rows are
/// equally long. Its lower left corner is (0, 0) of `enu`, so a cell's place can be read from the
/// drawing.
[[nodiscard]] inline OverheadMap drawn_map(double metres_per_cell,
                                           const std::vector<std::string>& rows) {
  const int height = static_cast<int>(rows.size());
  const int width = rows.empty() ? 0 : static_cast<int>(rows.front().size());
  OverheadMap map{.name = "drawn",
                  .plane = ProjectPlane::create({33.45, -83.9}).value(),
                  .metres_per_cell = metres_per_cell,
                  .top_left_in_enu_m = {0.0, metres_per_cell * height},
                  .labels = Raster<ClassId>(width, height, kUnclassified)};
  for (int row = 0; row < height; ++row) {
    const std::string& letters = rows[static_cast<std::size_t>(row)];
    if (static_cast<int>(letters.size()) != width) throw std::logic_error("drawn_map: ragged rows");
    for (int column = 0; column < width; ++column) {
      map.labels.at(column, row) = class_of_letter(letters[static_cast<std::size_t>(column)]);
    }
  }
  return map;
}

}  // namespace nadir
