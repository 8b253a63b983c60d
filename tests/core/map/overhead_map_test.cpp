// SPDX-License-Identifier: Apache-2.0
#include "core/map/overhead_map.h"

#include <gmock/gmock.h>

#include <limits>

#include "tests/support/drawn_map.h"
#include "tests/support/error_text.h"

namespace nadir {
namespace overhead_map_test {

using testing::HasSubstr;

TEST(OverheadMap, ShowsNorthUpAndEastRight) {
  const OverheadMap map = drawn_map(2.0, {"RST",  //
                                          "BVC"});
  EXPECT_EQ(map.class_at({1.0, 3.0}), kRoad);
  EXPECT_EQ(map.class_at({5.0, 3.0}), kTerrain);
  EXPECT_EQ(map.class_at({1.0, 1.0}), kBuilding);
  EXPECT_EQ(map.class_at({5.0, 1.0}), kCurb);
  EXPECT_EQ(map.width_m(), 6.0);
  EXPECT_EQ(map.height_m(), 4.0);
}

TEST(OverheadMap, TakesPointsThereAndBack) {
  const OverheadMap map = drawn_map(0.25, {"RS", "TB"});
  const Eigen::Vector2d point(0.3, 0.2);
  EXPECT_TRUE(map.enu_from_overhead(map.overhead_from_enu(point)).isApprox(point, 1e-12));
  EXPECT_EQ(map.enu_from_overhead({0.0, 0.0}), map.top_left_in_enu_m);
}

TEST(OverheadMap, IsUnclassifiedOutside) {
  const OverheadMap map = drawn_map(1.0, {"RR", "RR"});
  for (const Eigen::Vector2d& point :
       {Eigen::Vector2d(-0.001, 1.0), Eigen::Vector2d(2.0, 1.0), Eigen::Vector2d(1.0, 2.001),
        Eigen::Vector2d(1.0, 0.0), Eigen::Vector2d(1e300, 1.0),
        Eigen::Vector2d(std::numeric_limits<double>::quiet_NaN(), 1.0)}) {
    EXPECT_FALSE(map.contains(point)) << point.transpose();
    EXPECT_EQ(map.class_at(point), kUnclassified) << point.transpose();
  }
  EXPECT_TRUE(map.contains({0.0, 2.0}));  // the north-west corner belongs to the map
}

TEST(UsableForLocalising, AcceptsTwoClasses) {
  EXPECT_TRUE(check_usable_for_localising(drawn_map(1.0, {"RT."})));
}

TEST(UsableForLocalising, RefusesAMapWithoutClasses) {
  const auto checked = check_usable_for_localising(drawn_map(1.0, {"..", ".."}));
  EXPECT_EQ(error_text(checked), "drawn: no cell has a class");
  EXPECT_FALSE(check_usable_for_localising(drawn_map(1.0, {})));
}

TEST(UsableForLocalising, RefusesAMapOfASingleClass) {
  const auto checked = check_usable_for_localising(drawn_map(1.0, {"R.", ".R"}));
  EXPECT_THAT(error_text(checked), HasSubstr("drawn: only one class (road)"));
}

TEST(UsableForLocalising, RefusesAResolutionThatIsNone) {
  for (const double metres_per_cell : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(),
                                       std::numeric_limits<double>::infinity()}) {
    OverheadMap map = drawn_map(1.0, {"RT"});
    map.metres_per_cell = metres_per_cell;
    EXPECT_THAT(error_text(check_usable_for_localising(map)), HasSubstr("resolution"));
  }
}

}  // namespace overhead_map_test
}  // namespace nadir
