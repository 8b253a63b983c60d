// SPDX-License-Identifier: Apache-2.0
#include "maps/draw/markings.h"

#include <gmock/gmock.h>

namespace nadir::town {
namespace markings_test {

using ::testing::SizeIs;

/// One street of 100 m to the east, 8 m wide.
TownLayout one_street(Street street = {}) {
  TownLayout town;
  street.centre = {{{-50.0, 0.0}, {50.0, 0.0}}};
  street.half_width_m = 4.0;
  town.streets = {street};
  return town;
}

bool is_painted(const std::vector<Painted>& shapes, const Point& p) {
  return std::any_of(shapes.begin(), shapes.end(),
                     [&](const Painted& shape) { return contains(shape.outline, p); });
}

TEST(PaintedShapes, DashesRepeatWithTheirGap) {
  const auto shapes =
      painted_shapes(one_street({.dash_m = 3.0, .gap_m = 7.0, .first_dash_m = 1.0}));
  EXPECT_THAT(shapes, SizeIs(9));
  for (int i = 0; i < 9; ++i) {
    EXPECT_TRUE(is_painted(shapes, {-50.0 + 10.0 * i + 2.5, 0.05}));
    EXPECT_FALSE(is_painted(shapes, {-50.0 + 10.0 * i + 5.0, 0.05}));
  }
}

TEST(PaintedShapes, CentreLinesAreYellowAndTwoTenthsWide) {
  const auto shapes = painted_shapes(one_street({.centre_line = CentreLine::kSolid}));
  ASSERT_FALSE(shapes.empty());
  EXPECT_TRUE(shapes.front().yellow);
  EXPECT_TRUE(is_painted(shapes, {0.3, 0.09}));
  EXPECT_FALSE(is_painted(shapes, {0.3, 0.11}));
}

TEST(PaintedShapes, DoubleLineLeavesTheMiddleBare) {
  const auto shapes = painted_shapes(one_street({.centre_line = CentreLine::kDouble}));
  EXPECT_TRUE(is_painted(shapes, {0.3, 0.2}));
  EXPECT_TRUE(is_painted(shapes, {0.3, -0.2}));
  EXPECT_FALSE(is_painted(shapes, {0.3, 0.0}));
}

TEST(PaintedShapes, EdgeLinesRunInsideBothEdges) {
  const auto shapes =
      painted_shapes(one_street({.centre_line = CentreLine::kNone, .edge_lines = true}));
  EXPECT_TRUE(is_painted(shapes, {0.3, 3.6}));
  EXPECT_TRUE(is_painted(shapes, {0.3, -3.6}));
  EXPECT_FALSE(is_painted(shapes, {0.3, 0.0}));
}

TEST(PaintedShapes, LinesStopAtJunctionsAndCrossings) {
  TownLayout town = one_street({.centre_line = CentreLine::kSolid});
  town.junctions = {{0, 0, {0.0, 0.0}, 5.0, 10.0}};
  town.crossings = {{{30.0, 0.0}, 0.0, 8.0}};
  const auto shapes = painted_shapes(town);
  EXPECT_FALSE(is_painted(shapes, {9.0, 0.05}));
  EXPECT_TRUE(is_painted(shapes, {12.5, 0.05}));
  EXPECT_TRUE(is_painted(shapes, {-12.5, 0.05}));
  EXPECT_FALSE(is_painted(shapes, {31.9, 0.05}));
}

TEST(PaintedShapes, CrossingHasStripesAlongTheRoadAcrossItsWholeWidth) {
  TownLayout town = one_street({.centre_line = CentreLine::kNone});
  town.crossings = {{{0.0, 0.0}, 0.0, 8.0}};
  const auto shapes = painted_shapes(town);
  EXPECT_THAT(shapes, SizeIs(7));
  for (int i = -3; i <= 3; ++i) {
    EXPECT_TRUE(is_painted(shapes, {1.4, i + 0.2}));
    EXPECT_FALSE(is_painted(shapes, {1.4, i + 0.5}));
    EXPECT_FALSE(is_painted(shapes, {1.6, i + 0.2}));
  }
}

TEST(PaintedShapes, NBaysHaveOneLineMoreThanBays) {
  TownLayout town;
  town.bay_rows = {{{2.0, 1.0}, 90.0, 4, 2.5, 5.0, 0.0, 0.0}};
  const auto shapes = painted_shapes(town);
  EXPECT_THAT(shapes, SizeIs(5));
  EXPECT_TRUE(is_painted(shapes, {-2.5, 6.0}));  // left of a row to the north is west
  EXPECT_FALSE(is_painted(shapes, {-2.5, 7.0}));
  EXPECT_FALSE(is_painted(shapes, {2.5, 6.0}));
}

TEST(PaintedShapes, ArrowsPointWhereTheirLaneGoes) {
  TownLayout town;
  town.arrows = {{{0.0, 0.0}, 0.0, Arrow::kLeft}, {{50.0, 0.0}, 0.0, Arrow::kRight}};
  const auto shapes = painted_shapes(town);
  EXPECT_TRUE(is_painted(shapes, {3.0, 1.2}));
  EXPECT_FALSE(is_painted(shapes, {3.0, -1.2}));
  EXPECT_TRUE(is_painted(shapes, {53.0, -1.2}));
  EXPECT_FALSE(is_painted(shapes, {53.0, 1.2}));
}

}  // namespace markings_test
}  // namespace nadir::town
