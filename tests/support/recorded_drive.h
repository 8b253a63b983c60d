// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "core/map/map_import.h"

namespace nadir {

/// Folder of the recordings that are not ours to ship; empty where there is none.
[[nodiscard]] inline std::filesystem::path test_data_folder() {
  const char* folder =
      std::getenv("NADIR_TEST_DATA");  // NOLINT(concurrency-mt-unsafe): tests set no variables
  return folder == nullptr ? std::filesystem::path() : std::filesystem::path(folder);
}

/// The hand-drawn town of KITTI 00; its README gives georeference and classes.
inline OverheadMap drawn_town(const std::filesystem::path& data) {
  ImportOptions options;
  options.name = "kitti00";
  options.building_contours_m = 0.7;
  options.anchor = Geodetic{48.987721, 8.387722};
  options.metres_per_pixel = 1.0 / 3.058;
  options.flip_vertically = true;
  options.inside_value = 0;
  options.remap =
      ClassRemap::parse(
          "[ids]\n0 = \"terrain\"\n1 = \"road\"\n3 = \"building\"\n4 = \"vegetation\"\n", "kitti00")
          .value();
  return import_map(data / "maps" / "kitti00_drawn", options).value().map;
}

/// Where the drive begins: the README's similarity puts the first camera at pixel (592.6, 746.5) of
/// the stored raster, whose rows run north, looking along (-sin a, cos a) with a = 5.7515.
inline Rigid2 start_of_drive(const OverheadMap& town) {
  constexpr double kTurnRad = 5.7515;
  const Eigen::Vector2d start = town.enu_from_overhead({592.6, town.labels.height() - 746.5});
  return {start.x(), start.y(), std::atan2(std::cos(kTurnRad), -std::sin(kTurnRad))};
}

}  // namespace nadir
