// SPDX-License-Identifier: Apache-2.0
#include "maps/draw/shapes.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "maps/draw/ground.h"

namespace nadir::town {
namespace shapes_test {

using ::testing::DoubleNear;

constexpr Grid kGrid{200, 200, 0.1};

int cells_in(const Polygon& polygon) {
  int count = 0;
  for_cells(kGrid, bounds(polygon.corners), [&](int, int, const Point& p) {
    if (contains(polygon, p)) ++count;
  });
  return count;
}

TEST(Polygon, ContainsPointsOfAnAngledShapeButNotOfItsNotch) {
  const Polygon ell{{{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 3}, {0, 3}}};
  EXPECT_TRUE(contains(ell, {0.5, 2.5}));
  EXPECT_TRUE(contains(ell, {3.5, 0.5}));
  EXPECT_FALSE(contains(ell, {2.0, 2.0}));
  EXPECT_FALSE(contains(ell, {-0.1, 1.0}));
}

TEST(Polygon, SignedDistanceIsNegativeInsideAndMetricOutside) {
  const Polygon square = rectangle({10.0, 5.0}, 4.0, 2.0);
  EXPECT_THAT(signed_distance(square, {10.0, 5.0}), DoubleNear(-1.0, 1e-12));
  EXPECT_THAT(signed_distance(square, {10.0, 7.5}), DoubleNear(1.5, 1e-12));
  EXPECT_THAT(signed_distance(square, {15.0, 10.0}),
              DoubleNear(5.0, 1e-12));  // 3-4-5 from a corner
}

TEST(Polygon, ThinStripCoversExactlyItsArea) {
  // Common rasterisers make a strip of three cells a third too wide.
  EXPECT_EQ(cells_in(rectangle({0.05, 0.05}, 10.0, 0.3)), 100 * 3);
  EXPECT_EQ(cells_in(rectangle({0.0, 0.0}, 0.6, 0.4)), 6 * 4);
}

TEST(Polygon, NeighboursShareNoCellAndLeaveNoneOut) {
  const double slant = 0.37;
  const Polygon west{{{-5, -3}, {slant, -3}, {-slant, 3}, {-5, 3}}};
  const Polygon east{{{slant, -3}, {5, -3}, {5, 3}, {-slant, 3}}};
  EXPECT_EQ(cells_in(west) + cells_in(east), 100 * 60);
}

TEST(Polygon, TurnedRectangleKeepsItsArea) {
  EXPECT_NEAR(cells_in(rectangle({0.3, -0.7}, 8.0, 5.0, 31.0)), 4000, 20);
}

TEST(Polygon, QuarterTurnSwapsLengthAndWidth) {
  EXPECT_TRUE(contains(rectangle({0, 0}, 6.0, 2.0, 90.0), {0.9, 2.9}));
  EXPECT_FALSE(contains(rectangle({0, 0}, 6.0, 2.0, 90.0), {2.9, 0.9}));
}

TEST(Polyline, FootTellsDistanceAlongAndSide) {
  const Polyline bend{{{0, 0}, {10, 0}, {10, 10}}};
  const Foot left = nearest(bend, {4.0, 2.0});
  EXPECT_THAT(left.along_m, DoubleNear(4.0, 1e-12));
  EXPECT_THAT(left.lateral_m, DoubleNear(2.0, 1e-12));
  const Foot right = nearest(bend, {13.0, 5.0});
  EXPECT_THAT(right.along_m, DoubleNear(15.0, 1e-12));
  EXPECT_THAT(right.lateral_m, DoubleNear(-3.0, 1e-12));
  EXPECT_FALSE(right.at_end);
  EXPECT_TRUE(nearest(bend, {-2.0, 1.0}).at_end);
  EXPECT_TRUE(nearest(bend, {10.0, 12.0}).at_end);
}

TEST(Polyline, PointAtIsTheInverseOfNearest) {
  Polyline line{{{-20, 5}}};
  append_arc(line, {0, -5}, 10.0, 90.0, 10.0);
  for (double along_m = 0.5; along_m < length_m(line); along_m += 1.7) {
    const Foot foot = nearest(line, point_at(line, along_m, 0.8));
    EXPECT_NEAR(foot.along_m, along_m, 0.02);
    EXPECT_NEAR(foot.lateral_m, 0.8, 1e-3);
  }
}

TEST(Polyline, ArcHasTheLengthOfTheCircleToAMillimetre) {
  Polyline arc;
  append_arc(arc, {3, 4}, 40.0, 90.0, 0.0);
  EXPECT_NEAR(length_m(arc), 20.0 * std::numbers::pi, 1e-2);
  for (const Point& p : arc.points) EXPECT_NEAR((p - Point(3, 4)).norm(), 40.0, 1e-9);
  EXPECT_NEAR(heading_at_deg(arc, 0.1), -0.5, 1e-6);  // clockwise from the top: it leaves eastwards
}

TEST(Polyline, StripFollowsTheArcAtItsOffset) {
  Polyline arc;
  append_arc(arc, {0, 0}, 8.0, 0.0, 90.0);
  const Polygon band = strip(arc, 1.0, 10.0, 1.0, 0.4);  // left of counter-clockwise is inwards
  for (double angle_deg = 10.0; angle_deg < 70.0; angle_deg += 5.0) {
    const double angle_rad = angle_deg * std::numbers::pi / 180.0;
    const Point outwards{std::cos(angle_rad), std::sin(angle_rad)};
    EXPECT_TRUE(contains(band, 7.0 * outwards));
    EXPECT_FALSE(contains(band, 7.3 * outwards));
    EXPECT_FALSE(contains(band, 6.7 * outwards));
  }
}

TEST(RoundedUnion, RoundsTheInnerCornerWithTheRadius) {
  // Two roads whose edges are the axes, corner quadrant x, y > 0: the rounded edge is the circle
  // about (r, r).
  constexpr double kRadiusM = 5.0;
  const double on_edge_m = kRadiusM * (1.0 - std::numbers::sqrt2 / 2.0);
  EXPECT_NEAR(rounded_union(on_edge_m, on_edge_m, kRadiusM), 0.0, 1e-12);
  EXPECT_NEAR(rounded_union(kRadiusM, kRadiusM, kRadiusM), kRadiusM, 1e-12);
}

TEST(RoundedUnion, LeavesTheRoadsAloneAwayFromTheCorner) {
  EXPECT_EQ(rounded_union(-1.0, 7.0, 5.0), -1.0);
  EXPECT_EQ(rounded_union(0.7, 5.0, 5.0), 0.7);
  EXPECT_EQ(rounded_union(9.0, 6.0, 5.0), 6.0);
}

}  // namespace shapes_test
}  // namespace nadir::town
