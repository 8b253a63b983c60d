// SPDX-License-Identifier: Apache-2.0
#include "core/map/map_summary.h"

#include <gmock/gmock.h>

#include "tests/support/drawn_map.h"

namespace nadir {
namespace map_summary_test {

using testing::StartsWith;

TEST(MapSummary, TellsSizePlacesAndShares) {
  const OverheadMap map = drawn_map(2.0, {"RRT", "RRB"});
  const MapSummary summary = summarise_map(map, {"n", "s", "l", "d"});
  EXPECT_EQ(summary.provenance.name, "n");
  EXPECT_EQ(summary.width_cells, 3);
  EXPECT_EQ(summary.height_cells, 2);
  EXPECT_EQ(summary.width_m, 6.0);
  EXPECT_EQ(summary.height_m, 4.0);
  EXPECT_EQ(summary.statistics.cells[kRoad], 4);
}

TEST(MapSummary, WeighsClassesByTheReadingThatItNames) {
  const MapSummary summary = summarise_map(drawn_map(2.0, {"RRT", "RRB"}), {});
  // Four cells of road and one of terrain.
  EXPECT_EQ(enum_name(summary.alpha_reading), "inverse-root-share");
  EXPECT_DOUBLE_EQ(summary.alpha[kTerrain] / summary.alpha[kRoad], 2.0);
  EXPECT_EQ(summary.alpha, importance_weights(summary.statistics, summary.alpha_reading));
}

TEST(MapSummary, NamesTheCentreAndTheCornersClockwise) {
  const MapSummary summary = summarise_map(drawn_map(2.0, {"RRT", "RRB"}), {});
  ASSERT_EQ(summary.places.size(), 5U);
  EXPECT_EQ(summary.places[0].point_in_enu_m, Eigen::Vector2d(3.0, 2.0));
  EXPECT_EQ(summary.places[1].point_in_enu_m, Eigen::Vector2d(0.0, 4.0));
  EXPECT_EQ(summary.places[2].point_in_enu_m, Eigen::Vector2d(6.0, 4.0));
  EXPECT_EQ(summary.places[3].point_in_enu_m, Eigen::Vector2d(6.0, 0.0));
  EXPECT_EQ(summary.places[4].point_in_enu_m, Eigen::Vector2d(0.0, 0.0));
  EXPECT_EQ(summary.places[4].name, "south-west corner");
  // The drawing's lower left corner is the plane's origin.
  EXPECT_NEAR(summary.places[4].geodetic.latitude_deg, 33.45, 1e-12);
  EXPECT_NEAR(summary.places[4].geodetic.longitude_deg, -83.9, 1e-12);
  EXPECT_GT(summary.places[1].geodetic.latitude_deg, 33.45);
  EXPECT_GT(summary.places[3].geodetic.longitude_deg, -83.9);
}

TEST(MapPlace, SaysWhatLiesThereInEveryNotation) {
  const OverheadMap map = drawn_map(2.0, {"RRT", "RRB"});
  const MapPlace place = describe_place(map, {5.0, 1.0});
  EXPECT_TRUE(place.is_on_map);
  EXPECT_EQ(place.class_id, kBuilding);
  EXPECT_THAT(place.utm, StartsWith("17S "));
  EXPECT_THAT(place.mgrs, StartsWith("17S "));
  const MapPlace outside = describe_place(map, {-5.0, 1.0});
  EXPECT_FALSE(outside.is_on_map);
  EXPECT_EQ(outside.class_id, kUnclassified);
}

}  // namespace map_summary_test
}  // namespace nadir
