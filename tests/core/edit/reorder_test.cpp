// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <numeric>
#include <set>

#include "core/edit/edit_objects.h"
#include "tests/core/edit/edited_labels.h"

namespace nadir {
namespace reorder_test {

using testing::ElementsAre;
using testing::SizeIs;

/// From the lowest to the top-most.
std::vector<ObjectId> drawn_order(const LabelDocument& document) {
  std::vector<std::pair<std::int64_t, ObjectId>> order;
  for (const auto& [id, placed] : document.objects()) order.emplace_back(placed.object->order, id);
  std::sort(order.begin(), order.end());
  std::vector<ObjectId> ids;
  for (const auto& [at, id] : order) ids.push_back(id);
  return ids;
}

/// What each move means, one object after the other in a list.
std::vector<ObjectId> expected_order(const LabelDocument& document,
                                     const std::set<ObjectId>& moving,
                                     OrderMove move) {
  std::vector<ObjectId> list = drawn_order(document);
  const auto meets = [&](ObjectId a, ObjectId b) {
    const PlaneBounds& one = document.objects().at(a).bounds;
    const PlaneBounds& other = document.objects().at(b).bounds;
    return (one.low.array() <= other.high.array()).all() &&
           (other.low.array() <= one.high.array()).all();
  };
  const auto is_moving = [&](ObjectId id) { return moving.count(id) > 0; };
  if (move == OrderMove::kTop || move == OrderMove::kBottom) {
    std::stable_partition(list.begin(), list.end(), [&](ObjectId id) {
      return is_moving(id) == (move == OrderMove::kBottom);
    });
    return list;
  }
  // Down is up in a list that is turned over.
  if (move == OrderMove::kDown) std::reverse(list.begin(), list.end());
  std::vector<ObjectId> turns;
  std::copy_if(list.rbegin(), list.rend(), std::back_inserter(turns), is_moving);
  for (const ObjectId id : turns) {
    const auto own = std::find(list.begin(), list.end(), id);
    const auto next =
        std::find_if(own + 1, list.end(), [&](ObjectId other) { return meets(id, other); });
    if (next == list.end() || is_moving(*next)) continue;
    std::rotate(own, own + 1, next + 1);
  }
  if (move == OrderMove::kDown) std::reverse(list.begin(), list.end());
  return list;
}

TEST(Reorder, MovesAsInAListHoweverTightTheNumbersAre) {
  constexpr std::uint32_t kSeed = 211;
  std::size_t changed = 0;
  for (std::uint32_t round = 0; round < 60; ++round) {
    std::vector<LabelObject> objects;
    const int count = 3 + static_cast<int>(round % 25);
    for (int i = 0; i < count; ++i) {
      const auto [x, y] = uniforms({kSeed, 0, round, static_cast<std::uint32_t>(i), 0});
      const auto [side, order] = uniforms({kSeed, 1, round, static_cast<std::uint32_t>(i), 0});
      objects.push_back(area(kRoad, {box(30 * x, 20 * y, 30 * x + 12 * side, 20 * y + 9)}, i + 1));
      // All equal, side by side, or with room; some on another level.
      const double span = round % 3 == 0 ? 1.0 : round % 3 == 1 ? count : 1e9;
      objects.back().order = static_cast<std::int64_t>(order * span);
      if (i % 7 == 6) objects.back().order += 3 * kOrdersPerLevel;
    }
    LabelDocument document = document_of(objects);
    for (std::uint32_t step = 0; step < 12; ++step) {
      std::set<ObjectId> moving;
      for (int i = 0; i < 1 + static_cast<int>(step % 4); ++i) {
        const double at = uniforms({kSeed, 2, round, step, static_cast<std::uint32_t>(i)})[0];
        moving.insert(1 + static_cast<ObjectId>(at * count));
      }
      const auto move = static_cast<OrderMove>((round + step) % 4);
      const std::vector<ObjectId> ids(moving.begin(), moving.end());
      const auto edit = reorder(document, ids, move);
      const LabelDocument after = edited(document, edit);
      ASSERT_EQ(drawn_order(after), expected_order(document, moving, move))
          << "round " << round << ", step " << step;
      changed += edit->objects.size();
      for (const auto& [id, placed] : after.objects()) {
        if (moving.count(id) > 0) continue;
        EXPECT_EQ(level_of_order(placed.object->order),
                  level_of_order(object_in(document, id).order))
            << "what stays does so in its level";
      }
      document = after;
    }
  }
  EXPECT_GT(changed, 500U);
}

TEST(Reorder, LeavesRoomSoThatTheNextMoveChangesOneObject) {
  std::vector<LabelObject> objects;
  for (int i = 0; i < 200; ++i) objects.push_back(area(kRoad, {box(0, 0, 9, 9)}, i + 1));
  const LabelDocument document = document_of(objects);
  const auto first = reorder(document, std::vector<ObjectId>{10}, OrderMove::kUp);
  const LabelDocument after = edited(document, first);
  const auto second = reorder(after, std::vector<ObjectId>{20}, OrderMove::kUp);
  ASSERT_TRUE(second);
  EXPECT_THAT(second->objects, SizeIs(1));
}

TEST(Reorder, KeepsTheOrderOfWhatIsMovedAndItsLevelWhereItCan) {
  LabelObject low = area(kTerrain, {box(0, 0, 9, 9)}, 1);
  LabelObject next = area(kTerrain, {box(1, 1, 9, 9)}, 2);
  LabelObject road = area(kRoad, {box(2, 2, 9, 9)}, 3);
  const LabelDocument document = document_of({low, next, road});
  const auto raised = edited(document, reorder(document, std::vector<ObjectId>{1}, OrderMove::kUp));
  EXPECT_THAT(drawn_order(raised), ElementsAre(2, 1, 3));
  EXPECT_EQ(level_of_order(object_in(raised, 1).order), drawing_level(kTerrain))
      << "paint on terrain still shows";
  EXPECT_TRUE(reorder(document, std::vector<ObjectId>{2, 3}, OrderMove::kTop)->empty());
  EXPECT_TRUE(reorder(document, std::vector<ObjectId>{3, 2}, OrderMove::kUp)->empty())
      << "the top-most cannot move, and the one below does not overtake it";
}

TEST(Reorder, TakesOrdersAtTheEndOfNumbers) {
  LabelObject low = area(kTerrain, {box(0, 0, 9, 9)}, 1);
  LabelObject high = area(kTerrain, {box(0, 0, 9, 9)}, 2);
  low.order = std::numeric_limits<std::int64_t>::min();
  high.order = std::numeric_limits<std::int64_t>::max();
  const LabelDocument document = document_of({low, high, area(kRoad, {box(0, 0, 9, 9)}, 3)});
  for (const OrderMove move :
       {OrderMove::kUp, OrderMove::kDown, OrderMove::kTop, OrderMove::kBottom}) {
    EXPECT_TRUE(reorder(document, std::vector<ObjectId>{3}, move));
  }
}

}  // namespace reorder_test
}  // namespace nadir
