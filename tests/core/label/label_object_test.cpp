// SPDX-License-Identifier: Apache-2.0
#include "core/label/label_object.h"

#include <gmock/gmock.h>

#include <limits>

#include "tests/core/label/drawn_labels.h"
#include "tests/support/error_text.h"

namespace nadir {
namespace label_object_test {

using testing::HasSubstr;

TEST(LabelObject, IsSoundAsPeopleDrawIt) {
  EXPECT_TRUE(check_object(area(kRoad, {box(0, 0, 5, 5), box(1, 1, 2, 2)})));
  EXPECT_TRUE(check_object(area(kUnclassified, {box(0, 0, 5, 5)})));
  EXPECT_TRUE(check_object(line(kCurb, ring({{0, 0}, {1, 0}}), 0.15)));
  EXPECT_TRUE(check_object(outline(kBuilding, {box(0, 0, 5, 5)}, 0.3)));
}

TEST(LabelObject, MayCrossItselfForInsideIsToldByOddAndEven) {
  EXPECT_TRUE(check_object(area(kRoad, {ring({{0, 0}, {5, 5}, {5, 0}, {0, 5}})})));
}

TEST(LabelObject, NeedsThreeDifferentPlacesForARing) {
  EXPECT_EQ(error_text(check_object(area(kRoad, {ring({{0, 0}, {1, 1}})}, 7))),
            "area 7: a ring has 2 different places, and needs 3");
  EXPECT_FALSE(check_object(area(kRoad, {ring({{0, 0}, {1, 1}, {1, 1}, {0, 0}})})));
  EXPECT_FALSE(check_object(area(kRoad, {box(0, 0, 5, 5), {}})));
  EXPECT_FALSE(check_object(area(kRoad, {})));
}

TEST(LabelObject, NeedsTwoDifferentPlacesForALine) {
  EXPECT_FALSE(check_object(line(kCurb, ring({{2, 2}, {2, 2}}), 1.0)));
  EXPECT_TRUE(check_object(line(kCurb, ring({{2, 2}, {2, 3}, {2, 2}}), 1.0)));
  LabelObject two_parts = line(kCurb, ring({{0, 0}, {1, 0}}), 1.0);
  two_parts.rings.push_back(two_parts.rings.front());
  EXPECT_THAT(error_text(check_object(two_parts)), HasSubstr("2 parts"));
}

TEST(LabelObject, RefusesPlacesThatAreNoneOrFarOutside) {
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(),
                           std::numeric_limits<double>::infinity(), 1e12, -1.1e6}) {
    LabelObject object = area(kRoad, {box(0, 0, 5, 5)});
    object.rings.front()[2].y() = bad;
    EXPECT_THAT(error_text(check_object(object)), HasSubstr("not within 1000000 m")) << bad;
  }
}

TEST(LabelObject, RefusesWidthsThatItsKindDoesNotHave) {
  EXPECT_FALSE(check_object(line(kCurb, ring({{0, 0}, {1, 0}}), 0.0)));
  EXPECT_FALSE(check_object(line(kCurb, ring({{0, 0}, {1, 0}}), -1.0)));
  EXPECT_FALSE(
      check_object(line(kCurb, ring({{0, 0}, {1, 0}}), std::numeric_limits<double>::quiet_NaN())));
  EXPECT_FALSE(check_object(outline(kBuilding, {box(0, 0, 5, 5)}, 0.0)));
  EXPECT_FALSE(check_object(drawn(ObjectKind::kArea, kRoad, {box(0, 0, 5, 5)}, 1.0)));
}

TEST(LabelObject, RefusesTheSky) {
  EXPECT_THAT(error_text(check_object(area(kSky, {box(0, 0, 5, 5)}))), HasSubstr("class 9"));
  EXPECT_FALSE(check_object(area(ClassId{77}, {box(0, 0, 5, 5)})));
}

TEST(DrawingLevel, OfAnOrderRoundsDownBelowZeroToo) {
  EXPECT_EQ(level_of_order(0), 0);
  EXPECT_EQ(level_of_order(kOrdersPerLevel - 1), 0);
  EXPECT_EQ(level_of_order(3 * kOrdersPerLevel), 3);
  EXPECT_EQ(level_of_order(-1), -1);
}

TEST(LabelObject, DrawsWithinItsBounds) {
  const PlaneBounds bounds = drawn_bounds(line(kCurb, ring({{2, 3}, {6, 3}}), 2.0));
  EXPECT_EQ(bounds.low, Eigen::Vector2d(1.0, -4.0));
  EXPECT_EQ(bounds.high, Eigen::Vector2d(7.0, -2.0));
  EXPECT_EQ(drawn_bounds(outline(kBuilding, {box(0, 0, 5, 4)}, 2.0)).low,
            Eigen::Vector2d(0.0, -4.0));
}

TEST(LabelGrid, CountsCellsDownFromItsUpperLeftCorner) {
  const LabelGrid grid{0.5, {100.0, 200.0}, 20, 10};
  EXPECT_EQ(grid.cells_from_enu({101.0, 199.0}), Eigen::Vector2d(2.0, 2.0));
  EXPECT_EQ(grid.enu_from_cells({2.0, 2.0}), Eigen::Vector2d(101.0, 199.0));
  PlaneBounds bounds;
  EXPECT_TRUE(grid.cells_of(bounds, 3).empty());
  bounds.include({99.9, 199.9});
  bounds.include({100.6, 200.0});
  EXPECT_EQ(grid.cells_of(bounds, 0), (CellRect{-1, 0, 2, 1}));
  EXPECT_EQ(grid.cells_of(bounds, 1), (CellRect{-2, -1, 3, 2}));
}

TEST(CellRect, JoinsAndCuts) {
  const CellRect a{0, 0, 4, 4};
  const CellRect b{2, 3, 9, 5};
  EXPECT_EQ(a.joined(b), (CellRect{0, 0, 9, 5}));
  EXPECT_EQ(a.joined(CellRect{}), a);
  EXPECT_EQ(CellRect{}.joined(b), b);
  EXPECT_EQ(a.cut_to(b), (CellRect{2, 3, 4, 4}));
  EXPECT_TRUE(a.cut_to({7, 7, 9, 9}).empty());
  EXPECT_EQ(a.cut_to({7, 7, 9, 9}).width(), 0);
}

}  // namespace label_object_test
}  // namespace nadir
