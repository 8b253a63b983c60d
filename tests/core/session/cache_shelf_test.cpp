// SPDX-License-Identifier: Apache-2.0
#include "core/session/cache_shelf.h"

#include <gmock/gmock.h>

#include <set>

#include "core/session/cursor_order.h"

namespace nadir {
namespace cache_shelf_test {

using detail::CacheShelf;
using detail::CursorDistance;
using ::testing::ElementsAre;

std::vector<std::size_t> kept(const CacheShelf<int>& shelf, std::size_t count) {
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < count; ++i) {
    if (shelf.find(i)) indices.push_back(i);
  }
  return indices;
}

void put(CacheShelf<int>& shelf,
         std::size_t index,
         std::size_t bytes,
         std::size_t budget,
         const CursorDistance& distance) {
  shelf.put(index, std::make_shared<const int>(static_cast<int>(index)), bytes, budget, distance);
}

TEST(CacheShelf, DropsTheFarthestFirstAndNeverTheOneLookedAt) {
  CacheShelf<int> shelf;
  const CursorDistance at_five{.here = 5};
  for (const std::size_t index : {2U, 5U, 4U, 7U, 6U}) put(shelf, index, 10, 30, at_five);
  EXPECT_THAT(kept(shelf, 10), ElementsAre(4U, 5U, 6U));
  EXPECT_EQ(shelf.used(), 30U);
  shelf.shrink(0, at_five);
  EXPECT_THAT(kept(shelf, 10), ElementsAre(5U));
}

TEST(CacheShelf, WeighsWhatIsBehindThreeTimesInPlay) {
  CacheShelf<int> shelf;
  const CursorDistance playing{.here = 5, .is_forward = true, .is_playing = true};
  for (std::size_t index = 0; index < 10; ++index) put(shelf, index, 10, 50, playing);
  EXPECT_THAT(kept(shelf, 10), ElementsAre(4U, 5U, 6U, 7U, 8U));
  const CursorDistance backwards{.here = 5, .is_forward = false, .is_playing = true};
  CacheShelf<int> other;
  for (std::size_t index = 0; index < 10; ++index) put(other, index, 10, 50, backwards);
  EXPECT_THAT(kept(other, 10), ElementsAre(2U, 3U, 4U, 5U, 6U));
}

TEST(CacheShelf, RemembersWhatFoundNoRoomSoThatItIsNotTriedForEver) {
  CacheShelf<int> shelf;
  const CursorDistance at_five{.here = 5};
  put(shelf, 5, 10, 20, at_five);
  put(shelf, 6, 10, 20, at_five);
  put(shelf, 4, 15, 20, at_five);  // drops 6 of the same distance or itself; one of them stays out
  EXPECT_LE(shelf.used(), 25U);
  EXPECT_TRUE(shelf.is_settled(4));
  shelf.forget_room();
  EXPECT_EQ(shelf.is_settled(4), shelf.find(4) != nullptr);
}

TEST(CacheShelf, KnowsWhetherOneMoreWouldStay) {
  CacheShelf<int> shelf;
  const CursorDistance at_five{.here = 5};
  EXPECT_TRUE(shelf.has_room(0, 3, at_five)) << "nobody knows yet what one weighs";
  put(shelf, 5, 10, 30, at_five);
  put(shelf, 8, 10, 30, at_five);
  EXPECT_TRUE(shelf.has_room(30, 9, at_five));
  EXPECT_TRUE(shelf.has_room(20, 2, at_five)) << "in place of 8";
  EXPECT_FALSE(shelf.has_room(20, 3, at_five));
}

TEST(CacheShelf, GivesTheNearestWithinReach) {
  CacheShelf<int> shelf;
  const CursorDistance at_five{.here = 5};
  EXPECT_EQ(shelf.nearest(5, 100), nullptr);
  for (const std::size_t index : {3U, 8U, 20U}) put(shelf, index, 1, 100, at_five);
  EXPECT_EQ(*shelf.nearest(8, 0), 8);
  EXPECT_EQ(*shelf.nearest(5, 10), 3);
  EXPECT_EQ(*shelf.nearest(6, 10), 8);
  EXPECT_EQ(*shelf.nearest(14, 6), 8) << "of two the earlier";
  EXPECT_EQ(*shelf.nearest(15, 10), 20);
  EXPECT_EQ(*shelf.nearest(0, 3), 3);
  EXPECT_EQ(shelf.nearest(0, 2), nullptr);
  EXPECT_EQ(*shelf.nearest(100, 80), 20);
  EXPECT_EQ(shelf.nearest(100, 79), nullptr);
}

TEST(CacheShelf, IsSettledWhereSomethingIsBroken) {
  CacheShelf<int> shelf;
  shelf.mark_broken(3);
  EXPECT_TRUE(shelf.is_settled(3));
  EXPECT_EQ(shelf.find(3), nullptr);
  shelf.forget_broken();
  EXPECT_FALSE(shelf.is_settled(3));
}

TEST(StepsNearby, GoByTheirDistanceWithoutTheCursorAndOnceEach) {
  for (const bool is_playing : {false, true}) {
    for (const int direction : {1, -1}) {
      for (const std::size_t index : {0U, 3U, 500U, 997U, 999U}) {
        const Cursor cursor{index, direction, is_playing, true};
        const CursorDistance distance{index, direction > 0, is_playing};
        std::set<std::size_t> seen = {index};
        std::size_t last = 0;
        for (const auto& step : detail::steps_nearby(cursor, 1000)) {
          EXPECT_LT(step.index, 1000U);
          EXPECT_TRUE(seen.insert(step.index).second);
          EXPECT_GE(distance(step.index), last);
          last = distance(step.index);
        }
      }
    }
  }
}

TEST(StepsNearby, LookFartherAheadInPlay) {
  const auto reach = [](const Cursor& cursor) {
    std::size_t lowest = cursor.index;
    std::size_t highest = cursor.index;
    std::size_t with_camera = 0;
    for (const auto& step : detail::steps_nearby(cursor, 1000)) {
      lowest = std::min(lowest, step.index);
      highest = std::max(highest, step.index);
      with_camera += step.is_with_camera ? 1U : 0U;
    }
    return std::vector{cursor.index - lowest, highest - cursor.index, with_camera};
  };
  EXPECT_THAT(reach({500, 1, false, true}), ElementsAre(90U, 90U, 8U));
  EXPECT_THAT(reach({500, 1, true, true}), ElementsAre(20U, 240U, 31U));
  EXPECT_THAT(reach({500, -1, true, true}), ElementsAre(240U, 20U, 31U));
  EXPECT_TRUE(detail::steps_nearby({5, 1, true, true}, 5).empty()) << "past the end";
}

}  // namespace cache_shelf_test
}  // namespace nadir
