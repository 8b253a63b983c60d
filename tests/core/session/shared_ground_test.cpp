// SPDX-License-Identifier: Apache-2.0
#include "core/session/shared_ground.h"

#include <gtest/gtest.h>

namespace nadir {
namespace shared_ground_test {

RunHeader run_on(double latitude_deg,
                 double longitude_deg,
                 const std::string& map,
                 const std::string& hash) {
  RunHeader header;
  header.plane_latitude_deg = latitude_deg;
  header.plane_longitude_deg = longitude_deg;
  header.map = map;
  header.map_hash = hash;
  return header;
}

TEST(SharedGround, IsThatOfOneMap) {
  const RunHeader town = run_on(33.45, -83.9, "town", "a1");
  EXPECT_TRUE(share_ground(town, town));
  EXPECT_TRUE(share_ground(town, run_on(33.45 + 1e-9, -83.9, "town", "a1"))) << "rounded in a file";
}

TEST(SharedGround, IsThatOfAMapThatWasLabelledAgain) {
  const RunHeader town = run_on(33.45, -83.9, "town", "a1");
  EXPECT_TRUE(share_ground(town, run_on(33.45, -83.9, "town", "b2")));
  EXPECT_TRUE(share_ground(town, run_on(33.45, -83.9, "town-new", "c3")));
}

TEST(SharedGround, IsNotThatOfAnotherPlane) {
  const RunHeader town = run_on(33.45, -83.9, "town", "a1");
  EXPECT_FALSE(share_ground(town, run_on(49.0, 8.4, "town", "a1"))) << "whatever its name";
  EXPECT_FALSE(share_ground(town, run_on(33.45, -83.8999, "town", "a1"))) << "ten metres";
}

TEST(SharedGround, IsNotThatOfTwoMapsWithoutAPlace) {
  const RunHeader one = run_on(0.0, 0.0, "one", "a1");
  EXPECT_FALSE(share_ground(one, run_on(0.0, 0.0, "two", "b2")));
  EXPECT_TRUE(share_ground(one, run_on(0.0, 0.0, "one", "b2")));
  EXPECT_TRUE(share_ground(one, run_on(0.0, 0.0, "copy", "a1")));
}

TEST(SharedGround, ARunIsOnThePlaneOfItsOriginAroundTheWorld) {
  const ProjectPlane plane = ProjectPlane::create({-17.0, 180.0}).value();
  EXPECT_TRUE(is_on_plane(run_on(-17.0, 180.0, "isle", ""), plane));
  EXPECT_TRUE(is_on_plane(run_on(-17.0, -180.0, "isle", ""), plane));
  EXPECT_FALSE(is_on_plane(run_on(-17.0, 179.9, "isle", ""), plane));
}

}  // namespace shared_ground_test
}  // namespace nadir
