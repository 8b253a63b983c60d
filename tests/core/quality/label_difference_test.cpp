// SPDX-License-Identifier: Apache-2.0
#include "core/quality/label_difference.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "tests/core/label/drawn_labels.h"

namespace nadir {
namespace label_difference_test {

using testing::ElementsAre;
using testing::IsEmpty;

/// What is told of one object that becomes another.
LabelDifference between(const LabelObject& before, const LabelObject& after) {
  const auto all = differences(document_of({before}), document_of({after}));
  EXPECT_EQ(all.size(), 1U);
  return all.at(0);
}

TEST(Differences, OfEqualDocumentsAreNone) {
  const LabelDocument document = document_of({area(kRoad, {box(2, 2, 12, 12)}, 1)});
  EXPECT_THAT(differences(document, document), IsEmpty());
}

TEST(Differences, TellWhatWasDrawnAndDeleted) {
  const LabelDocument before = document_of({area(kRoad, {box(2, 2, 12, 12)}, 1)});
  const LabelDocument after = document_of({line(kCurb, ring({{2, 2}, {12, 2}}), 0.2, 2)});
  const auto all = differences(before, after);
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].kind, DifferenceKind::kRemoved);
  EXPECT_EQ(all[0].sentence, "road area 1 of 100 m2 was deleted");
  EXPECT_EQ(all[0].bounds.low, Eigen::Vector2d(2, -12));
  EXPECT_EQ(all[1].kind, DifferenceKind::kAdded);
  EXPECT_EQ(all[1].class_id, kCurb);
  EXPECT_EQ(all[1].sentence, "curb line 2 of 10 m was drawn");
}

TEST(Differences, AMoveIsToldFromAnotherShape) {
  const LabelObject before = area(kRoad, {box(2, 2, 12, 12), box(4, 4, 5, 5)}, 1);
  const LabelObject moved = area(kRoad, {box(5, 6, 15, 16), box(7, 8, 8, 9)}, 1);
  const LabelDifference move = between(before, moved);
  EXPECT_TRUE(move.is_moved);
  EXPECT_FALSE(move.is_reshaped);
  EXPECT_EQ(move.sentence, "road area 1 moved by 5 m");
  EXPECT_EQ(move.bounds.low, Eigen::Vector2d(2, -16));
  EXPECT_EQ(move.bounds.high, Eigen::Vector2d(15, -2));
  const LabelDifference shape = between(before, area(kRoad, {box(2, 2, 13, 12)}, 1));
  EXPECT_TRUE(shape.is_reshaped);
  EXPECT_FALSE(shape.is_moved);
  EXPECT_EQ(shape.sentence, "road area 1 reshaped from 99 m2 to 110 m2");
  // Only its hole stays behind.
  EXPECT_TRUE(between(before, area(kRoad, {box(5, 6, 15, 16), box(6, 8, 7, 9)}, 1)).is_reshaped);
}

TEST(Differences, TellClassWidthOrderAndNote) {
  const LabelObject before = line(kCurb, ring({{2, 2}, {12, 2}}), 0.2, 7);
  LabelObject after = line(kFence, ring({{2, 2}, {12, 2}}), 0.35, 7);
  after.note = "wooden";
  const LabelDifference told = between(before, after);
  EXPECT_TRUE(told.is_reclassed);
  EXPECT_TRUE(told.is_resized);
  EXPECT_TRUE(told.is_renoted);
  EXPECT_FALSE(told.is_reordered) << "another class has another level";
  EXPECT_EQ(told.sentence,
            "curb line 7 became fence line, is 0.35 m wide instead of 0.2 m and has another note");
  LabelObject raised = before;
  raised.order += kOrderStep;
  EXPECT_EQ(between(before, raised).sentence, "curb line 7 was raised");
  EXPECT_EQ(between(raised, before).sentence, "curb line 7 was lowered");
}

TEST(Differences, TellPaintByTilesAndValues) {
  LabelDocument before = test_document(600, 300);
  before.apply(painting(before, {0, 0, 4, 1}, kRoad));
  LabelDocument after = before;
  after.apply(painting(after, {0, 0, 2, 1}, kNoPaint));
  after.apply(painting(after, {10, 3, 12, 6}, kTerrain + kPaintOver));
  after.apply(painting(after, {300, 20, 301, 21}, kUnclassified));
  after.apply({"Set", {}, {}, {{"offset", {nullptr, std::make_shared<const std::string>("1")}}}});
  const auto all = differences(before, after);
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[0].kind, DifferenceKind::kPaint);
  EXPECT_EQ(all[0].sentence, "paint of 8 cells changed: 6 terrain, 2 erased");
  EXPECT_EQ(all[0].bounds.low, Eigen::Vector2d(0, -6));
  EXPECT_EQ(all[0].bounds.high, Eigen::Vector2d(12, 0));
  EXPECT_EQ(all[1].sentence, "paint of 1 cell changed: 1 unclassified");
  EXPECT_EQ(all[1].bounds.low, Eigen::Vector2d(300, -21));
  EXPECT_EQ(all[2].kind, DifferenceKind::kValue);
  EXPECT_EQ(all[2].sentence, "offset was set");
  EXPECT_TRUE(all[2].bounds.is_empty);
}

TEST(Differences, OfRandomVersionsAreOneForEachThingThatChanged) {
  LabelDocument document = test_document();
  for (std::uint32_t step = 0; step < 40; ++step) {
    const LabelDocument before = document;
    for (std::uint32_t i = 0; i < 5; ++i) document.apply(random_edit(document, 8, step * 5 + i));
    const LabelEdit edit = difference(before, document, {});
    const auto all = differences(before, document);
    EXPECT_EQ(all.size(), edit.objects.size() + edit.tiles.size() + edit.values.size());
    for (const LabelDifference& one : all) {
      const bool is_object = one.object != 0;
      EXPECT_EQ(before.object(one.object) == nullptr,
                !is_object || one.kind == DifferenceKind::kAdded);
      EXPECT_EQ(document.object(one.object) == nullptr,
                !is_object || one.kind == DifferenceKind::kRemoved);
      if (one.kind != DifferenceKind::kChanged) continue;
      EXPECT_TRUE(one.is_moved || one.is_reshaped || one.is_reclassed || one.is_resized ||
                  one.is_reordered || one.is_renoted);
    }
  }
}

}  // namespace label_difference_test
}  // namespace nadir
