// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/label_overlay_model.h"

#include "core/desk/object_index.h"
#include "core/edit/polygon_algebra.h"
#include "tests/core/desk/desk_at_work.h"

namespace nadir {
namespace label_overlay_model_test {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

class DeskOverlay : public DeskAtWork {
 protected:
  /// The hand at a place in cells; y counts down.
  [[nodiscard]] LabelOverlay seen_at(double x, double y, double reach_m = 0.1) const {
    return label_overlay_of(desk, LabelHand{{x, -y}, reach_m});
  }
  static double area_of(const std::vector<Ring>& rings) {
    return area_m2(region_of(area(kRoad, rings)).value());
  }
};

TEST_F(DeskOverlay, OfAnEmptyDeskIsEmpty) {
  const LabelOverlay overlay = label_overlay_of(desk, std::nullopt);
  EXPECT_THAT(overlay.selected, IsEmpty());
  EXPECT_THAT(overlay.coming, IsEmpty());
  EXPECT_THAT(overlay.places, IsEmpty());
  EXPECT_FALSE(overlay.brush || overlay.snapped || overlay.next || overlay.under_hand);
}

TEST_F(DeskOverlay, HasWhatIsSelectedAndWhatTheHandIsOver) {
  const ObjectId first = drawn_box(10, 10, 20, 20);
  const ObjectId second = drawn_box(30, 10, 40, 20);
  take_up(ToolKind::kSelect);
  ASSERT_THAT(desk.select(std::vector{first}, SelectHow::kInstead), Succeeds());
  const LabelOverlay overlay = seen_at(35, 15);
  ASSERT_THAT(overlay.selected, SizeIs(1));
  EXPECT_EQ(overlay.selected[0]->id, first);
  ASSERT_NE(overlay.under_hand, nullptr);
  EXPECT_EQ(overlay.under_hand->id, second);
  EXPECT_FALSE(overlay.shows_corners);
  EXPECT_EQ(seen_at(15, 15).under_hand, nullptr) << "that one is selected already";
  EXPECT_EQ(seen_at(25, 15).under_hand, nullptr);
}

TEST_F(DeskOverlay, ShowsCornersWhileTheyCanBePicked) {
  drawn_box(10, 10, 20, 20);
  take_up(ToolKind::kVertices);
  ASSERT_THAT(desk.add_point({10.0, -20.0}, 0.5), Succeeds());
  const LabelOverlay overlay = label_overlay_of(desk, std::nullopt);
  EXPECT_TRUE(overlay.shows_corners);
  EXPECT_THAT(overlay.picked, ElementsAre(Eigen::Vector2d(10.0, -20.0)));
}

TEST_F(DeskOverlay, ShowsTheToolAtWorkWithItsLegs) {
  take_up(ToolKind::kArea, kVegetation);
  ASSERT_THAT(points({{10, 10}, {22, 10}}), Succeeds());
  const LabelOverlay overlay = seen_at(22, 15);
  EXPECT_THAT(overlay.places, SizeIs(2));
  EXPECT_EQ(overlay.next, Eigen::Vector2d(22.0, -15.0));
  EXPECT_TRUE(overlay.closes);
  ASSERT_THAT(overlay.words, SizeIs(2));
  EXPECT_EQ(overlay.words[0].line, "12.00 m");
  EXPECT_EQ(overlay.words[1].line, "5.00 m  180.0°");
  EXPECT_FALSE(overlay.words[1].is_typed);
  ASSERT_THAT(overlay.coming, SizeIs(1));
  EXPECT_EQ(overlay.coming[0].class_id, kVegetation);
  EXPECT_NEAR(area_of(overlay.coming[0].rings), 30.0, 1e-9);
  // The hand is elsewhere: what is there stays.
  const LabelOverlay away = label_overlay_of(desk, std::nullopt);
  EXPECT_THAT(away.places, SizeIs(2));
  EXPECT_FALSE(away.next);
}

TEST_F(DeskOverlay, SaysWhatWasTyped) {
  take_up(ToolKind::kLine);
  ASSERT_THAT(points({{10, 10}}), Succeeds());
  desk.type_leg({.length_m = 7.5, .bearing_deg = std::nullopt, .is_turn = false});
  const LabelOverlay overlay = seen_at(30, 10);
  ASSERT_THAT(overlay.words, SizeIs(1));
  EXPECT_EQ(overlay.words[0].line, "7.50 m  090.0°");
  EXPECT_TRUE(overlay.words[0].is_typed);
  EXPECT_NEAR(overlay.next->x(), 17.5, 1e-6);
}

TEST_F(DeskOverlay, MarksWhatTheNextPlaceHoldsOnTo) {
  drawn_box(10, 10, 20, 20);
  take_up(ToolKind::kArea);
  LabelTool tool = desk.tool();
  tool.snaps = true;
  ASSERT_THAT(desk.set_tool(tool), Succeeds());
  const auto mark = [this](double x, double y) {
    const LabelOverlay overlay = seen_at(x, y, 0.4);
    return overlay.snapped ? std::optional(overlay.snapped->mark) : std::nullopt;
  };
  EXPECT_EQ(mark(10.2, 10.2), SnapMark::kCorner);
  EXPECT_EQ(mark(15.0, 10.2), SnapMark::kEdge);
  EXPECT_EQ(mark(60.0, 60.0), std::nullopt);
  ASSERT_THAT(points({{50, 50}, {60, 50}}), Succeeds());
  EXPECT_EQ(mark(70.0, 50.2), SnapMark::kContinuing);
  EXPECT_EQ(mark(60.2, 60.0), SnapMark::kSquareOn);
  ASSERT_THAT(points({{60, 60}}), Succeeds());
  EXPECT_EQ(mark(50.1, 50.1), SnapMark::kClosing);
}

TEST_F(DeskOverlay, ShowsTheBrushWhereTheHandIs) {
  take_up(ToolKind::kBrush);
  LabelTool tool = desk.tool();
  tool.brush_unit = BrushUnit::kMetres;
  tool.brush_radius_m = 4.0;
  ASSERT_THAT(desk.set_tool(tool), Succeeds());
  const LabelOverlay overlay = seen_at(33, 44);
  ASSERT_TRUE(overlay.brush);
  EXPECT_EQ(overlay.brush->centre, Eigen::Vector2d(33.0, -44.0));
  EXPECT_EQ(overlay.brush->radius_m, 4.0);
  EXPECT_FALSE(label_overlay_of(desk, std::nullopt).brush);
  take_up(ToolKind::kFill);
  EXPECT_FALSE(seen_at(33, 44).brush);
}

TEST_F(DeskOverlay, ShapesCoverWhatTheObjectsWill) {
  const std::vector<LabelObject> objects = {
      area(kRoad, {box(0, 0, 10, 10), box(4, 4, 6, 6)}), line(kCurb, ring({{0, 0}, {20, 0}}), 2.0),
      outline(kBuilding, {box(0, 0, 10, 8)}, 1.0), line(kRoad, ring({{0, 0}, {9, 9}}), 0.0)};
  const auto shapes = coming_shapes(objects);
  ASSERT_THAT(shapes, SizeIs(4));
  EXPECT_NEAR(area_of(shapes[0].rings), 96.0, 1e-9);
  EXPECT_NEAR(area_of(shapes[1].rings), 40.0, 0.05);
  EXPECT_NEAR(area_of(shapes[2].rings), 80.0 - 48.0, 1e-6) << "a rim of one metre";
  EXPECT_FALSE(shapes[3].is_filled) << "a guide";
  EXPECT_EQ(shapes[3].rings, objects[3].rings);
}

}  // namespace label_overlay_model_test
}  // namespace nadir
