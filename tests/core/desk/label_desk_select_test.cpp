// SPDX-License-Identifier: Apache-2.0
// Choosing objects and corners, and what is done with them.
#include "core/base/random.h"
#include "core/desk/object_index.h"
#include "tests/core/desk/desk_at_work.h"

namespace nadir {
namespace label_desk_select_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using testing::UnorderedElementsAre;

using SelectionAtWork = DeskAtWork;

PlaneBounds rectangle_in_cells(double left, double top, double right, double bottom) {
  PlaneBounds bounds;
  bounds.include({left, -top});
  bounds.include({right, -bottom});
  return bounds;
}

/// Top-most first, by looking at every object.
std::vector<ObjectId> hit_by_looking_at_all(const LabelDocument& document,
                                            const Eigen::Vector2d& place,
                                            double reach_m) {
  std::vector<std::pair<std::int64_t, ObjectId>> ranked;
  for (const auto& [id, placed] : document.objects()) {
    if (is_hit(*placed.object, place, reach_m)) ranked.emplace_back(placed.object->order, id);
  }
  std::sort(ranked.rbegin(), ranked.rend());
  std::vector<ObjectId> ids;
  for (const auto& [order, id] : ranked) ids.push_back(id);
  return ids;
}

TEST(ObjectIndex, FindsWhatLookingAtAllObjectsFindsAlsoAfterEdits) {
  LabelDocument document = test_document(120, 90);
  ObjectIndex index(document);
  std::uint32_t draws = 0;
  const auto random = [&](double low, double high) {
    return low + (high - low) * uniforms({7, 0, 1000, 0, draws++})[0];
  };
  std::size_t hits = 0;
  for (std::uint32_t step = 0; step < 400; ++step) {
    const LabelEdit edit = random_edit(document, 7, step);
    document.apply(edit);
    index.apply(edit);
    const Eigen::Vector2d place(random(-20.0, 140.0), random(-110.0, 20.0));
    const double reach_m = random(0.0, 2.0);
    const auto found = objects_at(document, index, place, reach_m);
    ASSERT_EQ(found, hit_by_looking_at_all(document, place, reach_m)) << "step " << step;
    hits += found.size();
  }
  EXPECT_GT(hits, 100U);
  const ObjectIndex anew(document);
  const PlaneBounds some = rectangle_in_cells(10, 10, 60, 50);
  EXPECT_EQ(index.near(some), anew.near(some));
  EXPECT_THAT(index.near(rectangle_in_cells(-1e6, -1e6, 1e6, 1e6)),
              SizeIs(document.objects().size()));
}

TEST(ObjectIndex, HitsWhatIsDrawnAndWhatIsInside) {
  const LabelObject house = outline(kBuilding, {box(10, 10, 30, 30)}, 0.5);
  EXPECT_TRUE(is_hit(house, {20.0, -20.0}, 0.0));
  EXPECT_FALSE(is_hit(house, {31.0, -20.0}, 0.5));
  EXPECT_TRUE(is_hit(house, {31.0, -20.0}, 1.5));
  const LabelObject ground = area(kTerrain, {box(10, 10, 30, 30), box(15, 15, 25, 25)});
  EXPECT_FALSE(is_hit(ground, {20.0, -20.0}, 1.0));
  EXPECT_TRUE(is_hit(ground, {20.0, -14.0}, 0.0));
  const LabelObject street = line(kRoad, ring({{10, 10}, {30, 10}}), 4.0);
  EXPECT_TRUE(is_hit(street, {20.0, -11.9}, 0.0));
  EXPECT_FALSE(is_hit(street, {20.0, -12.1}, 0.0));
}

TEST_F(SelectionAtWork, AgainAtTheSamePlaceGoesDownAndRoundAgain) {
  const ObjectId low = drawn_box(10, 10, 50, 50, kTerrain);
  const ObjectId middle = drawn_box(20, 20, 40, 40, kRoad);
  const ObjectId top = drawn_box(25, 25, 35, 35, kBuilding);
  desk.select_at({30.0, -30.0}, 0.5, SelectHow::kInstead);
  EXPECT_THAT(desk.selection().ids(), ElementsAre(top));
  desk.select_at({30.1, -30.0}, 0.5, SelectHow::kInstead);
  EXPECT_THAT(desk.selection().ids(), ElementsAre(middle));
  desk.select_at({30.0, -30.0}, 0.5, SelectHow::kInstead);
  EXPECT_THAT(desk.selection().ids(), ElementsAre(low));
  desk.select_at({30.0, -30.0}, 0.5, SelectHow::kInstead);
  EXPECT_THAT(desk.selection().ids(), ElementsAre(top));
  desk.select_at({12.0, -12.0}, 0.5, SelectHow::kAdd);
  EXPECT_THAT(desk.selection().ids(), ElementsAre(top, low));
  desk.select_at({12.0, -12.0}, 0.5, SelectHow::kToggle);
  EXPECT_THAT(desk.selection().ids(), ElementsAre(top));
  desk.select_at({100.0, -80.0}, 0.5, SelectHow::kAdd);
  EXPECT_THAT(desk.selection().ids(), ElementsAre(top));
  desk.select_at({100.0, -80.0}, 0.5, SelectHow::kInstead);
  EXPECT_THAT(desk.selection().ids(), IsEmpty());
}

TEST_F(SelectionAtWork, ABoxTakesWhatLiesInItWhole) {
  const ObjectId inside = drawn_box(10, 10, 20, 20);
  const ObjectId across = drawn_box(15, 15, 60, 20);
  desk.select_within(rectangle_in_cells(5, 5, 30, 30), SelectHow::kInstead);
  EXPECT_THAT(desk.selection().ids(), ElementsAre(inside));
  desk.select_within(rectangle_in_cells(0, 0, 70, 30), SelectHow::kAdd);
  EXPECT_THAT(desk.selection().ids(), UnorderedElementsAre(inside, across));
  desk.select_within(rectangle_in_cells(5, 5, 30, 30), SelectHow::kRemove);
  EXPECT_THAT(desk.selection().ids(), ElementsAre(across));
  desk.select_all();
  EXPECT_THAT(desk.selection().ids(), SizeIs(2));
  EXPECT_THAT(error_text(desk.select(std::vector<ObjectId>{99}, SelectHow::kAdd)),
              HasSubstr("no object 99"));
}

TEST_F(SelectionAtWork, WhatIsUndoneLeavesTheSelectionAndTheRestStays) {
  const ObjectId first = drawn_box(10, 10, 20, 20);
  const ObjectId second = drawn_box(30, 10, 40, 20);
  ASSERT_THAT(desk.select(std::vector<ObjectId>{first, second}, SelectHow::kInstead), Succeeds());
  ASSERT_THAT(desk.undo(), Succeeds());
  EXPECT_THAT(desk.selection().ids(), ElementsAre(first));
}

TEST_F(SelectionAtWork, CommandsAreOneStepEachAndUndoGivesBackWhatWas) {
  const ObjectId one = drawn_box(10, 10, 20, 20);
  ASSERT_THAT(desk.draw({ObjectKind::kLine, kCurb, 0.5}, ring({{30, 30}, {50, 31}, {70, 30}})),
              Succeeds());
  const ObjectId two = desk.selection().ids().front();
  drawn_box(40, 40, 60, 60, kBuilding);
  const std::vector<ObjectId> both{one, two};
  const std::vector<std::function<Result<void>()>> commands{
      [&] {
        return desk.move_selected({3.0, -2.0});
      },
      [&] { return desk.delete_selected(); },
      [&] {
        return desk.duplicate_selected({5.0, 5.0});
      },
      [&] { return desk.set_class(kTerrain); },
      [&] { return desk.set_width(1.25); },
      [&] { return desk.set_note("seen from the street"); },
      [&] { return desk.reorder(OrderMove::kTop); },
      [&] { return desk.objects_to_paint(); }};
  for (std::size_t i = 0; i < commands.size(); ++i) {
    ASSERT_THAT(desk.select(both, SelectHow::kInstead), Succeeds());
    const LabelDocument before = now();
    const std::size_t steps = desk.sheet().history(1, 99)->size();
    ASSERT_THAT(commands[i](), Succeeds()) << i;
    EXPECT_FALSE(now() == before) << i;
    EXPECT_THAT(*desk.sheet().history(1, 99), SizeIs(steps + 1)) << i;
    ASSERT_THAT(desk.undo(), Succeeds()) << i;
    EXPECT_TRUE(now() == before) << i;
  }
}

TEST_F(SelectionAtWork, CommandsWithoutSelectionSaySo) {
  drawn_box(10, 10, 20, 20);
  EXPECT_TRUE(desk.cancel());
  EXPECT_EQ(error_text(desk.move_selected({1.0, 1.0})), "nothing is selected");
  EXPECT_EQ(error_text(desk.copy()), "nothing is selected");
  EXPECT_THAT(error_text(desk.subtract()), HasSubstr("two objects"));
  EXPECT_THAT(error_text(desk.remove_picked()), HasSubstr("no corner is picked"));
  EXPECT_THAT(error_text(desk.split(ring({{50, 50}, {60, 60}}))), HasSubstr("crosses no area"));
}

TEST_F(SelectionAtWork, SubtractsAllOthersFromTheFirstInOneStep) {
  const ObjectId ground = drawn_box(10, 10, 50, 50, kTerrain);
  const ObjectId left = drawn_box(10, 10, 20, 50);
  const ObjectId right = drawn_box(40, 10, 50, 50);
  ASSERT_THAT(desk.select(std::vector<ObjectId>{ground, left, right}, SelectHow::kInstead),
              Succeeds());
  ASSERT_THAT(desk.subtract(), Succeeds());
  EXPECT_NEAR(measured_way(now().object(ground)->rings.at(0)).area_m2.value(), 20.0 * 40.0, 1e-6);
  ASSERT_THAT(desk.undo(), Succeeds());
  EXPECT_NEAR(measured_way(now().object(ground)->rings.at(0)).area_m2.value(), 1600.0, 1e-6);
}

TEST_F(SelectionAtWork, CornersThatAreSharedMoveTogether) {
  const ObjectId left = drawn_box(10, 10, 30, 30);
  const ObjectId right = drawn_box(30, 10, 50, 30, kTerrain);
  LabelTool tool = desk.tool();
  tool.kind = ToolKind::kVertices;
  ASSERT_THAT(desk.set_tool(tool), Succeeds());
  desk.pick_at({30.1, -10.1}, 0.5, SelectHow::kInstead);
  ASSERT_THAT(desk.picked(), SizeIs(1));
  const auto count = [&](const Eigen::Vector2d& place) {
    const std::vector<Ring> rings{now().object(left)->rings.at(0),
                                  now().object(right)->rings.at(0)};
    return std::count_if(rings.begin(), rings.end(), [&](const Ring& one) {
      return std::find(one.begin(), one.end(), place) != one.end();
    });
  };
  ASSERT_THAT(desk.move_vertex(desk.picked()[0].at, {32.0, -8.0}), Succeeds());
  EXPECT_EQ(count({32.0, -8.0}), 2);
  ASSERT_THAT(desk.picked(), SizeIs(1));
  ASSERT_THAT(desk.move_picked({-1.0, 1.0}), Succeeds());
  EXPECT_EQ(count({31.0, -7.0}), 2);
  tool.shares_borders = false;
  ASSERT_THAT(desk.set_tool(tool), Succeeds());
  ASSERT_THAT(desk.move_picked({1.0, 0.0}), Succeeds());
  EXPECT_EQ(count({31.0, -7.0}), 1);
  ASSERT_THAT(desk.undo(), Succeeds());
  EXPECT_THAT(desk.picked(), IsEmpty());
}

TEST_F(SelectionAtWork, PickedCornersNeverMakeAnAreaCrossItself) {
  const ObjectId object = drawn_box(10, 10, 30, 30);
  desk.pick_at({10.0, -10.0}, 0.5, SelectHow::kInstead);
  desk.pick_at({30.0, -30.0}, 0.5, SelectHow::kAdd);
  ASSERT_THAT(desk.picked(), SizeIs(2));
  const LabelDocument before = now();
  EXPECT_THAT(error_text(desk.move_picked({0.0, -22.0})),
              HasSubstr("area 1 would cross itself at 10.91 E, -31.00 N"));
  EXPECT_TRUE(now() == before);
  EXPECT_THAT(desk.picked(), SizeIs(2));
  EXPECT_THAT(desk.coming_picked({0.0, -22.0}), IsEmpty());
  const auto coming = desk.coming_picked({5.0, 0.0});
  ASSERT_THAT(coming, SizeIs(1));
  ASSERT_THAT(desk.move_picked({5.0, 0.0}), Succeeds());
  EXPECT_EQ(now().object(object)->rings, coming[0].rings);
  EXPECT_EQ(desk.picked()[0].in_enu_m.x(), 15.0);
}

TEST_F(SelectionAtWork, ABoxOfCornersAddsTakesAwayAndTurnsOver) {
  const ObjectId object = drawn_box(10, 10, 30, 30);
  const auto places = [&] {
    std::vector<std::size_t> numbers;
    for (const PickedVertex& picked : desk.picked()) {
      EXPECT_EQ(picked.at.object, object);
      numbers.push_back(picked.at.place);
    }
    return numbers;
  };
  desk.pick_within(rectangle_in_cells(5, 5, 15, 35), SelectHow::kInstead);
  EXPECT_THAT(places(), ElementsAre(0, 3));
  desk.pick_within(rectangle_in_cells(5, 5, 35, 15), SelectHow::kAdd);
  EXPECT_THAT(places(), ElementsAre(0, 3, 1));
  desk.pick_within(rectangle_in_cells(5, 25, 35, 35), SelectHow::kToggle);
  EXPECT_THAT(places(), ElementsAre(0, 1, 2));
  desk.pick_within(rectangle_in_cells(5, 5, 15, 35), SelectHow::kRemove);
  EXPECT_THAT(places(), ElementsAre(1, 2));
}

TEST_F(SelectionAtWork, PickedCornersAreRemoved) {
  const ObjectId object = drawn_box(10, 10, 30, 30);
  desk.pick_within(rectangle_in_cells(25, 5, 35, 15), SelectHow::kInstead);
  ASSERT_THAT(desk.picked(), SizeIs(1));
  ASSERT_THAT(desk.remove_picked(), Succeeds());
  EXPECT_THAT(now().object(object)->rings.at(0), SizeIs(3));
  EXPECT_THAT(desk.picked(), IsEmpty());
}

TEST_F(SelectionAtWork, CopiesGoFromDeskToDesk) {
  drawn_box(10, 10, 20, 20, kBuilding);
  ASSERT_THAT(desk.draw({ObjectKind::kLine, kCurb, 0.5}, ring({{30, 30}, {50, 31.25}})),
              Succeeds());
  desk.select_all();
  const auto text = desk.copy();
  ASSERT_THAT(text, Succeeds());
  LabelDesk other = opened_desk(half_a_road(scratch.path()));
  ASSERT_THAT(other.paste(*text, {100.0, 0.0}), Succeeds());
  ASSERT_THAT(other.selection().ids(), SizeIs(2));
  std::vector<LabelObject> theirs;
  for (const ObjectId id : desk.selection().ids()) theirs.push_back(*now().object(id));
  for (std::size_t i = 0; i < 2; ++i) {
    const LabelObject& pasted = *other.sheet().now().object(other.selection().ids()[i]);
    EXPECT_EQ(pasted.kind, theirs[i].kind);
    EXPECT_EQ(pasted.class_id, theirs[i].class_id);
    EXPECT_EQ(pasted.width_m, theirs[i].width_m);
    ASSERT_EQ(pasted.rings.at(0).size(), theirs[i].rings.at(0).size());
    EXPECT_EQ(pasted.rings[0][1], theirs[i].rings[0][1] + Eigen::Vector2d(100.0, 0.0));
  }
  const LabelDocument before = other.sheet().now();
  EXPECT_FALSE(other.paste("hello", {0.0, 0.0}));
  EXPECT_TRUE(other.sheet().now() == before);
}

TEST_F(SelectionAtWork, SaysWhatLiesUnderAPlace) {
  const ObjectId house = drawn_box(10, 10, 20, 20, kBuilding);
  const UnderPlace under = desk.under({15.5, -15.5});
  EXPECT_TRUE(under.is_on_grid);
  EXPECT_EQ(under.class_id, kBuilding);
  EXPECT_EQ(under.object, house);
  EXPECT_EQ(under.paint, kNoPaint);
  EXPECT_FALSE(desk.under({-1.0, -1.0}).is_on_grid);
  EXPECT_FALSE(desk.under({100.0, -80.0}).object);
}

}  // namespace label_desk_select_test
}  // namespace nadir
