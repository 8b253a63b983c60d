// SPDX-License-Identifier: Apache-2.0
#include "maps/draw/ground.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "core/base/parallel.h"

namespace nadir::town {
namespace ground_test {

using ::testing::ElementsAre;

/// 40 m x 30 m with a street of 8 m to the east, and one of 6 m that comes from the south and ends
/// there.
TownLayout small_town() {
  TownLayout town;
  town.width_m = 40.0;
  town.height_m = 30.0;
  town.streets = {{.centre = {{{-30.0, 5.0}, {30.0, 5.0}}},
                   .half_width_m = 4.0,
                   .sidewalk_left_m = 2.0,
                   .centre_line = CentreLine::kNone},
                  {.centre = {{{0.0, -30.0}, {0.0, 1.5}}},
                   .half_width_m = 3.0,
                   .centre_line = CentreLine::kNone}};
  town.junctions = {{0, 1, {0.0, 5.0}, 4.0, 8.0}};
  return town;
}

ClassId class_at(const Ground& ground, const Point& p) {
  const Grid& grid = ground.grid;
  return class_of(
      ground.surface.at(static_cast<int>(p.x() / grid.metres_per_cell + grid.columns / 2.0),
                        static_cast<int>(grid.rows / 2.0 - p.y() / grid.metres_per_cell)));
}

TEST(Grid, CentresAreHalfACellFromTheCornerAndNorthIsUp) {
  const Grid grid{40, 20, 0.1};
  EXPECT_NEAR((grid.centre(0, 0) - Point(-1.95, 0.95)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((grid.centre(39, 19) - Point(1.95, -0.95)).norm(), 0.0, 1e-12);
}

TEST(Grid, VisitsExactlyTheCellsOfABox) {
  const Grid grid{40, 20, 0.1};
  int count = 0;
  for_cells(grid, {{-0.3, -0.2}, {0.3, 0.2}}, [&](int, int, const Point&) { ++count; });
  EXPECT_EQ(count, 6 * 4);
  count = 0;
  for_cells(grid, {{-9.0, -9.0}, {9.0, 9.0}}, [&](int, int, const Point&) { ++count; });
  EXPECT_EQ(count, 40 * 20);
}

TEST(Ground, TransectOfAStreetHasCurbRoadCurbSidewalkAtTheirWidths) {
  const Ground ground = draw_ground(small_town());
  std::vector<std::pair<ClassId, int>> runs;
  for (int row = 0; row < ground.grid.rows; ++row) {
    const ClassId id = class_of(ground.surface.at(30, row));  // 17 m west of the middle
    if (runs.empty() || runs.back().first != id) runs.emplace_back(id, 0);
    ++runs.back().second;
  }
  EXPECT_THAT(runs,
              ElementsAre(std::pair{kTerrain, 38}, std::pair{kSidewalk, 20}, std::pair{kCurb, 2},
                          std::pair{kRoad, 80}, std::pair{kCurb, 2}, std::pair{kTerrain, 158}));
}

TEST(Ground, CornersAreRoundAndTheFarSideOfATeeIsStraight) {
  const TownLayout town = small_town();
  // The corner's circle is about (7, -3): edges at x = 3 and y = 1, radius 4.
  EXPECT_NEAR(street_place(town, Point(7.0, -3.0) + 4.0 * Point(-0.6, 0.8)).distance_m, 0.0, 1e-9);
  for (double east_m = -10.0; east_m <= 10.0; east_m += 0.5) {
    EXPECT_NEAR(street_place(town, {east_m, 9.0}).distance_m, 0.0, 1e-9);
  }
}

TEST(Ground, DrivewayOpensTheCurbButNeverPavesTheRoadAnew) {
  TownLayout town = small_town();
  town.streets[0].surface = Surface::kOldAsphalt;
  town.driveways = {{rectangle({10.0, 9.0}, 3.0, 6.0), Surface::kConcrete}};
  const Ground ground = draw_ground(town);
  EXPECT_EQ(class_at(ground, {10.0, 9.1}), kRoad);
  EXPECT_EQ(class_at(ground, {10.0, 10.1}), kRoad);
  EXPECT_EQ(class_at(ground, {12.0, 9.1}), kCurb);
  EXPECT_EQ(ground.bare.at(300, 68),
            Surface::kOldAsphalt);  // (10, 8.1): inside the shape, on the road
}

TEST(Ground, BuildingsAreContoursOfThreeCellsAroundUnclassifiedGround) {
  TownLayout town = small_town();
  town.buildings = {{rectangle({10.0, -9.0}, 6.0, 5.0)}};
  const auto labels = draw_labels(draw_ground(town));
  const auto count = [&](ClassId id) {
    return std::count(labels.values().begin(), labels.values().end(), id);
  };
  EXPECT_EQ(count(kUnclassified), 54 * 44);
  EXPECT_EQ(count(kBuilding), 60 * 50 - 54 * 44);
}

TEST(Ground, PaintKeepsToTheRoad) {
  TownLayout town = small_town();
  town.painted = {{rectangle({10.0, 5.0}, 0.4, 12.0)}};
  const auto labels = draw_labels(draw_ground(town));
  EXPECT_EQ(std::count(labels.values().begin(), labels.values().end(), kLaneMarking), 4 * 80);
}

TEST(Ground, RoundaboutHasRoadAroundACurbedIsland) {
  TownLayout town;
  town.width_m = town.height_m = 40.0;
  town.streets = {{.centre = {{{-30.0, 0.0}, {30.0, 0.0}}}, .centre_line = CentreLine::kNone}};
  town.circles = {{{0.0, 0.0}, 14.0, 6.0, 3.0, 2.0, {0}}};
  const Ground ground = draw_ground(town);
  EXPECT_EQ(class_at(ground, {0.05, 10.0}), kRoad);
  EXPECT_EQ(class_at(ground, {10.0, 0.05}), kRoad);
  EXPECT_EQ(class_at(ground, {0.05, 5.9}), kCurb);
  EXPECT_EQ(class_at(ground, {0.05, 4.0}), kTerrain);
  EXPECT_EQ(class_at(ground, {0.05, 0.0}), kVegetation);
  EXPECT_EQ(class_at(ground, {0.05, 14.1}), kCurb);
  EXPECT_EQ(class_at(ground, {0.05, 15.0}), kSidewalk);
}

TEST(Ground, FencesAreTwoCellsAndHedgesAreVegetation) {
  TownLayout town = small_town();
  town.fences = {{{{{-15.0, -10.0}, {-5.0, -10.0}}}, 0.2, 1.5}};
  town.hedges = {{{{{-15.0, -5.0}, {-5.0, -5.0}}}, 1.0, 1.2}};
  const Ground ground = draw_ground(town);
  EXPECT_EQ(class_at(ground, {-10.0, -9.95}), kFence);
  EXPECT_EQ(class_at(ground, {-10.0, -10.05}), kFence);
  EXPECT_EQ(class_at(ground, {-10.0, -10.15}), kTerrain);
  EXPECT_EQ(class_at(ground, {-10.0, -5.45}), kVegetation);
  EXPECT_EQ(class_at(ground, {-10.0, -5.55}), kTerrain);
}

TEST(Ground, IsTheSameOnOneAndOnSeveralThreads) {
  const ThreadLimit one(1);
  const Ground alone = draw_ground(small_town());
  const ThreadLimit many(4);
  EXPECT_EQ(alone.surface, draw_ground(small_town()).surface);
}

}  // namespace ground_test
}  // namespace nadir::town
