// SPDX-License-Identifier: Apache-2.0
#include "core/map/building_contours.h"

#include <gmock/gmock.h>

#include "tests/support/drawn_map.h"

namespace nadir {
namespace building_contours_test {

Raster<ClassId> contours(double thickness_m, const std::vector<std::string>& rows) {
  return with_building_contours(drawn_map(0.5, rows).labels, 0.5, thickness_m);
}

Raster<ClassId> drawn(const std::vector<std::string>& rows) { return drawn_map(0.5, rows).labels; }

const std::vector<std::string> kHouse{"TTTTTTTTT",  //
                                      "TBBBBBBBT",  //
                                      "TBBBBBBBT",  //
                                      "TBBBBBBBT",  //
                                      "TBBBBBBBT",  //
                                      "TBBBBBBBT",  //
                                      "TTTTTTTTT"};

TEST(BuildingContours, LeaveWallsOfTheGivenThickness) {
  EXPECT_EQ(contours(0.5, kHouse), drawn({"TTTTTTTTT",  //
                                          "TBBBBBBBT",  //
                                          "TB.....BT",  //
                                          "TB.....BT",  //
                                          "TB.....BT",  //
                                          "TBBBBBBBT",  //
                                          "TTTTTTTTT"}));
  EXPECT_EQ(contours(1.0, kHouse), drawn({"TTTTTTTTT",  //
                                          "TBBBBBBBT",  //
                                          "TBBBBBBBT",  //
                                          "TBB...BBT",  //
                                          "TBBBBBBBT",  //
                                          "TBBBBBBBT",  //
                                          "TTTTTTTTT"}));
}

TEST(BuildingContours, KeepOneLayerOfCellsHoweverThin) {
  EXPECT_EQ(contours(0.0, kHouse), contours(0.5, kHouse));
  EXPECT_EQ(contours(0.0, {"TBT"}), drawn({"TBT"}));
}

TEST(BuildingContours, LeaveThickWallsWhole) { EXPECT_EQ(contours(50.0, kHouse), drawn(kHouse)); }

TEST(BuildingContours, HaveNoWallWhereTheMapEnds) {
  EXPECT_EQ(contours(0.5, {"BBBT",  //
                           "BBBT",  //
                           "BBBT",  //
                           "TTTT"}),
            drawn({"..BT",  //
                   "..BT",  //
                   "BBBT",  //
                   "TTTT"}));
  EXPECT_EQ(contours(0.5, {"BB", "BB"}), drawn({"..", ".."}));
}

TEST(BuildingContours, RunAlongUnclassifiedGroundAndCourtyardsToo) {
  EXPECT_EQ(contours(0.5, {".........",  //
                           ".BBBBBBB.",  //
                           ".BBBBBBB.",  //
                           ".BBBBBBB.",  //
                           ".BBBRBBB.",  //
                           ".BBBBBBB.",  //
                           ".BBBBBBB.",  //
                           ".BBBBBBB.",  //
                           "........."}),
            drawn({".........",  //
                   ".BBBBBBB.",  //
                   ".B.....B.",  //
                   ".B.BBB.B.",  //
                   ".B.BRB.B.",  //
                   ".B.BBB.B.",  //
                   ".B.....B.",  //
                   ".BBBBBBB.",  //
                   "........."}));
}

TEST(BuildingContours, ChangeNoOtherClass) {
  const std::vector<std::string> streets{"RRRR", "SSCC", "VVVL"};
  EXPECT_EQ(contours(0.5, streets), drawn(streets));
}

}  // namespace building_contours_test
}  // namespace nadir
