// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <numbers>
#include <numeric>

#include "core/edit/edit_objects.h"
#include "core/edit/polygon_algebra.h"
#include "tests/core/edit/edited_labels.h"

namespace nadir {
namespace cut_objects_test {

using testing::HasSubstr;
using testing::SizeIs;

double covered_m2(const LabelDocument& document) {
  double sum = 0.0;
  for (const auto& [id, placed] : document.objects()) sum += area_m2(*region_of(*placed.object));
  return sum;
}

std::vector<ObjectId> ids(std::initializer_list<ObjectId> of) { return of; }

int cells_with(const LabelDocument& document, int count) {
  const Raster<int> claimed = cells_claimed(document);
  return static_cast<int>(std::count(claimed.values().begin(), claimed.values().end(), count));
}

TEST(CutHole, TakesARingOutOfAnArea) {
  const LabelDocument document = document_of({area(kRoad, {box(0, 0, 10, 10)}, 1)});
  const auto after = edited(document, cut_hole(document, 1, box(2, 2, 5, 5)));
  EXPECT_THAT(object_in(after, 1).rings, SizeIs(2));
  EXPECT_DOUBLE_EQ(covered_m2(after), 91.0);
  const char* const kOut = "Cut hole: the hole reaches out of area 1";
  EXPECT_EQ(error_text(cut_hole(document, 1, box(8, 8, 12, 9))), kOut);
  EXPECT_EQ(error_text(cut_hole(document, 1, box(0, 3, 10, 4))), kOut) << "two would be left";
  EXPECT_EQ(error_text(cut_hole(after, 1, box(4, 4, 6, 6))), kOut) << "another hole";
  EXPECT_THAT(error_text(cut_hole(document, 1, ring({{2, 2}, {5, 5}}))),
              HasSubstr("a ring has 2 different places, and needs 3"));
  EXPECT_THAT(error_text(cut_hole(document, 1, ring({{2, 2}, {5, 5}, {5, 2}, {2, 5}}))),
              HasSubstr("the hole crosses itself"));
}

TEST(Split, PartsInheritAllAndCoverTheSame) {
  LabelObject whole = area(kVegetation, {box(0, 0, 20, 10), box(8, 3, 12, 7)}, 1);
  whole.note = "park";
  const LabelDocument document =
      document_of({whole, area(kTerrain, {box(0, 10, 20, 20)}, 2)}, 20, 20);
  const std::array<ObjectId, 1> one{1};
  const auto after = edited(document, split(document, one, ring({{3.3, -2}, {11.7, 12}})));
  ASSERT_EQ(after.objects().size(), 3U);
  EXPECT_EQ(object_in(after, 3).note, "park");
  EXPECT_EQ(object_in(after, 3).order, whole.order);
  EXPECT_GE(area_m2(*region_of(object_in(after, 1))), area_m2(*region_of(object_in(after, 3))));
  EXPECT_NEAR(covered_m2(after) / covered_m2(document), 1.0, 1e-9);
  EXPECT_EQ(rasterise(after), rasterise(document));
  EXPECT_EQ(cells_with(after, 2), 0);
  // The cut ends on the border with the terrain, which has got a place there.
  EXPECT_THAT(object_in(after, 2).rings[0], SizeIs(5));
  EXPECT_EQ(shared_places(after), 6U);
}

TEST(Split, CutsLinesAndSaysWhereItCutsNothing) {
  const LabelDocument document =
      document_of({line(kRoad, ring({{0, 5}, {20, 5}, {20, 20}}), 3.0, 1)});
  const std::array<ObjectId, 1> one{1};
  const auto after = edited(document, split(document, one, ring({{5, 0}, {5, 10}})));
  EXPECT_EQ(object_in(after, 1).rings[0], ring({{0, 5}, {5, 5}}));
  EXPECT_EQ(object_in(after, 2).rings[0], ring({{5, 5}, {20, 5}, {20, 20}}));
  EXPECT_EQ(error_text(split(document, one, ring({{5, 8}, {5, 10}}))),
            "the line does not cut across anything");
}

TEST(Merge, UnitesNeighboursAndJoinsLines) {
  const LabelDocument document =
      document_of({area(kRoad, {box(0, 0, 10, 10)}, 1), area(kTerrain, {box(10, 0, 20, 10)}, 2),
                   area(kRoad, {box(30, 0, 35, 5)}, 3), line(kCurb, ring({{0, 20}, {5, 20}}), 1, 4),
                   line(kCurb, ring({{9, 25}, {5, 20}}), 1, 5)});
  const std::array<ObjectId, 2> areas{2, 1};
  const auto after = edited(document, merge(document, areas));
  EXPECT_EQ(after.objects().count(1), 0U);
  EXPECT_EQ(object_in(after, 2).class_id, kTerrain);
  EXPECT_DOUBLE_EQ(area_m2(*region_of(object_in(after, 2))), 200.0);
  const std::array<ObjectId, 2> lines{4, 5};
  EXPECT_EQ(object_in(edited(document, merge(document, lines)), 4).rings[0],
            ring({{0, 20}, {5, 20}, {9, 25}}));
  const std::array<ObjectId, 2> apart{1, 3};
  EXPECT_THAT(error_text(merge(document, apart)), HasSubstr("do not all touch each other"));
  const std::array<ObjectId, 2> kinds{1, 4};
  EXPECT_THAT(error_text(merge(document, kinds)),
              HasSubstr("area 1 and line 4 are not of one kind"));
  EXPECT_FALSE(merge(document, std::span(areas.data(), 1)));
}

TEST(Subtract, TakesWhatTheOtherCovers) {
  const LabelDocument document = document_of({area(kVegetation, {box(0, 0, 20, 10)}, 1),
                                              line(kRoad, ring({{8, -5}, {12, 15}}), 3.0, 2),
                                              area(kBuilding, {box(-5, -5, 30, 30)}, 3)});
  const auto cut = edited(document, subtract(document, 1, ids({2})));
  EXPECT_EQ(cut.objects().size(), 4U) << "in two";
  const auto covered = region_of(object_in(document, 2));
  const auto whole = region_of(object_in(document, 1));
  EXPECT_NEAR(area_m2(*region_of(object_in(cut, 1))) + area_m2(*region_of(object_in(cut, 4))),
              area_m2(*without(*whole, *covered)), 1e-6);
  EXPECT_EQ(edited(document, subtract(document, 1, ids({3}))).objects().size(), 2U)
      << "covered whole";
  EXPECT_FALSE(subtract(document, 1, ids({1})));
  const LabelDocument apart =
      document_of({area(kRoad, {box(0, 0, 5, 5)}, 1), area(kRoad, {box(5, 0, 9, 5)}, 2)});
  EXPECT_TRUE(subtract(apart, 1, ids({2}))->empty()) << "they only touch";
}

TEST(Clip, LeavesNeitherGapNorOverlap) {
  for (std::uint32_t i = 0; i < 12; ++i) {
    const auto star = [&](std::uint32_t number, double x, double y) {
      Ring places;
      for (std::uint32_t p = 0; p < 11; ++p) {
        const auto [radius, turn] = uniforms({91, number, i, p, 0});
        const double angle = 2.0 * std::numbers::pi * (p + 0.8 * turn) / 11.0;
        places.emplace_back(x + (4 + 9 * radius) * std::cos(angle),
                            y + (4 + 9 * radius) * std::sin(angle));
      }
      return places;
    };
    const LabelDocument document =
        document_of({area(kTerrain, {star(0, 14, -15)}, 1), area(kTerrain, {star(1, 26, -13)}, 2),
                     area(kVegetation, {star(2, 20, -19)}, 3)});
    const int covered = 40 * 30 - cells_with(document, 0);
    for (const ClipSide side : {ClipSide::kThis, ClipSide::kOthers}) {
      LabelDocument after = document;
      std::vector<ObjectId> clipped{3};
      if (side == ClipSide::kThis) clipped = {1, 2};
      for (const ObjectId id : clipped) after = edited(after, clip(after, ids({id}), side));
      if (side == ClipSide::kOthers) {
        for (ObjectId id = 1; id < after.next_id(); ++id) {
          if (after.objects().count(id) > 0 && id != 3)
            after = edited(after, clip(after, ids({id}), side));
        }
      }
      EXPECT_EQ(40 * 30 - cells_with(after, 0), covered) << "no gap";
      EXPECT_EQ(cells_with(after, 2) + cells_with(after, 3), 0) << "no overlap";
      EXPECT_GT(shared_places(after), 0U);
    }
  }
}

TEST(Clip, NewBordersMoveTogetherAfterwards) {
  const LabelDocument document =
      document_of({area(kTerrain, {box(0.3, 0.1, 12.7, 9.7)}, 1),
                   area(kTerrain, {ring({{9.1, 3.3}, {19, 2}, {17, 8}})}, 2)});
  const auto after = edited(document, clip(document, ids({2}), ClipSide::kThis));
  // Where the borders of both crossed, both have a place now; the corner inside is gone.
  EXPECT_EQ(shared_places(after), 2U);
  EXPECT_NEAR(covered_m2(after),
              area_m2(*united(std::array{*region_of(object_in(document, 1)),
                                         *region_of(object_in(document, 2))})),
              1e-5);
}

TEST(CopyBeside, KeepsItsDistance) {
  const LabelDocument document = document_of(
      {line(kRoad, ring({{0, 5}, {20, 5}}), 3.0, 1), area(kRoad, {box(0, 0, 4, 4)}, 2)});
  const auto after = edited(document, copy_beside(document, 1, 2.0));
  EXPECT_EQ(object_in(after, 3).rings[0], ring({{0, 3}, {20, 3}}));
  EXPECT_DOUBLE_EQ(
      area_m2(*region_of(object_in(edited(document, copy_beside(document, 2, 1.0)), 3))), 36.0);
  EXPECT_THAT(error_text(copy_beside(document, 2, -3.0)), HasSubstr("nothing of area 2 is left"));
  EXPECT_FALSE(copy_beside(document, 2, std::nan("")));
}

TEST(Recode, WithinARingCutsVectorsAndChangesPaint) {
  LabelDocument document = document_of(
      {area(kTerrain, {box(0, 0, 20, 10)}, 1), area(kTerrain, {box(2, 12, 6, 16)}, 2),
       line(kTerrain, ring({{0, 20}, {30, 20}}), 2.0, 3),
       outline(kTerrain, {box(25, 2, 35, 9)}, 1.0, 4), area(kRoad, {box(0, 0, 3, 3)}, 5)});
  document.apply(painting(document, {8, 22, 20, 25}, kTerrain));
  document.apply(painting(document, {8, 25, 20, 28}, kTerrain + kPaintOver));
  const Ring within = box(-1, -1, 12.5, 29);
  const auto after = edited(document, recode(document, kTerrain, kVegetation, within));
  const auto before_cells = rasterise(document);
  const auto cells = rasterise(after);
  for (int row = 0; row < 30; ++row) {
    for (int column = 0; column < 40; ++column) {
      const ClassId was = before_cells.at(column, row);
      const bool is_within = column < 12;
      const bool is_on_ring = column == 12;
      const ClassId expected = is_within && was == kTerrain ? ClassId{kVegetation} : was;
      if (!is_on_ring) {
        EXPECT_EQ(cells.at(column, row), expected) << column << ", " << row;
      }
    }
  }
  EXPECT_EQ(object_in(after, 2).class_id, kVegetation) << "wholly within it keeps its number";
  EXPECT_EQ(object_in(after, 1).class_id, kTerrain);
  EXPECT_NEAR(covered_m2(after), covered_m2(document), 1e-5);
}

TEST(Recode, EverywhereChangesAllOfAClass) {
  LabelDocument document = document_of({area(kTerrain, {box(0, 0, 20, 10)}, 1)}, 600, 30);
  document.apply(painting(document, {240, 12, 280, 18}, kTerrain));
  document.apply(painting(document, {290, 12, 300, 18}, kTerrain + kPaintOver));
  document.apply(painting(document, {310, 12, 320, 18}, kRoad));
  const auto after = edited(document, recode(document, kTerrain, kSidewalk, {}));
  EXPECT_EQ(object_in(after, 1).class_id, kSidewalk);
  EXPECT_EQ(level_of_order(object_in(after, 1).order), drawing_level(kSidewalk));
  EXPECT_EQ(after.paint_at(250, 13), kSidewalk);
  EXPECT_EQ(after.paint_at(270, 13), kSidewalk);
  EXPECT_EQ(after.paint_at(295, 13), kSidewalk + kPaintOver);
  EXPECT_EQ(after.paint_at(315, 13), kRoad);
  const auto erased = edited(document, recode(document, kTerrain, kUnclassified, {}));
  EXPECT_EQ(erased.paint_at(250, 13), kUnclassified);
  EXPECT_TRUE(recode(document, kPole, kRoad, {})->empty());
  EXPECT_FALSE(recode(document, kRoad, kSky, {}));
  EXPECT_FALSE(recode(document, kRoad, kPole, ring({{0, 0}, {1, 1}})));
}

}  // namespace cut_objects_test
}  // namespace nadir
