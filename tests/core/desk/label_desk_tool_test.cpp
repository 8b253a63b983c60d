// SPDX-License-Identifier: Apache-2.0
// The tool at work: places, what they snap to, and what comes of them.
#include "tests/core/desk/desk_at_work.h"

namespace nadir {
namespace label_desk_tool_test {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

class ToolAtWork : public DeskAtWork {
 protected:
  [[nodiscard]] const LabelObject& only_selected() const {
    return *now().object(desk.selection().ids().at(0));
  }
  [[nodiscard]] double area_of_selected() const {
    return measured_way(only_selected().rings.at(0)).area_m2.value();
  }
};

TEST_F(ToolAtWork, AnAreaIsOneStepOnceItIsFinished) {
  take_up(ToolKind::kArea, kBuilding);
  ASSERT_THAT(points({{10, 10}, {30, 10}, {30, 20}, {10, 20}}), Succeeds());
  EXPECT_EQ(object_count(), 0U);
  ASSERT_THAT(desk.finish(), Succeeds());
  EXPECT_EQ(object_count(), 1U);
  EXPECT_TRUE(desk.points().empty());
  EXPECT_EQ(only_selected().class_id, kBuilding);
  EXPECT_EQ(class_at(20.5, 15.5), kBuilding);
  EXPECT_EQ(class_at(31.5, 15.5), kUnclassified);
  EXPECT_THAT(*desk.sheet().history(1, 9), SizeIs(1));
}

TEST_F(ToolAtWork, ARingIsDoneAtItsBeginning) {
  take_up(ToolKind::kArea);
  ASSERT_THAT(points({{10, 10}, {30, 10}, {30, 20}}), Succeeds());
  EXPECT_TRUE(desk.aim({10.05, -10.0}, 0.1).closes);
  ASSERT_THAT(desk.add_point({10.05, -10.0}, 0.1), Succeeds());
  EXPECT_EQ(object_count(), 1U);
  EXPECT_THAT(only_selected().rings.at(0), SizeIs(3));
}

TEST_F(ToolAtWork, WithTooFewPlacesItSaysSoAndKeepsThem) {
  take_up(ToolKind::kArea);
  ASSERT_THAT(points({{10, 10}, {30, 10}, {30, 10}}), Succeeds());  // One twice is one.
  EXPECT_THAT(error_text(desk.finish()), HasSubstr("area needs 3 places, and has 2"));
  EXPECT_EQ(desk.points().size(), 2U);
}

TEST_F(ToolAtWork, APlaceThatIsNoneIsRefused) {
  take_up(ToolKind::kLine);
  ASSERT_THAT(points({{10, 10}}), Succeeds());
  EXPECT_THAT(error_text(desk.add_point({std::nan(""), 0.0}, 0.1)),
              HasSubstr("not within 1000 km"));
  EXPECT_FALSE(desk.add_point({2e6, 0.0}, 0.1));
  desk.type_leg({std::nan(""), {}, false});
  EXPECT_FALSE(desk.add_point({20.0, 0.0}, 0.1));
  EXPECT_EQ(desk.points().size(), 1U);
}

TEST_F(ToolAtWork, ARectangleTakesThreePlacesAndACircleTwo) {
  take_up(ToolKind::kRectangle);
  ASSERT_THAT(points({{10, 10}, {20, 20}, {30, 10}}), Succeeds());
  EXPECT_NEAR(area_of_selected(), 200.0, 1e-3);
  take_up(ToolKind::kCircle);
  ASSERT_THAT(points({{60, 40}, {70, 40}}), Succeeds());
  EXPECT_NEAR(area_of_selected(), 314.16, 1.0);
  EXPECT_TRUE(desk.points().empty());
  EXPECT_EQ(object_count(), 2U);
}

TEST_F(ToolAtWork, LinesAndOutlinesHaveTheToolsWidth) {
  LabelTool tool = desk.tool();
  tool.kind = ToolKind::kLine;
  tool.line_width_m = 4.0;
  tool.outline_thickness_m = 2.0;
  ASSERT_THAT(desk.set_tool(tool), Succeeds());
  ASSERT_THAT(points({{10, 10.5}, {50, 10.5}}), Succeeds());
  ASSERT_THAT(desk.finish(), Succeeds());
  EXPECT_EQ(only_selected().width_m, 4.0);
  take_up(ToolKind::kOutline, kBuilding);
  ASSERT_THAT(points({{60, 30}, {80, 30}, {80, 50}, {60, 50}}), Succeeds());
  ASSERT_THAT(desk.finish(), Succeeds());
  EXPECT_EQ(class_at(61.5, 40.5), kBuilding);
  EXPECT_EQ(class_at(70.5, 40.5), kUnclassified);
}

TEST_F(ToolAtWork, AStreetNeedsItsProfile) {
  take_up(ToolKind::kStreet);
  ASSERT_THAT(points({{10, 40}, {100, 40}}), Succeeds());
  EXPECT_THAT(error_text(desk.finish()), HasSubstr("no street profile \"residential street\""));
  EXPECT_EQ(desk.points().size(), 2U);
  desk.set_profiles(
      {{"residential street", {{kRoad, 0.0, 6.0, 0.0, 0.0}, {kCurb, 3.5, 1.0, 0.0, 0.0}}}});
  EXPECT_FALSE(desk.coming({110.0, -40.0}, 0.1).empty());
  EXPECT_EQ(object_count(), 0U);
  ASSERT_THAT(desk.finish(), Succeeds());
  EXPECT_EQ(class_at(50.5, 40.5), kRoad);
  EXPECT_EQ(class_at(50.5, 36.5), kCurb);
  EXPECT_THAT(*desk.sheet().history(1, 9), SizeIs(1));
}

TEST_F(ToolAtWork, AHoleGoesIntoWhatLiesAroundIt) {
  drawn_box(10, 10, 50, 50);
  EXPECT_TRUE(desk.cancel());
  take_up(ToolKind::kHole);
  ASSERT_THAT(points({{20, 20}, {30, 20}, {30, 30}, {20, 30}}), Succeeds());
  ASSERT_THAT(desk.finish(), Succeeds());
  EXPECT_EQ(class_at(25.5, 25.5), kUnclassified);
  EXPECT_EQ(class_at(15.5, 25.5), kRoad);
  ASSERT_THAT(points({{70, 70}, {80, 70}, {80, 80}}), Succeeds());
  EXPECT_THAT(error_text(desk.finish()), HasSubstr("lies in no area"));
}

TEST_F(ToolAtWork, ASplitCutsWhatItCrosses) {
  drawn_box(10, 10, 50, 50);
  EXPECT_TRUE(desk.cancel());
  take_up(ToolKind::kSplit);
  ASSERT_THAT(points({{30, 5}, {30, 55}}), Succeeds());
  ASSERT_THAT(desk.finish(), Succeeds());
  EXPECT_EQ(object_count(), 2U);
  EXPECT_EQ(class_at(29.5, 30.5), kRoad);
  EXPECT_EQ(class_at(30.5, 30.5), kRoad);
}

TEST_F(ToolAtWork, BrushEraserAndFillPaint) {
  take_up(ToolKind::kBrush, kTerrain);
  ASSERT_THAT(points({{20.5, 20.5}, {40.5, 20.5}}), Succeeds());
  const auto coming = desk.coming({50.5, -20.5}, 0.1);
  ASSERT_THAT(coming, SizeIs(1));
  EXPECT_EQ(coming[0].width_m, 2.0);
  ASSERT_THAT(desk.finish(), Succeeds());
  EXPECT_EQ(class_at(30.5, 20.5), kTerrain);
  EXPECT_EQ(desk.under({30.5, -20.5}).paint, kTerrain);
  LabelTool eraser = desk.tool();
  eraser.kind = ToolKind::kEraser;
  eraser.brush_radius_m = 2.5;
  ASSERT_THAT(desk.set_tool(eraser), Succeeds());
  ASSERT_THAT(points({{30.5, 20.5}}), Succeeds());
  ASSERT_THAT(desk.finish(), Succeeds());
  EXPECT_EQ(class_at(30.5, 20.5), kUnclassified);
  take_up(ToolKind::kFill, kRoad);
  ASSERT_THAT(points({{22.5, 20.5}}), Succeeds());
  EXPECT_EQ(class_at(25.5, 20.5), kRoad);
  EXPECT_EQ(class_at(38.5, 20.5), kTerrain);
  EXPECT_EQ(desk.undo_title(), "Fill with road");
}

TEST_F(ToolAtWork, RecodingTakesEverythingOrARing) {
  drawn_box(10, 10, 20, 20, kTerrain);
  drawn_box(60, 10, 70, 20, kTerrain);
  take_up(ToolKind::kRecode, kRoad);
  ASSERT_THAT(points({{0, 0}, {40, 0}, {40, 40}, {0, 40}}), Succeeds());
  ASSERT_THAT(desk.finish(), Succeeds());
  EXPECT_EQ(class_at(15.5, 15.5), kRoad);
  EXPECT_EQ(class_at(65.5, 15.5), kTerrain);
  ASSERT_THAT(desk.finish(), Succeeds());
  EXPECT_EQ(class_at(65.5, 15.5), kRoad);
}

TEST_F(ToolAtWork, UndoTakesPlacesBackBeforeSteps) {
  drawn_box(10, 10, 20, 20);
  take_up(ToolKind::kLine);
  ASSERT_THAT(points({{50, 50}, {60, 50}}), Succeeds());
  EXPECT_EQ(desk.undo_title(), "Last place");
  ASSERT_THAT(desk.undo(), Succeeds());
  EXPECT_EQ(desk.points().size(), 1U);
  EXPECT_EQ(desk.redo_title(), "Place");
  ASSERT_THAT(desk.redo(), Succeeds());
  EXPECT_EQ(desk.points().size(), 2U);
  EXPECT_FALSE(desk.redo());
  ASSERT_THAT(desk.undo(), Succeeds());
  ASSERT_THAT(desk.undo(), Succeeds());
  EXPECT_EQ(object_count(), 1U);
  ASSERT_THAT(desk.undo(), Succeeds());
  EXPECT_EQ(object_count(), 0U);
  ASSERT_THAT(desk.redo(), Succeeds());
  EXPECT_EQ(object_count(), 1U);
  EXPECT_TRUE(desk.points().empty());
}

TEST_F(ToolAtWork, CancellingGoesBackInOrder) {
  drawn_box(10, 10, 20, 20);
  take_up(ToolKind::kLine);
  ASSERT_THAT(points({{50, 50}}), Succeeds());
  EXPECT_TRUE(desk.cancel());
  EXPECT_TRUE(desk.points().empty());
  EXPECT_THAT(desk.selection().ids(), SizeIs(1));
  EXPECT_TRUE(desk.cancel());
  EXPECT_TRUE(desk.selection().empty());
  EXPECT_EQ(desk.tool().kind, ToolKind::kLine);
  EXPECT_TRUE(desk.cancel());
  EXPECT_EQ(desk.tool().kind, ToolKind::kSelect);
  EXPECT_FALSE(desk.cancel());
  EXPECT_EQ(object_count(), 1U);
}

TEST_F(ToolAtWork, TypedNumbersCountMoreThanTheHand) {
  take_up(ToolKind::kLine);
  ASSERT_THAT(points({{50, 50}}), Succeeds());
  desk.type_leg({10.0, 90.0, false});  // East.
  ASSERT_THAT(desk.add_point({0.0, 0.0}, 1.0), Succeeds());
  EXPECT_NEAR((desk.points().ring()[1] - Eigen::Vector2d(60.0, -50.0)).norm(), 0.0, 1e-5);
  desk.type_leg({5.0, 90.0, true});  // Right of it: south.
  ASSERT_THAT(desk.add_point({0.0, 0.0}, 1.0), Succeeds());
  EXPECT_NEAR((desk.points().ring()[2] - Eigen::Vector2d(60.0, -55.0)).norm(), 0.0, 1e-5);
  desk.type_leg({{}, 90.0, false});  // As far east as the hand.
  ASSERT_THAT(desk.add_point({71.0, -20.0}, 1.0), Succeeds());
  EXPECT_NEAR((desk.points().ring()[3] - Eigen::Vector2d(71.0, -55.0)).norm(), 0.0, 1e-5);
  desk.type_leg({2.0, {}, false});  // Towards the hand.
  ASSERT_THAT(desk.add_point({71.0, 0.0}, 1.0), Succeeds());
  EXPECT_NEAR((desk.points().ring()[4] - Eigen::Vector2d(71.0, -53.0)).norm(), 0.0, 1e-5);
  ASSERT_THAT(desk.add_point({80.0, -30.0}, 1.0), Succeeds());  // What was typed was for one.
  EXPECT_NEAR((desk.points().ring()[5] - Eigen::Vector2d(80.0, -30.0)).norm(), 0.0, 1e-5);
}

TEST_F(ToolAtWork, SnapsToCornersToTheLastBitThenToEdges) {
  const Ring odd{{10.1, -10.3}, {40.7, -12.9}, {33.3, -47.1}};
  ASSERT_THAT(desk.draw({ObjectKind::kArea, kRoad, 0.0}, odd), Succeeds());
  const Ring corners = only_selected().rings.at(0);
  LabelTool tool = desk.tool();
  tool.kind = ToolKind::kArea;
  ASSERT_THAT(desk.set_tool(tool), Succeeds());
  for (const Eigen::Vector2d& corner : corners) {
    const ToolPoint aim = desk.aim(corner + Eigen::Vector2d(0.3, -0.2), 0.5);
    ASSERT_TRUE(aim.snap);
    EXPECT_EQ(aim.snap->kind, SnapKind::kVertex);
    EXPECT_EQ(aim.in_enu_m, corner);
  }
  const Eigen::Vector2d middle = (corners[0] + corners[1]) / 2.0;
  const ToolPoint on_edge = desk.aim(middle + Eigen::Vector2d(0.0, 0.3), 0.5);
  ASSERT_TRUE(on_edge.snap);
  EXPECT_EQ(on_edge.snap->kind, SnapKind::kEdge);
  EXPECT_FALSE(desk.aim({80.0, -80.0}, 0.5).snap);
  tool.snaps = false;
  ASSERT_THAT(desk.set_tool(tool), Succeeds());
  EXPECT_FALSE(desk.aim(corners[0], 0.5).snap);
}

TEST_F(ToolAtWork, TracesAlongABorderSoThatItIsShared) {
  drawn_box(10, 10, 50, 50);
  const Ring corners = only_selected().rings.at(0);
  LabelTool tool = desk.tool();
  tool.kind = ToolKind::kArea;
  ASSERT_THAT(desk.set_tool(tool), Succeeds());
  ASSERT_THAT(desk.add_point({50.0, -10.0}, 0.5), Succeeds());
  ASSERT_THAT(desk.add_traced({10.0, -50.0}, 0.5, false), Succeeds());
  EXPECT_EQ(desk.points().size(), 3U);  // By one of the two corners between.
  for (const Eigen::Vector2d& place : desk.points().ring()) {
    EXPECT_THAT(corners, testing::Contains(place));
  }
  EXPECT_THAT(error_text(desk.add_traced({90.0, -80.0}, 0.5, false)), HasSubstr("no border"));
}

TEST_F(ToolAtWork, TracesFromWhereAPlaceLiesAlsoAfterTheBorderHasChanged) {
  const ObjectId house = drawn_box(10, 10, 50, 50);
  const ObjectId beside = drawn_box(50, 10, 80, 50, kTerrain);
  LabelTool tool = desk.tool();
  tool.kind = ToolKind::kLine;
  ASSERT_THAT(desk.set_tool(tool), Succeeds());
  ASSERT_THAT(desk.add_point({30.0, -50.0}, 0.5), Succeeds());
  ASSERT_EQ(desk.points().all()[0].snap->kind, SnapKind::kEdge);
  // Two more places before the edge, whose number changes.
  ASSERT_THAT(desk.add_vertex({house, 0, 0}, {20.0, -10.0}), Succeeds());
  ASSERT_THAT(desk.add_vertex({house, 0, 0}, {15.0, -10.0}), Succeeds());
  ASSERT_THAT(desk.add_traced({50.0, -30.0}, 0.5, false), Succeeds());
  EXPECT_EQ(desk.points().ring(), ring({{30, 50}, {50, 50}, {50, 30}}));
  // What it lies on may be gone altogether; the neighbour's border is as good.
  ASSERT_THAT(desk.select(std::vector<ObjectId>{house}, SelectHow::kInstead), Succeeds());
  ASSERT_THAT(desk.delete_selected(), Succeeds());
  ASSERT_THAT(desk.add_traced({60.0, -10.0}, 0.5, false), Succeeds());
  EXPECT_EQ(desk.points().ring(), ring({{30, 50}, {50, 50}, {50, 30}, {50, 10}, {60, 10}}));
  ASSERT_THAT(desk.select(std::vector<ObjectId>{beside}, SelectHow::kInstead), Succeeds());
  ASSERT_THAT(desk.delete_selected(), Succeeds());
  EXPECT_FALSE(desk.add_traced({50.0, -30.0}, 0.5, false));
}

TEST_F(ToolAtWork, WhatComesIsWhatFinishingDraws) {
  for (const ToolKind kind : {ToolKind::kArea, ToolKind::kLine, ToolKind::kOutline,
                              ToolKind::kRectangle, ToolKind::kCircle}) {
    take_up(kind, kBuilding);
    const Ring places = ring({{10, 10}, {40, 12}, {35, 30}});
    const std::size_t count = kind == ToolKind::kCircle ? 2 : 3;
    for (std::size_t i = 0; i + 1 < count; ++i) {
      ASSERT_THAT(desk.add_point(places[i], 0.1), Succeeds());
    }
    const auto coming = desk.coming(places[count - 1], 0.1);
    ASSERT_THAT(coming, SizeIs(1));
    ASSERT_THAT(desk.add_point(places[count - 1], 0.1), Succeeds());
    if (most_points(kind) == 0) {
      ASSERT_THAT(desk.finish(), Succeeds());
    }
    const LabelObject& drawn = only_selected();
    EXPECT_EQ(drawn.kind, coming[0].kind) << enum_name(kind);
    EXPECT_EQ(drawn.rings, coming[0].rings) << enum_name(kind);
    EXPECT_EQ(drawn.width_m, coming[0].width_m) << enum_name(kind);
  }
}

TEST_F(ToolAtWork, MeasuringChangesNothing) {
  take_up(ToolKind::kMeasure);
  ASSERT_THAT(points({{10, 10}, {40, 10}, {40, 50}}), Succeeds());
  const MeasuredWay found = measured_way(desk.points().ring());
  EXPECT_DOUBLE_EQ(found.length_m, 70.0);
  EXPECT_DOUBLE_EQ(found.leg_m.value(), 40.0);
  EXPECT_DOUBLE_EQ(found.leg_deg.value(), 180.0);
  EXPECT_DOUBLE_EQ(found.area_m2.value(), 600.0);
  ASSERT_THAT(desk.finish(), Succeeds());
  EXPECT_TRUE(desk.points().empty());
  EXPECT_THAT(*desk.sheet().history(1, 9), IsEmpty());
}

}  // namespace label_desk_tool_test
}  // namespace nadir
