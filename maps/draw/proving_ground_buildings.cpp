// SPDX-License-Identifier: Apache-2.0
#include "maps/draw/town_layout.h"

namespace nadir::town {
namespace {

using enum RoofCover;

Building house(double east_m,
               double north_m,
               double length_m,
               double width_m,
               double heading_deg,
               Roof roof,
               RoofCover cover,
               double eave_m = 3.0,
               double pitch = 0.5) {
  return {rectangle({east_m, north_m}, length_m, width_m, heading_deg), roof, cover, eave_m,
          length_m >= width_m ? heading_deg : heading_deg + 90.0,       pitch};
}

Building shaped(
    std::vector<Point> corners, Roof roof, RoofCover cover, double eave_m, double pitch = 0.45) {
  return {{std::move(corners)}, roof, cover, eave_m, 0.0, pitch};
}

std::vector<Building> northern_buildings() {
  using enum Roof;
  return {
      shaped({{-82, 6}, {-62, 6}, {-62, 14}, {-72, 14}, {-72, 24}, {-82, 24}}, kHip, kBrownShingle,
             3.2),
      house(-54, 21, 9, 13, 0, kGable, kDarkShingle),
      house(-78, 35, 12, 9, 8, kGable, kRedTile),
      house(-54, 38, 10, 8, 0, kHip, kDarkShingle),
      shaped(
          {{-83, 44}, {-63, 44}, {-63, 56}, {-68, 56}, {-68, 50}, {-78, 50}, {-78, 56}, {-83, 56}},
          kFlat, kGravelFlat, 6.5),
      house(-50, 50, 6, 6, 0, kFlat, kTarFlat, 2.8),
      shaped({{-17, 8}, {8, 8}, {8, 20}, {0, 20}, {0, 29}, {-9, 29}, {-9, 20}, {-17, 20}}, kFlat,
             kWhiteFlat, 9.0),
      house(-27.5, 22, 8, 22, 0, kGable, kBrownShingle, 5.5, 0.6),
      house(-26, 48, 10, 13, 0, kHip, kRedTile),
      house(-9, 45, 12, 9, -14, kGable, kDarkShingle),
      {disc({6, 37}, 4.6, 8), Roof::kHip, kGreenMetal, 10.0, 0.0, 0.7},
      house(7, 53, 12, 8, 0, kGable, kBrownShingle),
      house(35, 12, 11, 14, 0, kFlat, kTarFlat, 7.0),
      shaped({{46, 5}, {63, 5}, {63, 13}, {55, 13}, {55, 23}, {46, 23}}, kHip, kGreenMetal, 3.4),
      shaped({{71, 6},
              {78, 6},
              {78, 14},
              {81, 14},
              {81, 20},
              {78, 20},
              {78, 30},
              {71, 30},
              {71, 20},
              {68, 20},
              {68, 14},
              {71, 14}},
             kHip, kDarkShingle, 6.0, 0.9),
      house(41, 51, 14, 9, 0, kGable, kDarkShingle),
      house(59, 50, 9, 11, 10, kHip, kBrownShingle),
      house(80, 46, 11, 8, -38, kHip, kRedTile),
      house(42, 32, 9, 10, 0, kHip, kBrownShingle),
      house(116, 14, 9, 13, 0, kHip, kDarkShingle),
      house(-112, 31, 13, 18, 0, kGable, kWhiteMetal, 5.5, 0.22),
      house(-110, 6, 10, 9, -5, kHip, kBrownShingle),
      house(-66, 83, 17, 10, 0, kGable, kRustMetal, 4.5, 0.3),
      shaped({{-26, 78}, {-12, 78}, {-12, 85}, {-18, 85}, {-18, 93}, {-26, 93}}, kHip, kDarkShingle,
             3.2),
      house(26, 84, 20, 11, 0, kFlat, kGravelFlat, 5.0),
  };
}

std::vector<Building> southern_buildings() {
  using enum Roof;
  return {
      house(-71, -26, 24, 16, 0, kGable, kWhiteMetal, 7.0, 0.2),
      house(-50, -37, 10, 14, 0, kFlat, kTarFlat, 6.0),
      house(-79, -58, 9, 7, 0, kGable, kRustMetal, 3.5, 0.3),
      house(-50, -57, 10, 9, 0, kHip, kDarkShingle),
      house(-9.5, -19.5, 25, 10, 0, kFlat, kWhiteFlat, 5.0),
      shaped({{10, -15}, {28, -15}, {28, -23}, {19, -23}, {19, -33}, {10, -33}}, kHip,
             kBrownShingle, 6.0),
      house(22, -43, 11, 9, 0, kHip, kRedTile),
      house(-25, -59, 12, 9, 0, kGable, kDarkShingle),
      house(6, -58, 12, 8, 6, kGable, kBrownShingle),
      house(24, -58, 9, 10, 0, kFlat, kGravelFlat, 6.2),
      shaped(
          {{45, -17}, {71, -17}, {71, -41}, {63, -41}, {63, -26}, {53, -26}, {53, -41}, {45, -41}},
          kHip, kDarkShingle, 9.0, 0.4),
      house(50, -57, 13, 9, 0, kGable, kRedTile),
      house(67, -57, 9, 10, 0, kHip, kBrownShingle),
      house(105, -26, 20, 13, 0, kFlat, kGravelFlat, 6.5),
      house(112, -51, 14, 10, -7, kGable, kGreenMetal, 3.2, 0.4),
      house(-111, -42, 14, 10, 12, kGable, kDarkShingle),
      house(-62, -88, 17, 9, 0, kGable, kGreenMetal, 4.0, 0.25),
      house(-12, -87, 11, 9, 0, kHip, kRedTile),
      house(104, -88, 12, 10, 0, kHip, kDarkShingle),
  };
}

}  // namespace

void add_buildings(TownLayout& town) {
  town.buildings = northern_buildings();
  for (Building& building : southern_buildings()) town.buildings.push_back(std::move(building));
}

}  // namespace nadir::town
