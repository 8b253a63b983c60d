// SPDX-License-Identifier: Apache-2.0
#include "core/quality/review_map.h"

#include <gmock/gmock.h>

#include "tests/core/edit/edited_labels.h"

namespace nadir {
namespace review_map_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

LabelDocument reviewed(double side_m = 10.0) {
  const LabelDocument document = document_of({area(kTerrain, {box(0, 0, 40, 30)}, 1)});
  return edited(document, begin_review(document, side_m));
}

LabelDocument marked(const LabelDocument& document,
                     const ReviewAddress& tile,
                     ReviewState state,
                     const std::string& note = {}) {
  return edited(document, mark_tile(document, tile, state, note, "ada", "2026-11-23T10:00:00Z"));
}

ReviewMap map_of(const LabelDocument& document) {
  auto map = review_map_of(document);
  EXPECT_TRUE(map) << error_text(map);
  return *map;
}

TEST(ReviewMark, RoundTripsAsTextWithAnyNote) {
  for (const std::string& note :
       {std::string(), std::string("look\nat the\n\ncurbs "), std::string("ü")}) {
    const ReviewMark mark{ReviewState::kToDo, "ada", "2026-11-23T10:00:00Z", "0123", note};
    EXPECT_EQ(review_mark_from(review_text(mark)), mark);
  }
  for (const char* const text : {"", "done", "finished\na\nb\nc\n", "done\na\nb\n"}) {
    EXPECT_FALSE(review_mark_from(text)) << text;
  }
}

TEST(ReviewMap, HasNoTilesBeforeAReviewBegins) {
  EXPECT_THAT(map_of(document_of({area(kTerrain, {box(0, 0, 40, 30)}, 1)})).tiles, IsEmpty());
  EXPECT_EQ(map_of(test_document()).done_share(), 0.0);
  const LabelDocument document = test_document();
  EXPECT_FALSE(mark_tile(document, {0, 0}, ReviewState::kDone, {}, "ada", "now"));
}

TEST(ReviewMap, CoversWhatIsLabelledAndEachCellOnce) {
  const LabelDocument plain = document_of({area(kTerrain, {box(12, 3, 35, 22)}, 1)});
  for (const double side_m : {10.0, 7.3, 100.0}) {
    const ReviewMap map = map_of(edited(plain, begin_review(plain, side_m)));
    Raster<int> counts(40, 30, 0);
    for (const ReviewTile& tile : map.tiles) {
      for (int y = 0; y < 30; ++y) {
        for (int x = 0; x < 40; ++x) {
          const Eigen::Vector2d centre(x + 0.5, -y - 0.5);
          const bool is_in = (centre.array() > tile.bounds.low.array()).all() &&
                             (centre.array() < tile.bounds.high.array()).all();
          counts.at(x, y) += is_in ? 1 : 0;
        }
      }
    }
    for (int y = 3; y < 22; ++y) {
      for (int x = 12; x < 35; ++x) ASSERT_EQ(counts.at(x, y), 1) << side_m;
    }
    EXPECT_LE(*std::max_element(counts.values().begin(), counts.values().end()), 1);
  }
  const ReviewMap map = map_of(edited(plain, begin_review(plain, 10.0)));
  EXPECT_EQ(map.columns, 3);
  ASSERT_EQ(map.tiles.size(), 9U);
  EXPECT_EQ(map.tiles[0].address, (ReviewAddress{1, 0}));
}

TEST(ReviewMap, ADoneTileIsStaleOnceItsCellsChangeAndNotWhenOthersDo) {
  const LabelDocument done = marked(reviewed(), {1, 1}, ReviewState::kDone, "fine");
  const ReviewTile& tile = *map_of(done).tile_at({15, -15});
  EXPECT_EQ(tile.mark.state, ReviewState::kDone);
  EXPECT_EQ(tile.mark.author, "ada");
  EXPECT_EQ(tile.mark.note, "fine");
  EXPECT_FALSE(tile.is_stale);
  EXPECT_DOUBLE_EQ(map_of(done).done_share(), 1.0 / 12.0);
  LabelDocument beside = done;
  beside.apply(painting(beside, {20, 10, 21, 11}, kRoad));
  EXPECT_FALSE(map_of(beside).tile_at({15, -15})->is_stale);
  LabelDocument within = done;
  const LabelEdit edit = painting(within, {19, 19, 20, 20}, kRoad);
  within.apply(edit);
  EXPECT_TRUE(map_of(within).tile_at({15, -15})->is_stale);
  EXPECT_TRUE(map_of(within).tile_at({15, -15})->is_open());
  EXPECT_EQ(map_of(within).done_share(), 0.0);
  within.apply(reversed(edit));
  EXPECT_FALSE(map_of(within).tile_at({15, -15})->is_stale) << "it was taken back";
}

TEST(ReviewMap, AMarkIsTakenBackByMarkingOpen) {
  const LabelDocument document = reviewed();
  const LabelDocument todo = marked(document, {0, 0}, ReviewState::kToDo, "curbs");
  EXPECT_EQ(map_of(todo).tiles[0].mark.note, "curbs");
  EXPECT_TRUE(marked(todo, {0, 0}, ReviewState::kOpen) == document);
  const auto nothing = mark_tile(document, {0, 0}, ReviewState::kOpen, {}, "ada", "now");
  ASSERT_TRUE(nothing);
  EXPECT_TRUE(nothing->empty());
}

TEST(ReviewMap, RefusesWhatIsNoTile) {
  const LabelDocument document = reviewed();
  EXPECT_THAT(error_text(mark_tile(document, {9, 0}, ReviewState::kDone, {}, "ada", "now")),
              HasSubstr("review tile 9, 0 lies outside of the image"));
  EXPECT_THAT(error_text(begin_review(document, 0.5)), HasSubstr("not in [1, 10000]"));
  EXPECT_FALSE(begin_review(document, std::numeric_limits<double>::quiet_NaN()));
}

TEST(ReviewMap, AnotherSizeForgetsAllMarksAndTheSameChangesNothing) {
  const LabelDocument done = marked(reviewed(), {1, 1}, ReviewState::kDone);
  const auto same = begin_review(done, 10.0);
  ASSERT_TRUE(same);
  EXPECT_TRUE(same->empty());
  const LabelDocument other = edited(done, begin_review(done, 20.0));
  EXPECT_EQ(other.values().size(), 1U);
  EXPECT_EQ(review_side_m(other), 20.0);
}

TEST(ReviewMap, NextOpenTileGoesToAndFroFromTheNorthAndAroundAgain) {
  LabelDocument document = reviewed();
  Eigen::Vector2d place(5, -5);
  std::vector<ReviewAddress> way;
  for (;;) {
    const ReviewMap map = map_of(document);
    const ReviewTile* const next = map.next_open(place);
    if (next == nullptr) break;
    way.push_back(next->address);
    place = (next->bounds.low + next->bounds.high) / 2.0;
    document = marked(document, next->address, ReviewState::kDone);
  }
  // All but the first, and at last that one.
  EXPECT_THAT(way, ElementsAre(ReviewAddress{1, 0}, ReviewAddress{2, 0}, ReviewAddress{3, 0},
                               ReviewAddress{3, 1}, ReviewAddress{2, 1}, ReviewAddress{1, 1},
                               ReviewAddress{0, 1}, ReviewAddress{0, 2}, ReviewAddress{1, 2},
                               ReviewAddress{2, 2}, ReviewAddress{3, 2}, ReviewAddress{0, 0}));
  EXPECT_EQ(map_of(document).done_share(), 1.0);
  EXPECT_EQ(map_of(document).tile_at({500, 0}), nullptr);
}

TEST(ReviewMap, ATextThatIsNoMarkCountsAsOpen) {
  LabelDocument document = reviewed();
  document.apply(
      {"Set", {}, {}, {{"review 0 0", {nullptr, std::make_shared<const std::string>("?")}}}});
  EXPECT_TRUE(map_of(document).tiles[0].is_open());
  LabelDocument broken = test_document();
  broken.apply(
      {"Set", {}, {}, {{"review", {nullptr, std::make_shared<const std::string>("ten")}}}});
  EXPECT_FALSE(review_side_m(broken));
}

TEST(ReviewMap, StopsWhenTold) {
  std::stop_source stop;
  stop.request_stop();
  const auto map = review_map_of(reviewed(), {stop.get_token(), {}});
  ASSERT_FALSE(map);
  EXPECT_EQ(map.error().code, ErrorCode::kCancelled);
}

}  // namespace review_map_test
}  // namespace nadir
