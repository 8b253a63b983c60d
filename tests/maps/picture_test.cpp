// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <algorithm>

#include "core/base/parallel.h"
#include "maps/draw/painting.h"

namespace nadir::town {
namespace picture_test {

/// The middle of the proving ground, small enough to be drawn twice.
TownLayout middle_of_town() {
  TownLayout town = proving_ground_layout();
  town.width_m = 60.0;
  town.height_m = 50.0;
  return town;
}

double brightness(const Colour& colour) { return (colour.red + colour.green + colour.blue) / 3.0; }

/// A plain of one grey with a block of 4 m on it.
Canvas block_on_a_plain() {
  const Grid grid{300, 300, 0.1};
  Canvas canvas{grid, Raster<Paint>(300, 300, Paint::Constant(128.0F)), Raster<float>(300, 300)};
  for_cells(grid, {{-2.0, -2.0}, {2.0, 2.0}},
            [&](int column, int row, const Point&) { canvas.height_m.at(column, row) = 4.0F; });
  return canvas;
}

TEST(Picture, IsTheSameOnOneAndOnSeveralThreads) {
  const TownLayout town = middle_of_town();
  const Ground ground = draw_ground(town);
  const ThreadLimit one(1);
  const auto alone = draw_picture(town, ground);
  const ThreadLimit many(4);
  EXPECT_EQ(alone, draw_picture(town, ground));
}

TEST(Picture, ShadowsFallToTheNorthWest) {
  const auto picture = light(block_on_a_plain());
  const auto at = [&](double east_m, double north_m) {
    return brightness(
        picture.at(static_cast<int>(150 + 10 * east_m), static_cast<int>(150 - 10 * north_m)));
  };
  EXPECT_LT(at(-2.5, 3.0), 0.6 * at(10.0, 10.0));   // north-west of the block
  EXPECT_GT(at(3.5, -3.5), 0.85 * at(10.0, 10.0));  // south-east of it
}

TEST(Picture, ShadowIsAsLongAsTheSunIsHigh) {
  const auto picture = light(block_on_a_plain());
  int dark = 0;
  for (int row = 0; row < 130; ++row) {  // due north of the block's middle
    if (brightness(picture.at(140, row)) < 80.0) ++dark;
  }
  // 4 m / 1.19 rise a metre, times the share 0.751 of it that goes north: 2.5 m.
  EXPECT_NEAR(dark, 25, 4);
}

TEST(Noise, StaysInRangeAndIsContinuous) {
  const Noise noise(Grid{100, 100, 0.1}, 0.7, 1);
  float before = noise({-4.9, 0.3});
  for (double east_m = -4.9; east_m < 4.9; east_m += 0.01) {
    const float now = noise({east_m, 0.3});
    EXPECT_LE(std::abs(now), 1.0F);
    EXPECT_LT(std::abs(now - before), 0.08F);
    before = now;
  }
}

TEST(Chance, DependsOnItsArgumentsAlone) {
  EXPECT_EQ(chance(1, 2, 3), chance(1, 2, 3));
  EXPECT_NE(chance(1, 2, 3), chance(1, 3, 2));
  double sum = 0.0;
  for (std::uint32_t i = 0; i < 4000; ++i) sum += static_cast<double>(chance(7, i));
  EXPECT_NEAR(sum / 4000.0, 0.5, 0.02);
}

TEST(Picture, GrassIsGreenAndRoadIsGrey) {
  const TownLayout town = middle_of_town();
  const Ground ground = draw_ground(town);
  const Canvas canvas = paint_ground(town, ground);
  Paint grass = Paint::Zero(), road = Paint::Zero();
  float grass_cells = 0.0F, road_cells = 0.0F;
  for (std::size_t i = 0; i < canvas.colour.size(); ++i) {
    if (ground.bare.values()[i] == Surface::kGrass)
      grass += canvas.colour.values()[i], ++grass_cells;
    if (ground.surface.values()[i] == Surface::kAsphalt)
      road += canvas.colour.values()[i], ++road_cells;
  }
  grass /= grass_cells;
  road /= road_cells;
  EXPECT_GT(grass.y(), grass.x());
  EXPECT_GT(grass.y(), grass.z() + 20.0F);
  EXPECT_LT(road.maxCoeff() - road.minCoeff(), 8.0F);
}

/// A flat lawn of 30 m x 30 m with nothing on it.
struct Lawn {
  TownLayout town;
  Ground ground;
  Canvas canvas;
};

Lawn lawn(TownLayout town = {}) {
  town.width_m = town.height_m = 30.0;
  town.streets = {
      {.centre = {{{-500.0, -400.0}, {500.0, -400.0}}}}};  // far away: grass needs a nearest street
  Ground ground = draw_ground(town);
  Canvas canvas = paint_ground(town, ground);
  return {std::move(town), std::move(ground), std::move(canvas)};
}

float height_at(const Canvas& canvas, const Point& p) {
  return canvas.height_m.at(static_cast<int>(150 + 10 * p.x()), static_cast<int>(150 - 10 * p.y()));
}

int cells_above_ground(const Canvas& canvas) {
  const auto& heights = canvas.height_m.values();
  return static_cast<int>(
      std::count_if(heights.begin(), heights.end(), [](float h) { return h > 0.0F; }));
}

TEST(Roofs, HipRoofRisesFromAllWallsToItsRidge) {
  Lawn scene =
      lawn({.buildings = {{.footprint = rectangle({0, 0}, 12, 8), .eave_m = 3.0, .pitch = 0.5}}});
  paint_roofs(scene.canvas, scene.town);
  EXPECT_NEAR(height_at(scene.canvas, {0.05, -3.95}), 3.0, 0.1);
  EXPECT_NEAR(height_at(scene.canvas, {-5.95, 0.05}), 3.0, 0.1);
  EXPECT_NEAR(height_at(scene.canvas, {0.05, -2.05}), 4.0, 0.1);
  EXPECT_EQ(height_at(scene.canvas, {0.05, 4.15}), 0.0F);
}

TEST(Roofs, GableRoofIsHighAtItsEndsToo) {
  Lawn scene = lawn({.buildings = {{.footprint = rectangle({0, 0}, 12, 8),
                                    .roof = Roof::kGable,
                                    .eave_m = 3.0,
                                    .pitch = 0.5}}});
  paint_roofs(scene.canvas, scene.town);
  EXPECT_NEAR(height_at(scene.canvas, {-5.95, 0.05}), 5.0, 0.1);
  EXPECT_NEAR(height_at(scene.canvas, {-5.95, 3.95}), 3.0, 0.1);
}

TEST(Roofs, AngledHipRoofHasASharpValley) {
  const Polygon ell{{{-8, -8}, {8, -8}, {8, 0}, {0, 0}, {0, 8}, {-8, 8}}};
  Lawn scene = lawn({.buildings = {{.footprint = ell, .eave_m = 3.0, .pitch = 0.5}}});
  paint_roofs(scene.canvas, scene.town);
  // From the inner corner (0, 0) inwards along the diagonal the height grows with the coordinate,
  // not with the distance.
  EXPECT_NEAR(height_at(scene.canvas, {-2.05, -2.05}), 4.0, 0.1);
}

TEST(Roofs, CoverExactlyTheirFootprint) {
  Lawn scene = lawn({.buildings = {{.footprint = rectangle({1, 2}, 7, 5), .roof = Roof::kFlat}}});
  paint_roofs(scene.canvas, scene.town);
  EXPECT_EQ(cells_above_ground(scene.canvas), 70 * 50);
}

TEST(Trees, CrownsFillMostOfTheirDiscAndStayNearIt) {
  Lawn scene = lawn({.trees = {{{0.0, 0.0}, 4.0}}});
  paint_trees(scene.canvas, scene.town, scene.ground);
  int inside = 0, outside = 0;
  for_cells(scene.canvas.grid, {{-15, -15}, {15, 15}}, [&](int column, int row, const Point& p) {
    if (scene.canvas.height_m.at(column, row) <= 0.0F) return;
    (p.norm() <= 4.0 ? inside : outside) += 1;
    EXPECT_LT(p.norm(), 5.2);
  });
  EXPECT_GT(inside, 0.7 * 5027);
  EXPECT_LT(outside, 0.2 * 5027);
}

TEST(Trees, GrowInWoodsAndNowhereElse) {
  Lawn scene = lawn({.areas = {{rectangle({-7.5, 0.0}, 15.0, 30.0), Surface::kWoods}}});
  paint_trees(scene.canvas, scene.town, scene.ground);
  EXPECT_GT(cells_above_ground(scene.canvas), 0.8 * 150 * 300);
  for (double north_m = -14.0; north_m < 14.0; north_m += 0.5) {
    EXPECT_EQ(height_at(scene.canvas, {6.0, north_m}), 0.0F);
  }
}

TEST(Things, CarsStandInTheirBaysAndInNoLabel) {
  Lawn scene = lawn({.bay_rows = {{{-10.0, 0.0}, 0.0, 6, 2.6, 5.0, 0.0, 1.0}}});
  paint_things(scene.canvas, scene.town);
  for (int i = 0; i < 6; ++i) {
    EXPECT_GT(height_at(scene.canvas, {-10.0 + 2.6 * (i + 0.5), 2.5}), 0.9F) << "bay " << i;
    EXPECT_EQ(height_at(scene.canvas, {-10.0 + 2.6 * i, 2.5}), 0.0F) << "line " << i;
  }
  const auto labels = draw_labels(scene.ground);
  EXPECT_EQ(std::count(labels.values().begin(), labels.values().end(), kCar), 0);
}

TEST(Things, ACarIsAboutAsLargeAsACar) {
  Lawn scene = lawn({.cars = {{{0.0, 0.0}, 30.0}}});
  paint_things(scene.canvas, scene.town);
  EXPECT_NEAR(cells_above_ground(scene.canvas), 850, 100);  // 4.3 to 4.9 m x 1.84 m
}

TEST(Wear, OnlyRoadsCrack) {
  TownLayout town;
  town.width_m = town.height_m = 30.0;
  town.streets = {{.centre = {{{-40.0, 0.0}, {40.0, 0.0}}}, .surface = Surface::kOldAsphalt}};
  const Ground ground = draw_ground(town);
  Canvas worn = paint_ground(town, ground);
  const Canvas fresh = worn;
  paint_wear(worn, town, ground);
  int changed = 0;
  for (std::size_t i = 0; i < worn.colour.size(); ++i) {
    if (worn.colour.values()[i] == fresh.colour.values()[i]) continue;
    ++changed;
    ASSERT_EQ(class_of(ground.bare.values()[i]), kRoad);
  }
  EXPECT_GT(changed, 100);
}

}  // namespace picture_test
}  // namespace nadir::town
