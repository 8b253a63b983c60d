// SPDX-License-Identifier: Apache-2.0
#include "core/session/map_sight.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace nadir {
namespace map_sight_test {

TEST(MapPage, ShowsWhatIsInsideOfTheRectangleWithNorthUp) {
  MapPage page{{10.0, 20.0}, 80.0, std::numbers::pi / 2.0, 2.0};
  EXPECT_TRUE(page.shows({10.0, 20.0}));
  EXPECT_TRUE(page.shows({49.9, 39.9})) << "40 m to the east, 20 m to the north";
  EXPECT_FALSE(page.shows({50.1, 20.0}));
  EXPECT_FALSE(page.shows({-30.1, 20.0}));
  EXPECT_FALSE(page.shows({10.0, 40.1}));
  EXPECT_FALSE(page.shows({NAN, 20.0}));
  page.aspect = 1.0;
  EXPECT_TRUE(page.shows({10.0, 40.1})) << "a page that is higher";
}

TEST(MapPage, TurnsWithTheMap) {
  for (int degrees = -180; degrees < 360; degrees += 15) {
    const double up_rad = degrees * std::numbers::pi / 180.0;
    const MapPage page{{3.0, -4.0}, 60.0, up_rad, 1.5};
    const Eigen::Vector2d up(std::cos(up_rad), std::sin(up_rad)), right(up.y(), -up.x());
    // A corner of the page, a little inside and a little outside of each of its sides.
    for (const double side : {-1.0, 1.0}) {
      const Eigen::Vector2d corner = page.centre_in_enu_m + side * (29.9 * right + 19.9 * up);
      EXPECT_TRUE(page.shows(corner)) << degrees;
      EXPECT_FALSE(page.shows(corner + 0.2 * side * right)) << degrees;
      EXPECT_FALSE(page.shows(corner + 0.2 * side * up)) << degrees;
    }
  }
}

}  // namespace map_sight_test
}  // namespace nadir
